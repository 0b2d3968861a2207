"use strict";

// Elements of HTML and SVG. Text is set as text, never as markup.

const SVG = "http://www.w3.org/2000/svg";

function element(name, attributes = {}, ...children) {
  return filled(document.createElement(name), attributes, children);
}

function drawn(name, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, name), attributes, children);
}

function filled(made, attributes, children) {
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children.map((child) => child ?? ""));
  return made;
}

function byId(id) {
  return document.getElementById(id);
}

// A point of a path to a hundredth of a pixel.
function place(x, y) {
  return `${Math.round(x * 100) / 100} ${Math.round(y * 100) / 100}`;
}

// Path through points, with gaps where a coordinate is not finite.
function pathThrough(xs, ys) {
  let text = "", pen = false;
  for (let k = 0; k < xs.length; k++) {
    if (Number.isFinite(xs[k]) && Number.isFinite(ys[k])) {
      text += (pen ? "L" : "M") + place(xs[k], ys[k]);
      pen = true;
    } else pen = false;
  }
  return text;
}

function multiples(low, high, step) {
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step);
  return found;
}

// Round numbers between two limits, about `count` of them.
function ticks(low, high, count) {
  const rough = (high - low) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const steps = [0.5, 1, 2, 5, 10].map((m) => m * power);
  let step = steps.find((s) => s >= rough * 0.999);
  if (multiples(low, high, step).length < 3) step = steps[Math.max(0, steps.indexOf(step) - 1)];
  return { found: multiples(low, high, step), decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

function tickText(value, { found, decimals }) {
  const largest = Math.max(...found.map(Math.abs));
  if (largest >= 1e7 || decimals > 5) return shortNumber(value, 3);
  return fixedNumber(value === 0 ? 0 : value, decimals);
}

// Limits with a margin; a range of rounding alone is drawn as a level line.
function limitsOf(low, high, share = 0.06) {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const margin = high - low > 1e-6 * largest ? share * (high - low) : 0.1 * largest || 1;
  return [low - margin, high + margin];
}

// Blue below, orange above, grey between: each shows on white and on black.
const LOW = [38, 102, 230], MIDDLE = [163, 163, 168], HIGH = [222, 84, 12];

function mixed(a, b, share) {
  return `rgb(${a.map((v, k) => Math.round(v + share * (b[k] - v))).join(",")})`;
}

function pressureColour(scale, pressure) {
  if (!Number.isFinite(pressure)) return "none";
  const away = pressure - scale.middle;
  return away < 0 ? mixed(MIDDLE, LOW, Math.min(1, -away / scale.below)) : mixed(MIDDLE, HIGH, Math.min(1, away / scale.above));
}

// Grey is the ambient, unless all pressures lie far from it: then their middle.
function pressureScale(low, high) {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const near = low * high > 0 && high - low > 1e-6 * largest && high - low < 0.4 * largest;
  if (near) return { low, high, middle: (low + high) / 2, below: (high - low) / 2, above: (high - low) / 2 };
  // Each side has the full colour, unless it is small beside the other.
  const sides = { below: Math.max(-low, 0.4 * largest) || 1, above: Math.max(high, 0.4 * largest) || 1 };
  return { low: Math.min(low, 0), high: Math.max(high, 0), middle: 0, ...sides };
}

// From the clamp to the tip: teal, blue, purple, magenta; each shows on white and on black.
function sectionColour(index, count) {
  const hue = 170 + 150 * (count > 1 ? index / (count - 1) : 0.3);
  return `hsl(${Math.round(hue)} 62% 48%)`;
}
