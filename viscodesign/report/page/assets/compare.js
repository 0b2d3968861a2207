"use strict";

// Several motions: their paths, distances from the first, metrics.

// Each shows on white and on black.
const MOTION_COLOURS = ["currentColor", "#d55e00", "#2f86d6", "#1b9e77", "#cc5fa0", "#b8860b", "#8a63d2"];
const PATHS_HEIGHT = 380;

function motionStyle(k) {
  const dashed = Math.floor(k / MOTION_COLOURS.length) % 2 === 1;
  return { colour: MOTION_COLOURS[k % MOTION_COLOURS.length], dashed };
}

function readComparison() {
  const found = JSON.parse(byId("run").textContent);
  found.motions.forEach((motion, k) => {
    const tip = unpacked(motion.tip);
    Object.assign(motion, motionStyle(k), { time: unpacked(motion.time).values,
      x: column(tip, 0).map((v) => 1e3 * v), z: column(tip, 1).map((v) => 1e3 * v) });
    if (motion.band) {
      const corners = unpacked(motion.band.corners);
      Object.assign(motion.band, { x: column(corners, 0).map((v) => 1e3 * v), z: column(corners, 1).map((v) => 1e3 * v) });
    }
  });
  found.differences.forEach((difference, k) => {
    const names = ["time", "distance", "band", "phase", "phase_distance"].filter((name) => difference[name]);
    for (const name of names) difference[name] = unpacked(difference[name]).values;
    Object.assign(difference, motionStyle(k + 1), { title: found.motions[k + 1].title });
  });
  return found;
}

function showComparisonHead(found) {
  const titles = found.motions.map((motion) => motion.label);
  document.title = titles.join(", ");
  byId("name").textContent = `${titles[0]} and ${titles.length === 2 ? titles[1] : `${titles.length - 1} others`}`;
  byId("meaning").textContent = `${found.motions.length} motions, each compared with ${titles[0]}. viscodesign ${found.version}.`;
  for (const motion of found.motions.filter((m) => m.status !== "complete")) {
    byId("banners").append(element("p", { class: `banner ${motion.status}`, role: "alert" }, element("strong", {},
      `${motion.label} ${motion.status === "failed" ? "failed" : "was interrupted"} at ${shortNumber(motion.end_s)} s.`),
      " The part that was computed is compared. ", motion.failure ? `Reason: ${motion.failure}` : ""));
  }
  const outside = found.motions.filter((m) => m.outside.length).map((m) => `${m.label} (${m.outside.join(", ")})`);
  if (outside.length) byId("banners").append(element("p", { class: "banner outside" }, element("strong", {}, "Outside of the model's validity"),
    `: ${outside.join("; ")}. Stated errors do not count it.`));
  if (found.missing.length) byId("banners").append(element("p", { class: "banner interrupted", role: "alert" },
    `The comparison was interrupted, without: ${found.missing.join(", ")}.`));
  const items = found.differences.flatMap((difference) => difference.words.map((text) => element("li", {}, text)));
  byId("differences").append(element("ul", { class: "notices" }, ...items));
  const notes = [`Motions are compared ${found.interpolation}.`, "Metrics are those of each whole motion.", ...found.notes];
  byId("notes").append(element("ul", { class: "notices" }, ...notes.map((text) => element("li", {}, text))));
}

function showComparedMetrics(found) {
  const rows = [
    ["from", ...found.motions.map((m) => (m.source ? `${m.origin} ${m.source}` : m.origin))],
    ["status", ...found.motions.map((m) => m.status)],
    ["stated error", ...found.motions.map((m) => m.error)],
  ];
  if (found.motions.some((m) => m.outside.length)) rows.push(["validity", ...found.motions.map((m) => (m.origin === "table" ? "measured"
    : m.outside.length ? `outside: ${m.outside.join(", ")}` : "inside"))]);
  if (found.motions.some((m) => m.band)) rows.push(["by coefficients", ...found.motions.map((m) => m.coefficients)]);
  for (const name of Object.keys(found.motions[0].metrics)) {
    const words = name.split("_"), [unit, factor] = METRIC_UNITS[words[words.length - 1]] || ["", 1];
    const values = found.motions.map((m) => m.metrics[name]);
    if (values.every((value) => value === null)) continue;
    rows.push([words.slice(0, -1).join(" "), ...values.map((v) => (v === null ? "–" : `${shortNumber(factor * v, 4)} ${unit}`))]);
  }
  const heads = ["number", ...found.motions.map((m) => m.title)];
  byId("metrics").append(stacked(table(heads, rows, { label: "metrics side by side" }), heads));
}

function makePaths(found) {
  const svg = drawn("svg", { role: "img", height: PATHS_HEIGHT, class: "tip-path", "aria-label": `Paths of ${found.motions.map((m) => m.title).join(", ")}` });
  const legend = element("span", { class: "legend" });
  for (const motion of found.motions) legend.append(namedKey(motion.title, keyOf({ ...motion, thick: true })), " ");
  byId("paths").append(element("figcaption", {}, "paths of the tips [mm] ", legend), svg);
  return { svg, height: PATHS_HEIGHT };
}

// The union of a band's ellipses: one path, so that where they overlap it is no darker.
function bandOf(view, motion) {
  const { x, z, points } = motion.band, parts = [];
  for (let k = 0; k < x.length; k += points) {
    parts.push(`${pathThrough([...x.slice(k, k + points)].map(view.px), [...z.slice(k, k + points)].map(view.py))}Z`);
  }
  return drawn("path", { class: "band", fill: motion.colour, "fill-opacity": 0.16, "data-name": motion.title, d: parts.join("") });
}

function layoutPaths(view, found, width) {
  const all = (name) => found.motions.flatMap((m) => [...m[name], ...(m.band ? m.band[name] : [])]);
  const limits = scaleTip(view, width, all("x"), all("z")), banded = found.motions.filter((m) => m.band);
  const paths = found.motions.map((motion) => drawn("path", { class: "curve", stroke: motion.colour, "stroke-width": 1.8,
    "data-name": motion.title, ...(motion.dashed ? { "stroke-dasharray": "6 3" } : {}),
    d: pathThrough(motion.x.map(view.px), motion.z.map(view.py)) }));
  view.dots = found.motions.map((motion) => drawn("circle", { class: "dot", r: 4.5, fill: motion.colour }));
  view.svg.replaceChildren(tipAxes(view, limits), ...banded.map((m) => bandOf(view, m)), ...paths, ...view.dots);
}

// Index of the row nearest to a time; -1 outside of the motion.
function rowAt(time, at) {
  const last = time.length - 1;
  if (at < time[0] - 1e-9 || at > time[last] + 1e-9) return -1;
  let low = 0, high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= at) low = middle; else high = middle;
  }
  return Math.abs(time[low] - at) <= Math.abs(time[high] - at) ? low : high;
}

function distancePanels(found, seekTime) {
  const host = byId("charts"), curves = found.differences.map((d) => ({ name: d.title, colour: d.colour, dashed: d.dashed,
    time: d.time, values: d.distance.map((v) => 1e3 * v) }));
  for (const d of found.differences.filter((own) => own.band)) curves.push({ name: `${d.title}: 95 % by the coefficients`,
    colour: d.colour, dashed: true, time: d.time, values: d.band.map((v) => 1e3 * v) });
  const known = found.differences.map((d) => d.numerical_m).filter((v) => v !== null);
  const note = known.length ? `Numerical errors explain up to ${millimetres(Math.max(...known))} of it.` : "Errors are not stated of all motions.";
  const ends = extremes(found.differences.flatMap((d) => [d.time[0], d.time[d.time.length - 1]]));
  const panels = [makePanel(host, ends, { title: "distance at the same time", unit: "mm", curves, note }, seekTime)];
  const cyclic = found.differences.filter((d) => d.phase);
  if (cyclic.length) panels.push(makePanel(host, [0, 1], { title: "distance at the same phase of the last period", unit: "mm", across: "",
    curves: cyclic.map((d) => ({ name: d.title, colour: d.colour, dashed: d.dashed, time: d.phase, values: d.phase_distance.map((v) => 1e3 * v) })) }, () => {}));
  for (const view of panels) view.low = Math.min(0, view.low);
  return panels;
}

function startComparison() {
  const found = readComparison();
  showComparisonHead(found);
  showComparedMetrics(found);
  const paths = makePaths(found), slider = byId("time");
  const [low, high] = extremes(found.motions.flatMap((m) => [m.time[0], m.time[m.time.length - 1]]));
  const panels = distancePanels(found, (time) => { slider.value = time; show(); });
  [slider.min, slider.max, slider.value] = [low, high, low];
  const show = () => {
    const at = Number(slider.value);
    byId("clock").textContent = `${shortNumber(at, 4)} s`;
    found.motions.forEach((motion, k) => {
      const row = rowAt(motion.time, at);
      paths.dots[k].setAttribute("cx", row < 0 ? -99 : paths.px(motion.x[row]));
      paths.dots[k].setAttribute("cy", row < 0 ? -99 : paths.py(motion.z[row]));
    });
    const x = panels[0].x(Math.min(Math.max(at, panels[0].start), panels[0].end));
    panels[0].cursor.setAttribute("d", `M${place(x, PANEL.top)}V${PANEL.height - PANEL.bottom}`);
  };
  const layout = () => {
    layoutCharts(byId("charts"), panels);
    for (const view of panels) for (const dot of view.dots) dot.remove();
    const width = Math.max(220, Math.floor(byId("paths").clientWidth));
    if (width !== paths.width) layoutPaths(paths, found, width);
    show();
  };
  slider.addEventListener("input", show);
  new ResizeObserver(layout).observe(document.body);
  layout();
}

startComparison();
