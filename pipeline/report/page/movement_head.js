// What stands in words on a movement's page: title, reason, flags, advice and figures.
import { reasonSentence, report } from "./data.js";
import { build, buildButton, buildName, buildStatus } from "./elements.js";
import { plainText } from "./format.js";
import { measures, measureText, shownValue } from "./measures.js";
import { timeOfDemonstration } from "./playback.js";
import { setTime } from "./state.js";

export function titleOf(row) {
  const run = report.runs.length > 1 ? build("span", { class: "muted" }, report.runs[row.run].name) : null;
  // Files of earlier versions and hands without an arm have no branch.
  const { branch_words: words = [], branch_changes: changes = [] } = row;
  const branch = words.length > 0
    ? build("span", { class: "muted small", title: "branch of the arm" }, plainText([words.join(", "), ...changes].join("; "))) : null;
  return [buildName(row.plan), " ", buildStatus(row.status), row.certificate.repaired ? " repaired " : " ", run, " ", branch]
    .filter((part) => part !== null);
}

const flagsOf = (row) => row.flags.map((flag) => build("p", {}, build("b", {}, "flag "), plainText(flag)));

export function reasonOf(plan, row) {
  const flags = flagsOf(row);
  if (row.reason === "")
    return row.detail ? [build("p", {}, plainText(row.detail)), ...flags] : flags;
  const parts = [build("p", {}, build("b", {}, row.reason), ": ", reasonSentence(row.reason)),
                 build("p", {}, plainText(row.detail)), ...flags];
  if (plan.worst) {
    const time = timeOfDemonstration(plan, plan.worst.demonstration_s);
    parts.push(build("p", {}, "Worst instant: ", plainText(plan.worst.sentence), " ",
        buildButton("show it", {}, () => setTime(time))));
  }
  if (plan.advice.length > 0) {
    parts.push(build("p", {}, "Suggestions:"),
               build("ul", {}, ...plan.advice.map((sentence) => build("li", {}, plainText(sentence)))));
  }
  if (plan.motions.length === 0) parts.push(build("p", {}, "Nothing was planned: the person alone is shown."));
  return parts;
}

const kLimitFigures = [["velocity_ratio", "velocity"], ["acceleration_ratio", "acceleration"],
                       ["jerk_ratio", "jerk"]];

export function figuresOf(row) {
  const entry = (name, value, exactText) =>
    build("div", {}, build("dt", {}, name), build("dd", { title: exactText }, value));
  const shown = measures.map((measure) => {
    const value = shownValue(measure, row);
    if (Number.isNaN(value)) return null;
    const text = `${measureText(measure, value)} ${measure.unit}`;
    return entry(measure.title, text, `${measure.source} = ${measure.rawValue(row)} ${measure.siUnit}`);
  });
  for (const [key, name] of kLimitFigures) {
    const value = row.certificate[key];
    if (typeof value === "number")
      shown.push(entry(`${name}, of limit`, `${(100 * value).toFixed(1)} %`, String(value)));
  }
  return shown.filter((entry) => entry !== null);
}
