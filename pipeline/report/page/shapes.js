// Bodies of the 3D view: capsules, objects, bones, lines.
import { rowOf, valueAt } from "./data.js";

const kSegmentsAround = 14, kSegmentsPerCap = 5;
const kUp = new THREE.Vector3(0, 0, 1);

// Straight part of the given length along z, its middle in the origin.
export function capsuleGeometry(radius, length) {
  const outline = [];
  for (let i = 0; i <= 2 * kSegmentsPerCap + 1; ++i) {
    const upper = i > kSegmentsPerCap;
    const angle = -Math.PI / 2 + (upper ? i - 1 : i) / (2 * kSegmentsPerCap) * Math.PI;
    outline.push(new THREE.Vector2(Math.max(0, radius * Math.cos(angle)),
        radius * Math.sin(angle) + (upper ? length / 2 : -length / 2)));
  }
  return new THREE.LatheBufferGeometry(outline, kSegmentsAround).rotateX(Math.PI / 2);
}

// Turns z into the direction of `to - from`, origin in the middle.
export function poseBetween(from, to) {
  const along = to.clone().sub(from);
  const length = along.length();
  const rotation = new THREE.Quaternion();
  if (length > 1e-9) rotation.setFromUnitVectors(kUp, along.divideScalar(length));
  return new THREE.Matrix4().compose(from.clone().add(to).multiplyScalar(0.5), rotation,
      new THREE.Vector3(1, 1, 1));
}

// A bone of unit length and radius that is put between two points; hidden where one is not seen.
export function placeBone(mesh, from, to, radius) {
  const length = from.distanceTo(to);
  mesh.visible = length > 1e-6; // NaN: not seen
  if (!mesh.visible) return;
  mesh.matrix.copy(poseBetween(from, to)).scale(new THREE.Vector3(radius, radius, length));
  mesh.matrixWorldNeedsUpdate = true;
}

// taper: the radius at the far end, as a share of that at the near one.
export const boneGeometry = (taper = 1) => new THREE.CylinderBufferGeometry(taper, 1, 1, 12).rotateX(Math.PI / 2);

export function fixedMesh(geometry, material) {
  const mesh = new THREE.Mesh(geometry, material);
  mesh.matrixAutoUpdate = false;
  return mesh;
}

export const ballGeometry = (radius) => new THREE.SphereBufferGeometry(radius, 12, 8);

const kGeometries = {
  sphere: ([radius]) => new THREE.SphereBufferGeometry(radius, 24, 16),
  box: (size) => new THREE.BoxBufferGeometry(...size),
  cylinder: ([radius, length]) => new THREE.CylinderBufferGeometry(radius, radius, length, 28).rotateX(Math.PI / 2),
  capsule: ([radius, length]) => capsuleGeometry(radius, length),
};

export function meshGeometry({ vertices, triangles }) {
  const geometry = new THREE.BufferGeometry();
  const corners = new Float32Array(3 * triangles.values.length);
  triangles.values.forEach((vertex, k) => corners.set(rowOf(vertices, vertex), 3 * k));
  geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return geometry;
}

export const objectGeometry = ({ shape, size }) => kGeometries[shape](size);

// Position and w x y z.
export const poseMatrix = ([x, y, z, qw, qx, qy, qz]) => new THREE.Matrix4().compose(
    new THREE.Vector3(x, y, z), new THREE.Quaternion(qx, qy, qz, qw), new THREE.Vector3(1, 1, 1));

// set() keeps NaN, the constructor makes 0 of it.
export const pointOf = (table, row, index = 0) =>
  new THREE.Vector3().set(valueAt(table, row, 3 * index), valueAt(table, row, 3 * index + 1), valueAt(table, row, 3 * index + 2));

// Between two rows; where only one of them was seen, that one.
export function interpolatePoint(table, { index, next, share }, column = 0) {
  const from = pointOf(table, index, column), to = pointOf(table, next, column);
  if (!Number.isFinite(from.x)) return to;
  return Number.isFinite(to.x) ? from.lerp(to, share) : from;
}

// A line through points that breaks where one is not seen.
export function pathGeometry(points) {
  const corners = [];
  for (let i = 1; i < points.length; ++i)
    if (Number.isFinite(points[i - 1].x + points[i].x)) corners.push(points[i - 1], points[i]);
  return new THREE.BufferGeometry().setFromPoints(corners);
}

// A cross in space at each point.
export function crossGeometry(points, size) {
  const corners = [];
  for (const point of points) {
    for (const axis of [[1, 1, 0], [1, -1, 0], [0, 1, 1], [0, 1, -1]]) {
      const arm = new THREE.Vector3(...axis).multiplyScalar(size);
      corners.push(point.clone().add(arm), point.clone().sub(arm));
    }
  }
  return new THREE.BufferGeometry().setFromPoints(corners);
}

// Diagonal stripes, for bodies that must not be distinguished by colour alone.
export function stripes(front, back) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext("2d");
  pen.fillStyle = back;
  pen.fillRect(0, 0, 32, 32);
  pen.strokeStyle = front;
  pen.lineWidth = 10;
  for (const x of [-32, 0, 32]) {
    pen.beginPath();
    pen.moveTo(x - 8, 40);
    pen.lineTo(x + 40, -8);
    pen.stroke();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.repeat.set(4, 4);
  return texture;
}
