"use strict";

// What the tip may be off, and what every effect does to it, as bars against the accuracy that was asked for.

function isKnown(value) {
  return value !== null && value !== undefined;
}

// As the command line says it: where the steps are not told apart, the error is that of all parts together.
function errorParts({ time_m, space_m, omitted_m, estimated_tip_error_m: stated }) {
  if (!isKnown(time_m) && isKnown(stated)) return [["all parts together", stated]];
  return [["time steps", time_m], ["mesh along the rod", space_m], ["neglected effects", omitted_m], ["sum", stated]];
}

// Error of the tip and its parts.
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
  const known = errorParts(accuracy).filter(([, value]) => isKnown(value));
  if (known.length) host.append(barTable(["part", "size beside the accuracy", "error"], known.map(([name, value]) => ({ cells: [name], value, after: [numberCell(millimetres(value))] })), asked, "error parts"));
  if (accuracy.method) host.append(element("p", { class: "hint" }, accuracy.method));
  showBand(run, host);
}

// What the numbers cost beside what is known of the actuator: never one without the other.
function showBand(run, host) {
  const { accuracy, uncertainty, validity } = run.summary, stated = accuracy.estimated_tip_error_m;
  const numerical = isKnown(stated) ? millimetres(stated) : "not estimated";
  // As the command line says it: `both_errors`.
  const known = run.bandless
    || `±${millimetres(uncertainty.half_width_95_m)} (95 %, at ${shortNumber(uncertainty.time_s, 3)} s)${uncertainty.keys.some((own) => own.assumed) ? ", some assumed" : ""}`;
  host.append(element("p", { id: "both-errors" }, element("strong", {}, "Both errors"), ...prose(`: numerical ${numerical}; from the coefficients ${known}; validity ${validity.state}.`)));
  if (run.bandless) return;
  const named = uncertainty.keys.filter((own) => own.share_of_variance >= MIN_SHARE);
  const heads = ["number", "value", "standard deviation", "share of the variance"];
  if (named.length) host.append(stacked(table(heads, named.map(knownCells), { label: "uncertain numbers" }), heads));
  host.append(element("p", { class: "hint" }, moreNumbers(uncertainty.keys, named),
    `Band of the tip by ${uncertainty.method}, at its widest, in the direction that is most uncertain.`));
}

// Share of the variance below which a number has no row of its own.
const MIN_SHARE = 0.0005;

function knownCells(own) {
  const unit = own.unit === "1" ? "" : ` ${own.unit}`;
  const deviation = own.value ? `${shortNumber((100 * own.standard_deviation) / Math.abs(own.value), 3)} %` : `${shortNumber(own.standard_deviation, 3)}${unit}`;
  return [breakable(own.key), numberCell(`${shortNumber(own.value, 4)}${unit}`), numberCell(`${deviation}, ${own.assumed ? "assumed" : "stated"}`, "number loose"),
    numberCell(`${shortNumber(100 * own.share_of_variance, 3)} %`)];
}

// A key of the spec, which may be broken behind its dots and underscores.
function breakable(key) {
  return element("span", {}, ...key.split(/(?<=[._])/).flatMap((part, k) => (k ? [element("wbr"), part] : [part])));
}

// What the numbers without a row come to, so that none is missed.
function moreNumbers(all, named) {
  const rest = all.length - named.length;
  if (!rest) return "";
  return `${named.length ? `And ${rest} more` : `${rest} numbers`}, each below ${shortNumber(100 * MIN_SHARE, 2)} % of the variance; summary.json has all. `;
}

// Rows with a bar in millimetres on a logarithmic axis; the accuracy is a line.
function barTable(heads, rows, asked, label) {
  const sizes = rows.flatMap((row) => [row.value, row.measured]).filter((value) => value > 0);
  const high = 10 ** Math.ceil(Math.log10(Math.max(2 * asked, ...sizes)) + 1e-9), low = Math.min(asked / 1e3, high / 1e5);
  const at = (value) => 180 * Math.max(0, Math.min(1, Math.log(value / low) / Math.log(high / low)));
  const made = table(heads, rows.map((row) => [...row.cells, element("td", { class: "bars" }, barOf(row, asked, at)), ...row.after]), { label });
  stacked(made, heads, ["decision", "size beside the accuracy", "why"]);
  made.classList.toggle("reasoned", heads.includes("why"));
  made.append(element("p", { class: "hint" }, `Bars are logarithmic, from ${millimetres(low)} to ${millimetres(high)}; the line is the requested accuracy, ${millimetres(asked)}.`));
  return made;
}

function barOf(row, asked, at) {
  const unbounded = !isKnown(row.value), limit = at(asked);
  const width = unbounded ? 180 : row.value > 0 ? Math.max(1, at(row.value)) : 0;
  const share = (value) => `${shortNumber((100 * value) / asked, 3)} % of the accuracy`;
  const words = `${unbounded ? "no bound" : share(row.value)}${isKnown(row.measured) ? `; measured: ${share(row.measured)}` : ""}`;
  const svg = drawn("svg", { viewBox: "0 0 180 14", width: 180, height: 14, role: "img", class: "bar", "aria-label": words },
    drawn("title", {}, words),
    drawn("rect", { x: 0, y: 3, width, height: 8, class: row.kind || "included" }),
    drawn("path", { class: "limit", d: `M${limit} 0V14` }));
  if (row.measured > 0) svg.append(drawn("circle", { class: "measured", cx: at(row.measured), cy: 7, r: 3.5 }));
  return svg;
}

function showEffects(run) {
  const asked = run.summary.accuracy.requested_m, proof = run.summary.proof || [];
  const measured = new Map(proof.map((row) => [row.name, row.measured_m]));
  const present = run.summary.effects.filter((row) => row.present !== false);
  const size = (row) => (row.contribution_m === null ? Infinity : row.contribution_m);
  present.sort((a, b) => size(b) - size(a));
  const rows = present.map((row) => ({
    cells: [row.name.replace(/_/g, " "), (row.taken ? "included" : "neglected") + (row.mode === "auto" ? "" : `, set ${row.mode}`)],
    value: row.contribution_m, kind: row.taken ? "included" : "neglected", measured: measured.get(row.name),
    after: [numberCell(row.contribution_m === null ? "no bound" : millimetres(row.contribution_m)),
      ...(proof.length ? [numberCell(measuredWords(measured, row.name))] : []), longCell(row.reason)],
  }));
  byId("effects").append(element("p", {}, "How far each effect alone moves the tip, estimated before solving",
    proof.length ? "; the ring and the number beside are what another solution measured, with the effect switched." : "."),
    barTable(["effect", "decision", "size beside the accuracy", "estimated", ...(proof.length ? ["measured"] : []), "why"], rows, asked, "effects"));
  tellNeglected(proof, asked);
  const absent = run.summary.effects.filter((row) => row.present === false).map((row) => row.name.replace(/_/g, " "));
  if (absent.length) byId("effects").append(element("p", { class: "hint" }, `Not applicable: ${absent.join(", ")}.`));
}

// A solution tells displacements apart down to a nanometre.
const MIN_MEASURED = 1e-9;

function measuredWords(measured, name) {
  if (!measured.has(name)) return "not measured";
  const size = measured.get(name);
  if (!isKnown(size)) return "no solution";
  return size < MIN_MEASURED ? "< 1e−6 mm" : millimetres(size);
}

function tellNeglected(proof, asked) {
  const own = proof.filter((row) => !row.taken && isKnown(row.measured_m)), sum = own.reduce((all, row) => all + row.measured_m, 0);
  if (own.length) byId("effects").append(element("p", {}, `The neglected effects add up to ${millimetres(sum)}, ` +
    `${shortNumber((100 * sum) / asked, 3)} % of the accuracy (${own.length} measured, one at a time).`));
}
