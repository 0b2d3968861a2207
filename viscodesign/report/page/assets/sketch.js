"use strict";

// The live sketch: sliders, and an actuator drawn beside the computed one.

function sketchSliders(numbers) {
  const tube = numbers.tubes[numbers.layout], kPa = (p) => `${shortNumber(p / 1e3, 3)} kPa`;
  const many = (k) => (tube.every((own) => own[k] === tube[0][k]) ? (f) => `${shortNumber(1e3 * f * tube[0][k], 3)} mm` : (f) => `${shortNumber(f, 3)} × the spec's`);
  const factor = (key, name, text, most) => ({ key, name, text, from: -1, to: 1, read: (at) => most ** at, step: 0.01, at: 0 });
  const reach = 20e3;
  return [
    { ...factor("viscosity", "Viscosity", (v) => `${shortNumber(v, 3)} Pa s`, 10), read: (at) => numbers.viscosity * 10 ** at },
    factor("length_factor", "Tube length", many(2), 4),
    factor("radius_factor", "Tube radius", many(3), 2),
    { key: "gauge", name: "Gauge pressure", text: kPa, from: -1, to: 1, step: 0.02, at: 0, read: (at) => numbers.gauge + reach * at },
    { key: "amplitude", name: "Amplitude", text: (v) => `${shortNumber(v, 3)} × the spec's`, from: 0, to: 2, step: 0.02, at: 1, read: (at) => at },
    factor("time_factor", "Period", (v) => `${shortNumber(v, 3)} × the spec's`, 8),
  ];
}

function makeSketch(run, body, room, scale, tip, changed) {
  const numbers = run.sketch;
  if (numbers.reason) {
    byId("sketch-words").textContent = `There is no sketch of this run: ${numbers.reason}.`;
    byId("sketch-body").hidden = true;
    return null;
  }
  const inlets = run.inlets.map((_, k) => column(run.inlet_pressure, k));
  const sketch = { run, numbers, inlets, choice: unchanged(numbers), tip, motion: null, seen: false, room: { ...room } };
  const even = Float64Array.from({ length: POINTS_A_SECTION * run.sections + 1 }, (_, k) => k);
  const own = { ...body, arc: even };
  const label = "Sketch of the actuator: linear network and arcs, not the simulation";
  byId("sketch-figure").append(element("figcaption", {}, "the sketch at the same phase, colours as above; dashed: the computed axis"));
  sketch.view = makeActuator(byId("sketch-figure"), own, room, scale, label);
  sketch.ghost = drawn("path", { class: "ghost", "stroke-width": 40 * run.width });
  sketch.view.svg.append(sketch.ghost);
  const words = element("p", { "aria-live": "polite", class: "distance" });
  const update = () => { solveSketch(sketch, words); changed(); };
  byId("sliders").append(...sketchSliders(numbers).map((row) => sketchSlider(sketch, row, update)));
  if (numbers.layout !== "custom") byId("sliders").append(layoutChoice(sketch, update));
  byId("sliders").append(resetButton(sketch, update), words);
  sketch.trust = element("p", { class: "trust" });
  byId("sketch-words").after(sketch.trust);
  byId("sketch-words").textContent = "A quick estimate for trying designs: the linear network and sections of constant curvature" +
    (numbers.polytropic_exponent === null ? "" : ", with the gas's own storage at the baseline") +
    ". No inertia, weight, turbulence, collapse or choking. Confirm what you find with viscodesign simulate.";
  byId("sketch-key").hidden = false;
  solveSketch(sketch, words);
  watchSketch(sketch);
  return sketch;
}

// What differences between designs the sketch can tell, by its error at the spec's own values.
const POOR_SHARE = 0.05;

function trustWords(largest, share) {
  const own = `At the spec's own values the sketch is off by ${shortNumber(largest, 3)} mm, ${shortNumber(100 * share, 2)} % of the length`;
  return share > POOR_SHARE
    ? `${own}: too far to rank designs. It shows which way a change works, no more; rank designs with viscodesign sweep.`
    : `${own}: it does not tell designs apart that differ by less.`;
}

function sketchSlider(sketch, row, update) {
  const input = element("input", { type: "range", min: row.from, max: row.to, step: row.step, value: row.at, id: `sketch-${row.key}` });
  const output = element("output", { for: input.id });
  const tell = () => {
    output.textContent = row.text(row.read(Number(input.value)));
    input.setAttribute("aria-valuetext", output.textContent);
  };
  input.addEventListener("input", () => {
    sketch.choice[row.key] = row.read(Number(input.value));
    tell();
    update();
  });
  input.addEventListener("reset-sketch", () => { input.value = row.at; tell(); });
  tell();
  return element("div", { class: "slider" }, element("label", { for: input.id }, row.name), input, output);
}

function layoutChoice(sketch, update) {
  const buttons = ["straight", "crossed"].map((name) => {
    const radio = element("input", { type: "radio", name: "sketch-layout", value: name, id: `sketch-${name}` });
    radio.checked = name === sketch.numbers.layout;
    radio.addEventListener("change", () => { sketch.choice.layout = name; update(); });
    radio.addEventListener("reset-sketch", () => { radio.checked = name === sketch.numbers.layout; });
    return [radio, element("label", { for: radio.id }, name)];
  });
  return element("fieldset", { class: "slider" }, element("legend", {}, "Layout"), ...buttons.flat());
}

function resetButton(sketch, update) {
  const button = element("button", { type: "button", id: "sketch-reset" }, "Back to the spec");
  button.addEventListener("click", () => {
    sketch.choice = unchanged(sketch.numbers);
    for (const input of byId("sliders").querySelectorAll("input")) input.dispatchEvent(new Event("reset-sketch"));
    update();
  });
  return button;
}

function solveSketch(sketch, words) {
  const { run, numbers, choice } = sketch, began = performance.now();
  sketch.motion = sketchMotion(numbers, choice, run.time.values, sketch.inlets);
  sketch.solved_ms = performance.now() - began;
  sketch.view.body.tubes = numbers.tubes[choice.layout];
  growRoom(sketch);
  const x = sketch.motion.x.map((v) => 1e3 * v), z = sketch.motion.z.map((v) => 1e3 * v);
  sketch.tip.sketch = { x, z };
  let largest = 0;
  for (let k = 0; k < x.length; k++) largest = Math.max(largest, Math.hypot(x[k] - sketch.tip.x[k], z[k] - sketch.tip.z[k]));
  const same = JSON.stringify(choice) === JSON.stringify(unchanged(numbers)), share = largest / (1e3 * run.length);
  words.textContent = `Largest distance of the sketched tip from the computed one, at the same phase: ${shortNumber(largest, 3)} mm, ` +
    `${shortNumber(100 * share, 2)} % of the length${same ? " (the sketch's own error, at the spec's values)" : ""}.`;
  if (same) sketch.trust.textContent = trustWords(largest, share);
  window.sketch = sketch;
}

// The picture grows with a sketch that reaches further, and never shrinks under the reader's hand.
function growRoom(sketch) {
  const { run, numbers, motion, view } = sketch, width = numbers.bellows.length, every = Math.ceil(run.count / 200);
  for (let row = 0; row < run.count; row += every) {
    const own = roomOf(sketchAxis(numbers, motion.pressure.subarray(row * width, (row + 1) * width)), run.width);
    for (const side of ["left", "top"]) sketch.room[side] = Math.min(sketch.room[side], own[side]);
    for (const side of ["right", "bottom"]) sketch.room[side] = Math.max(sketch.room[side], own[side]);
  }
  const { left, right, top, bottom } = sketch.room;
  view.svg.setAttribute("viewBox", [left, top, right - left, bottom - top].map((v) => 1000 * v).join(" "));
}

// While the motion plays, the sketch below it is drawn where it can be seen: it would cost as much again.
function watchSketch(sketch) {
  const look = (entries) => { sketch.seen = entries[entries.length - 1].isIntersecting; };
  new IntersectionObserver(look, { rootMargin: "200px" }).observe(byId("sketch-figure"));
}

function drawSketch(sketch, row) {
  const { numbers, motion, run, choice } = sketch, width = numbers.bellows.length;
  const pressures = motion.pressure.subarray(row * width, (row + 1) * width);
  const inlets = sketch.inlets.map((values) => choice.gauge + choice.amplitude * (values[row] - numbers.gauge));
  sketch.ghost.setAttribute("d", pathOf(shapeAt(run, row)));
  drawActuator(sketch.view, sketchAxis(numbers, pressures), pressures, inlets);
}
