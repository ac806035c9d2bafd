// Where the robot and the person are at an instant of the clock.
import { at } from "./data.js";

// Index of the last value not above x, at least 0 and at most the last but one; and the share of
// the way to the next.
export function place(table, x) {
  let low = 0, high = table.rows - 1;
  if (high < 1) return { index: 0, next: 0, share: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (at(table, middle) <= x) low = middle;
    else high = middle;
  }
  const from = at(table, low), to = at(table, high);
  const share = to > from ? Math.min(1, Math.max(0, (x - from) / (to - from))) : 0;
  return { index: low, next: high, share };
}

// A plan's motions on one clock: [{motion, begin, end}] in the order in which they are played.
export function clips(plan) {
  const first = plan.motions.findIndex(({ name }) => name !== "approach");
  let begin = 0;
  for (let i = 0; i < first; ++i) begin -= lastTime(plan.motions[i]);
  return plan.motions.map((motion) => {
    const clip = { motion, begin, end: begin + lastTime(motion) };
    begin = clip.end;
    return clip;
  });
}

const lastTime = ({ time }) => (time.rows > 0 ? at(time, time.rows - 1) : 0);

export const clockRange = (plan) => {
  const all = clips(plan);
  return all.length > 0 ? { begin: all[0].begin, end: all[all.length - 1].end } : { begin: 0, end: 0 };
};

export const isGoalMotion = ({ name }) => name !== "approach" && name !== "retreat";

// {motion, clip, index, next, share, demonstration_s, q, human: {index, next, share}} at a time of the clock;
// null if nothing was planned. Between samples: the cubic through position and velocity.
export function stateAt(plan, robot, time) {
  const all = clips(plan);
  if (all.length === 0) return null;
  const clip = all.find(({ end }) => time <= end) ?? all[all.length - 1];
  const { motion } = clip;
  const where = place(motion.time, time - clip.begin);
  const { index, next, share } = where;
  const between = (table) => {
    const from = at(table, index);
    return from + share * (at(table, next) - from);
  };
  const demonstration_s = between(motion.demonstration_time);
  return {
    clip, motion, index, next, share, demonstration_s,
    q: positionAt(motion, robot, where),
    human: place(plan.human.time, demonstration_s),
  };
}

function positionAt(motion, robot, { index, next, share }) {
  const { position, velocity } = motion;
  const q = new Float64Array(position.cols);
  const h = at(motion.time, next) - at(motion.time, index);
  for (let j = 0; j < q.length; ++j) {
    const from = at(position, index, j), to = at(position, next, j);
    if (share === 0 || !velocity) {
      q[j] = from + share * (to - from);
      continue;
    }
    const limit = robot.joints[j].velocity * h;
    const v0 = at(velocity, index, j) * limit, v1 = at(velocity, next, j) * limit;
    const s = share;
    q[j] = (1 + 2 * s) * (1 - s) ** 2 * from + s * (1 - s) ** 2 * v0 +
        s * s * (3 - 2 * s) * to - s * s * (1 - s) * v1;
  }
  return q;
}

// The clock's time at which a plan follows a demonstration time.
export function timeOfDemonstration(plan, demonstration_s) {
  const clip = clips(plan).find(({ motion }) => isGoalMotion(motion));
  if (!clip) return 0;
  const { index, next, share } = place(clip.motion.demonstration_time, demonstration_s);
  const from = at(clip.motion.time, index);
  return clip.begin + from + share * (at(clip.motion.time, next) - from);
}

// Pairs of bodies that touch at a row of a motion.
export function touchingPairs({ touching }, row) {
  const pairs = [];
  for (let k = 0; k < touching.rows; ++k)
    if (at(touching, k) === row) pairs.push([at(touching, k, 1), at(touching, k, 2)]);
  return pairs;
}
