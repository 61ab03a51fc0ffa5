// The camera, and what is drawn on both canvases.
"use strict";

const data = JSON.parse(document.getElementById("data").textContent);
const mesh = startOf(data);
const at = (id) => document.getElementById(id);
const [canvas, curve] = [at("mesh"), at("curve")];
const steps = data.steps.length;
/** Scale in pixels a unit, and the point in the middle of the canvas. */
const camera = { scale: 1, x: 0, y: 0, fitted: 1, isFit: true };
let [playing, picked, due, ink] = [false, undefined, false, {}];

// ---------------------------------------------------------------- the camera

function boxOf(points) {
  const box = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
  for (const [x, y] of points) {
    [box.left, box.right] = [Math.min(box.left, x), Math.max(box.right, x)];
    [box.low, box.high] = [Math.min(box.low, y), Math.max(box.high, y)];
  }
  return box.left <= box.right ? box : { left: 0, right: 1, low: 0, high: 1 };
}

/** The box around all points of the run. */
const box = (() => {
  const all = [data.start.points.map(([, ...p]) => p), data.drawing ? data.drawing.points : []];
  for (const { delta } of data.steps) all.push(delta.points.map(([, ...p]) => p));
  return boxOf(all.flat());
})();

/** Shows a box, which takes a share of the canvas. */
function fitTo(box, share) {
  const [w, h] = [box.right - box.left, box.high - box.low];
  const scale = share * Math.min(canvas.clientWidth / (w || h || 1), canvas.clientHeight / (h || w || 1));
  [camera.scale, camera.x, camera.y, camera.isFit] = [scale || 1, box.left + w / 2, box.low + h / 2, false];
  redraw();
}

function fit() {
  fitTo(box, 0.92);
  [camera.fitted, camera.isFit] = [camera.scale, true];
}

/** Zooms to what the present step is about; whole slices of a mesh are shown as a whole. */
function zoomToStep() {
  const { trace } = data.steps[mesh.step - 1] || {};
  if (!trace) return fit();
  const named = [...(trace.lepp || []), ...(trace.selected ? [trace.selected] : []), ...trace.made, ...(trace.crossed || []), ...(trace.subsegment ? [trace.subsegment] : [])];
  const { vertex, edge, triangle } = trace.shape || {};
  named.push(...[edge, triangle, vertex === undefined ? undefined : [vertex]].filter(Boolean));
  const points = named.flat().map((v) => mesh.points.get(v)).filter(Boolean);
  if (trace.inserted) points.push(trace.inserted.point);
  for (const { point } of trace.candidates || []) if (point) points.push(point);
  if (points.length && named.length < 200) fitTo(boxOf(points), 0.6);
  else fit();
}

/** From the drawing to the canvas; y points upwards in the drawing. */
function place([x, y]) {
  const [w, h] = [canvas.clientWidth, canvas.clientHeight];
  return [w / 2 + (x - camera.x) * camera.scale, h / 2 - (y - camera.y) * camera.scale];
}

function unplace(px, py) {
  const [w, h] = [canvas.clientWidth, canvas.clientHeight];
  return [camera.x + (px - w / 2) / camera.scale, camera.y - (py - h / 2) / camera.scale];
}

/** Zooms by a factor; what is at a place of the canvas stays there. */
function zoom(factor, px = canvas.clientWidth / 2, py = canvas.clientHeight / 2) {
  const [x, y] = unplace(px, py);
  camera.scale = Math.min(Math.max(camera.scale * factor, camera.fitted / 50), camera.fitted * 1e9);
  const [u, v] = unplace(px, py);
  [camera.x, camera.y, camera.isFit] = [camera.x + x - u, camera.y + y - v, false];
  redraw();
}

// ---------------------------------------------------------------- drawing

function redraw() {
  if (due) return;
  due = true;
  requestAnimationFrame(() => {
    due = false;
    draw();
  });
}

/** A context with the size of its canvas, in pixels of the page. */
function contextOf(element) {
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [element.clientWidth, element.clientHeight];
  if (element.width !== Math.round(w * ratio)) element.width = Math.round(w * ratio);
  if (element.height !== Math.round(h * ratio)) element.height = Math.round(h * ratio);
  const g = element.getContext("2d");
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.clearRect(0, 0, w, h);
  g.lineJoin = g.lineCap = "round";
  return g;
}

function readColours() {
  const style = getComputedStyle(document.documentElement);
  const names = "paper ink faint rule edge heavy hidden good fair bad made path selected terminal alarm circle accent";
  ink = Object.fromEntries(names.split(" ").map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** A colour between two, given as #rrggbb. */
function mix(from, to, share) {
  const part = (colour, i) => parseInt(colour.slice(1 + 2 * i, 3 + 2 * i), 16);
  return `rgb(${[0, 1, 2].map((i) => Math.round(part(from, i) * (1 - share) + part(to, i) * share)).join(",")})`;
}

/** The colour of a smallest angle: from bad to fair below the threshold, good above. */
function colourOf(angle) {
  const bound = Number(at("threshold").value);
  return angle < bound ? mix(ink.bad, ink.fair, Math.floor((12 * angle) / bound) / 12) : ink.good;
}

function draw() {
  const [shown, step] = [mesh.step, data.steps[mesh.step - 1]];
  const isBefore = at("before").checked && step;
  // What a step is about may have been destroyed by it, and is there before it.
  const known = new Map(mesh.points);
  if (step) {
    back(mesh, data);
    for (const [v, p] of mesh.points) if (!known.has(v)) known.set(v, p);
    if (!isBefore) forward(mesh, data);
  }
  drawMesh(contextOf(canvas), step, known, isBefore);
  seek(mesh, data, shown);
  drawCurve();
}

function drawMesh(g, step, known, isBefore) {
  const trace = step ? step.trace : {};
  const seen = inView();
  if (at("fills").checked) fillTriangles(g, seen);
  const path = trace.lepp || [];
  fillNamed(g, path, known, ink.path, 0.28);
  if (trace.selected) fillNamed(g, [trace.selected], known, ink.selected, 0.55);
  if (at("circles").checked) for (const { corners } of seen) ring(g, circleOf(corners), ink.circle, 0.6, 0.45);
  drawInput(g);
  // Where there is hardly a pixel between edges, they would hide the colours, and take long.
  if (canvas.clientWidth * canvas.clientHeight > 12 * seen.length) {
    for (const { colour, path } of pathsOf(seen, () => ink.edge)) strokePath(g, path, colour, 0.8);
  }
  if (at("news").checked && step) {
    const news = isBefore ? trace.destroyed : trace.made;
    const colour = isBefore ? ink.alarm : ink.made;
    strokePath(g, fillNamed(g, news, known, colour, 0.16), colour, 2.2);
  }
  strokeEdges(g, [...mesh.marked.values()], mesh.points, ink.heavy, 2.4);
  strokeEdges(g, trace.crossed || [], known, ink.alarm, 2, [5, 5]);
  if (trace.terminal_edge) strokeEdges(g, [trace.terminal_edge], known, ink.terminal, 4);
  const concerned = [...(trace.encroached || []), ...(trace.subsegment ? [trace.subsegment] : [])];
  strokeEdges(g, concerned, known, ink.alarm, 3.5);
  if (at("circle").checked) {
    for (const t of [trace.selected, picked && picked.t]) {
      const corners = t && t.map((v) => known.get(v));
      if (corners && corners.every(Boolean)) ring(g, circleOf(corners), ink.circle, 1.6, 1);
    }
  }
  if (picked && mesh.triangles.has(key(picked.t))) outline(g, picked.corners, ink.accent, 3);
  for (const shape of mesh.shapes.values()) drawShape(g, shape, known, ink.heavy, 1.8);
  if (trace.shape) drawShape(g, trace.shape, known, trace.act === "refuse" || trace.act === "remove" ? ink.alarm : ink.accent, 3.5);
  drawVertices(g);
  drawPath(g, path, known);
  drawTried(g, trace);
  drawSides(g, trace, known);
  if (trace.inserted) dot(g, trace.inserted.point, 6, ink.alarm, ink.paper);
  for (const { point } of trace.deleted || []) cross(g, point, 6, ink.alarm);
  if (at("numbers").checked) drawNumbers(g);
}

/** The triangles whose boxes meet the canvas. */
function inView() {
  const [left, high] = unplace(0, 0);
  const [right, low] = unplace(canvas.clientWidth, canvas.clientHeight);
  const isSeen = ({ corners: [a, b, c] }) =>
    Math.max(a[0], b[0], c[0]) >= left && Math.min(a[0], b[0], c[0]) <= right &&
    Math.max(a[1], b[1], c[1]) >= low && Math.min(a[1], b[1], c[1]) <= high;
  return [...mesh.triangles.values()].filter(isSeen);
}

/** No more triangles than this are in one path: browsers draw large paths slowly. */
const MOST_IN_PATH = 200;

/** Paths of triangles, each with its colour. */
function pathsOf(triangles, colourOf) {
  const [open, done] = [new Map(), []];
  for (const triangle of triangles) {
    const colour = colourOf(triangle.angle);
    let last = open.get(colour);
    if (!last || last.count === MOST_IN_PATH) {
      last = { colour, path: new Path2D(), count: 0 };
      open.set(colour, last);
      done.push(last);
    }
    addCorners(last.path, triangle.corners);
    last.count += 1;
  }
  return done;
}

function fillTriangles(g, triangles) {
  for (const { colour, path } of pathsOf(triangles, colourOf)) {
    g.fillStyle = colour;
    g.fill(path);
  }
}

function addCorners(path, corners) {
  corners.forEach((p, i) => path[i ? "lineTo" : "moveTo"](...place(p)));
  path.closePath();
}

function fillNamed(g, triangles, points, colour, alpha) {
  const path = new Path2D();
  for (const t of triangles) {
    const corners = t.map((v) => points.get(v));
    if (corners.every(Boolean)) addCorners(path, corners);
  }
  g.globalAlpha = alpha;
  g.fillStyle = colour;
  g.fill(path);
  g.globalAlpha = 1;
  return path;
}

function strokePath(g, path, colour, width, dash = []) {
  g.setLineDash(dash);
  [g.strokeStyle, g.lineWidth] = [colour, width];
  g.stroke(path);
  g.setLineDash([]);
}

function strokeEdges(g, edges, points, colour, width, dash) {
  for (let from = 0; from < edges.length; from += MOST_IN_PATH) {
    const path = new Path2D();
    for (const ends of edges.slice(from, from + MOST_IN_PATH)) {
      const [a, b] = ends.map((v) => points.get(v));
      if (!a || !b) continue;
      path.moveTo(...place(a));
      path.lineTo(...place(b));
    }
    strokePath(g, path, colour, width, dash);
  }
}

function outline(g, corners, colour, width) {
  const path = new Path2D();
  addCorners(path, corners);
  strokePath(g, path, colour, width);
}

function ring(g, circle, colour, width, alpha) {
  // Circles of flat triangles are lines on any screen.
  if (!circle || !(circle.radius * camera.scale < 1e5)) return;
  const path = new Path2D();
  const [x, y] = place([circle.x, circle.y]);
  path.arc(x, y, circle.radius * camera.scale, 0, 2 * Math.PI);
  g.globalAlpha = alpha;
  strokePath(g, path, colour, width);
  g.globalAlpha = 1;
}

function dot(g, p, radius, colour, rim) {
  const path = new Path2D();
  path.arc(...place(p), radius, 0, 2 * Math.PI);
  g.fillStyle = colour;
  g.fill(path);
  if (rim) strokePath(g, path, rim, 1.5);
}

function cross(g, p, size, colour) {
  const [x, y] = place(p);
  const path = new Path2D();
  for (const s of [-1, 1]) {
    path.moveTo(x - size, y - s * size);
    path.lineTo(x + size, y + s * size);
  }
  strokePath(g, path, colour, 2.2);
}

function label(g, text, [x, y], colour, size = 12) {
  g.font = `600 ${size}px system-ui, sans-serif`;
  [g.textAlign, g.textBaseline] = ["center", "middle"];
  [g.strokeStyle, g.lineWidth] = [ink.paper, 3.5];
  g.strokeText(text, x, y);
  g.fillStyle = colour;
  g.fillText(text, x, y);
}

/** What is to be triangulated: points and segments that are not in yet. */
function drawInput(g) {
  if (!data.drawing) return;
  const points = new Map(data.drawing.points.map((p, v) => [v, p]));
  strokeEdges(g, data.drawing.segments, points, ink.hidden, 1.2, [2, 5]);
  const waiting = [...points].filter(([v, p]) => !mesh.points.has(v) && inCanvas(place(p)));
  if (waiting.length <= MOST_DOTS) for (const [, p] of waiting) dot(g, p, 2.2, ink.faint);
}

/** No more vertices than this are drawn: they would hide the triangles. */
const MOST_DOTS = 4000;

function inCanvas([x, y]) {
  return x >= 0 && y >= 0 && x <= canvas.clientWidth && y <= canvas.clientHeight;
}

function drawVertices(g) {
  const seen = [...mesh.points].filter(([, p]) => inCanvas(place(p)));
  if (seen.length > MOST_DOTS) return;
  for (const [v, p] of seen) {
    if (v < data.input_points) dot(g, p, 2.8, ink.heavy);
    else if (at("steiner").checked) dot(g, p, 2.4, ink.path);
  }
}

/** The path of the selected triangle, numbered. */
function drawPath(g, path, known) {
  path.forEach((t, i) => {
    const corners = t.map((v) => known.get(v));
    if (!corners.every(Boolean)) return;
    const middle = [0, 1].map((k) => (corners[0][k] + corners[1][k] + corners[2][k]) / 3);
    label(g, `t${i}`, place(middle), i ? ink.path : ink.selected, 13);
  });
}

/** The places tried: refused ones with their reasons. */
function drawTried(g, { candidates = [], inserted }) {
  candidates.forEach(({ point, refused }, i) => {
    if (!point) return;
    const [x, y] = place(point);
    if (refused) cross(g, point, 5, ink.alarm);
    else dot(g, point, 4, inserted ? ink.made : ink.path, ink.paper);
    if (refused) label(g, `${i + 1}: ${refused}`, [x, y - 14], ink.alarm, 11);
  });
}

/** A shape that an algorithm tells of. */
function drawShape(g, { vertex, edge, triangle, line, circle }, known, colour, width) {
  if (vertex !== undefined && known.has(vertex)) dot(g, known.get(vertex), 2 * width, colour, ink.paper);
  if (edge) strokeEdges(g, [edge], known, colour, width);
  if (triangle) strokePath(g, fillNamed(g, [triangle], known, colour, 0.16), colour, width);
  if (line) strokeEdges(g, [[0, 1]], new Map(line.map((p, i) => [i, p])), colour, width, [6, 4]);
  if (circle) ring(g, { x: circle[0], y: circle[1], radius: circle[2] }, colour, width, 1);
}

/** The vertices on both sides of a segment that is about to go in. */
function drawSides(g, { left = [], right = [] }, known) {
  for (const [side, name] of [[left, "L"], [right, "R"]]) {
    side.forEach((v, i) => {
      const p = known.get(v);
      if (p) label(g, `${name}${i + 1}`, place(p).map((c) => c - 11), ink.alarm, 11);
    });
  }
}

function drawNumbers(g) {
  const seen = [...mesh.points].map(([v, p]) => [v, place(p)]).filter(([, p]) => inCanvas(p));
  if (seen.length > 600) return;
  for (const [v, [x, y]] of seen) label(g, String(v), [x + 9, y - 8], ink.ink, 10);
}

/** The smallest angle over the run, and where we are in it. */
const heights = [data.start.angle, ...data.steps.map(({ delta }) => delta.angle)];
function drawCurve() {
  const g = contextOf(curve);
  const [w, h] = [curve.clientWidth, curve.clientHeight];
  const x = (i) => 2 + ((w - 4) * i) / Math.max(1, steps);
  const y = (angle) => h - 3 - ((h - 8) * angle) / 60;
  g.font = "10px system-ui, sans-serif";
  g.fillStyle = ink.faint;
  for (const angle of [0, 30, 60]) {
    const line = new Path2D();
    line.moveTo(2, y(angle));
    line.lineTo(w - 2, y(angle));
    strokePath(g, line, ink.rule, 1);
    if (angle) g.fillText(`${angle}°`, 3, y(angle) + 10);
  }
  const bound = new Path2D();
  bound.moveTo(2, y(at("threshold").value));
  bound.lineTo(w - 2, y(at("threshold").value));
  strokePath(g, bound, ink.fair, 1.2, [4, 3]);
  const path = new Path2D();
  let isOpen = false;
  // No more points than pixels: of each column the lowest.
  const wide = Math.max(1, Math.ceil(heights.length / Math.max(1, w)));
  for (let i = 0; i < heights.length; i += wide) {
    const here = heights.slice(i, i + wide).filter((angle) => angle !== null);
    if (here.length) path[isOpen ? "lineTo" : "moveTo"](x(i), y(Math.min(...here)));
    isOpen = here.length > 0;
  }
  strokePath(g, path, ink.accent, 1.6);
  const now = new Path2D();
  now.moveTo(x(mesh.step), 2);
  now.lineTo(x(mesh.step), h - 2);
  strokePath(g, now, ink.alarm, 1.2);
  if (heights[mesh.step] !== null) {
    g.fillStyle = ink.alarm;
    g.beginPath();
    g.arc(x(mesh.step), y(heights[mesh.step]), 3, 0, 2 * Math.PI);
    g.fill();
  }
}
