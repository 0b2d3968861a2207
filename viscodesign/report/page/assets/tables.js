"use strict";

// Everything that is told in words and tables.

function table(heads, rows, attributes = {}) {
  const head = element("tr", {}, ...heads.map((text) => element("th", { scope: "col" }, text)));
  const body = rows.map(([first, ...cells]) => element("tr", {}, element("th", { scope: "row" }, first),
    ...cells.map((cell) => (cell instanceof Node && cell.nodeName === "TD" ? cell : element("td", {}, cell)))));
  return element("div", { class: "scrolled", tabindex: "0", role: "region", "aria-label": `Table: ${attributes.label}` },
    element("table", {}, element("thead", {}, head), element("tbody", {}, ...body)));
}

function millimetres(value) {
  return value === null || value === undefined ? "–" : `${shortNumber(1e3 * value, 3)} mm`;
}

function showHead(run) {
  const { summary } = run, mark = summary.status === "complete" ? "" : `${summary.status.toUpperCase()}: `;
  document.title = `${mark}${summary.name}`;
  byId("name").textContent = summary.name;
  byId("meaning").textContent = `Quadrant ${summary.quadrant}: ${summary.meaning}. viscodesign ${summary.version}.`;
  document.body.classList.add(`run-${summary.status}`);
  const banners = byId("banners");
  if (summary.status !== "complete") banners.append(element("p", { class: `banner ${summary.status}`, role: "alert" }, ...brokenWords(run)));
  if (summary.validity.state === "outside") {
    const words = summary.validity.reasons.map((reason) => reason.code).filter((code, k, all) => all.indexOf(code) === k);
    banners.append(element("p", { class: "banner outside" }, element("strong", {}, "Outside of the model's validity"),
      ` (${words.join(", ")}): the stated error is that of a model that does not hold here.`));
  }
  for (const note of run.notes) banners.append(element("p", { class: "banner note" }, `${note[0].toUpperCase()}${note.slice(1)}.`));
}

function brokenWords(run) {
  const { summary } = run, time = run.count ? run.time.values[run.count - 1] : null;
  const ended = time === null ? "before its first output time" : `at t = ${shortNumber(time, 6)} s`;
  const words = summary.status === "failed" ? `This run failed: it ended ${ended}.` : `This run was interrupted: it ended ${ended}.`;
  return [element("strong", {}, words), " What is shown is the part that was computed. ", summary.failure ? `Reason: ${summary.failure}` : ""];
}

// Error of the tip and its parts, as bars against the accuracy that was asked for.
function showAccuracy(run) {
  const { accuracy, status, effects, validity } = run.summary, host = byId("accuracy");
  const stated = accuracy.estimated_tip_error_m, asked = accuracy.requested_m;
  // As the command line says it: `error_qualifier` of a trajectory.
  const isPinned = effects.some((row) => row.mode === "off" && !row.taken && row.present !== false);
  const pinned = isPinned && validity.state === "inside" ? ", of the model as pinned" : "";
  const verdict = stated === null || stated === undefined
    ? "The error was not estimated."
    : `Estimated error ${millimetres(stated)}, ${shortNumber((100 * stated) / run.length, 2)} % of the length${pinned}; requested ${millimetres(asked)}: ${stated <= asked ? "reached" : "NOT reached"}.`;
  const part = status === "complete" || stated === null || stated === undefined ? "" : ` It holds for the part that was computed of a run that ${status === "failed" ? "failed" : "was interrupted"}.`;
  host.append(element("p", { class: stated > asked ? "bad" : "" }, verdict + part));
  const parts = [["time steps", accuracy.time_m], ["mesh along the rod", accuracy.space_m], ["neglected effects", accuracy.omitted_m], ["sum", stated]];
  const known = parts.filter(([, value]) => value !== null && value !== undefined);
  if (known.length) host.append(barTable(["part", "size beside the accuracy", "error"], known.map(([name, value]) => ({ cells: [name], value, after: [millimetres(value)] })), asked, "error parts"));
  if (accuracy.method) host.append(element("p", { class: "hint" }, accuracy.method));
  showBand(run, host);
}

// What the numbers cost beside what is known of the actuator: never one without the other.
function showBand(run, host) {
  const { accuracy, uncertainty, validity } = run.summary, stated = accuracy.estimated_tip_error_m;
  const numerical = stated === null || stated === undefined ? "not estimated" : millimetres(stated);
  const known = uncertainty
    ? `±${millimetres(uncertainty.half_width_95_m)} (95 %, at ${shortNumber(uncertainty.time_s, 3)} s)`
    : "unknown (uncertainty: typical gives a first band)";
  host.append(element("p", { id: "both-errors" }, element("strong", {}, "Both errors"), `: numerical ${numerical}; from the coefficients ${known}; validity ${validity.state}.`));
  if (!uncertainty) return;
  const rows = uncertainty.keys.filter((own) => own.share_of_variance >= 0.0005).map((own) => [own.key,
    `${shortNumber(own.value, 4)} ${own.unit === "1" ? "" : own.unit}`, own.value ? `${shortNumber((100 * own.standard_deviation) / Math.abs(own.value), 3)} %` : `${shortNumber(own.standard_deviation, 3)} ${own.unit}`,
    own.assumed ? "assumed" : "stated", `${shortNumber(100 * own.share_of_variance, 3)} %`]);
  if (rows.length) host.append(table(["number", "value", "standard deviation", "known", "share of the variance"], rows, { label: "uncertain numbers" }));
  host.append(element("p", { class: "hint" }, `Band of the tip by ${uncertainty.method}, at its widest, in the direction that is most uncertain.`));
}

// Rows with a bar in millimetres on a logarithmic axis; the accuracy is a line.
function barTable(heads, rows, asked, label) {
  const sizes = rows.map((row) => row.value).filter((value) => value > 0);
  const high = 10 ** Math.ceil(Math.log10(Math.max(2 * asked, ...sizes)) + 1e-9), low = Math.min(asked / 1e3, high / 1e5);
  const at = (value) => 180 * Math.max(0, Math.min(1, Math.log(value / low) / Math.log(high / low)));
  const bar = (row) => {
    const unbounded = row.value === null || row.value === undefined, x = at(asked);
    const width = unbounded ? 180 : row.value > 0 ? Math.max(1, at(row.value)) : 0;
    const svg = drawn("svg", { viewBox: "0 0 180 14", width: 180, height: 14, role: "img", class: "bar",
      "aria-label": unbounded ? "no bound" : `${shortNumber((100 * row.value) / asked, 3)} % of the accuracy` },
      drawn("rect", { x: 0, y: 3, width, height: 8, class: row.kind || "included" }),
      drawn("path", { class: "limit", d: `M${x} 0V14` }));
    if (row.measured > 0) svg.append(drawn("circle", { class: "measured", cx: at(row.measured), cy: 7, r: 3.5 }));
    return svg;
  };
  const made = table(heads, rows.map((row) => [...row.cells, element("td", { class: "bars" }, bar(row)), ...row.after]), { label });
  made.append(element("p", { class: "hint" }, `Bars are logarithmic, from ${millimetres(low)} to ${millimetres(high)}; the line is the requested accuracy, ${millimetres(asked)}.`));
  return made;
}

function showEffects(run) {
  const asked = run.summary.accuracy.requested_m;
  const measured = new Map((run.summary.proof || []).map((row) => [row.name, row.measured_m]));
  const present = run.summary.effects.filter((row) => row.present !== false);
  const size = (row) => (row.contribution_m === null ? Infinity : row.contribution_m);
  present.sort((a, b) => size(b) - size(a));
  const rows = present.map((row) => ({
    cells: [row.name.replace(/_/g, " "), (row.taken ? "included" : "neglected") + (row.mode === "auto" ? "" : `, set ${row.mode}`)],
    value: row.contribution_m, kind: row.taken ? "included" : "neglected", measured: measured.get(row.name),
    after: [row.contribution_m === null ? "no bound" : millimetres(row.contribution_m), row.reason],
  }));
  byId("effects").append(element("p", {}, "How far each effect alone moves the tip, estimated before solving",
    measured.size ? "; the ring is what a second solution measured." : "."),
    barTable(["effect", "decision", "size beside the accuracy", "moves the tip", "why"], rows, asked, "effects"));
  const absent = run.summary.effects.filter((row) => row.present === false).map((row) => row.name.replace(/_/g, " "));
  if (absent.length) byId("effects").append(element("p", { class: "hint" }, `Not applicable: ${absent.join(", ")}.`));
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
  if (warnings.length) byId("warnings").append(element("h3", {}, "Warnings"), notices(warnings, run, player));
  else byId("warnings").append(element("p", {}, "No warnings."));
  if (run.summary.more_warnings) byId("warnings").append(element("p", { class: "hint" }, `${run.summary.more_warnings} more are in summary.json.`));
}

function notices(list, run, player) {
  const items = list.map((notice) => {
    const item = element("li", {}, element("strong", {}, notice.code.replace(/_/g, " ")), `: ${notice.message}`, notice.where ? ` (${notice.where}) ` : " ");
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

function showProvenance(run) {
  const { summary } = run, { cost, provenance, invariants } = summary, packages = provenance.packages || {};
  const versions = Object.entries(packages).map(([name, version]) => `${name} ${version}`).join(", ");
  const settings = Object.entries(summary.settings || {}).map(([name, value]) => `${name.replace(/_/g, " ")}: ${value}`).join("; ");
  const rows = [
    ["program", `viscodesign ${summary.version}, Python ${provenance.python || "?"}, ${provenance.platform || "?"}`],
    ["packages", versions || "–"], ["settings", settings || "–"],
    ["spec", `SHA-256 ${summary.spec_sha256}`],
    ["cost", `solution ${shortNumber(cost.solve_s, 3)} s, verification ${shortNumber(cost.verify_s, 3)} s, ${cost.steps} steps`],
    ["balances", `volume ${shortNumber(invariants.volume_imbalance_rel, 2)}, energy ${shortNumber(invariants.energy_imbalance_rel, 2)} (relative)`],
    ["retries", (summary.ladder || []).map((row) => `${shortNumber(row.time_s, 4)} s: ${row.tried} ${row.solved ? "succeeded" : "failed"} (${row.reason})`).join("; ") || "none"],
  ];
  byId("provenance").append(table(["what", "value"], rows, { label: "provenance" }));
  byId("spec").textContent = run.spec;
}

// The table of all values at the cursor; filled while it is open.
function makeInstant(run) {
  const details = byId("instant"), host = details.querySelector("div"), most = 64;
  const cells = [], cell = () => { const made = element("td", { class: "number" }); cells.push(made); return made; };
  const rows = [["time [s]", cell()], ["tip x [mm]", cell()], ["tip z [mm]", cell()], ["tip angle [deg]", cell()],
    ...run.inlets.map((name) => [`pressure, ${run.inlets.length > 1 ? `inlet ${name}` : "inlet"} [kPa]`, cell()]),
    ...run.bellows.slice(0, most).map((name) => [`pressure, ${name} [kPa]`, cell()]),
    ...run.tubes.map((name) => [`flow, ${name} [mL/s]`, cell()])];
  const body = rows.map(([name, made]) => element("tr", {}, element("th", { scope: "row" }, name), made));
  host.append(element("table", { class: "instant" }, element("tbody", {}, ...body)));
  if (run.bellows.length > most) host.append(element("p", { class: "hint" }, `The first ${most} of ${run.bellows.length} bellows; all are in trajectory.csv.`));
  const decimals = timeDecimals(run.time.values);
  const fill = (row) => {
    const at = (array, k) => array.values[row * array.shape[1] + k];
    const texts = [fixedNumber(run.time.values[row], decimals), ...[0, 1].map((k) => fixedNumber(1e3 * at(run.tip, k), 3)), fixedNumber((180 / Math.PI) * at(run.tip, 2), 2),
      ...run.inlets.map((_, k) => fixedNumber(at(run.inlet_pressure, k) / 1e3, 3)),
      ...run.bellows.slice(0, most).map((_, k) => fixedNumber(at(run.pressure, k) / 1e3, 3)),
      ...run.tubes.map((_, k) => fixedNumber(1e6 * at(run.flow, k), 4))];
    texts.forEach((text, k) => { cells[k].textContent = text; });
  };
  return { details, fill };
}
