// What a plan is measured by, in the units in which it is shown.
import { rows } from "./data.js";
import { build } from "./elements.js";
import { threeDigits } from "./words.js";

const kDegrees = 180 / Math.PI;

const certified = (attribute) => (row) => row.certificate[attribute];

function certifiedMeasure(id, attribute, short, title, unit, siUnit, factor, ofTheArm = false) {
  return { id, short, title, unit, siUnit, factor, ofTheArm, source: attribute,
           of: certified(attribute) };
}

// Of plans that were simulated alone.
const heldMeasure = {
  id: "held", short: "Held", title: "Simulated rollouts in which the grasp held", unit: "%",
  siUnit: "", factor: 100, source: "physics.held / physics.rollouts", missing: "not simulated",
  of: ({ physics }) => (physics && physics.rollouts > 0 ? physics.held / physics.rollouts : null),
};

// Absent: infeasible; null: does not apply.
export const measures = [
  {
    id: "duration", short: "Duration", title: "Duration of the trajectory", unit: "s", siUnit: "s",
    factor: 1, source: "duration_s", of: (row) => row.duration_s, missing: "no trajectory",
  },
  certifiedMeasure("tempo", "duration_ratio", "Duration ratio", "Duration of the trajectory divided by the person's", "", "", 1),
  certifiedMeasure("tips_mean", "tip_error_mean", "Tips mean",
      "Mean distance of the fingertips from their goals", "mm", "m", 1000),
  certifiedMeasure("tips_max", "tip_error_max", "Tips max",
      "Largest distance of a fingertip from its goal", "mm", "m", 1000),
  certifiedMeasure("tips_grasp", "tip_error_grasp", "Tips at grasp",
      "Largest distance of a fingertip from its goal in grasp and hold", "mm", "m", 1000),
  certifiedMeasure("clearance", "clearance", "Clear\u00adance",
      "Smallest distance between bodies that must not touch", "mm", "m", 1000),
  certifiedMeasure("upper_arm", "upper_arm_error_mean", "Upper arm",
      "Mean angle between the robot's upper arm and the person's (~: estimated)", "°", "rad",
      kDegrees, true),
  certifiedMeasure("humanlikeness", "humanlikeness_final", "Human\u00adlikeness",
      "Metric A of the trajectory: squared distances of the joint centres, smaller is more humanlike " +
      "(~: from an estimated shoulder or elbow)", "m²", "m²", 1, true),
  ...(rows.some(({ physics }) => physics) ? [heldMeasure] : []),
  {
    id: "out_of_reach", short: "Out of reach", title: "Fingertip goals out of reach", unit: "%",
    siUnit: "", factor: 100, source: "out_of_reach / goals", missing: "no goals",
    of: ({ goals, out_of_reach }) => (goals > 0 ? out_of_reach / goals : null),
  },
  {
    id: "findings", short: "Find\u00adings", title: "Problems before repair",
    unit: "", siUnit: "", factor: 1, whole: true, source: "findings", of: (row) => row.findings,
  },
  {
    id: "repaired", short: "Re\u00adpaired", title: "Executable after repair of the mapped path",
    unit: "", siUnit: "", factor: 1, whole: true, words: ["no", "yes"], source: "repaired",
    of: ({ certificate }) => (typeof certificate.repaired === "boolean"
        ? Number(certificate.repaired) : certificate.repaired),
  },
];

export const measureOf = (id) => measures.find((measure) => measure.id === id);

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

export function shownValue(measure, row) {
  const value = measure.of(row);
  return isNumber(value) ? value * measure.factor : NaN;
}

const valuesById = new Map();

// Of every row, NaN: none.
export function valuesOf(measure) {
  if (!valuesById.has(measure.id))
    valuesById.set(measure.id, Float64Array.from(rows, (row) => shownValue(measure, row)));
  return valuesById.get(measure.id);
}

export function measureText(measure, value) {
  if (measure.words) return measure.words[value] ?? String(value);
  return measure.whole ? String(value) : threeDigits(value);
}

export const whyMissing = (measure, row) => measure.missing ??
    (measure.of(row) === undefined ? "infeasible" : "does not apply");

const wholeTitle = (measure, row) => `${measure.source} = ${measure.of(row)} ${measure.siUnit}`.trim();

// The person's shoulder or elbow was not recorded.
const armEstimated = ({ estimated }) => estimated.includes("shoulder") || estimated.includes("elbow");

export function fillMeasure(cell, measure, row) {
  const value = shownValue(measure, row);
  const mark = measure.ofTheArm && armEstimated(row) ? "~" : "";
  cell.append(Number.isNaN(value) ? "–" : mark + measureText(measure, value));
  cell.title = Number.isNaN(value) ? whyMissing(measure, row) : wholeTitle(measure, row);
}

// A number that is no plan's own, such as a median.
export const buildFigure = (measure, value) => build("td", {
  class: "number",
  title: Number.isNaN(value) ? "no plan has a value" : `${value} ${measure.unit}`.trim(),
}, Number.isNaN(value) ? "–" : threeDigits(value));
