// Columns of the first page's table: plans, or the differences of two runs.
import { report, rows } from "./data.js";
import { build, buildName, buildStatus, runClass } from "./elements.js";
import { fillMeasure, measureText, measures, shownValue, valuesOf } from "./measures.js";
import { addressOf } from "./state.js";
import { plainText } from "./words.js";

const linkTo = (row) => {
  const link = build("a", { href: addressOf(rows, row) });
  link.append(buildName(rows[row].plan));
  return link;
};

function textColumn(id, title, width, textOf) {
  return { id, title, unit: "", hint: title, number: false, width, key: textOf,
           fill: (cell, item) => cell.append(buildName(textOf(item))) };
}

const measureColumn = (measure) => ({
  id: measure.id, title: measure.short, unit: measure.unit, hint: measure.title, number: true, width: 5.4,
  key: (row) => valuesOf(measure)[row], fill: (cell, row) => fillMeasure(cell, measure, rows[row]),
});

const isSaid = (key) => rows.some((row) => row[key]);

// Items are indices into rows.
export function planColumns() {
  const plan = { ...textColumn("plan", "Plan", 14, (row) => rows[row].plan),
                 fill: (cell, row) => cell.append(linkTo(row)) };
  const run = { ...textColumn("run", "Run", 8, (row) => report.runs[rows[row].run].name),
                fill: (cell, row) => cell.append(
                    build("span", { class: runClass(rows[row].run), "aria-hidden": "true" }), " ",
                    buildName(report.runs[rows[row].run].name)) };
  const status = { ...textColumn("status", "Status", 8.5, (row) => rows[row].status),
                   fill: (cell, row) => cell.append(buildStatus(rows[row].status)) };
  const reason = { ...textColumn("reason", "Reason", 9, (row) => rows[row].reason),
                   fill: (cell, row) => {
                     cell.append(rows[row].reason);
                     cell.title = plainText(rows[row].detail);
                   } };
  return [plan, ...(report.runs.length > 1 ? [run] : []), status, ...(isSaid("reason") ? [reason] : []),
          ...(isSaid("subject") ? [textColumn("subject", "Subject", 6, (row) => rows[row].subject)] : []),
          ...(isSaid("task") ? [textColumn("task", "Task", 8, (row) => rows[row].task)] : []),
          ...measures.map(measureColumn)];
}

// Of every row the one of the other run that follows the same demonstration, -1: none.
export function partners(before, after) {
  const indexOf = new Map();
  rows.forEach((row, index) => { if (row.run === after) indexOf.set(row.plan, index); });
  return rows.map((row) => (row.run === before ? indexOf.get(row.plan) ?? -1 : -1));
}

const signed = (measure, value) => (value > 0 ? "+" : "") + measureText({ ...measure, words: undefined }, value);

function differenceColumn(measure, partner) {
  const difference = (row) =>
    (partner[row] < 0 ? NaN : shownValue(measure, rows[partner[row]]) - shownValue(measure, rows[row]));
  return {
    id: measure.id, title: `Δ ${measure.short}`, unit: measure.unit, number: true, width: 5.4,
    hint: `${measure.title}: second run minus first run`,
    key: difference,
    fill: (cell, row) => {
      const value = difference(row);
      cell.append(Number.isNaN(value) ? "–" : signed(measure, value));
      if (partner[row] >= 0)
        cell.title = `${measure.source}: ${measure.of(rows[row])} → ${measure.of(rows[partner[row]])} ${measure.siUnit}`;
    },
  };
}

// Items are indices into rows of the run before.
export function differenceColumns(partner) {
  const statusOf = (row) => {
    const other = partner[row] < 0 ? "missing" : rows[partner[row]].status;
    return rows[row].status === other ? other : `${rows[row].status} → ${other}`;
  };
  return [
    { ...textColumn("plan", "Plan", 14, (row) => rows[row].plan), fill: (cell, row) => cell.append(linkTo(row)) },
    { ...textColumn("status", "Status", 12, statusOf), fill: (cell, row) => cell.append(statusOf(row)) },
    ...measures.map((measure) => differenceColumn(measure, partner)),
  ];
}
