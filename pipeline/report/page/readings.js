// Every joint, fingertip and the nearest pair in numbers at one instant, to be picked.
import { valueAt } from "./data.js";
import { build, buildButton } from "./elements.js";
import { numberText, plainText } from "./format.js";
import { tipTolerance, touchingPairs } from "./playback.js";
import { on, pick, state } from "./state.js";
import { bodyNameOf } from "./subject.js";

const kUpdatesPerSecond = 5; // a playing clock does not rewrite the table at every frame

export function createReadings(host) {
  let shownPlan = null, entries = [], state_now = null, writeTimer = 0;
  const nearest = build("p", { class: "nearest" });
  const write = () => {
    writeTimer = 0;
    for (const entry of entries) entry.write(state_now);
    writeNearest(nearest, shownPlan, state_now);
  };
  on("pick", () => {
    for (const { button, selection } of entries)
      button.setAttribute("aria-pressed", JSON.stringify(selection) === JSON.stringify(state.pick));
  });
  return {
    show(newPlan) {
      shownPlan = newPlan;
      const joints = shownPlan.robot.joints.map((joint, index) => jointEntry(joint, index));
      const tips = shownPlan.robot.tips.map((tip, index) => tipEntry(shownPlan, tip, index));
      entries = [...joints, ...tips];
      host.replaceChildren(nearest,
          buildTableOf(["joint", "position", "share of range", "velocity", "acceleration", "jerk"], joints),
          buildTableOf(["fingertip", "error", "tolerance"], tips));
    },
    update(newState) {
      state_now = newState;
      writeTimer ||= setTimeout(write, 1000 / kUpdatesPerSecond);
    },
  };
}

const buildTableOf = (names, entries) =>
  build("table", {}, build("thead", {}, build("tr", {}, ...names.map((name) => build("th", { scope: "col" }, name)))),
      build("tbody", {}, ...entries.map(({ row }) => row)));

// A line of a table: {row (its element), button, selection, write(state)}.
function entryOf(name, selection, count, valuesAt) {
  const cells = Array.from({ length: count }, () => build("td", { class: "number" }));
  const button = buildButton(plainText(name), { "aria-pressed": "false" }, () => pick(selection));
  const row = build("tr", {}, build("th", { scope: "row" }, button), ...cells);
  const write = (now) => {
    const values = now ? valuesAt(now) : [];
    cells.forEach((cell, i) => { cell.textContent = values[i] ?? "–"; });
  };
  return { row, button, selection, write };
}

function jointEntry({ name, lower, upper, prismatic }, index) {
  const unit = prismatic ? [1e3, "mm"] : [180 / Math.PI, "°"];
  return entryOf(name, { kind: "joint", index }, 5, ({ motion, index: row, q }) => {
    const share = (kind) => (motion[kind] ? `${numberText(100 * valueAt(motion[kind], row, index))} %` : "–");
    return [`${numberText(unit[0] * q[index])} ${unit[1]}`,
            `${(100 * (q[index] - lower) / (upper - lower)).toFixed(1)} %`,
            share("velocity"), share("acceleration"), share("jerk")];
  });
}

const tipEntry = ({ row, plan }, { name }, index) =>
  entryOf(name, { kind: "finger", index }, 2, ({ motion, index: sample }) => {
    if (!motion.tip_error) return [];
    return [valueAt(motion.tip_error, sample, index), tipTolerance(row, plan, motion, sample)]
      .map((metres) => `${numberText(1e3 * metres)} mm`);
  });

const bodyName = (shownPlan, index) => plainText(bodyNameOf(shownPlan, index));

function writeNearest(host, shownPlan, now) {
  if (!now || valueAt(now.motion.nearest.first, now.index) < 0) {
    host.replaceChildren("Closest pair: no pair is checked");
    return;
  }
  const { nearest } = now.motion;
  const first = valueAt(nearest.first, now.index), second = valueAt(nearest.second, now.index);
  const distance_mm = 1e3 * valueAt(nearest.distance, now.index), required_mm = 1e3 * valueAt(nearest.required, now.index);
  const button = buildButton(`${bodyName(shownPlan, first)} – ${bodyName(shownPlan, second)}`, {},
      () => pick({ kind: "pair", first, second }));
  const touching = touchingPairs(now.motion, now.index).map(([a, b]) =>
    `${bodyName(shownPlan, a)} – ${bodyName(shownPlan, b)}`);
  host.replaceChildren("Closest pair: ", button,
      `, ${numberText(distance_mm)} mm (minimum ${numberText(required_mm)})`,
      touching.length > 0 ? ` · touching: ${touching.join(", ")}` : "");
}
