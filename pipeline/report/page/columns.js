// Columns of the first page's table: plans, or the differences of two runs.
import { report, rows } from "./data.js";
import { build, buildName, buildStatus, runClass } from "./elements.js";
import { plainText } from "./format.js";
import { fillMeasure, measures, measureText, shownValue, valuesOf } from "./measures.js";
import { addressOf } from "./state.js";

const linkTo = (row) => {
  const link = build("a", { href: addressOf(rows, row) });
  link.append(buildName(rows[row].plan));
  return link;
};

function textColumn(id, title, width, textOf) {
  return { id, title, unit: "", hint: title, number: false, width, sortKey: textOf,
           fill: (cell, item) => cell.append(buildName(textOf(item))) };
}

const measureColumn = (measure) => ({
  id: measure.id, title: measure.label, unit: measure.unit, hint: measure.title, number: true, width: 5.4,
  sortKey: (row) => valuesOf(measure)[row], fill: (cell, row) => fillMeasure(cell, measure, rows[row]),
});

const isGiven = (sortKey) => rows.some((row) => row[sortKey]);

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
  return [plan, ...(report.runs.length > 1 ? [run] : []), status, ...(isGiven("reason") ? [reason] : []),
          ...(isGiven("subject") ? [textColumn("subject", "Subject", 6, (row) => rows[row].subject)] : []),
          ...(isGiven("task") ? [textColumn("task", "Task", 8, (row) => rows[row].task)] : []),
          ...measures.map(measureColumn)];
}

// For every row that of the other run's plan of the same demonstration, -1: none.
export function partnerRows(before, after) {
  const indexOf = new Map();
  rows.forEach((row, index) => { if (row.run === after) indexOf.set(row.plan, index); });
  return rows.map((row) => (row.run === before ? indexOf.get(row.plan) ?? -1 : -1));
}

const signed = (measure, value) => (value > 0 ? "+" : "") + measureText({ ...measure, valueNames: undefined }, value);

function differenceColumn(measure, partnerOf) {
  const difference = (row) =>
    (partnerOf[row] < 0 ? NaN : shownValue(measure, rows[partnerOf[row]]) - shownValue(measure, rows[row]));
  return {
    id: measure.id, title: `Δ ${measure.label}`, unit: measure.unit, number: true, width: 5.4,
    hint: `${measure.title}: second run minus first run`,
    sortKey: difference,
    fill: (cell, row) => {
      const value = difference(row);
      cell.append(Number.isNaN(value) ? "–" : signed(measure, value));
      if (partnerOf[row] >= 0)
        cell.title = `${measure.source}: ${measure.rawValue(rows[row])} → ${measure.rawValue(rows[partnerOf[row]])} ${measure.siUnit}`;
    },
  };
}

// Items are indices into rows of the first run.
export function differenceColumns(partnerOf) {
  const statusOf = (row) => {
    const other = partnerOf[row] < 0 ? "missing" : rows[partnerOf[row]].status;
    return rows[row].status === other ? other : `${rows[row].status} → ${other}`;
  };
  return [
    { ...textColumn("plan", "Plan", 14, (row) => rows[row].plan), fill: (cell, row) => cell.append(linkTo(row)) },
    { ...textColumn("status", "Status", 12, statusOf), fill: (cell, row) => cell.append(statusOf(row)) },
    ...measures.map((measure) => differenceColumn(measure, partnerOf)),
  ];
}
