// The measures of a plan, in the units in which they are shown.
import { rows } from "./data.js";
import { build } from "./elements.js";
import { threeDigits } from "./format.js";

const kDegreesPerRad = 180 / Math.PI;

function certifiedMeasure(id, attribute, label, title, unit, siUnit, factor, dependsOnArm = false) {
  return { id, label, title, unit, siUnit, factor, dependsOnArm, source: attribute,
           rawValue: (row) => row.certificate[attribute] };
}

// Only of plans that were simulated.
const heldMeasure = {
  id: "held", label: "Held", title: "Simulated rollouts in which the grasp held", unit: "%",
  siUnit: "", factor: 100, source: "physics.held / physics.rollouts", missing: "not simulated",
  rawValue: ({ physics }) => (physics && physics.rollouts > 0 ? physics.held / physics.rollouts : null),
};

// rawValue(row) in SI units; undefined: infeasible; null: does not apply.
export const measures = [
  {
    id: "duration", label: "Duration", title: "Duration of the trajectory", unit: "s", siUnit: "s",
    factor: 1, source: "duration_s", rawValue: (row) => row.duration_s, missing: "no trajectory",
  },
  certifiedMeasure("duration_ratio", "duration_ratio", "Duration ratio", "Duration of the trajectory divided by the person's", "", "", 1),
  certifiedMeasure("tip_error_mean", "tip_error_mean", "Tips mean",
      "Mean distance of the fingertips from their goals", "mm", "m", 1000),
  certifiedMeasure("tip_error_max", "tip_error_max", "Tips max",
      "Largest distance of a fingertip from its goal", "mm", "m", 1000),
  certifiedMeasure("tip_error_grasp", "tip_error_grasp", "Tips at grasp",
      "Largest distance of a fingertip from its goal in grasp and hold", "mm", "m", 1000),
  certifiedMeasure("clearance", "clearance", "Clear\u00adance",
      "Smallest distance between bodies that must not touch", "mm", "m", 1000),
  certifiedMeasure("upper_arm_error", "upper_arm_error_mean", "Upper arm",
      "Mean angle between the robot's upper arm and the person's (~: estimated)", "°", "rad",
      kDegreesPerRad, true),
  certifiedMeasure("forearm_error", "forearm_error_mean", "Forearm",
      "Mean angle between the robot's forearm and the person's (~: estimated)", "°", "rad",
      kDegreesPerRad, true),
  certifiedMeasure("swivel_error", "swivel_error_mean", "Swivel",
      "Mean angle of the elbow about the line from shoulder to wrist, against the person's (~: estimated)",
      "°", "rad", kDegreesPerRad, true),
  certifiedMeasure("palm_error", "palm_error_mean", "Palm",
      "Mean angle between the robot's palm and the person's", "°", "rad", kDegreesPerRad),
  certifiedMeasure("wrist_speed_correlation", "wrist_speed_correlation", "Wrist speed r",
      "Correlation of the wrists' speeds, the robot's and the person's", "", "", 1),
  certifiedMeasure("humanlikeness", "humanlikeness_final", "Human\u00adlikeness",
      "Metric A of the trajectory: squared distances of the joint centres, smaller is more humanlike " +
      "(~: from an estimated shoulder or elbow)", "m²", "m²", 1, true),
  ...(rows.some(({ physics }) => physics) ? [heldMeasure] : []),
  {
    id: "unreachable_share", label: "Out of reach", title: "Fingertip goals out of reach", unit: "%",
    siUnit: "", factor: 100, source: "out_of_reach / goals", missing: "no goals",
    rawValue: ({ goals, out_of_reach }) => (goals > 0 ? out_of_reach / goals : null),
  },
  {
    id: "findings", label: "Find\u00adings", title: "Problems before repair",
    unit: "", siUnit: "", factor: 1, isInteger: true, source: "findings", rawValue: (row) => row.findings,
  },
  {
    id: "repaired", label: "Re\u00adpaired", title: "Executable after repair of the mapped path",
    unit: "", siUnit: "", factor: 1, isInteger: true, valueNames: ["no", "yes"], source: "repaired",
    rawValue: ({ certificate }) => (typeof certificate.repaired === "boolean"
        ? Number(certificate.repaired) : certificate.repaired),
  },
];

export const measureOf = (id) => measures.find((measure) => measure.id === id);

const isNumber = (value) => typeof value === "number" && Number.isFinite(value);

export function shownValue(measure, row) {
  const value = measure.rawValue(row);
  return isNumber(value) ? value * measure.factor : NaN;
}

const valuesById = new Map();

// The shown values of all rows, NaN: no value.
export function valuesOf(measure) {
  if (!valuesById.has(measure.id))
    valuesById.set(measure.id, Float64Array.from(rows, (row) => shownValue(measure, row)));
  return valuesById.get(measure.id);
}

export function measureText(measure, value) {
  if (measure.valueNames) return measure.valueNames[value] ?? String(value);
  return measure.isInteger ? String(value) : threeDigits(value);
}

const missingReasonOf = (measure, row) => measure.missing ??
    (measure.rawValue(row) === undefined ? "infeasible" : "does not apply");

const exactValueText = (measure, row) => `${measure.source} = ${measure.rawValue(row)} ${measure.siUnit}`.trim();

// The person's shoulder or elbow was not recorded.
const isArmEstimated = ({ estimated }) => estimated.includes("shoulder") || estimated.includes("elbow");

export function fillMeasure(cell, measure, row) {
  const value = shownValue(measure, row);
  const mark = measure.dependsOnArm && isArmEstimated(row) ? "~" : "";
  cell.append(Number.isNaN(value) ? "–" : mark + measureText(measure, value));
  cell.title = Number.isNaN(value) ? missingReasonOf(measure, row) : exactValueText(measure, row);
}

// The cell of a number that belongs to no single plan, such as a median.
export const buildNumberCell = (measure, value) => build("td", {
  class: "number",
  title: Number.isNaN(value) ? "no plan has a value" : `${value} ${measure.unit}`.trim(),
}, Number.isNaN(value) ? "–" : threeDigits(value));
