// The 3D view: robots, person, goals, objects and the nearest pair, in the frame of the world
// (X to the person's right, Y forward, Z up).
import { createCamera } from "./camera.js";
import { report, valueAt } from "./data.js";
import { build, buildName } from "./elements.js";
import { numberText, shortText } from "./format.js";
import { matrixOf } from "./kinematics.js";
import { kRobotColours } from "./materials.js";
import { kTable } from "./objects.js";
import { createFloor, createPlanParts, disposeParts, poseParts } from "./plan_parts.js";
import { clockRange, isPathChanged, stateAt } from "./playback.js";
import { boneGeometry, fixedMesh, placeBone, pointOf } from "./shapes.js";
import { createStage } from "./stage.js";
import { bodyNameOf } from "./subject.js";
import { viewpoint } from "./views.js";

export const kHasMeshes = report.runs.some(({ robot }) => robot.meshes);
const kSpacing_m = 0.9;
const kInitiallyVisible = 2; // of several robots

// The 3D view; null without WebGL, after a message.
export function createScene(host) {
  const canvas = build("canvas", { tabindex: "0", role: "img",
    "aria-label": "3D view: arrow keys rotate, with shift they move, plus and minus zoom" });
  const stage = createStage(canvas);
  if (!stage) {
    host.append(build("p", { class: "reason" },
        "This browser cannot show 3D graphics (WebGL is off); plots and numbers are below."));
    return null;
  }
  const { root, materials, renderer } = stage;
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  const label = build("output", { class: "scene-label" });
  const legend = build("p", { class: "scene-legend" });
  host.append(canvas, label);
  host.after(legend);
  const pairBone = fixedMesh(boneGeometry(), materials.nearest);
  pairBone.renderOrder = 1;
  root.add(pairBone);
  const options = { person: true, goals: true, capsules: !kHasMeshes, meshes: true, mappedPath: true, objects: true,
                    nearest: true, contacts: true, sideBySide: false };
  let shownParts = [], states = [], floor = null, isDrawRequested = false, pickListener = () => {}, nearestText = "";

  const draw = () => {
    isDrawRequested = false;
    if (canvas.clientWidth === 0) return;
    stage.render(cameraControl.camera);
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
    label.textContent = nearestText;
    const left = Math.max(0, x - 12 - label.offsetWidth);
    label.style.transform = `translate(${Math.round(left)}px, ${Math.round(y + 6)}px)`;
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
    const bodies = [valueAt(nearest.first, state.index), valueAt(nearest.second, state.index)];
    const names = bodies.map((body) => shortText(bodyNameOf(parts.shownPlan, body)));
    nearestText = `${numberText(1e3 * valueAt(nearest.distance, state.index))} mm\n${names.join("\n")}`;
    return bodies;
  }

  function updateParts(parts, state, pick, isFirst) {
    const nearest = isFirst ? showNearest(parts, state) : [];
    poseParts(parts, state, { pick, nearest, isFirst, showsMapped: options.mappedPath, showsTouching: true });
  }

  function applyOptions() {
    for (const { shownPlan, model, person, goals, objects } of shownParts) {
      // Where some robots have meshes, the others have nothing but their capsules.
      model.show({ capsules: options.capsules || kHasMeshes && !shownPlan.robot.meshes, meshes: options.meshes });
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
    floor = createFloor(shownParts, materials.floor);
    root.add(floor);
  }

  function view(name) {
    const { from, to } = viewpoint(name, shownParts, cameraControl.distanceFor);
    cameraControl.look(from, to);
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height, false);
    cameraControl.resize(width, height);
  }
  new ResizeObserver(resize).observe(host);

  function clear() {
    for (const parts of shownParts) {
      root.remove(parts.group);
      disposeParts(parts);
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
      states = shownPlans.map(({ plan, robot }) => stateAt(plan, robot, clockRange(plan).begin));
      applyOptions();
      api.update(states, null);
      placeFloor();
      legend.replaceChildren(...legendOf(shownPlans, setVisible));
      resize();
      view("subject");
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
      stage.theme();
      if (shownParts.length > 0) placeFloor();
      requestDraw();
    },
    resize,
    onPick(listener) { pickListener = listener; },
  };
  stage.compile(cameraControl.camera);
  return api;
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
  const has = (test) => shownPlans.some(({ plan, target }) => test(plan, target));
  const hasObject = (test) => has((plan, target) => plan.objects.some(({ name }) => test(name, target)));
  const further = [
    ["person", "person, recorded", has(({ human }) => human.time.rows > 0)],
    ["torso", "torso, drawn from the shoulder", shownPlans[0].plan.upright],
    ["mapped", "mapped path, where repair changed it", shownPlans.some(isPathChanged)],
    ["target", "target", hasObject((name, target) => name === target)],
    ["obstacle", "obstacle", hasObject((name, target) => name !== target && name !== kTable)],
    ["goal", "goal of a fingertip", true],
    ["near", "nearest pair", true],
    ["touching", "touching", true],
    ["reach", "goal out of reach", shownPlans[0].row.out_of_reach > 0],
  ];
  return [...robots, ...further.flatMap(([name, text, isShown]) => (isShown ? [entry(name, text)] : []))];
}
