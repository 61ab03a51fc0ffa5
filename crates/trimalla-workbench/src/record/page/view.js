// Words beside the canvas, and controls.
"use strict";

// ---------------------------------------------------------------- words beside it

function fill(list, rows) {
  const items = rows.filter(([, value]) => value !== undefined && value !== "").flatMap(([name, value, kind]) => {
    const [dt, dd] = ["dt", "dd"].map((tag) => document.createElement(tag));
    [dt.textContent, dd.textContent, dd.className] = [name, value, kind || ""];
    return [dt, dd];
  });
  at(list).replaceChildren(...items);
}

const degrees = (angle) => (angle === null || angle === undefined ? "–" : `${angle.toFixed(3)}°`);
const list = (names, word) => (names && names.length ? `${count(names.length, word)}: ${names.slice(0, 12).map((n) => n.join("–")).join(", ")}${names.length > 12 ? ", …" : ""}` : "");

function tell() {
  const step = data.steps[mesh.step - 1];
  const trace = step ? step.trace : {};
  const early = data.is_cut && mesh.step === steps ? ". The run has more steps, which this page does not hold." : "";
  at("words").textContent = (step ? wordsOf(step) : "Before the first step") + early;
  fill("counts", [
    ["Smallest angle", degrees(heights[mesh.step])],
    ["Vertices", `${mesh.points.size}`],
    ["Triangles", `${mesh.triangles.size}`],
  ]);
  const tried = (trace.candidates || []).map(({ point, edge, refused }, i) => [
    `Place ${i + 1}`,
    `${point ? point.map((c) => Number(c.toPrecision(9))).join(", ") : `split of ${(edge || []).join("–")}`}${refused ? `: refused, ${refused}` : trace.inserted ? ": accepted" : ": a subsegment is split first"}`,
    refused ? "alarm" : "",
  ]);
  fill("details", [
    ["Outcome", trace.outcome || "–"],
    ["Selected", trace.selected ? `${trace.selected.join(" ")} (${trace.why})` : ""],
    ["Path", (trace.lepp || []).map((t, i) => `t${i} = ${t.join(" ")}`).join(", ")],
    ["Terminal edge", trace.terminal_edge ? trace.terminal_edge.join("–") : ""],
    ["Subsegment", trace.subsegment ? trace.subsegment.join("–") : ""],
    ["Crossed", list(trace.crossed, "edge")],
    ["Left", (trace.left || []).join(" ")],
    ["Right", (trace.right || []).join(" ")],
    ...tried,
    ["Encroached", list(trace.encroached, "subsegment"), "alarm"],
    ["Inserted", trace.inserted ? `${trace.inserted.vertex} at ${trace.inserted.point.map((c) => Number(c.toPrecision(9))).join(", ")} (${trace.inserted.kind})` : ""],
    ["Deleted", (trace.deleted || []).map((d) => d.vertex).join(" ")],
    ["Given up", trace.given_up || "", "alarm"],
    ["Destroyed", step ? count(trace.destroyed.length, "triangle") : ""],
    ["Made", step ? count(trace.made.length, "triangle") : ""],
  ]);
  const isThere = picked && mesh.triangles.has(key(picked.t));
  fill("picked", isThere
    ? [["Vertices", picked.t.join(" ")], ["Angles", anglesOf(picked.corners).map((a) => a.toFixed(2)).join("°, ") + "°"]]
    : [["", picked ? "it is gone" : "click one"]]);
  at("slider").value = mesh.step;
  at("slider").setAttribute("aria-valuetext", `step ${mesh.step} of ${steps}`);
  at("place").textContent = `${mesh.step} / ${steps}`;
  at("first").disabled = at("back").disabled = mesh.step === 0;
  at("last").disabled = at("next").disabled = mesh.step === steps;
  at("degrees").textContent = `${at("threshold").value}°`;
  const share = (100 * at("threshold").value) / 60;
  at("scale").style.background = `linear-gradient(90deg, ${ink.bad}, ${ink.fair} ${share}%, ${ink.good} ${share}%)`;
  at("rate").textContent = `${rate()} / s`;
}

// ---------------------------------------------------------------- controls

function show() {
  tell();
  if (at("follow").checked) zoomToStep();
  redraw();
}

function goTo(step) {
  seek(mesh, data, step);
  show();
  noteStep();
}

/** Writes the step into the address, so that it can be sent; not more often than browsers allow. */
let noting;
function noteStep() {
  clearTimeout(noting);
  noting = setTimeout(() => {
    try {
      history.replaceState(null, "", `#step=${mesh.step}`);
    } catch {
      // A browser that refuses this for files shows the same steps.
    }
  }, 400);
}

function openFragment() {
  const found = /step=(\d+)/.exec(location.hash);
  if (found) seek(mesh, data, Number(found[1]));
  if (/follow/.test(location.hash)) at("follow").checked = true;
  show();
}

const rate = () => Number((10 ** Number(at("speed").value)).toPrecision(2));

function play(isOn) {
  if (isOn && !playing && mesh.step === steps) seek(mesh, data, 0);
  const wasOn = playing;
  playing = isOn && steps > 0;
  at("play").textContent = playing ? "⏸ Pause" : "▶ Play";
  at("play").setAttribute("aria-label", playing ? "Pause" : "Play");
  if (playing && !wasOn) requestAnimationFrame((now) => tick(now, now, 0));
}

/** Makes the steps that are due; `owed` is a part of one. */
function tick(now, before, owed) {
  if (!playing) return;
  const sum = owed + ((now - before) / 1000) * rate();
  const whole = Math.floor(sum);
  if (whole) goTo(mesh.step + whole);
  if (mesh.step === steps) play(false);
  else requestAnimationFrame((next) => tick(next, now, sum - whole));
}

function move(step) {
  play(false);
  goTo(step);
}

function pick(px, py) {
  const [x, y] = unplace(px, py);
  const isIn = ([a, b, c]) => {
    const sides = [[a, b], [b, c], [c, a]].map(([p, q]) => Math.sign((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])));
    return sides.every((s) => s >= 0) || sides.every((s) => s <= 0);
  };
  picked = [...mesh.triangles.values()].find(({ corners }) => isIn(corners));
  show();
}

const pointers = new Map();
let dragged = 0;
canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
  dragged = 0;
});
canvas.addEventListener("pointermove", (event) => {
  const old = pointers.get(event.pointerId);
  if (!old) return;
  const now = [event.offsetX, event.offsetY];
  const other = [...pointers].find(([id]) => id !== event.pointerId);
  dragged += Math.hypot(now[0] - old[0], now[1] - old[1]);
  if (other) {
    const apart = (p) => Math.hypot(p[0] - other[1][0], p[1] - other[1][1]) || 1;
    zoom(apart(now) / apart(old), ...other[1]);
  } else {
    at("follow").checked = camera.isFit = false;
    camera.x -= (now[0] - old[0]) / camera.scale;
    camera.y += (now[1] - old[1]) / camera.scale;
    redraw();
  }
  pointers.set(event.pointerId, now);
});
for (const name of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(name, (event) => {
    if (name === "pointerup" && pointers.size === 1 && dragged < 4) pick(event.offsetX, event.offsetY);
    pointers.delete(event.pointerId);
  });
}
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event.offsetX, event.offsetY);
}, { passive: false });
curve.addEventListener("pointerdown", (event) => move((steps * event.offsetX) / (curve.clientWidth || 1)));

const buttons = { first: () => move(0), back: () => move(mesh.step - 1), play: () => play(!playing), next: () => move(mesh.step + 1), last: () => move(steps), fit };
for (const [id, act] of Object.entries(buttons)) at(id).addEventListener("click", act);
at("slider").addEventListener("input", (event) => move(Number(event.target.value)));
for (const id of ["follow", "threshold", "before", "fills", "news", "circle", "circles", "steiner", "numbers", "speed"]) at(id).addEventListener("input", show);

const toggle = (id) => () => at(id).click();
const keys = {
  ArrowRight: buttons.next, ArrowLeft: buttons.back, Home: buttons.first, End: buttons.last, " ": buttons.play,
  "+": () => zoom(1.25), "-": () => zoom(0.8), f: fit, z: toggle("follow"), b: toggle("before"), c: toggle("circle"), n: toggle("numbers"),
};
document.addEventListener("keydown", (event) => {
  const { tagName, type } = event.target;
  const isSlider = tagName === "INPUT" && type === "range";
  const isPressed = event.key === " " && (tagName === "BUTTON" || tagName === "INPUT");
  if (event.ctrlKey || event.metaKey || event.altKey || isPressed || (isSlider && /^(Arrow|Home|End)/.test(event.key))) return;
  const act = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!act) return;
  event.preventDefault();
  act();
});
window.addEventListener("hashchange", openFragment);
new ResizeObserver(() => {
  if (camera.isFit) fit();
  draw(); // At once: a canvas that is drawn a frame later is stretched meanwhile.
}).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { readColours(); show(); });

at("title").textContent = data.title;
document.title = `${data.title} – trimalla player`;
at("slider").max = steps;
at("threshold").value = 30;
readColours();
fit();
openFragment();
