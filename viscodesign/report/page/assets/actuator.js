"use strict";

// The actuator at an instant: bellows coloured by pressure, tubes, inlets, axis, tip.
// Works on points of the axis in metres; `body` is {arc, sections, width, bellows, inlets, tubes}.

const BELLOW_GAP = 0.12, AXIS_GAP = 0.08;
const MAX_EDGED = 64, MAX_TUBES = 128, COLOURS = 32;
// From so many sections on the gap between two is less than half a pixel; a piece of the axis of a few pixels is
// as good as straight.
const MERGED_SECTIONS = 140, LONGEST_PIECE = 4, USUAL_HEIGHT = 400, MAX_SPINE = 257;

// The actuator of a run.
function bodyOf(run) {
  return { arc: run.arc.values, sections: run.sections, width: run.width, widths: run.widths, bellows: run.bellows, inlets: run.inlets,
    tubes: run.all_tubes, junctions: junctionsOf(run.all_tubes, run.bellows, run.inlets), surface: run.surface };
}

// Room that all shapes take: {left, right, top, bottom} in metres, z downwards.
function roomOf(points, width) {
  let left = -0.8 * width, right = 0.8 * width, bottom = 0.2 * width, top = -0.75 * width;
  for (let k = 0; k < points.length; k += 2) {
    left = Math.min(left, points[k] - 0.8 * width);
    right = Math.max(right, points[k] + 0.8 * width);
    bottom = Math.max(bottom, points[k + 1] + 0.6 * width);
    top = Math.min(top, points[k + 1] - 0.75 * width);
  }
  return { left, right, top, bottom };
}

function makeActuator(host, body, room, scale, label) {
  const pen = 1000 * body.width, edged = body.bellows.length <= MAX_EDGED;
  const box = [room.left, room.top, room.right - room.left, room.bottom - room.top].map((v) => 1000 * v);
  const svg = drawn("svg", { viewBox: box.join(" "), role: "img", "aria-label": label, class: "body" });
  const trace = drawn("path", { class: "trace", "stroke-width": 0.02 * pen });
  const tubes = drawn("path", { class: "tubes", "stroke-width": 0.035 * pen });
  const spine = drawn("path", { class: "spine", "stroke-width": 0.03 * pen });
  const tip = drawn("circle", { class: "tip", r: 0.055 * pen, "stroke-width": 0.02 * pen });
  // Many bellows share one path for each of a few colours: that many elements would be slow.
  const cells = Array.from({ length: edged ? body.bellows.length : COLOURS }, () => drawn("path", {
    class: edged ? "bellow" : "bellow plain", "stroke-width": 0.012 * pen,
  }));
  const inlets = body.inlets.map((_, k) => drawn("path", {
    class: "inlet", "stroke-width": 0.02 * pen, d: inletMark(body, k),
  }));
  const names = body.inlets.length > 1 ? body.inlets.map((name, k) => drawn("text", {
    class: "inlet-name", x: 1000 * inletPlace(body, k)[0], y: -0.56 * pen,
  }, name.length > 12 ? `${name.slice(0, 11)}…` : name)) : [];
  const ground = body.surface ? [drawn("path", { class: "ground touched", "stroke-width": 0.03 * pen, d: pathOf(body.surface.outline.flat()) })] : [];
  // The foot that touches the ground moves with the tip.
  const foot = body.surface?.foot ? [drawn("circle", { class: "ground foot", r: 1000 * body.surface.foot, "stroke-width": 0.03 * pen })] : [];
  // The page's own size of text would win over the attribute.
  names.forEach((name) => { name.style.fontSize = `${0.15 * pen}px`; });
  svg.append(...ground, trace, clampMark(pen), tubes, ...cells, spine, ...inlets, tip, ...foot, ...names);
  host.append(svg);
  if (body.surface) host.append(element("p", { class: "hint ground-words" }, body.surface.words));
  return { svg, cells, tubes, spine, tips: [tip, ...foot], inlets, trace, body, scale, frame: framesOf(body), cellOf: cellsOf(body.bellows), columns: columnsOf(body) };
}

function clampMark(pen) {
  const half = 0.7 * pen, strokes = [];
  for (let k = 0; k < 9; k++) {
    const foot = -half + (2 * half * k) / 9;
    strokes.push(`M${place(foot, 0)}L${place(foot + (2 * half) / 9, -0.14 * pen)}`);
  }
  return drawn("path", { class: "clamp", "stroke-width": 0.025 * pen, d: `M${place(-half, 0)}L${place(half, 0)}${strokes.join("")}` });
}

function inletPlace(body, index) {
  const first = body.tubes.find(([a, b]) => a === body.inlets[index] || b === body.inlets[index]) || [];
  const side = first.some((end) => /^L\d+$/.test(end)) ? -1 : 1;
  const beside = body.inlets.length > 2 ? (index - (body.inlets.length - 1) / 2) * 0.5 : 0.62 * side;
  return [beside * body.width, -0.36 * body.width];
}

function inletMark(body, index) {
  const [x, z] = inletPlace(body, index).map((v) => 1000 * v), size = 90 * body.width;
  return `M${place(x - size, z - size)}L${place(x + size, z - size)}L${place(x, z + size)}Z`;
}

// Where along the axis the ends of each bellow lie: indices and shares.
function framesOf(body) {
  const { arc, sections } = body, last = arc[arc.length - 1], found = [];
  let from = 0;
  for (let s = 0; s < sections; s++) {
    for (const at of [s + BELLOW_GAP / 2, s + 0.5, s + 1 - BELLOW_GAP / 2]) {
      const wanted = (at / sections) * last;
      while (from < arc.length - 2 && arc[from + 1] < wanted) from++;
      found.push([from, (wanted - arc[from]) / (arc[from + 1] - arc[from])]);
    }
  }
  return found;
}

// Points and unit normals at the places of `framesOf`: x, z, right x, right z of each.
function placesAlong(points, frame) {
  const last = points.length - 2, places = new Float64Array(4 * frame.length);
  for (let f = 0; f < frame.length; f++) {
    const [index, share] = frame[f], rest = 1 - share, k = 2 * index, next = k + 2;
    const before = Math.max(0, k - 2), after = Math.min(last, k + 4);
    const tx = rest * (points[next] - points[before]) + share * (points[after] - points[k]);
    const tz = rest * (points[next + 1] - points[before + 1]) + share * (points[after + 1] - points[k + 1]);
    const size = Math.sqrt(tx * tx + tz * tz) || 1;
    places[4 * f] = rest * points[k] + share * points[next];
    places[4 * f + 1] = rest * points[k + 1] + share * points[next + 1];
    places[4 * f + 2] = tz / size;
    places[4 * f + 3] = -tx / size;
  }
  return places;
}

function corner(places, f, across) {
  const k = 4 * f;
  return place(1000 * (places[k] + across * places[k + 2]), 1000 * (places[k + 1] + across * places[k + 3]));
}

function plainPath(places, { section, sign }, width) {
  const near = (sign * AXIS_GAP * width) / 2, far = (sign * width) / 2, f = 3 * section;
  return `M${corner(places, f, near)}L${corner(places, f, far)}L${corner(places, f + 2, far)}L${corner(places, f + 2, near)}Z`;
}

// Size across the axis of a bellow's section.
function widthOf(body, { section }) {
  return body.widths.length ? body.widths[section] : body.width;
}

// Section and side of every bellow, from names such as R3.
function cellsOf(bellows) {
  return bellows.map((name) => ({ section: Number(name.slice(1)) - 1, sign: name[0] === "R" ? 1 : -1 }));
}

// Bellows of both columns by their section, for actuators whose neighbours are drawn as one.
function columnsOf(body) {
  if (body.sections < MERGED_SECTIONS) return [];
  const columns = [1, -1].map((sign) => ({ sign, bellows: new Array(body.sections) }));
  cellsOf(body.bellows).forEach(({ section, sign }, k) => { columns[sign > 0 ? 0 : 1].bellows[section] = k; });
  return columns;
}

function drawInColours(view, places, pressures) {
  const { low, high } = view.scale, step = (high - low) / COLOURS || 1;
  const texts = new Array(COLOURS).fill("");
  const colourOf = (k) => Math.max(0, Math.min(COLOURS - 1, Math.floor((pressures[k] - low) / step)));
  if (view.columns.length) for (const column of view.columns) addStretches(view, places, column, colourOf, texts);
  else for (let k = 0; k < pressures.length; k++) {
    if (Number.isFinite(pressures[k])) texts[colourOf(k)] += plainPath(places, view.cellOf[k], widthOf(view.body, view.cellOf[k]));
  }
  view.cells.forEach((cell, c) => {
    if (cell.drawn !== texts[c]) cell.setAttribute("d", texts[c]);
    cell.drawn = texts[c];
    if (!cell.hasAttribute("fill")) cell.setAttribute("fill", pressureColour(view.scale, low + (c + 0.5) * step));
  });
}

// Neighbours of one colour and width, as one outline each.
function addStretches(view, places, { sign, bellows }, colourOf, texts) {
  const { body } = view, width = (s) => widthOf(body, { section: s });
  for (let first = 0, last; first < bellows.length; first = last + 1) {
    const colour = colourOf(bellows[first]);
    last = first;
    while (last + 1 < bellows.length && colourOf(bellows[last + 1]) === colour && width(last + 1) === width(first)) last++;
    if (!Number.isNaN(colour)) texts[colour] += stretchPath(places, first, last, sign, width(first), body.sections);
  }
}

function stretchPath(places, first, last, sign, width, sections) {
  const near = (sign * AXIS_GAP * width) / 2, far = (sign * width) / 2, stride = Math.max(1, Math.floor((LONGEST_PIECE * sections) / USUAL_HEIGHT));
  const at = [];
  for (let s = first; s <= last; s += stride) at.push(3 * s);
  at.push(3 * last + 2);
  return `M${at.map((f) => corner(places, f, near)).join("L")}L${at.reverse().map((f) => corner(places, f, far)).join("L")}Z`;
}

function bellowPath(places, { section, sign }, width) {
  const near = (sign * AXIS_GAP * width) / 2, far = (sign * width) / 2, f = 3 * section;
  return `M${corner(places, f, near)}L${corner(places, f, far)}L${corner(places, f + 1, far)}` +
    `L${corner(places, f + 2, far)}L${corner(places, f + 2, near)}L${corner(places, f + 1, near)}Z`;
}

function drawActuator(view, points, pressures, inletPressures) {
  const { body, scale } = view, places = placesAlong(points, view.frame);
  if (body.bellows.length > MAX_EDGED) drawInColours(view, places, pressures);
  else body.bellows.forEach((_, k) => {
    view.cells[k].setAttribute("d", bellowPath(places, view.cellOf[k], widthOf(body, view.cellOf[k])));
    view.cells[k].setAttribute("fill", pressureColour(scale, pressures[k]));
  });
  view.inlets.forEach((mark, k) => mark.setAttribute("fill", pressureColour(scale, inletPressures[k])));
  if (body.tubes.length <= MAX_TUBES) view.tubes.setAttribute("d", tubePaths(body, places));
  view.spine.setAttribute("d", pathOf(points, Math.ceil(points.length / 2 / MAX_SPINE)));
  for (const mark of view.tips) {
    mark.setAttribute("cx", 1000 * points[points.length - 2]);
    mark.setAttribute("cy", 1000 * points[points.length - 1]);
  }
}

// A line through every so many points of an axis, and its end, in millimetres.
function pathOf(points, every = 1) {
  let text = "";
  const last = points.length - 2;
  for (let k = 0; k < last; k += 2 * every) text += (k ? "L" : "M") + place(1000 * points[k], 1000 * points[k + 1]);
  return `${text}L${place(1000 * points[last], 1000 * points[last + 1])}`;
}

// A tube along a column bulges outwards; one between the columns runs straight.
function tubePaths(body, places) {
  const ports = portsOf(body, places);
  let text = "";
  for (const [a, b] of body.tubes) {
    const p = ports.get(a), q = ports.get(b);
    if (!p || !q) continue;
    text += `M${place(1000 * p.x, 1000 * p.z)}`;
    if (p.side && p.side === q.side) {
      const bulge = 0.22 * body.width;
      const x = (p.x + q.x) / 2 + (bulge * p.side * (p.nx + q.nx)) / 2;
      const z = (p.z + q.z) / 2 + (bulge * p.side * (p.nz + q.nz)) / 2;
      text += `Q${place(1000 * x, 1000 * z)} ${place(1000 * q.x, 1000 * q.z)}`;
    } else text += `L${place(1000 * q.x, 1000 * q.z)}`;
  }
  return text;
}

// Bellows have their port outside, inlets theirs above the clamp; junctions lie amid their neighbours.
function portsOf(body, places) {
  const ports = new Map();
  body.inlets.forEach((name, k) => {
    const [x, z] = inletPlace(body, k);
    ports.set(name, { x, z: z + 0.09 * body.width, side: 0 });
  });
  for (const name of body.bellows) {
    const side = name[0] === "R" ? 1 : -1, k = 4 * (3 * (Number(name.slice(1)) - 1) + 1);
    const nx = places[k + 2], nz = places[k + 3], out = (0.5 * side) * widthOf(body, { section: Number(name.slice(1)) - 1 });
    ports.set(name, { x: places[k] + out * nx, z: places[k + 1] + out * nz, nx, nz, side });
  }
  for (const [name, near] of body.junctions) ports.set(name, { x: 0, z: 0, side: 0, near });
  for (let pass = 0; pass < (body.junctions.length ? 4 : 0); pass++) {
    for (const [name, near] of body.junctions) {
      const ends = near.map((end) => ports.get(end)).filter(Boolean);
      const port = ports.get(name);
      port.x = ends.reduce((sum, end) => sum + end.x, 0) / ends.length;
      port.z = ends.reduce((sum, end) => sum + end.z, 0) / ends.length;
    }
  }
  return ports;
}

// Nodes that are neither bellows nor inlets, each with its neighbours.
function junctionsOf(tubes, bellows, inlets) {
  const known = new Set([...bellows, ...inlets]), found = new Map();
  for (const [a, b] of tubes) {
    for (const [own, other] of [[a, b], [b, a]]) {
      if (!known.has(own)) found.set(own, [...(found.get(own) || []), other]);
    }
  }
  return [...found];
}

// The colours as a bar with its numbers [kPa].
function drawScale(host, scale) {
  const stops = [];
  for (let k = 0; k <= 16; k++) {
    const pressure = scale.low + ((scale.high - scale.low) * k) / 16;
    stops.push(drawn("stop", { offset: k / 16, "stop-color": pressureColour(scale, pressure) }));
  }
  const svg = drawn("svg", { viewBox: "0 0 320 40", role: "img", class: "scale",
    "aria-label": `Colours: gauge pressure from ${shortNumber(scale.low / 1e3)} to ${shortNumber(scale.high / 1e3)} kilopascal` });
  svg.append(
    drawn("defs", {}, drawn("linearGradient", { id: "pressures" }, ...stops)),
    drawn("text", { x: 4, y: 11 }, "gauge pressure [kPa]"),
    drawn("rect", { x: 4, y: 16, width: 312, height: 8, fill: "url(#pressures)" }));
  const span = [scale.low / 1e3, scale.high / 1e3], marks = ticks(...span, 6);
  for (const value of marks.found) {
    const x = 4 + (312 * (value - span[0])) / (span[1] - span[0] || 1);
    if (!Number.isFinite(x)) continue;
    const anchor = x < 16 ? "start" : x > 304 ? "end" : "middle";
    svg.append(drawn("path", { class: "axis", d: `M${x} 24V27` }),
      drawn("text", { x, y: 37, "text-anchor": anchor }, tickText(value, marks)));
  }
  host.append(svg);
}
