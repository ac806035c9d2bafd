// What the plots beside the 3D view show: tables of numbers over the clock.
import { at } from "./data.js";
import { clips, isGoalMotion, stateAt, timeOfDemonstration } from "./player.js";

// {title, unit, names, kind of what a series stands for, rows: [[time, value…]], limits: [lines]}
const plotOf = (title, unit, series, rows, more = {}) => ({ title, unit, series, rows, ...more });

// One row a sample of all motions; null: nothing there.
function overMotions(plan, count, valueAt) {
  const rows = [];
  for (const { motion, begin } of clips(plan)) {
    for (let k = 0; k < motion.time.rows; ++k) {
      const row = [begin + at(motion.time, k)];
      for (let i = 0; i < count; ++i) {
        const value = valueAt(motion, k, i);
        row.push(Number.isFinite(value) ? value : null);
      }
      // dygraphs wants times that rise.
      if (rows.length === 0 || row[0] > rows[rows.length - 1][0]) rows.push(row);
    }
  }
  return rows;
}

const shareOfRange = ({ lower, upper }, q) => 100 * (q - lower) / (upper - lower);

function jointPlots({ plan, robot }) {
  const joints = robot.joints;
  const series = joints.map(({ name }, index) => ({ name, pick: { kind: "joint", index } }));
  const share = (table) => (motion, k, j) => (motion[table] ? 100 * at(motion[table], k, j) : NaN);
  const plot = (title, unit, limits, value) =>
      plotOf(title, unit, series, overMotions(plan, joints.length, value), { limits });
  const plots = [plot("Joint positions", "% of range", [0, 100],
      (motion, k, j) => shareOfRange(joints[j], at(motion.position, k, j)))];
  if (plan.motions.some((motion) => motion.velocity)) {
    for (const [title, table] of [["Velocity", "velocity"], ["Acceleration", "acceleration"], ["Jerk", "jerk"]]) {
      plots.push(plot(title, "% of limit", [-100, 100], share(table)));
    }
  }
  return plots;
}

const kGrasping = [3, 4]; // phases grasp and hold

function tipPlot({ plan, robot, row }) {
  const { tracking_tolerance, tracking_tolerance_grasp } = row.tolerances;
  const series = robot.tips.map(({ name }, index) => ({ name, pick: { kind: "finger", index } }));
  series.push({ name: "tolerance", line: true });
  const tips = robot.tips.length;
  return plotOf("Fingertip error", "mm", series, overMotions(plan, tips + 1, (motion, k, i) => {
    if (!motion.tip_error) return NaN;
    if (i < tips) return 1e3 * at(motion.tip_error, k, i);
    return 1e3 * (kGrasping.includes(at(motion.phase, k)) ? tracking_tolerance_grasp : tracking_tolerance);
  }));
}

// A number of another run at the same instants of the demonstration.
function ofOthers(players, first, value) {
  return players.slice(1).map((player) => {
    const table = new Map();
    return (motion, k) => {
      if (!isGoalMotion(motion)) return NaN;
      const demonstration_s = at(motion.demonstration_time, k);
      const state = stateAt(player.plan, player.robot, timeOfDemonstration(player.plan, demonstration_s));
      return state ? value(state.motion, state.index) : NaN;
    };
  });
}

function plotOfRuns(players, title, unit, own, value, more = {}) {
  const others = ofOthers(players, players[0], value);
  const label = players.length > 1 ? players[0].label : "robot";
  const series = [{ name: label }, ...players.slice(1).map((player) => ({ name: player.label })),
                  ...own.map(({ name, line }) => ({ name, line }))];
  const columns = [value, ...others, ...own.map(({ value: of }) => of)];
  return plotOf(title, unit, series,
      overMotions(players[0].plan, columns.length, (motion, k, i) => columns[i](motion, k)), more);
}

export function plotsOf(players) {
  const [first] = players;
  const { plan, row } = first;
  if (plan.motions.length === 0) return [];
  const atDemonstration = (table, of) => (motion, k) => {
    if (!table || !isGoalMotion(motion)) return NaN;
    const frame = nearestFrame(plan.human.time, at(motion.demonstration_time, k));
    return of(frame);
  };
  const human = { name: "person", value: atDemonstration(plan.human.speed, (f) => at(plan.human.speed, f)) };
  const mapped = { name: "mapped", line: true,
                   value: atDemonstration(plan.mapped, (f) => at(plan.mapped.humanlikeness, f, 0)) };
  const margin = { name: "minimum", line: true, value: () => 1e3 * row.tolerances.required_clearance };
  const clearance = (motion, k) =>
      1e3 * (motion.clearance ? at(motion.clearance, k) : at(motion.nearest.distance, k));
  const plots = [
    tipPlot(first),
    plotOfRuns(players, "Clearance", "mm", [margin], clearance),
    plotOfRuns(players, "Tip speed", "m/s", [human], (motion, k) => (motion.speed ? at(motion.speed, k) : NaN)),
    plotOfRuns(players, "Distance from the person's arm (A)", "m²", [mapped],
        (motion, k) => (motion.humanlikeness ? at(motion.humanlikeness, k) : NaN)),
    ...jointPlots(first),
  ];
  return plots.filter(({ rows }) => rows.some((each) => each.slice(1).some((value) => value !== null)));
}

function nearestFrame(times, time) {
  let best = 0;
  for (let f = 1; f < times.rows; ++f) {
    if (Math.abs(at(times, f) - time) < Math.abs(at(times, best) - time)) best = f;
  }
  return best;
}
