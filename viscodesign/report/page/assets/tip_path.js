"use strict";

// The tip's way in the plane, x to the right and z downwards, at one scale.

const TIP = { height: 250, left: 44, right: 12, top: 10, bottom: 34 };

function makeTipPath(host, run) {
  const x = column(run.tip, 0).map((v) => 1e3 * v), z = column(run.tip, 1).map((v) => 1e3 * v);
  const svg = drawn("svg", { role: "img", height: TIP.height, class: "tip-path",
    "aria-label": `Path of the tip: x ${extremes(x).map((v) => shortNumber(v, 3)).join(" to ")} mm, z ${extremes(z).map((v) => shortNumber(v, 3)).join(" to ")} mm` });
  host.append(element("figcaption", {}, "path of the tip [mm] ",
    element("span", { class: "legend" }, namedKey("computed ", keyOf({ colour: "currentColor" })),
      element("span", { id: "sketch-key", hidden: "" }, keyOf({ colour: "currentColor", dashed: true }), "sketch "),
      ...(run.band ? [element("span", { id: "band-key" }, bandKey(), "95 % band by what is known of the coefficients")] : []))), svg);
  return { svg, x, z, sketch: null, band: run.band ? ellipsesOf(run.band, x, z) : [] };
}

function bandKey() {
  return drawn("svg", { width: 14, height: 10, class: "key", "aria-hidden": "true" }, drawn("rect", { class: "band", width: 14, height: 10 }));
}

const ELLIPSES = 200, CORNERS = 32;

// Ellipses [mm] about the tip at some of the rows, each {x, z} with its corners.
function ellipsesOf(band, x, z) {
  const [xx, zz, xz] = [0, 1, 2].map((k) => column(band.covariance, k)), found = [];
  const stride = Math.max(1, Math.ceil(xx.length / ELLIPSES));
  for (let row = 0; row < xx.length; row += stride) {
    // A root of the covariance turns the unit circle into the ellipse.
    const a = Math.sqrt(xx[row]), b = a > 0 ? xz[row] / a : 0, c = Math.sqrt(Math.max(zz[row] - b * b, 0));
    const size = 1e3 * band.factor, turns = Array.from({ length: CORNERS }, (_, k) => 2 * Math.PI * k / CORNERS);
    found.push({ x: turns.map((t) => x[row] + size * a * Math.cos(t)),
      z: turns.map((t) => z[row] + size * (b * Math.cos(t) + c * Math.sin(t))) });
  }
  return found;
}

// All of them as one shape: where they overlap, it is no darker.
function bandPath(view) {
  const corners = (own) => own.x.map((v, k) => `${view.px(v).toFixed(1)} ${view.py(own.z[k]).toFixed(1)}`).join("L");
  return drawn("path", { class: "band", d: view.band.map((own) => `M${corners(own)}Z`).join("") });
}

// Equal scales for both coordinates [mm], as large as the room lets them be.
function scaleTip(view, width, xValues, zValues) {
  const { svg } = view, height = heightOf(view), high = height - TIP.top - TIP.bottom;
  const xs = limitsOf(...extremes(xValues)), zs = limitsOf(...extremes(zValues));
  view.left = roomFor(ticks(...zs, 5), TIP.left, 14);
  const wide = width - view.left - TIP.right;
  const scale = Math.min(wide / (xs[1] - xs[0]), high / (zs[1] - zs[0]));
  const [mx, mz] = [(xs[0] + xs[1]) / 2, (zs[0] + zs[1]) / 2];
  view.px = (v) => view.left + wide / 2 + scale * (v - mx);
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
  for (const own of view.band) xs.push(...own.x), zs.push(...own.z);
  const limits = scaleTip(view, width, xs, zs), { svg } = view;
  view.dot = drawn("circle", { class: "tip", r: 4.5 });
  const own = drawn("path", { class: "path", d: pathThrough(view.x.map(view.px), view.z.map(view.py)) });
  const parts = [tipAxes(view, limits), ...(view.band.length ? [bandPath(view)] : []), own];
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
    group.append(drawn("path", { class: "grid", d: `M${view.left} ${y}H${view.width - TIP.right}` }),
      drawn("text", { x: view.left - 5, y: y + 3.5, "text-anchor": "end" }, tickText(value, down)));
  }
  group.append(drawn("text", { x: (view.left + view.width - TIP.right) / 2, y: heightOf(view) - 4, "text-anchor": "middle" }, "x, towards R"),
    drawn("text", { x: 10, y: (TIP.top + base) / 2, "text-anchor": "middle", transform: `rotate(-90 10 ${(TIP.top + base) / 2})` }, "z, downwards"));
  return group;
}

function drawTip(view, row) {
  if (!view.dot) return;
  view.dot.setAttribute("cx", Number.isFinite(view.x[row]) ? view.px(view.x[row]) : -99);
  view.dot.setAttribute("cy", Number.isFinite(view.z[row]) ? view.py(view.z[row]) : -99);
}
