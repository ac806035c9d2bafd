// Every joint, fingertip and the nearest pair in numbers at one instant, to be picked.
import { at } from "./data.js";
import { build, buildButton } from "./elements.js";
import { touchingPairs } from "./player.js";
import { on, pick, state } from "./state.js";
import { figureText, plainText } from "./words.js";

const kPerSecond = 5; // a playing clock does not rewrite the table at every frame

export function createReadings(host) {
  let player = null, lines = [], now = null, wanted = 0;
  const nearest = build("p", { class: "nearest" });
  const write = () => {
    wanted = 0;
    for (const line of lines) line.write(now);
    writeNearest(nearest, player, now);
  };
  on("pick", () => {
    for (const { button, what } of lines)
      button.setAttribute("aria-pressed", JSON.stringify(what) === JSON.stringify(state.pick));
  });
  return {
    show(shown) {
      player = shown;
      const joints = player.robot.joints.map((joint, index) => jointLine(joint, index));
      const tips = player.robot.tips.map((tip, index) => tipLine(player, tip, index));
      lines = [...joints, ...tips];
      host.replaceChildren(nearest,
          table(["joint", "position", "share of range", "velocity", "acceleration", "jerk"], joints),
          table(["fingertip", "error", "tolerance"], tips));
    },
    update(state_now) {
      now = state_now;
      wanted ||= setTimeout(write, 1000 / kPerSecond);
    },
  };
}

const table = (names, lines) =>
  build("table", {}, build("thead", {}, build("tr", {}, ...names.map((name) => build("th", { scope: "col" }, name)))),
      build("tbody", {}, ...lines.map(({ row }) => row)));

function lineOf(name, what, count, valuesAt) {
  const cells = Array.from({ length: count }, () => build("td", { class: "number" }));
  const button = buildButton(plainText(name), { "aria-pressed": "false" }, () => pick(what));
  const row = build("tr", {}, build("th", { scope: "row" }, button), ...cells);
  const write = (now) => {
    const values = now ? valuesAt(now) : [];
    cells.forEach((cell, i) => { cell.textContent = values[i] ?? "–"; });
  };
  return { row, button, what, write };
}

function jointLine({ name, lower, upper, prismatic }, index) {
  const unit = prismatic ? [1e3, "mm"] : [180 / Math.PI, "°"];
  return lineOf(name, { kind: "joint", index }, 5, ({ motion, index: row, q }) => {
    const share = (kind) => (motion[kind] ? `${figureText(100 * at(motion[kind], row, index))} %` : "–");
    return [`${figureText(unit[0] * q[index])} ${unit[1]}`,
            `${(100 * (q[index] - lower) / (upper - lower)).toFixed(1)} %`,
            share("velocity"), share("acceleration"), share("jerk")];
  });
}

const kGraspAndHold = [3, 4];

function tipLine({ row }, { name }, index) {
  const { tracking_tolerance, tracking_tolerance_grasp } = row.tolerances;
  return lineOf(name, { kind: "finger", index }, 2, ({ motion, index: sample }) => {
    if (!motion.tip_error) return [];
    const allowed = kGraspAndHold.includes(at(motion.phase, sample)) ? tracking_tolerance_grasp : tracking_tolerance;
    return [`${figureText(1e3 * at(motion.tip_error, sample, index))} mm`, `${figureText(1e3 * allowed)} mm`];
  });
}

export const bodyName = ({ robot, plan }, index) =>
  plainText(index < robot.capsules.length ? robot.capsules[index].name
      : plan.objects[index - robot.capsules.length].name);

function writeNearest(host, player, now) {
  if (!now || at(now.motion.nearest.first, now.index) < 0) {
    host.replaceChildren("Closest pair: no pair is checked");
    return;
  }
  const { nearest } = now.motion;
  const first = at(nearest.first, now.index), second = at(nearest.second, now.index);
  const apart = 1e3 * at(nearest.distance, now.index), required = 1e3 * at(nearest.required, now.index);
  const button = buildButton(`${bodyName(player, first)} – ${bodyName(player, second)}`, {},
      () => pick({ kind: "pair", first, second }));
  const touching = touchingPairs(now.motion, now.index).map(([a, b]) =>
    `${bodyName(player, a)} – ${bodyName(player, b)}`);
  host.replaceChildren("Closest pair: ", button,
      `, ${figureText(apart)} mm (minimum ${figureText(required)})`,
      touching.length > 0 ? ` · touching: ${touching.join(", ")}` : "");
}
