"use strict";

// The tip's way in the plane, x to the right and z downwards, at one scale.

const TIP = { height: 250, left: 44, right: 12, top: 10, bottom: 34 };

function makeTipPath(host, run) {
  const x = column(run.tip, 0).map((v) => 1e3 * v), z = column(run.tip, 1).map((v) => 1e3 * v);
  const svg = drawn("svg", { role: "img", height: TIP.height, class: "tip-path",
    "aria-label": `Path of the tip: x ${extremes(x).map((v) => shortNumber(v, 3)).join(" to ")} mm, z ${extremes(z).map((v) => shortNumber(v, 3)).join(" to ")} mm` });
  host.append(element("figcaption", {}, "path of the tip [mm] ",
    element("span", { class: "legend" }, keyOf({ colour: "currentColor" }), "computed ",
      element("span", { id: "sketch-key", hidden: "" }, keyOf({ colour: "currentColor", dashed: true }), "sketch"))), svg);
  return { svg, x, z, sketch: null };
}

// Equal scales for both coordinates [mm], as large as the room lets them be.
function scaleTip(view, width, xValues, zValues) {
  const { svg } = view, height = heightOf(view), wide = width - TIP.left - TIP.right, high = height - TIP.top - TIP.bottom;
  const xs = limitsOf(...extremes(xValues)), zs = limitsOf(...extremes(zValues));
  const scale = Math.min(wide / (xs[1] - xs[0]), high / (zs[1] - zs[0]));
  const [mx, mz] = [(xs[0] + xs[1]) / 2, (zs[0] + zs[1]) / 2];
  view.px = (v) => TIP.left + wide / 2 + scale * (v - mx);
  view.py = (v) => TIP.top + high / 2 + scale * (v - mz);
  view.width = width;
  const limits = { x: [mx - wide / 2 / scale, mx + wide / 2 / scale], z: [mz - high / 2 / scale, mz + high / 2 / scale] };
  svg.setAttribute("width", width);
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.dataset.domain = [...limits.x, ...limits.z].join(" ");
  svg.dataset.range = [...limits.x.map(view.px), ...limits.z.map(view.py)].join(" ");
  return limits;
}

function heightOf(view) {
  return view.height || TIP.height;
}

function layoutTipPath(view, width) {
  const xs = [...view.x, ...(view.sketch ? view.sketch.x : [])], zs = [...view.z, ...(view.sketch ? view.sketch.z : [])];
  const limits = scaleTip(view, width, xs, zs), { svg } = view;
  view.dot = drawn("circle", { class: "tip", r: 4.5 });
  const own = drawn("path", { class: "path", d: pathThrough(view.x.map(view.px), view.z.map(view.py)) });
  const parts = [tipAxes(view, limits), own];
  if (view.sketch) parts.push(drawn("path", { class: "path sketched", d: pathThrough(view.sketch.x.map(view.px), view.sketch.z.map(view.py)) }));
  svg.replaceChildren(...parts, view.dot);
}

function tipAxes(view, limits) {
  const group = drawn("g", { "aria-hidden": "true" });
  const across = ticks(...limits.x, view.width / 80), down = ticks(...limits.z, 5), base = heightOf(view) - TIP.bottom;
  for (const value of across.found) {
    const x = view.px(value);
    group.append(drawn("path", { class: "grid", d: `M${x} ${TIP.top}V${base}` }),
      drawn("text", { x, y: base + 14, "text-anchor": "middle" }, tickText(value, across)));
  }
  for (const value of down.found) {
    const y = view.py(value);
    group.append(drawn("path", { class: "grid", d: `M${TIP.left} ${y}H${view.width - TIP.right}` }),
      drawn("text", { x: TIP.left - 5, y: y + 3.5, "text-anchor": "end" }, tickText(value, down)));
  }
  group.append(drawn("text", { x: (TIP.left + view.width - TIP.right) / 2, y: heightOf(view) - 4, "text-anchor": "middle" }, "x, towards R"),
    drawn("text", { x: 10, y: (TIP.top + base) / 2, "text-anchor": "middle", transform: `rotate(-90 10 ${(TIP.top + base) / 2})` }, "z, downwards"));
  return group;
}

function drawTip(view, row) {
  if (!view.dot) return;
  view.dot.setAttribute("cx", Number.isFinite(view.x[row]) ? view.px(view.x[row]) : -99);
  view.dot.setAttribute("cy", Number.isFinite(view.z[row]) ? view.py(view.z[row]) : -99);
}
