"use strict";

// The page of a gait.

function readGait() {
  const gait = JSON.parse(byId("run").textContent);
  for (const name of ["time", "body", "lift", "normal", "friction", "pressure", "barrel", "axes"]) gait[name] = unpacked(gait[name]);
  gait.count = gait.time.values.length;
  gait.colours = gait.legs.map((_, k) => sectionColour(k, gait.legs.length));
  return gait;
}

function showGaitHead(gait) {
  const { summary } = gait, speed = summary.speed_body_lengths_per_s, advance = summary.advance_per_cycle_m;
  showTitle(summary, summary.status === "complete"
    ? `${millimetres(Math.abs(advance))} a cycle, ${advance > 0 ? "forward" : "backward"}; ${shortNumber(speed, 3)} body lengths a second. viscodesign ${summary.provenance.version}.`
    : `No speed is stated. viscodesign ${summary.provenance.version}.`);
  if (summary.status === "refused") banner("failed", element("strong", {}, "No speed is stated: "), `${summary.refusal}.`);
  else if (summary.status !== "complete") banner(summary.status, ...brokenWords(summary.status, gait, summary.refusal));
  showNotes(gait.notes);
}

function gaitPanels(gait) {
  const byLeg = (array, factor) => gait.legs.map((name, k) => ({ name, values: column(array, k).map((v) => factor * v), colour: gait.colours[k] }));
  const bySource = (array, factor) => gait.sources.map((name, k) => ({ name, values: column(array, k).map((v) => factor * v),
    colour: "currentColor", thick: true, dashed: k > 0 }));
  const degrees = 180 / Math.PI;
  return [
    { title: "body forward", unit: "mm", curves: [{ name: "x", values: column(gait.body, 0).map((v) => 1e3 * v), colour: "currentColor", thick: true }] },
    { title: "hips over the ground", unit: "mm", curves: [{ name: "height", values: column(gait.body, 1).map((v) => 1e3 * v), colour: "currentColor", thick: true }] },
    { title: "body's turn", unit: "deg", curves: ["pitch, nose up", "roll, right side down"].map((name, k) => ({ name,
      values: column(gait.body, 2 + k).map((v) => degrees * v), colour: sectionColour(2 * k, 3), thick: true })) },
    { title: "lift of feet", unit: "mm", curves: byLeg(gait.lift, 1e3) },
    { title: "normal force", unit: "N", curves: byLeg(gait.normal, 1) },
    { title: "friction, forward positive", unit: "N", curves: byLeg(gait.friction, 1) },
    { title: "pressure of sources", unit: "kPa gauge", curves: bySource(gait.pressure, 1e-3) },
    { title: "barrel of pumps", unit: "mL", curves: bySource(gait.barrel, 1e6) },
  ];
}

function gaitInstant(gait) {
  return makeInstant([valueLine("time [s]", gait.time, 0, 1, timeDecimals(gait.time.values)),
    valueLine("body x [mm]", gait.body, 0, 1e3, 3), valueLine("height of hips [mm]", gait.body, 1, 1e3, 3),
    valueLine("pitch, nose up [deg]", gait.body, 2, 180 / Math.PI, 3), valueLine("roll, right side down [deg]", gait.body, 3, 180 / Math.PI, 3),
    ...gait.legs.flatMap((name, k) => [valueLine(`lift, ${name} [mm]`, gait.lift, k, 1e3, 3), valueLine(`normal force, ${name} [N]`, gait.normal, k, 1, 4),
      valueLine(`friction, ${name} [N]`, gait.friction, k, 1, 4)]),
    ...gait.sources.flatMap((name, k) => [valueLine(`pressure, ${name} [kPa gauge]`, gait.pressure, k, 1e-3, 3), valueLine(`barrel, ${name} [mL]`, gait.barrel, k, 1e6, 3)])]);
}

function showGaitTables({ summary }) {
  const percent = (value) => (value === null ? "not known" : `${shortNumber(1e2 * value, 3)} %`), volume = (value) => `${shortNumber(1e6 * value, 4)} mL`;
  const told = (value, text) => (value === null ? "not stated" : text);
  byId("gait").append(table(["what", "value"], [
    ["advance per cycle, forward positive", told(summary.advance_per_cycle_m, millimetres(summary.advance_per_cycle_m))],
    ["speed", told(summary.speed_body_lengths_per_s, `${shortNumber(summary.speed_body_lengths_per_s, 3)} body lengths a second`)],
    ["period", `${shortNumber(summary.period_s)} s`], ["length of the body", millimetres(summary.body_length_m)],
    ["advance of each cycle", summary.advances_by_cycle_m.map(millimetres).join(", ") || "no whole cycle"],
    ["last cycle beside the one before", percent(summary.cycle_change)]], { label: "gait" }));
  const ofFeet = ["foot", "lift", "on the ground", "sliding", "largest normal force", "largest friction"];
  byId("feet").append(stacked(table(ofFeet,
    Object.entries(summary.feet).map(([name, own]) => [name, millimetres(own.lift_m), percent(own.stance_share), percent(own.slide_share),
      `${shortNumber(own.peak_normal_n, 3)} N`, `${shortNumber(own.peak_friction_n, 3)} N`]), { label: "feet" }), ofFeet));
  const ofPumps = ["source", "barrel, last cycle", "barrel, whole run", "largest flow", "the spec's pump"];
  byId("pumps").append(stacked(table(ofPumps,
    Object.entries(summary.pumps).map(([name, own]) => [name, volume(own.volume_m3), volume(own.run_volume_m3), `${volume(own.flow_m3_s)}/s`,
      own.is_feasible === null ? "none is stated" : own.is_feasible ? "can do it" : element("strong", { class: "bad" }, "cannot do it")]), { label: "pumps" }), ofPumps));
  showGaitEnergy(summary.energy);
  showSteps(summary, percent);
}

function showGaitEnergy(energy) {
  const joules = (value) => `${shortNumber(1e3 * value, 4)} mJ`;
  const rows = [...Object.keys(energy.work_j).map((name) => [`work of ${name}`, joules(energy.cycle_work_j[name]), joules(energy.work_j[name])]),
    ...Object.keys(energy.loss_j).map((name) => [`lost in ${name}`, joules(energy.cycle_loss_j[name]), joules(energy.loss_j[name])]),
    ["stored, end minus start", joules(energy.cycle_stored_j), joules(energy.stored_j)]];
  byId("energy").append(table(["what", "last cycle", "whole run"], rows, { label: "energy" }),
    element("p", { class: "hint" }, `Not accounted for: at most ${shortNumber(energy.imbalance_rel, 2)} of the work. Bellows whose volume under load is not reciprocal to their strain under pressure do the coupling's work.`));
}

function showSteps(summary, percent) {
  const found = summary.invariants;
  byId("steps").append(table(["step", "advance in the last cycle"], summary.steps_s.map((step, k) =>
    [`${shortNumber(1e3 * step, 3)} ms`, millimetres(summary.advances_by_step_m[k])]), { label: "steps" }),
    element("p", {}, `Halving the step moved the advance by ${percent(summary.step_halving_change)}${summary.body_path_error_m === null ? ""
      : `, the body's path by at most ${millimetres(summary.body_path_error_m)} and the feet's by ${millimetres(summary.feet_path_error_m)}`}.`),
    table(["balance", "largest that was found"], [
      ["feet inside the ground", `${shortNumber(1e6 * found.worst_penetration_m, 2)} µm`], ["gap times force", `${shortNumber(found.worst_gap_force_n_m, 2)} N m`],
      ["friction beyond its cone", `${shortNumber(found.worst_cone_excess_n, 2)} N`], ["momentum", `${shortNumber(found.force_imbalance_rel, 2)} of the weight`],
      ["gas", `${shortNumber(found.gas_mass_imbalance_rel, 2)} of the contents`], ["energy", `${shortNumber(found.energy_imbalance_rel, 2)} of the work`]], { label: "balances" }));
}

function startGait() {
  const gait = readGait(), { summary } = gait;
  showGaitHead(gait);
  const scale = pressureScale(...extremes(gait.pressure.values)), robot = makeRobot(byId("robot"), gait, scale), instant = gaitInstant(gait);
  drawScale(byId("pressure-scale"), scale);
  const player = makePlayer(gait, (row) => showRow(row));
  const host = byId("charts"), charts = gaitPanels(gait).map((panel) => makePanel(host, gait.time.values, panel,
    (time) => { setPlaying(player, false); seek(player, nearestRow(gait.time.values, time)); }));
  const showRow = (row) => {
    drawRobot(robot, row);
    for (const chart of charts) drawCursor(chart, row);
    if (instant.details.open) instant.fill(row);
  };
  const layout = () => { layoutCharts(host, charts); showRow(player.row); };
  instant.details.addEventListener("toggle", () => instant.fill(player.row));
  new ResizeObserver(layout).observe(document.body);
  layout();
  seek(player, summary.status === "failed" || summary.status === "interrupted" ? player.last : 0);
  window.player = player;
  showGaitTables(gait);
  listWarnings(summary.warnings, gait, player);
  tellProvenance([...programRows(summary.provenance), ["cost", `last solution ${shortNumber(summary.cost.solve_cpu_s, 3)} s of processor time, all ${shortNumber(summary.cost.total_s, 3)} s`]], gait.spec);
}

startGait();
