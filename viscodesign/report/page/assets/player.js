"use strict";

// Time: one shown row at a time, by button, slider, keys or a pointer in a chart.

function makePlayer(run, show) {
  const time = run.time.values, last = run.count - 1;
  const player = { row: 0, playing: false, time, last, show, speeds: speedsOf(time), decimals: timeDecimals(time) };
  const slider = byId("time");
  slider.max = last;
  for (const speed of player.speeds) {
    byId("speed").append(element("option", { value: speed }, speed === 1 ? "1 × (real time)" : `${shortNumber(speed, 2)} ×`));
  }
  player.speed = player.speeds[3];
  byId("speed").value = String(player.speed);
  byId("speed").addEventListener("change", (event) => { player.speed = Number(event.target.value); });
  byId("play").addEventListener("click", () => setPlaying(player, !player.playing));
  slider.addEventListener("input", () => { setPlaying(player, false); seek(player, Number(slider.value)); });
  document.addEventListener("keydown", (event) => pressed(player, event));
  if (last < 1) for (const id of ["player", "keys"]) byId(id).hidden = true;
  return player;
}

// Playing a run takes about eight seconds at the middle one; real time where that is near.
function speedsOf(time) {
  const wanted = (time[time.length - 1] - time[0]) / 8 || 1;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const round = wanted > 0.3 && wanted < 3 ? 1 : [1, 2, 5, 10].find((m) => m * power >= 0.999 * wanted) * power;
  return [0.1, 0.25, 0.5, 1, 2, 4].map((m) => Number((m * round).toPrecision(3)));
}

function seek(player, row) {
  player.row = Math.max(0, Math.min(player.last, row));
  const slider = byId("time"), words = timeWords(player.time, player.row, player.decimals);
  slider.value = player.row;
  slider.setAttribute("aria-valuetext", words);
  for (const own of document.querySelectorAll(".clock")) own.textContent = words;
  player.show(player.row);
}

function nearestRow(time, wanted) {
  let low = 0, high = time.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] <= wanted) low = middle;
    else high = middle;
  }
  return wanted - time[low] <= time[high] - wanted ? low : high;
}

function setPlaying(player, playing) {
  const stops = player.playing && !playing;
  player.playing = playing && player.last > 0;
  if (stops) player.show(player.row);
  byId("play").textContent = player.playing ? "Pause" : "Play";
  byId("play").setAttribute("aria-pressed", String(player.playing));
  if (!player.playing) return;
  let at = player.row >= player.last ? player.time[0] : player.time[player.row], before = null;
  const run = (own) => {
    player.ticking = own;
    const step = (now) => {
      if (!player.playing || player.ticking !== own) return;
      if (before !== null) at += ((now - before) / 1000) * player.speed;
      before = now;
      const end = player.time[player.last];
      if (at >= end) {
        seek(player, player.last);
        setPlaying(player, false);
        return;
      }
      const row = nearestRow(player.time, at);
      if (row !== player.row) seek(player, row);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  };
  run({});
}

function pressed(player, event) {
  const own = event.target.closest && event.target.closest("input, select, textarea, summary, button, pre, .scrolled");
  const isTime = own && own.id === "time";
  if (event.ctrlKey || event.metaKey || event.altKey || (own && !isTime && !(own.id === "play" && event.key !== " " && event.key !== "Enter"))) return;
  const step = event.shiftKey ? 10 : 1;
  const moves = { ArrowLeft: player.row - step, ArrowRight: player.row + step, Home: 0, End: player.last };
  if (event.key === " ") setPlaying(player, !player.playing);
  else if (event.key in moves) {
    setPlaying(player, false);
    seek(player, moves[event.key]);
  } else if (event.key === "+" || event.key === "-") changeSpeed(player, event.key === "+" ? 1 : -1);
  else return;
  event.preventDefault();
}

function changeSpeed(player, direction) {
  const k = player.speeds.indexOf(player.speed) + direction;
  player.speed = player.speeds[Math.max(0, Math.min(player.speeds.length - 1, k))];
  byId("speed").value = String(player.speed);
}
