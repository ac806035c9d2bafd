// How many plans of each status and reason, as buttons that select; of several runs a line each, and
// what their plans measure in the median.
import { reasonSentence, report, rows } from "./data.js";
import { build, buildButton, buildName, runClass } from "./elements.js";
import { filter, passing, setFilter } from "./filter.js";
import { buildFigure, measures, valuesOf } from "./measures.js";
import { counted, medianOf } from "./words.js";

const tally = (of) => {
  const counts = new Map();
  for (const row of rows) if (of(row) !== "") counts.set(of(row), (counts.get(of(row)) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a);
};

const nowCounted = (key, value) => rows.reduce((sum, row, i) => sum + (passing[i] && row[key] === value ? 1 : 0), 0);

function countButton(key, value, count, hint) {
  const number = build("b", {}, String(count));
  const button = buildButton("", { class: `count ${key}-${value}`, title: hint, "aria-pressed": "false" },
      () => setFilter({ [key]: filter[key] === value ? "" : value }));
  button.append(number, ` ${value}`);
  const update = () => {
    const shown = nowCounted(key, value);
    number.textContent = shown === count ? String(count) : `${shown} of ${count}`;
    button.setAttribute("aria-pressed", String(filter[key] === value));
  };
  return { button, update };
}

// {section, update}
export function buildCounts() {
  const statuses = tally(({ status }) => status).map(([value, count]) => countButton("status", value, count, ""));
  const reasons = tally(({ reason }) => reason).map(([value, count]) =>
    countButton("reason", value, count, reasonSentence(value)));
  const section = build("section", { "aria-labelledby": "counts-title" },
      build("h2", { id: "counts-title" }, "Plans"),
      build("div", { class: "counts" }, build("span", { class: "count-all" }, build("b", {}, String(rows.length)), " plans"),
          ...statuses.map(({ button }) => button)));
  if (reasons.length > 0) {
    section.append(build("div", { class: "counts reasons" }, build("span", { class: "muted" }, "reasons"),
        ...reasons.map(({ button }) => button)));
  }
  if (report.runs.length > 1) section.append(runsTable());
  const update = () => [...statuses, ...reasons].forEach((each) => each.update());
  return { section, update };
}

function runsTable() {
  const shown = measures.filter((measure) => valuesOf(measure).some((x) => !Number.isNaN(x)) && !measure.words);
  const head = build("tr", {}, build("th", { scope: "col" }, "Run"), build("th", { scope: "col" }, "Executable"),
      ...shown.map(({ short, unit }) => build("th", { scope: "col", class: "number" }, `${short} ${unit}`)));
  const lines = report.runs.map(({ name }, run) => {
    const own = rows.map((_, i) => i).filter((i) => rows[i].run === run);
    const good = own.filter((i) => rows[i].status === "executable").length;
    return build("tr", {},
        build("th", { scope: "row" }, build("span", { class: runClass(run), "aria-hidden": "true" }), " ", buildName(name)),
        build("td", {}, `${good} of ${counted(own.length, "plan")}`),
        ...shown.map((measure) => buildFigure(measure, medianOf(own.map((i) => valuesOf(measure)[i])))));
  });
  return build("div", { class: "table-box plain" }, build("table", { class: "medians" },
      build("caption", {}, "Medians of each run's plans"), build("thead", {}, head), build("tbody", {}, ...lines)));
}
