"use strict";

// A robot from its side at an instant: body, legs, feet, the ground and its forces.

const FORCE_LENGTH = 0.5;

// Room for all that moves [mm]: {left, right, top}, the ground at 0, downwards positive.
function robotRoom(gait) {
  const xs = gait.axes.values.filter((_, k) => k % 2 === 0), ups = gait.axes.values.filter((_, k) => k % 2 === 1);
  const [left, right] = extremes(xs), [, top] = extremes(ups), room = 1e3 * 0.25 * gait.body_length;
  return { left: 1e3 * left - room, right: 1e3 * right + room, top: -1e3 * top - room };
}

function makeRobot(host, gait, scale) {
  const room = robotRoom(gait), foot = Math.max(1e3 * gait.foot_radius, 2), below = 2 * foot;
  const svg = drawn("svg", { viewBox: [room.left, room.top, room.right - room.left, below - room.top].join(" "), role: "img",
    class: "body robot", "aria-label": "The robot in motion from its right side, with its feet, the ground and its forces" });
  const pen = 1e3 * gait.body_length / 60;
  const legs = gait.legs.map((_, k) => drawn("path", { class: "leg", stroke: gait.colours[k], "stroke-width": 1.6 * pen }));
  const feet = gait.legs.map((_, k) => drawn("circle", { class: "foot", r: foot, stroke: gait.colours[k], "stroke-width": 0.5 * pen }));
  const forces = gait.legs.map(() => drawn("path", { class: "force", "stroke-width": 0.5 * pen }));
  const hips = gait.legs.map(() => drawn("circle", { class: "hip", r: 1.3 * pen, "stroke-width": 0.2 * pen }));
  const body = drawn("path", { class: "rigid", "stroke-width": 2.6 * pen });
  svg.append(groundLine(room, pen), ...legs, ...feet, body, ...hips, ...forces);
  host.append(element("figcaption", {}, "legs ", element("span", { class: "legend" }, ...gait.legs.map((name, k) => namedKey(name, keyOf({ colour: gait.colours[k], thick: true }))))), svg);
  const largest = Math.max(1e-12, ...extremes(gait.normal.values).map(Math.abs));
  return { gait, scale, legs, feet, forces, hips, body, pen, perNewton: (FORCE_LENGTH * -(room.top)) / largest };
}

function groundLine(room, pen) {
  const marks = [];
  for (let x = 50 * Math.ceil(room.left / 50); x <= room.right; x += 50) marks.push(`M${place(x, 0)}L${place(x - 1.5 * pen, 1.5 * pen)}`);
  return drawn("path", { class: "ground", "stroke-width": 0.35 * pen, d: `M${place(room.left, 0)}H${room.right}${marks.join("")}` });
}

function drawRobot(view, row) {
  const { gait } = view, points = gait.axes.shape[2], size = 2 * points, hips = [];
  gait.legs.forEach((_, k) => {
    const from = (row * gait.legs.length + k) * size, own = gait.axes.values.subarray(from, from + 2 * gait.points[k]);
    const xs = own.filter((_, c) => c % 2 === 0).map((v) => 1e3 * v), ys = own.filter((_, c) => c % 2 === 1).map((v) => -1e3 * v);
    const at = (array) => array.values[row * gait.legs.length + k], bears = at(gait.normal) > 0;
    view.legs[k].setAttribute("d", pathThrough(xs, ys));
    const [x, y] = [xs[xs.length - 1], ys[ys.length - 1]];
    view.feet[k].setAttribute("cx", x);
    view.feet[k].setAttribute("cy", y);
    view.feet[k].setAttribute("fill", bears ? gait.colours[k] : "none");
    view.forces[k].setAttribute("d", bears ? arrow(x, 0, view.perNewton * at(gait.friction), -view.perNewton * at(gait.normal), 1.5 * view.pen) : "");
    view.hips[k].setAttribute("cx", xs[0]);
    view.hips[k].setAttribute("cy", ys[0]);
    view.hips[k].setAttribute("fill", pressureColour(view.scale, gait.pressure.values[row * gait.sources.length + gait.source_of[k]]));
    hips.push([xs[0], ys[0]]);
  });
  hips.sort((a, b) => a[0] - b[0]);
  view.body.setAttribute("d", pathThrough(hips.map(([x]) => x), hips.map(([, y]) => y)));
}

function arrow(x, y, dx, dy, head) {
  const size = Math.hypot(dx, dy), [ux, uy] = [dx / size, dy / size], short = Math.min(head, size / 2);
  if (!(size > 0)) return "";
  const side = (sign) => place(x + dx - short * (ux + 0.5 * sign * uy), y + dy - short * (uy - 0.5 * sign * ux));
  return `M${place(x, y)}L${place(x + dx, y + dy)}M${side(1)}L${place(x + dx, y + dy)}L${side(-1)}`;
}
