// The mesh that is shown, and steps forward and back. Nothing here draws.
"use strict";

const key = (vertices) => vertices.join(",");

/** The mesh before the first step. */
function startOf(data) {
  const mesh = { points: new Map(), triangles: new Map(), marked: new Map(), shapes: new Map(), step: 0, undo: [], hidden: [] };
  for (const [v, x, y] of data.start.points) mesh.points.set(v, [x, y]);
  for (const t of data.start.triangles) addTriangle(mesh, t);
  for (const e of data.start.marked) mesh.marked.set(key(e), e);
  return mesh;
}

/** Makes the next step; returns whether there was one. */
function forward(mesh, data) {
  const step = data.steps[mesh.step];
  if (!step) return false;
  const { trace, delta } = step;
  for (const t of trace.destroyed) mesh.triangles.delete(key(t));
  const changed = [...delta.points.map(([v]) => v), ...delta.gone];
  mesh.undo[mesh.step] = changed.map((v) => [v, mesh.points.get(v)]);
  for (const [v, x, y] of delta.points) mesh.points.set(v, [x, y]);
  for (const t of [...trace.made, ...delta.again]) addTriangle(mesh, t);
  for (const v of delta.gone) mesh.points.delete(v);
  for (const e of delta.marked) mesh.marked.set(key(e), e);
  for (const e of delta.unmarked) mesh.marked.delete(key(e));
  changeShapes(mesh, trace);
  mesh.step += 1;
  return true;
}

/** Takes the last step back; returns whether there was one. */
function back(mesh, data) {
  if (mesh.step === 0) return false;
  mesh.step -= 1;
  const { trace, delta } = data.steps[mesh.step];
  if (trace.shape) putShape(mesh, JSON.stringify(trace.shape), mesh.hidden[mesh.step]);
  for (const e of delta.marked) mesh.marked.delete(key(e));
  for (const e of delta.unmarked) mesh.marked.set(key(e), e);
  for (const t of trace.made) mesh.triangles.delete(key(t));
  for (const [v, at] of mesh.undo[mesh.step]) {
    if (at) mesh.points.set(v, at);
    else mesh.points.delete(v);
  }
  for (const t of [...trace.destroyed, ...delta.again]) addTriangle(mesh, t);
  return true;
}

/** Adds or removes the shape of a step; what was there before is kept. Triangles are not among the shapes. */
function changeShapes(mesh, { act, shape }) {
  if (!shape) return;
  const name = JSON.stringify(shape);
  mesh.hidden[mesh.step] = mesh.shapes.get(name);
  if (act === "add" && !shape.triangle) putShape(mesh, name, shape);
  else if (act === "remove") putShape(mesh, name, undefined);
}

function putShape(mesh, name, shape) {
  if (shape) mesh.shapes.set(name, shape);
  else mesh.shapes.delete(name);
}

/** Goes to the mesh after so many steps. */
function seek(mesh, data, step) {
  const to = Math.max(0, Math.min(data.steps.length, Math.round(step) || 0));
  while (mesh.step < to && forward(mesh, data));
  while (mesh.step > to && back(mesh, data));
}

function addTriangle(mesh, t) {
  const corners = t.map((v) => mesh.points.get(v));
  mesh.triangles.set(key(t), { t, corners, angle: Math.min(...anglesOf(corners)) });
}

/** The angles of a triangle in degrees, each in the order of its corner. */
function anglesOf(corners) {
  return corners.map((a, i) => {
    const [b, c] = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
    const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
    return (Math.atan2(Math.abs(ux * vy - uy * vx), ux * vx + uy * vy) * 180) / Math.PI;
  });
}

/** Centre and radius of the circle through three points; nothing if they lie on a line. */
function circleOf([a, b, c]) {
  const [ux, uy, vx, vy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
  const area = 2 * (ux * vy - uy * vx);
  if (area === 0) return undefined;
  const [u, v] = [ux * ux + uy * uy, vx * vx + vy * vy];
  const [x, y] = [(vy * u - uy * v) / area, (ux * v - vx * u) / area];
  return { x: a[0] + x, y: a[1] + y, radius: Math.hypot(x, y) };
}

/** A number of things, in words. */
const count = (n, one, many = `${one}s`) => `${n} ${n === 1 ? one : many}`;

/** What a step did, in words. */
function wordsOf({ trace }) {
  const words = [`Step ${trace.step}: ${trace.outcome}`];
  if (trace.selected) words.push(`triangle ${trace.selected.join(" ")} selected for its ${trace.why}`);
  if (trace.outcome === "duplicate") words.push(`vertex ${trace.vertex} lies on vertex ${trace.on}`);
  if (trace.segment !== undefined) words.push(`segment ${trace.segment} from ${trace.subsegment.join(" to ")}`);
  else if (trace.subsegment) words.push(`subsegment ${trace.subsegment.join(" to ")}`);
  if (trace.crossed) words.push(`${count(trace.crossed.length, "edge")} crossed`);
  if (trace.inserted) words.push(`vertex ${trace.inserted.vertex} inserted (${trace.inserted.kind})`);
  if (trace.deleted && trace.deleted.length) words.push(`${count(trace.deleted.length, "vertex", "vertices")} deleted`);
  if (trace.encroached && trace.encroached.length) words.push(`${count(trace.encroached.length, "subsegment")} encroached upon`);
  if (trace.shape) words.push(`${{ look: "looks at", add: "adds", remove: "removes", refuse: "refuses" }[trace.act]} ${nameOf(trace.shape)}`);
  if (trace.given_up) words.push(`given up: ${trace.given_up}`);
  return words.join(", ");
}

/** What a shape is, in words. */
function nameOf(shape) {
  if (shape.vertex !== undefined) return `vertex ${shape.vertex}`;
  if (shape.edge) return `edge ${shape.edge.join("–")}`;
  if (shape.triangle) return `triangle ${shape.triangle.join(" ")}`;
  return shape.line ? "a line" : "a circle";
}
