// The 3D view: robots, person, goals, objects and the nearest pair, in the frame of the world
// (X to the person's right, Y forward, Z up).
import { createCamera } from "./camera.js";
import { colour } from "./colours.js";
import { at, rowOf } from "./data.js";
import { build, buildName } from "./elements.js";
import { createGoals } from "./goals.js";
import { matrixOf } from "./kinematics.js";
import { createObjects } from "./objects.js";
import { createPerson } from "./person.js";
import { clips, isGoalMotion, place, touchingPairs } from "./player.js";
import { createRobotModel } from "./robot_model.js";
import { boneGeometry, fixedMesh, placeBone, pointOf, stripes } from "./shapes.js";
import { figureText } from "./words.js";

const kApart_m = 0.9;
const kRobotColours = 4;
const kShownAtFirst = 2; // of several robots

// Whether the processor draws, which has no time for smooth edges.
function drawnInSoftware() {
  const context = build("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

function createRenderer(canvas) {
  try {
    return new THREE.WebGLRenderer({ canvas, antialias: !drawnInSoftware() });
  } catch {
    return null;
  }
}

// Materials by name; paint() gives them the theme's colours.
function createMaterials() {
  const solid = (more = {}) => new THREE.MeshLambertMaterial(more);
  const line = (more = {}) => new THREE.LineBasicMaterial(more);
  const faint = { transparent: true, opacity: 0.3, depthWrite: false };
  const kinds = {
    person: solid(), goal: solid(), goalLine: new THREE.LineDashedMaterial({ dashSize: 0.012, gapSize: 0.008 }),
    tipLine: line(), gap: solid(), reach: line(), object: solid(), target: solid(), edge: line(),
    floor: line({ transparent: true, opacity: 0.4 }),
    near: solid(), picked: solid(), touching: solid(), touchingObject: solid(), ghost: solid(faint),
    nearest: new THREE.MeshBasicMaterial({ depthTest: false }), none: new THREE.MeshBasicMaterial({ visible: false }),
    ...Object.fromEntries(Array.from({ length: kRobotColours }, (_, k) => [`robot-${k}`, solid()])),
    tip: solid(), mesh: solid(), contact: new THREE.MeshBasicMaterial({ depthTest: false }),
  };
  const names = { person: "--person", goal: "--goal", goalLine: "--goal", tipLine: "--robot-0", gap: "--bad",
    reach: "--bad", object: "--object", target: "--target", edge: "--scene-line", floor: "--scene-line", near: "--near",
    picked: "--accent", ghost: "--ghost", nearest: "--near", tip: "--robot-0", mesh: "--mesh", contact: "--accent" };
  const paint = () => {
    for (const [kind, name] of Object.entries(names)) kinds[kind].color.set(colour(name));
    for (let k = 0; k < kRobotColours; ++k) kinds[`robot-${k}`].color.set(colour(`--robot-${k}`));
    kinds.touching.map = stripes(colour("--bad"), colour("--near"));
    kinds.touchingObject.map = stripes(colour("--bad"), colour("--target"));
  };
  paint();
  return { kinds, paint };
}

// A player's parts: {robot model, ghost, person, goals, objects, group}.
function createActor(player, kinds, first, onChange) {
  const group = new THREE.Group();
  group.matrixAutoUpdate = false;
  const { plan, robot, index } = player;
  const own = { plain: kinds[`robot-${index % kRobotColours}`], picked: kinds.picked, near: kinds.near,
                touching: kinds.touching, mesh: kinds.mesh, tip: kinds.tip };
  const model = createRobotModel(robot, own, onChange);
  const ghostOf = { plain: kinds.ghost, picked: kinds.ghost, near: kinds.ghost, touching: kinds.ghost };
  const ghost = plan.mapped ? createRobotModel(robot, ghostOf, onChange) : null;
  const goals = createGoals(player, kinds);
  const objects = createObjects(player, kinds, !first, onChange);
  const person = first ? createPerson(plan, robot, kinds.person) : null;
  group.add(model.group, goals.group, objects.group);
  if (ghost) group.add(ghost.group);
  if (person) group.add(person.group);
  return { player, group, model, ghost, goals, objects, person };
}

const repairedNow = (state) => state && isGoalMotion(state.motion) &&
    (at(state.motion.origin, state.index) > 0 || at(state.motion.origin, state.next) > 0);

function mappedAt(plan, when) {
  const { position } = plan.mapped;
  const from = rowOf(position, when.index), to = rowOf(position, when.next);
  return from.map((value, joint) => value + when.share * (to[joint] - value));
}

// Capsules and objects at one posture, in the world.
function boundsOf(actors) {
  const box = new THREE.Box3();
  for (const { group, model, person } of actors) {
    group.updateMatrixWorld(true);
    if (model.group.visible) box.expandByObject(model.capsulesGroup);
    if (person) person.group.children.filter(({ visible }) => visible).forEach((part) => box.expandByObject(part));
  }
  return box;
}

// null where there is no WebGL: a sentence says so.
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
  const { kinds, paint } = createMaterials();
  const sun = new THREE.DirectionalLight(0xffffff, 0.55);
  const sky = new THREE.HemisphereLight(0xffffff, 0x8a8a92, 0.6);
  sun.position.set(-1, -1.5, 3);
  sky.position.set(0, 0, 1);
  root.add(sun, sky);
  const pairBone = fixedMesh(boneGeometry(), kinds.nearest);
  pairBone.renderOrder = 1;
  root.add(pairBone);
  const options = { person: true, goals: true, capsules: true, meshes: true, ghost: true, objects: true,
                    nearest: true, contacts: true, apart: false };
  let actors = [], states = [], floor = null, asked = false, picked = () => {}, nearestWords = "";

  const draw = () => {
    asked = false;
    if (canvas.clientWidth === 0) return;
    renderer.render(root, eye.camera);
    placeLabel();
  };
  const ask = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(draw);
  };
  const eye = createCamera(canvas, ask, (x, y) => pickAt(x, y));

  function pickAt(x, y) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera({ x, y }, eye.camera);
    const hits = actors.flatMap(({ group, model }, player) => !group.visible ? [] : ray.intersectObjects(model.capsulesGroup.children)
      .map(({ distance, object }) => ({ distance, player, capsule: object.userData.capsule })));
    hits.sort((a, b) => a.distance - b.distance);
    if (hits.length > 0) picked(hits[0]);
  }

  function placeLabel() {
    label.hidden = !pairBone.visible;
    if (label.hidden) return;
    const middle = new THREE.Vector3().setFromMatrixPosition(pairBone.matrix).project(eye.camera);
    const x = (middle.x + 1) / 2 * canvas.clientWidth, y = (1 - middle.y) / 2 * canvas.clientHeight;
    label.hidden = middle.z > 1;
    label.style.transform = `translate(${Math.round(x + 10)}px, ${Math.round(y - 24)}px)`;
    label.textContent = nearestWords;
  }

  function showNearest(actor, state) {
    const none = !options.nearest || !state || at(state.motion.nearest.first, state.index) < 0;
    pairBone.visible = !none;
    if (none) return [];
    const { nearest } = state.motion;
    const [a, b] = [0, 1].map((end) =>
      pointOf(nearest.points, state.index, end).applyMatrix4(actor.group.matrix));
    const length = a.distanceTo(b);
    if (length < 1e-4) b.z += 1e-4;
    placeBone(pairBone, a, b, 0.0025);
    nearestWords = `${figureText(1e3 * at(nearest.distance, state.index))} mm`;
    return [at(nearest.first, state.index), at(nearest.second, state.index)];
  }

  function updateActor(actor, state, pick, isFirst) {
    const { player, model, ghost, goals, objects, person } = actor;
    const { plan } = player;
    const demonstration_s = state ? state.demonstration_s : (plan.worst?.demonstration_s ?? at(plan.human.time, 0));
    const human = state ? state.human : place(plan.human.time, demonstration_s);
    model.group.visible = state !== null;
    const poses = state ? model.pose(state.q) : null;
    if (ghost) {
      ghost.group.visible = options.ghost && Boolean(repairedNow(state));
      if (ghost.group.visible) ghost.pose(mappedAt(plan, human));
    }
    goals.pose(human, state && isGoalMotion(state.motion) ? poses : null, pick);
    objects.pose(state, demonstration_s);
    person?.pose(human);
    const nearest = isFirst ? showNearest(actor, state) : [];
    const touching = new Set(state ? touchingPairs(state.motion, state.index).flat() : []);
    model.wear(isFirst || pick?.kind !== "pair" ? pick : null, nearest, touching);
    objects.wear(isFirst ? pick : null, nearest, touching);
  }

  function applyOptions() {
    for (const { model, person, goals, objects } of actors) {
      model.capsulesGroup.visible = options.capsules;
      model.meshesGroup.visible = options.meshes;
      if (person) person.group.visible = options.person;
      goals.group.visible = options.goals;
      objects.group.visible = options.objects;
      objects.marks.visible = options.contacts;
    }
    actors.forEach(({ group, player }, k) => {
      group.matrix.copy(matrixOf(player.plan.world_from_base));
      if (options.apart) group.matrix.premultiply(new THREE.Matrix4().makeTranslation(k * kApart_m, 0, 0));
      group.matrixWorldNeedsUpdate = true;
    });
  }

  function layFloor() {
    if (floor) root.remove(floor);
    const box = boundsOf(actors);
    for (const { objects } of actors) box.expandByObject(objects.group);
    floor = new THREE.GridHelper(4, 20);
    floor.geometry.rotateX(Math.PI / 2);
    floor.material = kinds.floor;
    floor.position.z = Number.isFinite(box.min.z) ? box.min.z - 0.002 : 0;
    root.add(floor);
  }

  function view(name) {
    const box = boundsOf(actors);
    const centre = box.isEmpty() ? new THREE.Vector3(0, 0.3, 0) : box.getCenter(new THREE.Vector3());
    const radius = box.isEmpty() ? 0.6 : Math.max(0.3, 0.42 * box.getSize(new THREE.Vector3()).length());
    const away = eye.distanceFor(radius);
    const from = (x, y, z) => centre.clone().add(new THREE.Vector3(x, y, z).setLength(away));
    const left = actors[0]?.player.robot.side === "left" ? -1 : 1;
    const sights = {
      front: () => eye.look(from(0, 1, 0.12), centre),
      side: () => eye.look(from(left, 0, 0.12), centre),
      top: () => eye.look(from(0, -0.001, 1), centre),
      fit: () => eye.look(from(left * 0.9, 0.75, 0.55), centre),
      // The eyes are taken to be 0.2 m beside the shoulder, 0.25 m above and 0.1 m before it.
      eyes: () => eye.look(new THREE.Vector3(-0.2 * left, 0.1, 0.25), attention(centre)),
    };
    sights[name]();
  }

  // Where the eyes look: between the goals at the grasp, or at the middle of the scene.
  function attention(otherwise) {
    if (actors.length === 0) return otherwise;
    const { plan, robot } = actors[0].player;
    const when = place(plan.human.time, plan.grasp?.demonstration_s ?? at(plan.human.time, plan.human.time.rows - 1));
    const seen = robot.tips.map((_, tip) => pointOf(plan.human.tips, when.index, tip)).filter(({ x }) => Number.isFinite(x));
    if (seen.length === 0) return otherwise;
    return seen.reduce((sum, point) => sum.add(point), new THREE.Vector3()).divideScalar(seen.length)
      .applyMatrix4(actors[0].group.matrix);
  }

  function resize() {
    const { clientWidth: width, clientHeight: height } = host;
    if (width === 0 || height === 0) return;
    renderer.setSize(width, height, false);
    eye.shape(width, height);
  }
  new ResizeObserver(resize).observe(host);

  // The shaders of all materials, before the first movement is opened.
  function compile() {
    const samples = new THREE.Group();
    for (const material of Object.values(kinds)) {
      const part = material.isLineBasicMaterial ? THREE.LineSegments : THREE.Mesh;
      samples.add(new part(boneGeometry(), material));
    }
    root.add(samples);
    renderer.compile(root, eye.camera);
    root.remove(samples);
  }

  function clear() {
    for (const { group } of actors) {
      root.remove(group);
      group.traverse((part) => part.geometry?.dispose());
    }
    actors = [];
  }

  function showActor(index, on) {
    actors[index].group.visible = on;
    ask();
  }

  const api = {
    show(players) {
      clear();
      actors = players.map((player, k) => createActor(player, kinds, k === 0, () => {
        applyOptions();
        api.update(states, null);
      }));
      actors.forEach(({ group }, k) => {
        root.add(group);
        group.visible = k < kShownAtFirst;
      });
      states = players.map(({ plan, robot }) => firstState(plan, robot));
      applyOptions();
      api.update(states, null);
      layFloor();
      legend.replaceChildren(...legendOf(players, showActor));
      resize();
      view("fit");
    },
    update(now, pick) {
      states = now;
      actors.forEach((actor, k) => { if (k < now.length) updateActor(actor, now[k], pick, k === 0); });
      ask();
    },
    view,
    set(option, on) {
      options[option] = on;
      applyOptions();
      ask();
    },
    theme() {
      paint();
      root.background = new THREE.Color(colour("--scene-ground"));
      if (actors.length > 0) layFloor();
      ask();
    },
    resize,
    onPick(listener) { picked = listener; },
  };
  root.background = new THREE.Color(colour("--scene-ground"));
  compile();
  return api;
}

// The posture in which a movement is laid out: its first.
function firstState(plan, robot) {
  const [clip] = clips(plan);
  if (!clip) return null;
  const { motion } = clip;
  const demonstration_s = at(motion.demonstration_time, 0);
  return { clip, motion, index: 0, next: 0, share: 0, demonstration_s,
           q: rowOf(motion.position, 0).slice(0, robot.joints.length),
           human: place(plan.human.time, demonstration_s) };
}

// What the colours mean; of several robots each can be shown or not.
function legendOf(players, onShow) {
  const entry = (name, ...words) => build("span", { class: `legend ${name}` }, ...words);
  const robotEntry = ({ label, index }, k) => {
    const box = build("input", { type: "checkbox", checked: k < kShownAtFirst });
    box.addEventListener("change", () => onShow(k, box.checked));
    return entry(`run-${index % kRobotColours}`, build("label", {}, box, " ", buildName(label)));
  };
  const robots = players.length > 1 ? players.map(robotEntry) : players.map(({ index }) => entry(`run-${index % kRobotColours}`, "robot"));
  return [...robots, entry("person", "person"), entry("goal", "goal"), entry("near", "nearest"), entry("touching", "touching")];
}
