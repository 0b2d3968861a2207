"use strict";

// The page of several actuators, side by side in time.

function readSeveral() {
  const found = JSON.parse(byId("run").textContent), solved = {};
  for (const own of found.actuators) {
    own.run = own.equal_to && solved[own.equal_to] ? solved[own.equal_to] : unpackedRun(own.run);
    solved[own.name] = own.run;
  }
  for (const own of found.shared) [own.time, own.pressure] = [unpacked(own.time).values, unpacked(own.pressure).values];
  found.actuators.forEach((own, k) => { own.colour = sectionColour(k, found.actuators.length); });
  found.moving = found.actuators.filter((own) => own.run.count);
  const longest = found.moving.reduce((a, b) => (a && endOf(a.run.time.values) >= endOf(b.run.time.values) ? a : b), null);
  if (longest) [found.time, found.count] = [longest.run.time, longest.run.count];
  return found;
}

function endOf(time) {
  return time[time.length - 1];
}

function showSeveralHead(found) {
  const { summary } = found;
  showTitle(summary, `${found.actuators.length} actuators side by side. viscodesign ${summary.version}.`);
  if (summary.status !== "complete") banner(summary.status, element("strong", {}, summary.status === "failed" ? "Not all of them have a whole run." : "It was interrupted: not all of them have a whole run."),
    " What is shown is the part that was computed. ", summary.failure || "");
  for (const [name, why] of Object.entries(summary.failures)) if (!(summary.failure || "").includes(name)) banner("failed", element("strong", {}, `${name}: `), why);
  if (summary.interrupted.length) banner("note", `Not begun: ${summary.interrupted.join(", ")}.`);
  for (const own of found.actuators) for (const note of own.run.notes) banner("note", `${own.name}: ${note}.`);
}

function makeFigures(host, found, scale) {
  const rooms = found.moving.map((own) => roomOf(own.run.shape.values, own.run.width));
  const room = { left: Math.min(...rooms.map((r) => r.left)), right: Math.max(...rooms.map((r) => r.right)),
    top: Math.min(...rooms.map((r) => r.top)), bottom: Math.max(...rooms.map((r) => r.bottom)) };
  return found.moving.map((own) => {
    const figure = element("figure", {}, element("figcaption", {}, keyOf({ colour: own.colour, thick: true }), `${own.name} `,
      element("span", { class: "legend" }, `fed by ${own.sources.join(", ")}${own.equal_to ? `; equal to ${own.equal_to}` : ""}`)));
    host.append(figure);
    const view = makeActuator(figure, bodyOf(own.run), room, scale, `${own.name} in motion, its bellows coloured by gauge pressure`);
    view.trace.setAttribute("d", pathThrough(column(own.run.tip, 0).map((v) => 1e3 * v), column(own.run.tip, 1).map((v) => 1e3 * v)));
    return { ...view, own, figure };
  });
}

function severalPanels(found) {
  const curves = (array, k, factor) => found.moving.map((own) => ({ name: own.name, time: own.run.time.values, dashed: Boolean(own.equal_to),
    values: column(own.run[array], k).map((v) => factor * v), colour: own.colour, thick: true }));
  const sources = new Map();
  const through = new Set(found.shared.map((own) => own.name));
  for (const own of found.moving) own.sources.forEach((name, k) => { if (!sources.has(name) && !through.has(name)) sources.set(name, { own, k }); });
  const pressures = [...sources].map(([name, { own, k }]) => ({ name, time: own.run.time.values, pressure: column(own.run.inlet_pressure, k) }));
  const all = [...pressures, ...found.shared].map(({ name, time, pressure }, s) => ({ name, time, values: pressure.map((v) => v / 1e3),
    colour: "currentColor", thick: s === 0, dashed: s % 2 === 1 }));
  const title = `pressure of sources${found.shared.some((own) => own.is_junction) ? " and junctions" : ""}`;
  return [{ title: "tip x", unit: "mm", curves: curves("tip", 0, 1e3) }, { title: "tip z", unit: "mm", curves: curves("tip", 1, 1e3) },
    { title, unit: "kPa gauge", curves: all }];
}

function showSeveral(found) {
  const runs = found.moving.map((own) => own.run), all = runs.flatMap((run) => [...extremes(run.pressure.values), ...extremes(run.inlet_pressure.values)]);
  const scale = pressureScale(...extremes(all)), figures = makeFigures(byId("actuators"), found, scale), time = found.time.values;
  drawScale(byId("pressure-scale"), scale);
  const player = makePlayer(found, (row) => showRow(row)), host = byId("charts");
  const charts = severalPanels(found).map((panel) => makePanel(host, time, panel, (at) => { setPlaying(player, false); seek(player, nearestRow(time, at)); }));
  const showRow = (row) => {
    for (const view of figures) {
      const { run } = view.own, own = nearestRow(run.time.values, time[row]);
      drawActuator(view, shapeAt(run, own), rowOf(run.pressure, own), rowOf(run.inlet_pressure, own));
      view.figure.classList.toggle("ended", time[row] > endOf(run.time.values) + 1e-9);
    }
    for (const chart of charts) cursorAt(chart, time[row]);
  };
  const layout = () => { layoutCharts(host, charts); showRow(player.row); };
  new ResizeObserver(layout).observe(document.body);
  layout();
  seek(player, found.summary.status === "complete" ? 0 : player.last);
  window.player = player;
  return player;
}

// The cursor of a chart whose curves have times of their own.
function cursorAt(view, time) {
  if (!view.cursor) return;
  const x = view.x(time);
  view.cursor.setAttribute("d", `M${place(x, PANEL.top)}V${PANEL.height - PANEL.bottom}`);
  view.panel.curves.forEach((curve, k) => {
    const known = time <= endOf(curve.time) + 1e-9, value = curve.values[nearestRow(curve.time, time)];
    view.dots[k].setAttribute("cx", x);
    view.dots[k].setAttribute("cy", known && Number.isFinite(value) ? view.y(value) : -99);
  });
}

function showEach(found) {
  const rows = found.actuators.map(({ name, equal_to, sources, run: { summary } }) => [name, sources.join(", "), equal_to || "–", summary.status,
    summary.accuracy.estimated_tip_error_m === null ? "not estimated" : `${millimetres(summary.accuracy.estimated_tip_error_m)} (requested ${millimetres(summary.accuracy.requested_m)})`,
    summary.validity.state, longCell(summary.effects.filter((row) => row.taken).map((row) => row.name.replace(/_/g, " ")).join(", "))]);
  const heads = ["actuator", "source", "equal to", "status", "error of the tip", "validity", "effects included"];
  byId("each").append(stacked(table(heads, rows, { label: "actuators" }), heads),
    element("p", { class: "hint" }, "The folder of each has its own page, with its spec, effects and flows."));
  byId("sources").append(table(["source", "feeds", "volume swing", "largest flow"], Object.entries(found.summary.sources).map(([name, own]) =>
    [name, own.feeds.join(", "), `${shortNumber(1e6 * own.volume_swing_m3, 4)} mL`, `${shortNumber(1e6 * own.largest_flow_m3_s, 4)} mL/s`]), { label: "sources" }),
    element("p", { class: "hint" }, "Of fluid at ambient density."));
}

function startSeveral() {
  const found = readSeveral();
  showSeveralHead(found);
  const player = found.count ? showSeveral(found) : null;
  if (!player) byId("motion").append(element("p", { class: "bad" }, "Nothing was computed, so there is no motion to show."));
  for (const id of player ? [] : ["player", "keys"]) byId(id).hidden = true;
  showEach(found);
  const solved = found.actuators.filter((own) => !own.equal_to);
  listWarnings(solved.flatMap(({ name, run }) => run.summary.warnings.map((own) => ({ ...own, where: own.where ? `${name}, ${own.where}` : name }))), found, player);
  tellProvenance([...programRows(found.provenance), ["spec", `SHA-256 ${found.summary.spec_sha256}`]], found.spec);
}

startSeveral();
