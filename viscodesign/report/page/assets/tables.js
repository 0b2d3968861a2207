"use strict";

// Everything that is told in words and tables.

// A number with its unit, which stays in one line.
const QUANTITY = /^[<−+\d][^,;:]{0,15}$/;

function table(heads, rows, attributes = {}) {
  const head = element("tr", {}, ...heads.map((text) => element("th", { scope: "col" }, text)));
  const body = rows.map(([first, ...cells]) => element("tr", {}, element("th", { scope: "row" }, first),
    ...cells.map((cell) => (cell instanceof Node && cell.nodeName === "TD" ? cell : element("td", QUANTITY.test(cell) ? { class: "number" } : {}, cell)))));
  return element("div", { class: "scrolled", tabindex: "0", role: "region", "aria-label": `Table: ${attributes.label}` },
    element("table", {}, element("thead", {}, head), element("tbody", {}, ...body)));
}

// A table whose rows become blocks on a narrow screen, where every cell says what it is but those of the `unnamed` heads.
function stacked(made, heads, unnamed = []) {
  made.classList.add("stacked");
  for (const [tags, role] of [["table", "table"], ["thead, tbody", "rowgroup"], ["tr", "row"], ["thead th", "columnheader"], ["tbody th", "rowheader"], ["td", "cell"]]) {
    for (const part of made.querySelectorAll(tags)) part.setAttribute("role", role);
  }
  for (const line of made.querySelectorAll("tbody tr")) [...line.cells].forEach((cell, k) => { if (k && !unnamed.includes(heads[k])) cell.dataset.head = heads[k]; });
  return made;
}

function numberCell(text, kind = "number") {
  return element("td", { class: kind }, text);
}

// A cell with a sentence: on a narrow screen it takes a line of its own.
function longCell(text) {
  return element("td", { class: "long" }, text);
}

function millimetres(value) {
  return value === null || value === undefined ? "–" : `${shortNumber(1e3 * value, 3)} mm`;
}

// Warnings that say of the whole run that its numbers are not to be used.
const DOUBTS = ["unresolved_motion"];

// Name, status and the words below them, and a box for a place where banners stand.
function showTitle({ name, status }, words) {
  document.title = `${status === "complete" ? "" : `${status.toUpperCase()}: `}${name}`;
  byId("name").textContent = name;
  byId("meaning").textContent = words;
  document.body.classList.add(`run-${status}`);
}

function banner(kind, ...children) {
  byId("banners").append(element("p", kind === "note" || kind === "outside" ? { class: `banner ${kind}` } : { class: `banner ${kind}`, role: "alert" }, ...children));
}

function showNotes(notes) {
  for (const note of notes) banner("note", `${note[0].toUpperCase()}${note.slice(1)}.`);
}

function showHead(run) {
  const { summary } = run;
  showTitle(summary, `Quadrant ${summary.quadrant}: ${summary.meaning}. viscodesign ${summary.version}.`);
  if (summary.status !== "complete") banner(summary.status, ...brokenWords(summary.status, run, summary.failure));
  if (summary.validity.state === "outside") {
    const words = summary.validity.reasons.map((reason) => reason.code).filter((code, k, all) => all.indexOf(code) === k);
    banner("outside", element("strong", {}, "Outside of the model's validity"),
      ` (${words.join(", ")}): the stated error is that of a model that does not hold here.`);
  }
  if (run.count === 1) banner("note", `One output time only, ${timeWords(run.time.values, 0)}: a state, not a motion.`);
  for (const doubt of summary.warnings.filter((own) => DOUBTS.includes(own.code))) {
    byId("banners").append(element("p", { class: "banner outside", role: "alert" }, element("strong", {}, "Not resolved"), ": ", ...prose(doubt.message), "."));
  }
  showNotes(run.notes);
}

function brokenWords(status, run, failure) {
  const time = run.count ? run.time.values[run.count - 1] : null;
  const ended = time === null ? "before its first output time" : `at t = ${shortNumber(time, 6)} s`;
  const words = status === "failed" ? `This run failed: it ended ${ended}.` : `This run was interrupted: it ended ${ended}.`;
  return [element("strong", {}, words), " What is shown is the part that was computed. ", ...(failure ? prose(`Reason: ${failure}`) : [])];
}

const METRIC_UNITS = { m: ["mm", 1e3], m2: ["cm²", 1e4], s: ["s", 1], rad: ["rad", 1] };

function showMetrics(run) {
  const rows = Object.entries(run.summary.metrics).map(([name, value]) => {
    const words = name.split("_"), [unit, factor] = METRIC_UNITS[words[words.length - 1]] || ["", 1];
    const text = value === null ? "not defined" : `${shortNumber(factor * value, 5)} ${unit}`;
    return [words.slice(0, -1).join(" "), text];
  });
  if (run.summary.status !== "complete") byId("metrics").append(element("p", { class: "bad" }, "Of the part that was computed."));
  byId("metrics").append(table(["metric", "value"], rows, { label: "metrics" }));
}

function showWarnings(run, player) {
  const { validity, warnings } = run.summary, host = byId("validity");
  host.append(element("p", { class: validity.state === "outside" ? "bad" : "" }, validity.state === "inside"
    ? "The run stays within what its model describes." : "The run leaves what its model describes:"));
  if (validity.reasons.length) host.append(notices(validity.reasons, run, player));
  byId("warnings").append(element("h3", {}, "Warnings"));
  listWarnings(warnings, run, player);
  if (run.summary.more_warnings) byId("warnings").append(element("p", { class: "hint" }, `${run.summary.more_warnings} more are in summary.json.`));
}

function listWarnings(warnings, run, player) {
  byId("warnings").append(warnings.length ? notices(warnings, run, player) : element("p", {}, "No warnings."));
}

function notices(list, run, player) {
  const items = list.map((notice) => {
    const item = element("li", {}, element("strong", {}, notice.code.replace(/_/g, " ")), ": ", ...prose(notice.message), notice.where ? ` (${notice.where}) ` : " ");
    if (notice.time_s !== null && notice.time_s !== undefined) item.append(jump(notice.time_s, run, player));
    return item;
  });
  return element("ul", { class: "notices" }, ...items);
}

// A button that moves the cursor to a time, or the time alone where it is not shown.
function jump(time, run, player) {
  const words = `t = ${shortNumber(time, 5)} s`, shown = run.count ? run.time.values : [];
  const margin = run.count > 1 ? (shown[run.count - 1] - shown[0]) / (run.count - 1) : 0;
  if (!player || time < shown[0] - margin || time > shown[run.count - 1] + margin) return element("span", {}, `at ${words} (not shown)`);
  const button = element("button", { type: "button", class: "jump" }, `show ${words}`);
  button.addEventListener("click", () => {
    setPlaying(player, false);
    seek(player, nearestRow(shown, time));
    byId("motion").scrollIntoView({ block: "start" });
    byId("time").focus({ preventScroll: true });
  });
  return button;
}

const COST_PARTS = [["load_s", "reading the spec"], ["choose_s", "choosing effects"], ["build_s", "building the equations"], ["solve_s", "solution"],
  ["verify_s", "verification"], ["read_s", "motion and balances"]];

// All that took time until the files of the run were written, this page among them.
function costWords(cost) {
  const parts = COST_PARTS.filter(([key]) => cost[key]).map(([key, words]) => `${words} ${shortNumber(cost[key], 3)} s`);
  const total = COST_PARTS.reduce((sum, [key]) => sum + (cost[key] || 0), 0);
  return `${shortNumber(total, 3)} s without writing files${parts.length ? `: ${parts.join(", ")}` : ""}; ${cost.steps} steps`;
}

// Rows of a table: with what it was computed.
function programRows({ version, python, platform, packages = {} }) {
  const versions = Object.entries(packages).map(([name, own]) => `${name} ${own}`).join(", ");
  return [["program", `viscodesign ${version}, Python ${python || "?"}, ${platform || "?"}`], ["packages", versions || "–"]];
}

function showProvenance(run) {
  const { summary } = run, { cost, provenance, invariants } = summary;
  const settings = Object.entries(summary.settings || {}).map(([name, value]) => `${name.replace(/_/g, " ")}: ${value}`).join("; ");
  const rows = [
    ...programRows({ ...provenance, version: summary.version }), ["settings", settings || "–"],
    ["spec", `SHA-256 ${summary.spec_sha256}`],
    ["cost", costWords(cost)],
    ["balances", `volume ${shortNumber(invariants.volume_imbalance_rel, 2)}, energy ${shortNumber(invariants.energy_imbalance_rel, 2)} (relative)`],
    ["retries", (summary.ladder || []).map((row) => `${shortNumber(row.time_s, 4)} s: ${row.tried} ${row.solved ? "succeeded" : "failed"} (${row.reason})`).join("; ") || "none"],
  ];
  tellProvenance(rows, run.spec);
}

function tellProvenance(rows, spec) {
  byId("provenance").append(table(["what", "value"], rows, { label: "provenance" }));
  byId("spec").textContent = spec;
  printWhole();
}

// On paper nobody can open what is folded.
function printWhole() {
  const folded = () => [...document.querySelectorAll("details.printed")];
  let opened = [];
  window.addEventListener("beforeprint", () => {
    opened = folded().filter((own) => !own.open);
    for (const own of opened) own.open = true;
  });
  window.addEventListener("afterprint", () => { for (const own of opened) own.open = false; });
}

// The table of all values at the cursor, filled while it is open; lines are [name, text of a row].
function makeInstant(lines, note = "") {
  const details = byId("instant"), host = details.querySelector("div");
  const cells = lines.map(() => element("td", { class: "number" }));
  const body = lines.map(([name], k) => element("tr", {}, element("th", { scope: "row" }, name), cells[k]));
  host.append(element("table", { class: "instant" }, element("tbody", {}, ...body)));
  if (note) host.append(element("p", { class: "hint" }, note));
  const fill = (row) => lines.forEach(([, text], k) => { cells[k].textContent = text(row); });
  return { details, fill };
}

// One line for a column of an array, times a factor.
function valueLine(name, array, k, factor, decimals) {
  return [name, (row) => fixedNumber(factor * array.values[row * (array.shape[1] || 1) + k], decimals)];
}

const MAX_LISTED = 64;

function instantOf(run) {
  const lines = [valueLine("time [s]", run.time, 0, 1, timeDecimals(run.time.values)), ...["x", "z"].map((name, k) => valueLine(`tip ${name} [mm]`, run.tip, k, 1e3, 3)),
    valueLine("tip angle [deg]", run.tip, 2, 180 / Math.PI, 2),
    ...run.inlets.map((name, k) => valueLine(`pressure, ${run.inlets.length > 1 ? `inlet ${name}` : "inlet"} [kPa]`, run.inlet_pressure, k, 1e-3, 3)),
    ...run.bellows.slice(0, MAX_LISTED).map((name, k) => valueLine(`pressure, ${name} [kPa]`, run.pressure, k, 1e-3, 3)),
    ...run.tubes.map((name, k) => valueLine(`flow, ${name} [mL/s]`, run.flow, k, 1e6, 4)),
    ...(run.quantities ?? []).flatMap(({ title, unit, names, values }) => names.slice(0, MAX_LISTED).map((name, k) =>
      valueLine(`${name === title ? title : `${title}, ${name}`} [${unit}]`, values, k, 1, 4)))];
  return makeInstant(lines, run.bellows.length > MAX_LISTED ? `The first ${MAX_LISTED} of ${run.bellows.length} bellows; all are in trajectory.csv.` : "");
}
