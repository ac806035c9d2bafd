// The number of plans of each status and reason, as buttons that select them; for several runs a table
// of their medians.
import { reasonSentence, report, rows } from "./data.js";
import { build, buildButton, buildName, runClass } from "./elements.js";
import { filter, passing, setFilter } from "./filter.js";
import { countText, medianOf } from "./format.js";
import { buildNumberCell, measures, valuesOf } from "./measures.js";

// [[value, count]] of a key of the rows, the most frequent first.
const countValues = (key) => {
  const counts = new Map();
  for (const row of rows) if (row[key] !== "") counts.set(row[key], (counts.get(row[key]) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a);
};

const countShown = (key, value) => rows.reduce((sum, row, i) => sum + (passing[i] && row[key] === value ? 1 : 0), 0);

function countButton(key, value, count, hint) {
  const number = build("b", {}, String(count));
  const button = buildButton("", { class: `count ${key}-${value}`, title: hint, "aria-pressed": "false" },
      () => setFilter({ [key]: filter[key] === value ? "" : value }));
  button.append(number, ` ${value}`);
  const update = () => {
    const shown = countShown(key, value);
    number.textContent = shown === count ? String(count) : `${shown} of ${count}`;
    button.setAttribute("aria-pressed", String(filter[key] === value));
  };
  return { button, update };
}

// {section, update}
export function buildCounts() {
  const statuses = countValues("status").map(([value, count]) => countButton("status", value, count, ""));
  const reasons = countValues("reason").map(([value, count]) =>
    countButton("reason", value, count, reasonSentence(value)));
  const section = build("section", { "aria-labelledby": "counts-title" },
      build("h2", { id: "counts-title" }, "Plans"),
      build("div", { class: "counts" }, build("span", { class: "count-all" }, build("b", {}, String(rows.length)), rows.length === 1 ? " plan" : " plans"),
          ...statuses.map(({ button }) => button)));
  if (reasons.length > 0) {
    section.append(build("div", { class: "counts reasons" }, build("span", { class: "muted" }, "reasons"),
        ...reasons.map(({ button }) => button)));
  }
  if (report.runs.length > 1) section.append(buildRunsTable());
  const update = () => [...statuses, ...reasons].forEach((countEntry) => countEntry.update());
  return { section, update };
}

function buildRunsTable() {
  const shown = measures.filter((measure) => valuesOf(measure).some((x) => !Number.isNaN(x)) && !measure.valueNames);
  const head = build("tr", {}, build("th", { scope: "col" }, "Run"), build("th", { scope: "col" }, "Executable"),
      ...shown.map(({ label, unit }) => build("th", { scope: "col", class: "number" }, `${label} ${unit}`)));
  const runRows = report.runs.map(({ name }, run) => {
    const planIndices = rows.map((_, i) => i).filter((i) => rows[i].run === run);
    const executableCount = planIndices.filter((i) => rows[i].status === "executable").length;
    return build("tr", {},
        build("th", { scope: "row" }, build("span", { class: runClass(run), "aria-hidden": "true" }), " ", buildName(name)),
        build("td", {}, `${executableCount} of ${countText(planIndices.length, "plan")}`),
        ...shown.map((measure) => buildNumberCell(measure, medianOf(planIndices.map((i) => valuesOf(measure)[i])))));
  });
  return build("div", { class: "table-box plain" }, build("table", { class: "medians" },
      build("caption", {}, "Medians of each run's plans"), build("thead", {}, head), build("tbody", {}, ...runRows)));
}
