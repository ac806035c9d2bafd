// The values of the plots beside the 3D view: tables of numbers over the clock.
import { valueAt } from "./data.js";
import { isGoalMotion, stateAt, timedMotions, timeOfDemonstration, tipTolerance } from "./playback.js";

// {title, unit, series: [{name, pick, isReference}], rows: [[time, value…]], limits: [low, high],
// group: the heading of plots with the same series}
const plotOf = (title, unit, series, rows, more = {}) => ({ title, unit, series, rows, ...more });

// One row per sample of all motions; null: no value.
function rowsOverMotions(plan, count, seriesValue) {
  const rows = [];
  for (const { motion, begin } of timedMotions(plan)) {
    for (let k = 0; k < motion.time.rows; ++k) {
      const row = [begin + valueAt(motion.time, k)];
      for (let i = 0; i < count; ++i) {
        const value = seriesValue(motion, k, i);
        row.push(Number.isFinite(value) ? value : null);
      }
      // dygraphs needs increasing times.
      if (rows.length === 0 || row[0] > rows[rows.length - 1][0]) rows.push(row);
    }
  }
  return rows;
}

const shareOfRange = ({ lower, upper }, q) => 100 * (q - lower) / (upper - lower);

function jointPlots({ plan, robot }) {
  const joints = robot.joints;
  const series = joints.map(({ name }, index) => ({ name, pick: { kind: "joint", index } }));
  const share = (table) => (motion, k, j) => (motion[table] ? 100 * valueAt(motion[table], k, j) : NaN);
  const jointPlot = (title, unit, limits, value) =>
      plotOf(title, unit, series, rowsOverMotions(plan, joints.length, value), { limits, group: "Joints" });
  const plots = [jointPlot("Position", "% of range", [0, 100],
      (motion, k, j) => shareOfRange(joints[j], valueAt(motion.position, k, j)))];
  if (plan.motions.some((motion) => motion.velocity)) {
    for (const [title, table] of [["Velocity", "velocity"], ["Acceleration", "acceleration"], ["Jerk", "jerk"]]) {
      plots.push(jointPlot(title, "% of limit", [-100, 100], share(table)));
    }
  }
  return plots;
}

function tipPlot({ plan, robot, row }) {
  const series = robot.tips.map(({ name }, index) => ({ name, pick: { kind: "finger", index } }));
  series.push({ name: "tolerance", isReference: true });
  const tips = robot.tips.length;
  return plotOf("Fingertip error", "mm", series, rowsOverMotions(plan, tips + 1, (motion, k, i) => {
    if (!motion.tip_error) return NaN;
    return 1e3 * (i < tips ? valueAt(motion.tip_error, k, i) : tipTolerance(row, plan, motion, k));
  }));
}

const kArmErrors = ["upper arm", "forearm", "swivel", "palm"];

// The angles between the first robot's arm and the person's.
function armPlot({ plan }) {
  return plotOf("Arm against the person's", "°", kArmErrors.map((name) => ({ name })),
      rowsOverMotions(plan, kArmErrors.length, (motion, k, i) =>
        (motion.arm_error ? 180 / Math.PI * valueAt(motion.arm_error, k, i) : NaN)));
}

// The values of the other runs at the same instants of the demonstration.
function valuesOfOtherRuns(shownPlans, value) {
  return shownPlans.slice(1).map(({ plan, robot }) => (motion, k) => {
    if (!isGoalMotion(motion)) return NaN;
    const demonstration_s = valueAt(motion.demonstration_time, k);
    const state = stateAt(plan, robot, timeOfDemonstration(plan, demonstration_s));
    return state ? value(state.motion, state.index) : NaN;
  });
}

// A quantity of all runs, with further series of the first one's plan or person.
function plotOfRuns(shownPlans, title, unit, furtherSeries, value) {
  const [first, ...others] = shownPlans;
  const series = [{ name: others.length > 0 ? first.label : "robot" }, ...others.map(({ label }) => ({ name: label })),
                  ...furtherSeries];
  const columns = [value, ...valuesOfOtherRuns(shownPlans, value), ...furtherSeries.map((further) => further.value)];
  return plotOf(title, unit, series,
      rowsOverMotions(first.plan, columns.length, (motion, k, i) => columns[i](motion, k)));
}

export function plotsOf(shownPlans) {
  const [first] = shownPlans;
  const { plan, row } = first;
  if (plan.motions.length === 0) return [];
  const frameValue = (table) => (motion, k) => {
    if (!table || !isGoalMotion(motion)) return NaN;
    return valueAt(table, nearestFrame(plan.human.time, valueAt(motion.demonstration_time, k)));
  };
  const human = { name: "person", value: frameValue(plan.human.speed) };
  const mapped = { name: "mapped", isReference: true, value: frameValue(plan.mapped?.humanlikeness) };
  const minimum = { name: "minimum", isReference: true, value: () => 1e3 * row.tolerances.required_clearance };
  const clearance = (motion, k) =>
      1e3 * (motion.clearance ? valueAt(motion.clearance, k) : valueAt(motion.nearest.distance, k));
  const plots = [
    tipPlot(first),
    plotOfRuns(shownPlans, "Clearance", "mm", [minimum], clearance),
    plotOfRuns(shownPlans, "Tip speed", "m/s", [human], (motion, k) => (motion.speed ? valueAt(motion.speed, k) : NaN)),
    plotOfRuns(shownPlans, "Distance from the person's arm (A)", "m²", [mapped],
        (motion, k) => (motion.humanlikeness ? valueAt(motion.humanlikeness, k) : NaN)),
    armPlot(first),
    ...jointPlots(first),
  ];
  return plots.filter(({ rows }) => rows.some((row) => row.slice(1).some((value) => value !== null)));
}

function nearestFrame(times, time) {
  let best = 0;
  for (let f = 1; f < times.rows; ++f) {
    if (Math.abs(valueAt(times, f) - time) < Math.abs(valueAt(times, best) - time)) best = f;
  }
  return best;
}
