// The states of the robot and the person at an instant of the clock.
import { valueAt } from "./data.js";

// {index, next, share}: the rows between which x lies in a column of increasing values, and its share
// of the way from one to the other.
export function interpolationAt(table, x) {
  let low = 0, high = table.rows - 1;
  if (high < 1) return { index: 0, next: 0, share: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (valueAt(table, middle) <= x) low = middle;
    else high = middle;
  }
  const from = valueAt(table, low), to = valueAt(table, high);
  const share = to > from ? Math.min(1, Math.max(0, (x - from) / (to - from))) : 0;
  return { index: low, next: high, share };
}

// A plan's motions on one clock: [{motion, begin, end}] in the order in which they are played.
export function timedMotions(plan) {
  const first = plan.motions.findIndex(({ name }) => name !== "approach");
  let begin = 0;
  for (let i = 0; i < first; ++i) begin -= lastTime(plan.motions[i]);
  return plan.motions.map((motion) => {
    const timedMotion = { motion, begin, end: begin + lastTime(motion) };
    begin = timedMotion.end;
    return timedMotion;
  });
}

const lastTime = ({ time }) => (time.rows > 0 ? valueAt(time, time.rows - 1) : 0);

export const clockRange = (plan) => {
  const all = timedMotions(plan);
  return all.length > 0 ? { begin: all[0].begin, end: all[all.length - 1].end } : { begin: 0, end: 0 };
};

export const isGoalMotion = ({ name }) => name !== "approach" && name !== "retreat";

// True of a shown plan whose path repair changed.
export const isPathChanged = ({ plan }) => plan.mapped &&
    plan.motions.some((motion) => isGoalMotion(motion) && motion.origin.values.some((value) => value > 0));

// {motion, index, next, share, demonstration_s, q, human: {index, next, share}} at a time of the clock;
// null if nothing was planned. Between samples: the cubic through position and velocity.
export function stateAt(plan, robot, time) {
  const all = timedMotions(plan);
  if (all.length === 0) return null;
  const timedMotion = all.find(({ end }) => time <= end) ?? all[all.length - 1];
  const { motion } = timedMotion;
  const interpolation = interpolationAt(motion.time, time - timedMotion.begin);
  const { index, next, share } = interpolation;
  const interpolate = (table) => {
    const from = valueAt(table, index);
    return from + share * (valueAt(table, next) - from);
  };
  const demonstration_s = interpolate(motion.demonstration_time);
  return {
    motion, index, next, share, demonstration_s,
    q: positionAt(motion, robot, interpolation),
    human: interpolationAt(plan.human.time, demonstration_s),
  };
}

function positionAt(motion, robot, { index, next, share }) {
  const { position, velocity } = motion;
  const q = new Float64Array(position.cols);
  const h = valueAt(motion.time, next) - valueAt(motion.time, index);
  for (let j = 0; j < q.length; ++j) {
    const from = valueAt(position, index, j), to = valueAt(position, next, j);
    if (share === 0 || !velocity) {
      q[j] = from + share * (to - from);
      continue;
    }
    const limit = robot.joints[j].velocity * h;
    const v0 = valueAt(velocity, index, j) * limit, v1 = valueAt(velocity, next, j) * limit;
    const s = share;
    q[j] = (1 + 2 * s) * (1 - s) ** 2 * from + s * (1 - s) ** 2 * v0 +
        s * s * (3 - 2 * s) * to - s * s * (1 - s) * v1;
  }
  return q;
}

// The clock's time at which a plan follows a demonstration time.
export function timeOfDemonstration(plan, demonstration_s) {
  const timedMotion = timedMotions(plan).find(({ motion }) => isGoalMotion(motion));
  if (!timedMotion) return 0;
  const { index, next, share } = interpolationAt(timedMotion.motion.demonstration_time, demonstration_s);
  const from = valueAt(timedMotion.motion.time, index);
  return timedMotion.begin + from + share * (valueAt(timedMotion.motion.time, next) - from);
}

// True in grasp and hold, boundaries included.
const isGrasping = (phases, demonstration_s) => phases.some(({ name, begin_s, end_s }) =>
  (name === "grasp" || name === "hold") && begin_s <= demonstration_s && demonstration_s <= end_s);

// The tolerance of a fingertip at a row of a motion of a plan [m].
export const tipTolerance = ({ tolerances }, { phases }, { demonstration_time }, index) =>
  (isGrasping(phases, valueAt(demonstration_time, index))
    ? tolerances.tracking_tolerance_grasp : tolerances.tracking_tolerance);

// Pairs of bodies that touch at a row of a motion.
export function touchingPairs({ touching }, row) {
  const pairs = [];
  for (let k = 0; k < touching.rows; ++k)
    if (valueAt(touching, k) === row) pairs.push([valueAt(touching, k, 1), valueAt(touching, k, 2)]);
  return pairs;
}
