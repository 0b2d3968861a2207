"use strict";

// The linear network and sections of constant curvature: no inertia, no weight, no turbulence,
// no collapse. `numbers` are SI; `choice` has factors and the design that a slider asks for.

const SKETCH_STEPS = 1200, REPEATS = 6;
const GAMMA = 2 - Math.SQRT2;

// Nodes in the order in which tubes reach them from the inlets: neighbours get close numbers.
function nodeOrder(numbers, tubes) {
  const near = new Map([...numbers.inlets, ...numbers.bellows, ...numbers.junctions].map((name) => [name, []]));
  for (const [a, b] of tubes) {
    near.get(a).push(b);
    near.get(b).push(a);
  }
  const order = [], seen = new Set(numbers.inlets), queue = [...numbers.inlets];
  for (const rest of [[], ...numbers.bellows.map((name) => [name])]) {
    queue.push(...rest.filter((name) => !seen.has(name)));
    for (const name of queue.splice(0)) visit(name);
  }
  function visit(first) {
    const level = [first];
    if (!seen.has(first)) order.push(first);
    seen.add(first);
    while (level.length) {
      for (const next of near.get(level.shift())) {
        if (seen.has(next)) continue;
        seen.add(next);
        order.push(next);
        level.push(next);
      }
    }
  }
  return order;
}

// Storage of a bellow [m3/Pa]; a gas stores more by its own compression at the baseline.
function storage(numbers, gauge, bellow) {
  const compliance = numbers.compliance[bellow];
  if (numbers.polytropic_exponent === null) return compliance;
  const volume = numbers.rest_volume[bellow] + compliance * gauge;
  return compliance + Math.max(volume, 0) / (numbers.polytropic_exponent * (numbers.ambient + gauge));
}

// C dp/dt = -K p + F u: storage, banded conductances (by rows, up to the diagonal), feeds.
function linearNetwork(numbers, choice) {
  const tubes = numbers.tubes[choice.layout], order = nodeOrder(numbers, tubes);
  const index = new Map(order.map((name, k) => [name, k])), count = order.length;
  const inner = tubes.filter(([a, b]) => index.has(a) && index.has(b));
  const band = Math.max(0, ...inner.map(([a, b]) => Math.abs(index.get(a) - index.get(b)))), row = band + 1;
  const bellows = new Map(numbers.bellows.map((name, k) => [name, storage(numbers, choice.gauge, k)]));
  const network = { order, index, count, band, conductance: new Float64Array(count * row), feeds: [],
    capacity: Float64Array.from(order, (name) => bellows.get(name) || 0) };
  for (const [a, b, length, radius] of tubes) {
    const resistance = (8 * choice.viscosity * length * choice.length_factor) / (Math.PI * (radius * choice.radius_factor) ** 4);
    const ends = [index.get(a), index.get(b)];
    ends.forEach((k, side) => {
      if (k === undefined) return;
      network.conductance[k * row + band] += 1 / resistance;
      if (ends[1 - side] === undefined) network.feeds.push([k, numbers.inlets.indexOf(side ? a : b), 1 / resistance]);
      else if (ends[1 - side] < k) network.conductance[k * row + band - (k - ends[1 - side])] -= 1 / resistance;
    });
  }
  return network;
}

// Cholesky factor of C + s K, in the same band.
function factorised(network, scale) {
  const { count, band, conductance, capacity } = network, row = band + 1;
  const factor = conductance.map((value) => scale * value);
  for (let k = 0; k < count; k++) {
    factor[k * row + band] += capacity[k];
    for (let j = Math.max(0, k - band); j <= k; j++) {
      let sum = factor[k * row + band - (k - j)];
      for (let i = Math.max(0, k - band, j - band); i < j; i++) sum -= factor[k * row + band - (k - i)] * factor[j * row + band - (j - i)];
      factor[k * row + band - (k - j)] = j < k ? sum / factor[j * row + band] : Math.sqrt(sum);
    }
  }
  return factor;
}

function solveBand(network, factor, right) {
  const { count, band } = network, row = band + 1;
  for (let k = 0; k < count; k++) {
    for (let j = Math.max(0, k - band); j < k; j++) right[k] -= factor[k * row + band - (k - j)] * right[j];
    right[k] /= factor[k * row + band];
  }
  for (let k = count - 1; k >= 0; k--) {
    right[k] /= factor[k * row + band];
    for (let j = Math.max(0, k - band); j < k; j++) right[j] -= factor[k * row + band - (k - j)] * right[k];
  }
}

// Flow into every node [m3/s] with all inlets at zero, from the pressures at `from` on.
function inflow(network, pressure, from, found) {
  const { count, band, conductance } = network, row = band + 1;
  found.fill(0);
  for (let k = 0; k < count; k++) {
    found[k] -= conductance[k * row + band] * pressure[from + k];
    for (let j = Math.max(0, k - band); j < k; j++) {
      const value = conductance[k * row + band - (k - j)];
      found[k] -= value * pressure[from + j];
      found[j] -= value * pressure[from + k];
    }
  }
}

// Even samples of a curve that is linear between its times.
function resampled(time, values, wanted) {
  let k = 0;
  return Float64Array.from(wanted, (t) => {
    while (k < time.length - 2 && time[k + 1] < t) k++;
    return values[k] + ((t - time[k]) / (time[k + 1] - time[k])) * (values[k + 1] - values[k]);
  });
}

// Pressures of all bellows at the times: (T, B). TR-BDF2: second order, and stiff modes decay.
function sketchPressures(numbers, choice, time, inlets) {
  const network = linearNetwork(numbers, choice), { count } = network;
  const stretched = Float64Array.from(time, (t) => t * choice.time_factor);
  const steps = stepCount(count), step = (stretched[time.length - 1] - stretched[0]) / steps;
  const even = Float64Array.from({ length: steps + 1 }, (_, k) => stretched[0] + k * step);
  const asked = (p) => choice.gauge + choice.amplitude * (p - numbers.gauge);
  const drive = driven(network, inlets.map((values) => resampled(stretched, values.map(asked), even)));
  const history = new Float64Array((steps + 1) * count), solver = makeSolver(network, step);
  history.fill(choice.gauge, 0, count);
  if (numbers.start !== "rest") settle(network, history, drive, step * steps);
  for (let pass = numbers.start === "periodic" ? REPEATS : 1; pass > 0; pass--) {
    for (let k = 0; k < steps; k++) advance(solver, history, k * count, drive, k * count, (k + 1) * count);
    if (pass > 1) history.copyWithin(0, steps * count);
  }
  return atTimes(history, numbers.bellows.map((name) => network.index.get(name)), count, steps, (row) => (stretched[row] - even[0]) / step, time.length);
}

function stepCount(nodes) {
  return Math.max(200, Math.floor((SKETCH_STEPS * 64) / Math.max(64, nodes)));
}

// Inflow that the inlets alone drive into every node: (steps + 1, nodes).
function driven(network, levels) {
  const { count } = network, found = new Float64Array(levels[0].length * count);
  for (const [k, u, value] of network.feeds) {
    const own = levels[u];
    for (let row = 0; row < own.length; row++) found[row * count + k] += value * own[row];
  }
  return found;
}

// Values of some nodes at places between the steps: (T, nodes).
function atTimes(history, nodes, count, steps, at, rows) {
  const found = new Float64Array(rows * nodes.length);
  for (let row = 0; row < rows; row++) {
    const place = Math.min(at(row), steps), k = Math.min(Math.floor(place), steps - 1), share = place - k;
    for (let b = 0; b < nodes.length; b++) {
      const before = history[k * count + nodes[b]], after = history[(k + 1) * count + nodes[b]];
      found[row * nodes.length + b] = before + share * (after - before);
    }
  }
  return found;
}

function makeSolver(network, step) {
  return { network, half: (GAMMA / 2) * step, factor: factorised(network, (GAMMA / 2) * step),
    flow: new Float64Array(network.count), middle: new Float64Array(network.count) };
}

// The equilibrium at the first inlet pressures: longer and longer steps with these held.
function settle(network, history, drive, span) {
  const { count } = network, state = new Float64Array(2 * count), held = new Float64Array(2 * count);
  state.set(history.subarray(0, count));
  held.set(drive.subarray(0, count));
  held.copyWithin(count, 0, count);
  for (const step of [span, 10 * span, 100 * span, 1e4 * span]) {
    const solver = makeSolver(network, step);
    for (let k = 0; k < 30; k++) {
      advance(solver, state, 0, held, 0, count);
      state.copyWithin(0, count);
    }
  }
  history.set(state.subarray(0, count));
}

// One step, from the pressures at `from` in `history` to those after them; `drive` likewise.
function advance(solver, history, from, drive, before, after) {
  const { network, half, factor, flow, middle } = solver, { count, capacity } = network;
  inflow(network, history, from, flow);
  for (let k = 0; k < count; k++) {
    const between = drive[before + k] + GAMMA * (drive[after + k] - drive[before + k]);
    middle[k] = capacity[k] * history[from + k] + half * (flow[k] + drive[before + k] + between);
  }
  solveBand(network, factor, middle);
  const w = 1 / (GAMMA * (2 - GAMMA)), v = (1 - GAMMA) ** 2 * w;
  for (let k = 0; k < count; k++) middle[k] = capacity[k] * (w * middle[k] - v * history[from + k]) + half * drive[after + k];
  solveBand(network, factor, middle);
  history.set(middle, from + count);
}

// Points of the axis (sections + 1, two coordinates, finer inside) from the pressures of one time.
const POINTS_A_SECTION = 4;

function sketchAxis(numbers, pressures) {
  const { sections } = numbers, length = numbers.length / sections, points = new Float64Array(2 * (POINTS_A_SECTION * sections + 1));
  let angle = 0;
  for (let s = 0; s < sections; s++) {
    const right = pressures[s], left = pressures[sections + s];
    const drawn = numbers.stretch_per_pressure, bent = numbers.curvature_per_pressure;
    const stretch = 1 + drawn[s] * right + drawn[sections + s] * left;
    const turn = ((bent[sections + s] * left - bent[s] * right) * length) / POINTS_A_SECTION;
    const chord = (stretch * length * (Math.abs(turn) > 1e-6 ? Math.sin(turn / 2) / (turn / 2) : 1)) / POINTS_A_SECTION;
    for (let k = POINTS_A_SECTION * s; k < POINTS_A_SECTION * (s + 1); k++) {
      points[2 * k + 2] = points[2 * k] + chord * Math.sin(angle + turn / 2);
      points[2 * k + 3] = points[2 * k + 1] + chord * Math.cos(angle + turn / 2);
      angle += turn;
    }
  }
  return points;
}

// The whole sketched motion: pressures (T, B), and the tip's x and z (T,).
function sketchMotion(numbers, choice, time, inlets) {
  const width = numbers.bellows.length, pressure = sketchPressures(numbers, choice, time, inlets);
  const x = new Float64Array(time.length), z = new Float64Array(time.length);
  for (let row = 0; row < time.length; row++) {
    const axis = sketchAxis(numbers, pressure.subarray(row * width, (row + 1) * width));
    x[row] = axis[axis.length - 2];
    z[row] = axis[axis.length - 1];
  }
  return { pressure, x, z };
}

// The design of the spec.
function unchanged(numbers) {
  return { layout: numbers.layout, viscosity: numbers.viscosity, gauge: numbers.gauge, length_factor: 1, radius_factor: 1, amplitude: 1, time_factor: 1 };
}
