"use strict";

// Arrays of the run from their base64 texts. Each is {shape, values}, row by row.

function unpacked(packed) {
  const text = atob(packed.bytes);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  const view = new DataView(bytes.buffer);
  const [size, read] = {
    f8: [8, (at) => view.getFloat64(at, true)],
    f4: [4, (at) => view.getFloat32(at, true)],
    u2: [2, (at) => view.getUint16(at, true)],
  }[packed.type];
  const values = new Float64Array(bytes.length / size);
  for (let k = 0; k < values.length; k++) values[k] = read(k * size);
  if (packed.type === "u2") {
    for (let k = 0; k < values.length; k++) values[k] = packed.low + packed.step * values[k];
  }
  return { shape: packed.shape, values };
}

function column(array, index) {
  const width = array.shape[1];
  return Float64Array.from({ length: array.shape[0] }, (_, row) => array.values[row * width + index]);
}

function rowOf(array, row) {
  return array.values.subarray(row * array.shape[1], (row + 1) * array.shape[1]);
}

function shapeAt(run, row) {
  const size = 2 * run.shape.shape[1], first = size * run.shape_of.values[row];
  return run.shape.values.subarray(first, first + size);
}

function readRun() {
  return unpackedRun(JSON.parse(document.getElementById("run").textContent));
}

const RUN_ARRAYS = ["rows", "time", "tip", "inlet_pressure", "pressure", "flow", "arc", "shape", "shape_of"];

function unpackedRun(run) {
  if (!run.time) return { ...run, count: 0 };
  for (const name of RUN_ARRAYS) if (run[name]) run[name] = unpacked(run[name]);
  for (const quantity of run.quantities ?? []) quantity.values = unpacked(quantity.values);
  run.band = run.band && { ...run.band, covariance: unpacked(run.band.covariance) };
  run.count = run.time.values.length;
  run.sections = run.bellows.length / 2;
  return run;
}

function extremes(values) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [0, 0];
}

// A number as people read it: `digits` significant ones, with a true minus sign.
function shortNumber(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e5 || size < 1e-4
    ? value.toExponential(digits - 1).replace(/\.?0+e/, "e").replace("e+", "e")
    : String(Number(value.toPrecision(digits)));
  return text.replace(/-/g, "−");
}

function fixedNumber(value, decimals) {
  return Number.isFinite(value) ? value.toFixed(decimals).replace("-", "−") : "–";
}

// The time of a row in words.
function timeWords(time, row, decimals = timeDecimals(time)) {
  return `t = ${fixedNumber(time[row], decimals)} s`;
}

// Decimals that tell the output times of a run apart; those of a single one to six digits.
function timeDecimals(time) {
  if (time.length === 1) return Math.min(12, (String(Number(Math.abs(time[0]).toPrecision(6))).split(".")[1] || "").length);
  const step = time.length > 1 ? (time[time.length - 1] - time[0]) / (time.length - 1) : 1;
  return Math.min(12, Math.max(0, Math.ceil(-Math.log10(step || 1) - 1e-9) + (step < 1 ? 0 : 1)));
}
