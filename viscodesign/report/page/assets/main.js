"use strict";

function start() {
  const run = readRun();
  showHead(run);
  const player = run.count ? showMotion(run) : null;
  if (!player) byId("motion").append(element("p", { class: "bad" }, "Nothing was computed, so there is no motion to show."));
  for (const id of player ? [] : ["player", "keys", "instant", "sketch"]) byId(id).hidden = true;
  showAccuracy(run);
  showMetrics(run);
  showEffects(run);
  showWarnings(run, player);
  showProvenance(run);
}

function showMotion(run) {
  const body = bodyOf(run);
  const pressures = [...extremes(run.pressure.values), ...extremes(run.inlet_pressure.values)];
  const scale = pressureScale(Math.min(...pressures), Math.max(...pressures)), room = roomOf(run.shape.values, run.width);
  const view = makeActuator(byId("actuator"), body, room, scale, "The actuator in motion, its bellows coloured by gauge pressure");
  view.trace.setAttribute("d", pathThrough(column(run.tip, 0).map((v) => 1e3 * v), column(run.tip, 1).map((v) => 1e3 * v)));
  drawScale(byId("pressure-scale"), scale);
  const tip = makeTipPath(byId("tip-path"), run), instant = instantOf(run);
  const player = makePlayer(run, (row) => showRow(row));
  const charts = makeCharts(byId("charts"), run, (time) => { setPlaying(player, false); seek(player, nearestRow(run.time.values, time)); });
  const sketch = makeSketch(run, body, room, scale, tip, () => layout(true));
  const showRow = (row) => {
    drawActuator(view, shapeAt(run, row), rowOf(run.pressure, row), rowOf(run.inlet_pressure, row));
    for (const chart of charts) drawCursor(chart, row);
    drawTip(tip, row);
    if (instant.details.open) instant.fill(row);
    if (sketch && (sketch.seen || !player.playing)) drawSketch(sketch, row);
  };
  const layout = (again) => {
    layoutCharts(byId("charts"), charts);
    const width = Math.max(220, Math.floor(byId("tip-path").clientWidth));
    if (again || tip.width !== width) layoutTipPath(tip, width);
    showRow(player.row);
  };
  instant.details.addEventListener("toggle", () => instant.fill(player.row));
  new ResizeObserver(() => layout(false)).observe(document.body);
  layout(true);
  seek(player, run.summary.status === "complete" ? 0 : player.last);
  window.player = player;
  return player;
}

start();
