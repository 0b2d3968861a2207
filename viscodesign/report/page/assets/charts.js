"use strict";

// Curves against time. A panel is drawn at its width in pixels, so that texts keep their size;
// its curves are drawn once, and only the cursor and its dots move.

const PANEL = { height: 136, left: 52, right: 10, top: 6, bottom: 20 };
const MAX_CURVES = 16;

// `panel`: {title, unit, curves: [{name, values, colour, thick, dashed, time}], note, across}; a curve may
// have times of its own, and what stands behind the last number of the axis is ` s` unless `across` says.
function makePanel(host, time, panel, seekTime) {
  const figure = element("figure", { class: "chart" });
  const caption = element("figcaption", {}, `${panel.title} [${panel.unit}] `, legendOf(panel));
  const [low, high] = limitsOf(...extremesOf(panel.curves));
  const svg = drawn("svg", { role: "img", height: PANEL.height, "aria-label": describe(panel) });
  const [start, end] = spanOf(time);
  const view = { svg, time, panel, low, high, start, end, dots: [], cursor: null, left: PANEL.left };
  figure.append(caption, svg);
  if (panel.note) figure.append(element("p", { class: "hint" }, panel.note));
  host.append(figure);
  dragging(svg, view, seekTime);
  return view;
}

// Limits of the axis of times; a single one stands in its middle.
function spanOf(time) {
  return time.length > 1 ? [time[0], time[time.length - 1]] : [time[0] - 0.5, time[0] + 0.5];
}

function extremesOf(curves) {
  const all = curves.map((curve) => extremes(curve.values));
  return [Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))];
}

function describe(panel) {
  const parts = panel.curves.map((curve) => {
    const [low, high] = extremes(curve.values);
    return `${curve.name} ${shortNumber(low, 3)} to ${shortNumber(high, 3)}`;
  });
  return `${panel.title} in ${panel.unit} against time: ${parts.join("; ")}`;
}

function legendOf(panel) {
  const legend = element("span", { class: "legend" });
  const inOrder = panel.curves.filter((curve) => !curve.ordered);
  const ordered = panel.curves.filter((curve) => curve.ordered);
  const single = ordered.length > 2 ? inOrder : [...inOrder, ...ordered];
  legend.append(...single.map((curve) => namedKey(curve.name, keyOf(curve))));
  if (ordered.length > 2) {
    const colours = [0, 1, 2, 3, 4].map((k) => keyOf(ordered[Math.round((k * (ordered.length - 1)) / 4)], "key close"));
    legend.append(namedKey(`${ordered[0].name} to ${ordered[ordered.length - 1].name}`, element("span", { class: "keys" }, ...colours)));
  }
  return legend;
}

// A key and its name, which stay in one line.
function namedKey(name, key) {
  return element("span", { class: "pair" }, key, name);
}

function keyOf(curve, kind = "key") {
  const line = drawn("path", { d: "M0 5H14", stroke: curve.colour, "stroke-width": curve.thick ? 3 : 2,
    ...(curve.dashed ? { "stroke-dasharray": "4 2.5" } : {}) });
  return drawn("svg", { width: 14, height: 10, class: kind, "aria-hidden": "true" }, line);
}

function layoutPanel(view, width) {
  const { svg, panel } = view;
  view.width = width;
  view.left = roomFor(ticks(view.low, view.high, 4), PANEL.left);
  view.x = (t) => view.left + ((t - view.start) / (view.end - view.start)) * (width - view.left - PANEL.right);
  view.y = (v) => PANEL.height - PANEL.bottom - ((v - view.low) / (view.high - view.low)) * (PANEL.height - PANEL.top - PANEL.bottom);
  svg.setAttribute("width", width);
  svg.setAttribute("viewBox", `0 0 ${width} ${PANEL.height}`);
  svg.dataset.domain = [view.start, view.end, view.low, view.high].join(" ");
  svg.dataset.range = [view.x(view.start), view.x(view.end), view.y(view.low), view.y(view.high)].join(" ");
  const curves = panel.curves.map((curve) => drawn("path", {
    class: "curve", stroke: curve.colour, "stroke-width": curve.thick ? 2.6 : 1.3,
    "data-name": curve.name, ...(curve.dashed ? { "stroke-dasharray": "6 3" } : {}),
    d: pathThrough(Float64Array.from(curve.time || view.time, view.x), Float64Array.from(curve.values, view.y)),
  }));
  view.cursor = drawn("path", { class: "cursor" });
  view.dots = panel.curves.map((curve) => drawn("circle", { class: "dot", r: curve.thick ? 3.6 : 2.8, fill: curve.colour }));
  // All dots stand above each other: their group moves with the time.
  view.dotted = drawn("g", {}, ...view.dots);
  svg.replaceChildren(axesOf(view), ...curves, view.cursor, view.dotted);
}

function axesOf(view) {
  const group = drawn("g", { "aria-hidden": "true" });
  const up = ticks(view.low, view.high, 4), across = view.time.length > 1 ? ticks(view.start, view.end, view.width / 90)
    : { found: [view.time[0]], decimals: timeDecimals(view.time) };
  for (const value of up.found) {
    const y = view.y(value);
    group.append(drawn("path", { class: value === 0 ? "grid zero" : "grid", d: `M${view.left} ${y}H${view.width - PANEL.right}` }),
      drawn("text", { x: view.left - 5, y: y + 3.5, "text-anchor": "end" }, tickText(value, up)));
  }
  const base = PANEL.height - PANEL.bottom;
  across.found.forEach((value, k) => {
    const x = view.x(value), last = k === across.found.length - 1;
    const anchor = x > view.width - 30 ? "end" : "middle";
    group.append(drawn("path", { class: "axis", d: `M${x} ${base}V${base + 3}` }),
      drawn("text", { x: anchor === "end" ? view.width - 2 : x, y: base + 14, "text-anchor": anchor },
        tickText(value, across) + (last ? view.panel.across ?? " s" : "")));
  });
  return group;
}

function drawCursor(view, row) {
  if (!view.cursor) return;
  const x = view.x(view.time[row]);
  view.cursor.setAttribute("d", `M${place(x, PANEL.top)}V${PANEL.height - PANEL.bottom}`);
  view.dotted.setAttribute("transform", `translate(${x} 0)`);
  view.panel.curves.forEach((curve, k) => {
    const known = Number.isFinite(curve.values[row]);
    view.dots[k].setAttribute("cy", known ? view.y(curve.values[row]) : -99);
  });
}

function dragging(svg, view, seekTime) {
  const follow = (event) => {
    const x = event.clientX - svg.getBoundingClientRect().left;
    const share = (x - view.x(view.start)) / (view.x(view.end) - view.x(view.start));
    seekTime(view.start + share * (view.end - view.start));
  };
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    follow(event);
  });
  svg.addEventListener("pointermove", (event) => {
    if (svg.hasPointerCapture(event.pointerId)) follow(event);
  });
}

// Which of many curves are drawn: the first, the last, and some between.
function someOf(count) {
  if (count <= MAX_CURVES) return Array.from({ length: count }, (_, k) => k);
  return Array.from({ length: MAX_CURVES }, (_, k) => Math.round((k * (count - 1)) / (MAX_CURVES - 1)));
}

function panelsOf(run) {
  const inlets = run.inlets.map((name, k) => ({
    name: run.inlets.length > 1 ? `inlet ${name}` : "inlet", values: column(run.inlet_pressure, k).map((v) => v / 1e3),
    colour: "currentColor", thick: true, dashed: k > 0,
  }));
  const tip = ["x", "z"].map((name, k) => ({
    name, values: column(run.tip, k).map((v) => 1e3 * v), colour: sectionColour(2 * k, 3), thick: true,
  }));
  const panels = [{ title: "tip", unit: "mm", curves: tip }];
  for (const [side, words] of [["R", "right"], ["L", "left"]]) {
    const own = run.bellows.flatMap((name, k) => (name[0] === side ? [k] : []));
    const some = someOf(own.length);
    const curves = some.map((k) => ({ name: run.bellows[own[k]], ordered: true,
      values: column(run.pressure, own[k]).map((v) => v / 1e3), colour: sectionColour(k, own.length) }));
    panels.push({ title: `pressure, ${words} column`, unit: "kPa gauge", curves: [...inlets, ...curves],
      note: some.length < own.length ? `${some.length} of ${own.length} bellows are drawn` : "" });
  }
  const some = someOf(run.tubes.length);
  if (some.length) panels.push({ title: "flow", unit: "mL/s", curves: some.map((k) => ({ name: run.tubes[k], ordered: true,
    values: column(run.flow, k).map((v) => 1e6 * v), colour: sectionColour(k, run.tubes.length) })),
    note: some.length < run.all_tubes.length ? `${some.length} of ${run.all_tubes.length} tubes are drawn` : "" });
  return [...panels, ...(run.quantities ?? []).map(quantityPanel)];
}

// The panel of a quantity that has no other place on the page.
function quantityPanel({ title, unit, names, values }) {
  const some = someOf(names.length);
  return { title, unit, curves: some.map((k) => ({ name: names[k], ordered: true, values: column(values, k), colour: sectionColour(k, names.length) })),
    note: some.length < names.length ? `${some.length} of ${names.length} are drawn` : "" };
}

function makeCharts(host, run, seekTime) {
  const panels = panelsOf(run);
  // Pressures share one axis, so that columns can be compared.
  const views = panels.map((panel) => makePanel(host, run.time.values, panel, seekTime));
  const [low, high] = extremesOf([views[1].low, views[2].low, views[1].high, views[2].high].map((v) => ({ values: [v] })));
  for (const view of views.slice(1, 3)) [view.low, view.high] = [low, high];
  return views;
}

function layoutCharts(host, views) {
  const width = Math.max(240, Math.floor(host.clientWidth));
  for (const view of views) if (view.width !== width) layoutPanel(view, width);
}
