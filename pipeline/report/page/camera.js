// The 3D view's camera: drag turns, with shift or the right button moves, wheel or pinch comes
// nearer; arrow keys turn, + and - come nearer while the view has the focus.

const kTurn = 0.008, kSteep = Math.PI / 2 - 0.01;

// {camera, look(from, to), distanceFor(radius), resize(width, height)}; onChange() after every move,
// onClick(x, y) with coordinates from -1 to 1.
export function createCamera(canvas, onChange, onClick) {
  const camera = new THREE.PerspectiveCamera(40, 1, 0.01, 50);
  camera.up.set(0, 0, 1);
  const centre = new THREE.Vector3();
  let yaw = 0, pitch = 0.3, distance = 2;

  const updateCamera = () => {
    const flat = Math.cos(pitch);
    camera.position.set(Math.cos(yaw) * flat, Math.sin(yaw) * flat, Math.sin(pitch))
      .multiplyScalar(distance).add(centre);
    camera.lookAt(centre);
    camera.updateMatrixWorld();
    onChange();
  };
  const turn = (dx, dy) => {
    yaw -= kTurn * dx;
    pitch = Math.min(kSteep, Math.max(-kSteep, pitch + kTurn * dy));
    updateCamera();
  };
  const move = (dx, dy) => {
    const scale = 2 * distance * Math.tan(camera.fov * Math.PI / 360) / canvas.clientHeight;
    const right = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 0);
    const up = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 1);
    centre.addScaledVector(right, -dx * scale).addScaledVector(up, dy * scale);
    updateCamera();
  };
  const zoom = (factor) => {
    distance = Math.min(20, Math.max(0.1, distance * factor));
    updateCamera();
  };

  const pointers = new Map();
  let travelled = 0;
  const middle = () => {
    const all = [...pointers.values()];
    const mean = (coordinate) => all.reduce((sum, pointer) => sum + coordinate(pointer), 0) / all.length;
    const x = mean((p) => p.x), y = mean((p) => p.y);
    return { x, y, spread: mean((p) => Math.hypot(p.x - x, p.y - y)) };
  };
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    if (pointers.size === 0) travelled = 0;
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  canvas.addEventListener("pointermove", (event) => {
    if (!pointers.has(event.pointerId)) return;
    const before = middle();
    pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const now = middle();
    const dx = now.x - before.x, dy = now.y - before.y;
    travelled += Math.abs(dx) + Math.abs(dy);
    if (pointers.size > 1) {
      if (before.spread > 0 && now.spread > 0) zoom(before.spread / now.spread);
      move(dx, dy);
    } else if (event.shiftKey || (event.buttons & 2) !== 0) move(dx, dy);
    else turn(dx, dy);
  });
  const leave = (event) => {
    const last = pointers.get(event.pointerId);
    pointers.delete(event.pointerId);
    if (!last || event.type !== "pointerup" || travelled > 4 || event.button !== 0) return;
    const box = canvas.getBoundingClientRect();
    onClick(2 * (event.clientX - box.left) / box.width - 1, 1 - 2 * (event.clientY - box.top) / box.height);
  };
  canvas.addEventListener("pointerup", leave);
  canvas.addEventListener("pointercancel", leave);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.sign(event.deltaY) * 0.12));
  }, { passive: false });
  const turns = { ArrowLeft: [-12, 0], ArrowRight: [12, 0], ArrowUp: [0, 12], ArrowDown: [0, -12] };
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (event.key === "+" || event.key === "=") zoom(0.9);
    else if (event.key === "-") zoom(1 / 0.9);
    else if (Object.hasOwn(turns, event.key) && event.shiftKey) move(...turns[event.key]);
    else if (Object.hasOwn(turns, event.key)) turn(...turns[event.key]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    camera,
    look(from, to) {
      centre.copy(to);
      const away = from.clone().sub(to);
      distance = away.length();
      pitch = Math.min(kSteep, Math.max(-kSteep, Math.asin(away.z / distance)));
      if (Math.hypot(away.x, away.y) > 1e-6) yaw = Math.atan2(away.y, away.x);
      updateCamera();
    },
    // From which distance a ball fills the view.
    distanceFor: (radius) => radius / Math.sin(Math.min(1, camera.aspect) * camera.fov * Math.PI / 360),
    resize(width, height) {
      camera.aspect = width / Math.max(1, height);
      camera.updateProjectionMatrix();
      onChange();
    },
  };
}
