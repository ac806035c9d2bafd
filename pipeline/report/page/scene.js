// The 3D view: robots, person, goals, objects and the nearest pair, in the frame of the world
// (X to the person's right, Y forward, Z up).
import { createCamera } from "./camera.js";
import { colour } from "./colours.js";
import { rowOf, valueAt } from "./data.js";
import { build, buildName } from "./elements.js";
import { numberText } from "./format.js";
import { createGoals } from "./goals.js";
import { matrixOf } from "./kinematics.js";
import { createMaterials, kRobotColours } from "./materials.js";
import { createObjects } from "./objects.js";
import { createPerson } from "./person.js";
import { interpolationAt, isGoalMotion, timedMotions, touchingPairs } from "./playback.js";
import { createRobotModel } from "./robot_model.js";
import { boneGeometry, fixedMesh, placeBone, pointOf } from "./shapes.js";

const kSpacing_m = 0.9;
const kInitiallyVisible = 2; // of several robots

// True if WebGL is drawn by the processor, which is too slow for smooth edges.
function isSoftwareRenderer() {
  const context = build("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

function createRenderer(canvas) {
  try {
    return new THREE.WebGLRenderer({ canvas, antialias: !isSoftwareRenderer() });
  } catch {
    return null;
  }
}

// The parts of a plan in the scene: {model, mappedModel, person, goals, objects, group of all}.
function createPlanParts(shownPlan, materials, first, onChange) {
  const group = new THREE.Group();
  group.matrixAutoUpdate = false;
  const { plan, robot, index } = shownPlan;
  const robotMaterials = { plain: materials[`robot-${index % kRobotColours}`], picked: materials.picked, near: materials.near,
                touching: materials.touching, mesh: materials.mesh, tip: materials.tip };
  const model = createRobotModel(robot, robotMaterials, onChange);
  const { mappedPath } = materials;
  const mappedMaterials = { plain: mappedPath, picked: mappedPath, near: mappedPath, touching: mappedPath };
  const mappedModel = plan.mapped ? createRobotModel(robot, mappedMaterials, onChange) : null;
  const goals = createGoals(shownPlan, materials);
  const objects = createObjects(shownPlan, materials, !first, onChange);
  const person = first ? createPerson(plan, robot, materials.person) : null;
  group.add(model.group, goals.group, objects.group);
  if (mappedModel) group.add(mappedModel.group);
  if (person) group.add(person.group);
  return { shownPlan, group, model, mappedModel, goals, objects, person };
}

const isRepairedAt = (state) => state && isGoalMotion(state.motion) &&
    (valueAt(state.motion.origin, state.index) > 0 || valueAt(state.motion.origin, state.next) > 0);

function mappedAt(plan, interpolation) {
  const { position } = plan.mapped;
  const from = rowOf(position, interpolation.index), to = rowOf(position, interpolation.next);
  return from.map((value, joint) => value + interpolation.share * (to[joint] - value));
}

// The bounding box of robots and person, in the world.
function boundsOf(shownParts) {
  const box = new THREE.Box3();
  for (const { group, model, person } of shownParts) {
    group.updateMatrixWorld(true);
    if (model.group.visible) box.expandByObject(model.capsulesGroup);
    if (person) person.group.children.filter(({ visible }) => visible).forEach((part) => box.expandByObject(part));
  }
  return box;
}

// The 3D view; null without WebGL, after a message.
export function createScene(host) {
  const canvas = build("canvas", { tabindex: "0", role: "img",
    "aria-label": "3D view: arrow keys rotate, with shift they move, plus and minus zoom" });
  const renderer = createRenderer(canvas);
  if (!renderer) {
    host.append(build("p", { class: "reason" },
        "This browser cannot show 3D graphics (WebGL is off); plots and numbers are below."));
    return null;
  }
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  const label = build("output", { class: "scene-label" });
  const legend = build("p", { class: "scene-legend" });
  host.append(canvas, label, legend);
  const root = new THREE.Scene();
  const { materials, applyTheme } = createMaterials();
  const directionalLight = new THREE.DirectionalLight(0xffffff, 0.55);
  const ambientLight = new THREE.HemisphereLight(0xffffff, 0x8a8a92, 0.6);
  directionalLight.position.set(-1, -1.5, 3);
  ambientLight.position.set(0, 0, 1);
  root.add(directionalLight, ambientLight);
  const pairBone = fixedMesh(boneGeometry(), materials.nearest);
  pairBone.renderOrder = 1;
  root.add(pairBone);
  const options = { person: true, goals: true, capsules: true, meshes: true, mappedPath: true, objects: true,
                    nearest: true, contacts: true, sideBySide: false };
  let shownParts = [], states = [], floor = null, isDrawRequested = false, pickListener = () => {}, nearestText = "";

  const draw = () => {
    isDrawRequested = false;
    if (canvas.clientWidth === 0) return;
    renderer.render(root, cameraControl.camera);
    placeLabel();
  };
  const requestDraw = () => {
    if (isDrawRequested) return;
    isDrawRequested = true;
    requestAnimationFrame(draw);
  };
  const cameraControl = createCamera(canvas, requestDraw, (x, y) => pickAt(x, y));

  function pickAt(x, y) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera({ x, y }, cameraControl.camera);
    const hits = shownParts.flatMap(({ group, model }, planIndex) => !group.visible ? [] : ray.intersectObjects(model.capsulesGroup.children)
      .map(({ distance, object }) => ({ distance, planIndex, capsule: object.userData.capsule })));
    hits.sort((a, b) => a.distance - b.distance);
    if (hits.length > 0) pickListener(hits[0]);
  }

  function placeLabel() {
    label.hidden = !pairBone.visible;
    if (label.hidden) return;
    const middle = new THREE.Vector3().setFromMatrixPosition(pairBone.matrix).project(cameraControl.camera);
    const x = (middle.x + 1) / 2 * canvas.clientWidth, y = (1 - middle.y) / 2 * canvas.clientHeight;
    label.hidden = middle.z > 1;
    label.style.transform = `translate(${Math.round(x + 10)}px, ${Math.round(y - 24)}px)`;
    label.textContent = nearestText;
  }

  function showNearest(parts, state) {
    const hasNoPair = !options.nearest || !state || valueAt(state.motion.nearest.first, state.index) < 0;
    pairBone.visible = !hasNoPair;
    if (hasNoPair) return [];
    const { nearest } = state.motion;
    const [a, b] = [0, 1].map((end) =>
      pointOf(nearest.points, state.index, end).applyMatrix4(parts.group.matrix));
    const length = a.distanceTo(b);
    if (length < 1e-4) b.z += 1e-4;
    placeBone(pairBone, a, b, 0.0025);
    nearestText = `${numberText(1e3 * valueAt(nearest.distance, state.index))} mm`;
    return [valueAt(nearest.first, state.index), valueAt(nearest.second, state.index)];
  }

  function updateParts(parts, state, pick, isFirst) {
    const { shownPlan, model, mappedModel, goals, objects, person } = parts;
    const { plan } = shownPlan;
    const demonstration_s = state ? state.demonstration_s : (plan.worst?.demonstration_s ?? valueAt(plan.human.time, 0));
    const human = state ? state.human : interpolationAt(plan.human.time, demonstration_s);
    model.group.visible = state !== null;
    const poses = state ? model.pose(state.q) : null;
    if (mappedModel) {
      mappedModel.group.visible = options.mappedPath && Boolean(isRepairedAt(state));
      if (mappedModel.group.visible) mappedModel.pose(mappedAt(plan, human));
    }
    goals.pose(human, state && isGoalMotion(state.motion) ? poses : null, pick);
    objects.pose(state, demonstration_s);
    person?.pose(human);
    const nearest = isFirst ? showNearest(parts, state) : [];
    const touching = new Set(state ? touchingPairs(state.motion, state.index).flat() : []);
    model.highlight(isFirst || pick?.kind !== "pair" ? pick : null, nearest, touching);
    objects.highlight(isFirst ? pick : null, nearest, touching);
  }

  function applyOptions() {
    for (const { model, person, goals, objects } of shownParts) {
      model.capsulesGroup.visible = options.capsules;
      model.meshesGroup.visible = options.meshes;
      if (person) person.group.visible = options.person;
      goals.group.visible = options.goals;
      objects.group.visible = options.objects;
      objects.marks.visible = options.contacts;
    }
    shownParts.forEach(({ group, shownPlan }, k) => {
      group.matrix.copy(matrixOf(shownPlan.plan.world_from_base));
      if (options.sideBySide) group.matrix.premultiply(new THREE.Matrix4().makeTranslation(k * kSpacing_m, 0, 0));
      group.matrixWorldNeedsUpdate = true;
    });
  }

  function placeFloor() {
    if (floor) root.remove(floor);
    const box = boundsOf(shownParts);
    for (const { objects } of shownParts) box.expandByObject(objects.group);
    floor = new THREE.GridHelper(4, 20);
    floor.geometry.rotateX(Math.PI / 2);
    floor.material = materials.floor;
    floor.position.z = Number.isFinite(box.min.z) ? box.min.z - 0.002 : 0;
    root.add(floor);
  }

  function view(name) {
    const box = boundsOf(shownParts);
    const centre = box.isEmpty() ? new THREE.Vector3(0, 0.3, 0) : box.getCenter(new THREE.Vector3());
    const radius = box.isEmpty() ? 0.6 : Math.max(0.3, 0.42 * box.getSize(new THREE.Vector3()).length());
    const distance = cameraControl.distanceFor(radius);
    const from = (x, y, z) => centre.clone().add(new THREE.Vector3(x, y, z).setLength(distance));
    const left = shownParts[0]?.shownPlan.robot.side === "left" ? -1 : 1;
    const views = {
      front: () => cameraControl.look(from(0, 1, 0.12), centre),
      side: () => cameraControl.look(from(left, 0, 0.12), centre),
      top: () => cameraControl.look(from(0, -0.001, 1), centre),
      fit: () => cameraControl.look(from(left * 0.9, 0.75, 0.55), centre),
      // Assumed: the eyes are 0.2 m beside the shoulder, 0.25 m above and 0.1 m in front of it.
      eyes: () => cameraControl.look(new THREE.Vector3(-0.2 * left, 0.1, 0.25), gazeTarget(centre)),
    };
    views[name]();
  }

  // The mean of the goals at the grasp, or the middle of the scene.
  function gazeTarget(fallback) {
    if (shownParts.length === 0) return fallback;
    const { plan, robot } = shownParts[0].shownPlan;
    const interpolation = interpolationAt(plan.human.time, plan.grasp?.demonstration_s ?? valueAt(plan.human.time, plan.human.time.rows - 1));
    const seen = robot.tips.map((_, tip) => pointOf(plan.human.tips, interpolation.index, tip)).filter(({ x }) => Number.isFinite(x));
    if (seen.length === 0) return fallback;
    return seen.reduce((sum, point) => sum.add(point), new THREE.Vector3()).divideScalar(seen.length)
      .applyMatrix4(shownParts[0].group.matrix);
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height, false);
    cameraControl.resize(width, height);
  }
  new ResizeObserver(resize).observe(host);

  // The shaders of all materials, before the first movement is opened.
  function compile() {
    const samples = new THREE.Group();
    for (const material of Object.values(materials)) {
      const part = material.isLineBasicMaterial ? THREE.LineSegments : THREE.Mesh;
      samples.add(new part(boneGeometry(), material));
    }
    root.add(samples);
    renderer.compile(root, cameraControl.camera);
    root.remove(samples);
  }

  function clear() {
    for (const { group } of shownParts) {
      root.remove(group);
      group.traverse((part) => part.geometry?.dispose());
    }
    shownParts = [];
  }

  function setVisible(index, on) {
    shownParts[index].group.visible = on;
    requestDraw();
  }

  const api = {
    show(shownPlans) {
      clear();
      shownParts = shownPlans.map((shownPlan, k) => createPlanParts(shownPlan, materials, k === 0, () => {
        applyOptions();
        api.update(states, null);
      }));
      shownParts.forEach(({ group }, k) => {
        root.add(group);
        group.visible = k < kInitiallyVisible;
      });
      states = shownPlans.map(({ plan, robot }) => firstState(plan, robot));
      applyOptions();
      api.update(states, null);
      placeFloor();
      legend.replaceChildren(...legendOf(shownPlans, setVisible));
      resize();
      view("fit");
    },
    update(now, pick) {
      states = now;
      shownParts.forEach((parts, k) => { if (k < now.length) updateParts(parts, now[k], pick, k === 0); });
      requestDraw();
    },
    view,
    set(option, on) {
      options[option] = on;
      applyOptions();
      requestDraw();
    },
    theme() {
      applyTheme();
      root.background = new THREE.Color(colour("--scene-ground"));
      if (shownParts.length > 0) placeFloor();
      requestDraw();
    },
    resize,
    onPick(listener) { pickListener = listener; },
  };
  root.background = new THREE.Color(colour("--scene-ground"));
  compile();
  return api;
}

// The first state of a plan.
function firstState(plan, robot) {
  const [first] = timedMotions(plan);
  if (!first) return null;
  const { motion } = first;
  const demonstration_s = valueAt(motion.demonstration_time, 0);
  return { motion, index: 0, next: 0, share: 0, demonstration_s,
           q: rowOf(motion.position, 0).slice(0, robot.joints.length),
           human: interpolationAt(plan.human.time, demonstration_s) };
}

// The legend of the colours, with a checkbox for each of several robots.
function legendOf(shownPlans, onShow) {
  const entry = (name, ...words) => build("span", { class: `legend ${name}` }, ...words);
  const robotEntry = ({ label, index }, k) => {
    const box = build("input", { type: "checkbox", checked: k < kInitiallyVisible });
    box.addEventListener("change", () => onShow(k, box.checked));
    return entry(`run-${index % kRobotColours}`, build("label", {}, box, " ", buildName(label)));
  };
  const robots = shownPlans.length > 1 ? shownPlans.map(robotEntry) : shownPlans.map(({ index }) => entry(`run-${index % kRobotColours}`, "robot"));
  return [...robots, entry("person", "person"), entry("goal", "goal"), entry("near", "nearest"), entry("touching", "touching")];
}
