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

// A sentence in which keys stand between backticks, as parts for `element`: these as code.
function prose(text) {
  const parts = text.split("`");
  return parts.length % 2 ? parts.map((part, k) => (k % 2 ? element("code", {}, part) : part)) : [text];
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

// Least range of the colours, as a share of the largest pressure.
const MIN_RANGE = 0.02;

// Grey is the ambient, unless all pressures lie far from it: then their middle.
function pressureScale(low, high) {
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const near = low * high > 0 && high - low > 1e-6 * largest && high - low < 0.4 * largest;
  if (near) {
    // Full colours for hardly any difference would tell of a motion that is none.
    const middle = (low + high) / 2, half = Math.max((high - low) / 2, MIN_RANGE * largest / 2);
    return { low: middle - half, high: middle + half, middle, below: half, above: half };
  }
  // Each side has the full colour, unless it is small beside the other.
  const sides = { below: Math.max(-low, 0.4 * largest) || 1, above: Math.max(high, 0.4 * largest) || 1 };
  return { low: Math.min(low, 0), high: Math.max(high, 0), middle: 0, ...sides };
}

// From the clamp to the tip: light teal, blue, purple, dark magenta. Their luminances lie where the contrast
// with white and with the dark ground is above 3.
const LUMINANCES = [0.275, 0.15];

function sectionColour(index, count) {
  const share = count > 1 ? index / (count - 1) : 0.3, hue = 170 + 150 * share;
  return colourOf(hue, 0.62, LUMINANCES[0] + share * (LUMINANCES[1] - LUMINANCES[0]));
}

// The colour of a hue [deg] and a saturation that has a luminance.
function colourOf(hue, saturation, wanted) {
  let low = 0, high = 1;
  for (let pass = 0; pass < 20; pass++) {
    const middle = (low + high) / 2;
    if (luminance(channelsOf(hue, saturation, middle)) < wanted) low = middle; else high = middle;
  }
  return `rgb(${channelsOf(hue, saturation, low).map((v) => Math.round(255 * v)).join(",")})`;
}

// Red, green and blue of a hue, a saturation and a lightness, as CSS defines them.
function channelsOf(hue, saturation, lightness) {
  const reach = saturation * Math.min(lightness, 1 - lightness);
  return [0, 8, 4].map((n) => { const k = (n + hue / 30) % 12; return lightness - reach * Math.max(-1, Math.min(k - 3, 9 - k, 1)); });
}

// Relative luminance, as the contrast of WCAG 2 has it.
function luminance(channels) {
  const linear = channels.map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

// Room for numbers at the left of an axis, and more where it has a name [pixel].
function roomFor(marks, least, name = 0) {
  const longest = Math.max(0, ...marks.found.map((value) => tickText(value, marks).length));
  return Math.max(least, 7 + 6.4 * longest + name);
}
