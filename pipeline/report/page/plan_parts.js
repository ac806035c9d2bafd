// The parts of a plan in the 3D view: its robot, the mapped robot, goals, objects and the person, in
// the frame of the world (X to the person's right, Y forward, Z up).
import { rowOf, valueAt } from "./data.js";
import { createGoals } from "./goals.js";
import { matrixOf } from "./kinematics.js";
import { kRobotColours } from "./materials.js";
import { createObjects } from "./objects.js";
import { createPerson } from "./person.js";
import { interpolationAt, isGoalMotion, touchingPairs } from "./playback.js";
import { createRobotModel } from "./robot_model.js";

// {shownPlan, group (of all), model, mappedModel, person, goals, objects}; the person and all objects
// belong to the first plan.
export function createPlanParts(shownPlan, materials, first, onChange) {
  const group = new THREE.Group();
  group.matrixAutoUpdate = false;
  const { plan, robot, index } = shownPlan;
  const { picked, near, touching, mesh, tip } = materials;
  const [plain, hand] = ["robot", "hand"].map((part) => materials[`${part}-${index % kRobotColours}`]);
  const robotMaterials = { plain, hand, picked, near, touching, mesh, tip };
  const model = createRobotModel(robot, robotMaterials, onChange);
  const { mappedPath } = materials;
  const mappedMaterials = { plain: mappedPath, hand: mappedPath, picked: mappedPath, near: mappedPath, touching: mappedPath };
  const mappedModel = plan.mapped ? createRobotModel(robot, mappedMaterials, onChange) : null;
  const goals = createGoals(shownPlan, materials);
  const objects = createObjects(shownPlan, materials, !first, onChange);
  const person = first ? createPerson(shownPlan, materials) : null;
  group.add(model.group, goals.group, objects.group);
  if (mappedModel) group.add(mappedModel.group);
  if (person) group.add(person.group);
  group.matrix.copy(matrixOf(plan.world_from_base));
  return { shownPlan, group, model, mappedModel, goals, objects, person };
}

const isRepairedAt = (state) => state && isGoalMotion(state.motion) &&
    (valueAt(state.motion.origin, state.index) > 0 || valueAt(state.motion.origin, state.next) > 0);

function mappedAt(plan, interpolation) {
  const { position } = plan.mapped;
  const from = rowOf(position, interpolation.index), to = rowOf(position, interpolation.next);
  return from.map((value, joint) => value + interpolation.share * (to[joint] - value));
}

// Moves the parts to a state (null: nothing was planned), and marks the picked and the nearest bodies.
export function poseParts(parts, state, { pick, nearest, isFirst, showsMapped, showsTouching }) {
  const { shownPlan, model, mappedModel, goals, objects, person } = parts;
  const { plan } = shownPlan;
  const demonstration_s = state ? state.demonstration_s : (plan.worst?.demonstration_s ?? valueAt(plan.human.time, 0));
  const human = state ? state.human : interpolationAt(plan.human.time, demonstration_s);
  model.group.visible = state !== null;
  const poses = state ? model.pose(state.q) : null;
  if (mappedModel) {
    mappedModel.group.visible = showsMapped && Boolean(isRepairedAt(state));
    if (mappedModel.group.visible) mappedModel.pose(mappedAt(plan, human));
  }
  goals.pose(human, state && isGoalMotion(state.motion) ? poses : null, pick);
  objects.pose(state, demonstration_s);
  person?.pose(human);
  const touching = new Set(state && showsTouching ? touchingPairs(state.motion, state.index).flat() : []);
  model.highlight(isFirst || pick?.kind !== "pair" ? pick : null, nearest, touching);
  objects.highlight(isFirst ? pick : null, nearest, touching);
}

// The bounding box of robots and the person's arms, in the world.
export function boundsOf(shownParts) {
  const box = new THREE.Box3();
  for (const { group, model, person } of shownParts) {
    group.updateMatrixWorld(true);
    if (model.group.visible) box.expandByObject(model.capsulesGroup);
    if (person) person.arm.children.filter(({ visible }) => visible).forEach((part) => box.expandByObject(part));
  }
  return box;
}

export function disposeParts({ group }) {
  group.traverse((part) => part.geometry?.dispose());
}

// A grid below everything that is shown.
export function createFloor(shownParts, material) {
  const box = boundsOf(shownParts);
  for (const { objects, person } of shownParts) {
    box.expandByObject(objects.group);
    if (person) box.expandByObject(person.group);
  }
  const floor = new THREE.GridHelper(4, 20);
  floor.geometry.rotateX(Math.PI / 2);
  floor.material = material;
  floor.position.z = Number.isFinite(box.min.z) ? box.min.z - 0.002 : 0;
  return floor;
}
