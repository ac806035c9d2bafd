// What a plan is about: the obstacle that repair avoids, else the pair that comes nearest, and the
// direction from which it is in sight.
import { valueAt } from "./data.js";
import { forward, tipPosition } from "./kinematics.js";
import { poseMatrixAt } from "./objects.js";
import { clockRange, isGoalMotion, stateAt, timedMotions, timeOfDemonstration } from "./playback.js";

const kLargeObject_m = 0.6;

const capsuleIndex = ({ capsules }, name) => capsules.findIndex((capsule) => capsule.name === name);

// The object that most findings name before repair, -1: none.
function avoidedObject(plan) {
  const counts = plan.objects.map(({ name }) => plan.findings.filter(({ other }) => other === name).length);
  const most = Math.max(0, ...counts);
  return most > 0 ? counts.indexOf(most) : -1;
}

// {time, bodies: [first, second]} of the obstacle, null: nothing was avoided.
function avoided({ plan, robot, row }) {
  const index = row.status === "infeasible" ? -1 : avoidedObject(plan);
  if (index < 0) return null;
  const { name } = plan.objects[index];
  const certified = (row.certificate.clearance_by_kind ?? []).find(({ second }) => second === name);
  const finding = plan.findings.find(({ other }) => other === name);
  const time = certified ? certified.time : timeOfDemonstration(plan, (finding.begin_s + finding.end_s) / 2);
  return { time, bodies: [capsuleIndex(robot, certified?.first ?? finding.subject), robot.capsules.length + index] };
}

// {time, bodies} of the least slack of a motion that follows the goals; null: no pair is checked.
function tightest({ plan }) {
  let least = Infinity, found = null;
  for (const { motion, begin } of timedMotions(plan)) {
    if (!isGoalMotion(motion)) continue;
    const { nearest } = motion;
    for (let k = 0; k < motion.time.rows; ++k) {
      const slack = valueAt(nearest.distance, k) - valueAt(nearest.required, k);
      if (!(slack < least)) continue;
      least = slack;
      found = { time: begin + valueAt(motion.time, k), bodies: [valueAt(nearest.first, k), valueAt(nearest.second, k)],
                distance: valueAt(nearest.distance, k) };
    }
  }
  return found;
}

// {time (of the clock), bodies (as in `nearest`, or none), kind: "avoided" | "worst" | "tightest" | "none"}
export function subjectOf(shownPlan) {
  const { plan } = shownPlan;
  const around = avoided(shownPlan);
  if (around) return { kind: "avoided", ...around };
  const pair = tightest(shownPlan);
  if (plan.worst) return { kind: "worst", bodies: pair?.bodies ?? [], time: timeOfDemonstration(plan, plan.worst.demonstration_s) };
  return pair ? { kind: "tightest", ...pair } : { kind: "none", bodies: [], time: clockRange(plan).begin };
}

export const bodyNameOf = ({ robot, plan }, body) => (body < robot.capsules.length
    ? robot.capsules[body].name : plan.objects[body - robot.capsules.length].name);

// Points along an object's longest axis, none of one so large that a part of it is always in sight.
function objectPoints(object, matrix) {
  const { shape, size } = object;
  const length = shape === "cylinder" || shape === "capsule" ? size[1] : shape === "box" ? Math.max(...size) : 0;
  if (length > kLargeObject_m) return [];
  return [-0.45, -0.15, 0.15, 0.45].map((share) => new THREE.Vector3(0, 0, share * length).applyMatrix4(matrix));
}

const ends = ({ from, to }, pose) => [from, to].map((end) => new THREE.Vector3(...end).applyMatrix4(pose));

function bodyPoints({ plan, robot }, body, poses, demonstration_s) {
  if (body < 0) return [];
  if (body >= robot.capsules.length) {
    const object = plan.objects[body - robot.capsules.length];
    return objectPoints(object, poseMatrixAt(object, demonstration_s));
  }
  const [a, b] = ends(robot.capsules[body], poses[robot.capsules[body].frame]);
  return [a.add(b).multiplyScalar(0.5)];
}

// At an instant, in the robot's base: the points of the subject, those of the hand, and what stands
// in the way of a view of them. null: nothing was planned.
function snapshotAt(shownPlan, { bodies }, time) {
  const { plan, robot } = shownPlan;
  const now = stateAt(plan, robot, time);
  if (!now) return null;
  const poses = forward(robot, now.q);
  const obstructions = robot.capsules.map((capsule, index) => {
    const [a, b] = ends(capsule, poses[capsule.frame]);
    return { index, a, b, radius: capsule.radius };
  });
  return { points: bodies.flatMap((body) => bodyPoints(shownPlan, body, poses, now.demonstration_s)),
           hand: robot.tips.map((tip) => tipPosition(tip, poses)),
           obstructions: obstructions.filter(({ index }) => !bodies.includes(index)) };
}

// The points of a subject at its time, in the robot's base.
export const subjectPoints = (shownPlan, subject) => snapshotAt(shownPlan, subject, subject.time)?.points ?? [];

const kTurns_deg = [0, 20, -20, 40, -40, 60, -60, 80, -80, 110, -110], kElevations = [0.2, 0.5, 0.8, 1.1];
// Of the score of a direction: the hand in sight, beside 1 for the subject; all of the robot before the
// subject; each radian away from the preferred direction.
const kHandShare = 0.4, kBeforeShare = 0.3, kPerRadian = 0.3;
const kBefore_m = 0.15;

// The direction near the preferred one (in the base, as all here) from which most of the subject and
// of the hand is in sight from the beginning to the subject's time; up is the world's.
export function clearDirection(shownPlan, subject, preferred, up) {
  const { begin } = clockRange(shownPlan.plan);
  const snapshots = [begin, (begin + subject.time) / 2, subject.time].map((time) => snapshotAt(shownPlan, subject, time));
  const forwardAxis = preferred.clone().projectOnPlane(up).normalize();
  let best = preferred.clone().normalize(), bestScore = -Infinity;
  for (const turn_deg of kTurns_deg) {
    const flat = forwardAxis.clone().applyAxisAngle(up, turn_deg * Math.PI / 180);
    for (const elevation of kElevations) {
      const direction = flat.clone().multiplyScalar(Math.cos(elevation)).addScaledVector(up, Math.sin(elevation));
      const seen = snapshots.reduce((sum, { points, hand, obstructions }) =>
        sum + shareInSight(points, obstructions, direction) + kHandShare * shareInSight(hand, obstructions, direction, 0.03) -
            kBeforeShare * shareBefore(points, obstructions, direction), 0);
      const score = seen / snapshots.length - kPerRadian * direction.angleTo(preferred);
      if (score > bestScore) [best, bestScore] = [direction, score];
    }
  }
  return best;
}

// The share of the points from which a ray in a direction, begun a little away, meets no obstruction.
function shareInSight(points, obstructions, direction, away = 0) {
  if (points.length === 0) return 1;
  const hidden = points.filter((point) => {
    const ray = new THREE.Ray(point.clone().addScaledVector(direction, away), direction);
    return obstructions.some(({ a, b, radius }) => ray.distanceSqToSegment(a, b) < radius * radius);
  });
  return 1 - hidden.length / points.length;
}

// The share of the robot, by the areas of its capsules, that is nearer to the camera than all points.
function shareBefore(points, obstructions, direction) {
  const nearest = Math.max(...points.map((point) => point.dot(direction))) + kBefore_m;
  let all = 0, before = 0;
  for (const { a, b, radius } of obstructions) {
    const area = radius * (a.distanceTo(b) + 2 * radius);
    all += area;
    if ((a.dot(direction) + b.dot(direction)) / 2 > nearest) before += area;
  }
  return all > 0 ? before / all : 0;
}
