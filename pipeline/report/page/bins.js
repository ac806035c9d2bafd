// The bins of a measure: about twenty, of a round width. The first and the last bin also hold the few
// values far beyond them.
import { axisText } from "./format.js";
import { valuesOf } from "./measures.js";

const kBins = 20;

function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((m) => m * power).find((step) => step >= least * 0.999999);
}

const quantile = (sorted, share) => sorted[Math.round(share * (sorted.length - 1))];

// The interval of the bins: all values without the few that are far away from the others.
function centralRange(sorted) {
  const [least, most] = [sorted[0], sorted[sorted.length - 1]];
  const [low, high] = [quantile(sorted, 0.02), quantile(sorted, 0.98)];
  const margin = 2 * (high - low);
  if (margin === 0) return { low: least, high: most };
  return { low: low - least > margin ? low : least, high: most - high > margin ? high : most };
}

function stepOf(measure, low, high) {
  const span = high > low ? high - low : Math.max(Math.abs(high), 1e-6);
  const step = roundStep(span / kBins);
  return measure.isInteger ? Math.max(1, step) : step;
}

function makeBinning(measure) {
  const values = valuesOf(measure);
  const sorted = values.filter((x) => !Number.isNaN(x)).sort();
  const missing = values.length - sorted.length;
  if (sorted.length === 0) return { bins: new Int16Array(values.length).fill(-1), count: 0, missing };
  const { low, high } = measure.valueNames ? { low: 0, high: 1 } : centralRange(sorted);
  const step = stepOf(measure, low, high);
  const cellOf = (x) => Math.floor(x / step + 1e-9);
  const firstCell = cellOf(low), count = cellOf(high) - firstCell + 1;
  const bins = Int16Array.from(values, (x) =>
    Number.isNaN(x) ? -1 : Math.min(count - 1, Math.max(0, cellOf(x) - firstCell)));
  return {
    bins, count, missing, step, firstCell,
    hasValuesBelow: cellOf(sorted[0]) < firstCell,
    hasValuesAbove: cellOf(sorted[sorted.length - 1]) > firstCell + count - 1,
  };
}

const binnings = new Map();

// {bins [row] (-1: no value), count, missing, step, firstCell, hasValuesBelow, hasValuesAbove}: the last
// two say whether the first and the last bin also hold values beyond them.
export function binningOf(measure) {
  if (!binnings.has(measure.id)) binnings.set(measure.id, makeBinning(measure));
  return binnings.get(measure.id);
}

export const edgeOf = ({ firstCell, step }, bin) => (firstCell + bin) * step;

// The range of bins first … last, in words.
export function rangeLabel(measure, { first, last }) {
  const binning = binningOf(measure);
  if (measure.valueNames) return first === last ? measure.valueNames[first] : measure.valueNames.join(" or ");
  const low = axisText(edgeOf(binning, first));
  const high = axisText(edgeOf(binning, last + 1));
  const unit = measure.unit === "" ? "" : ` ${measure.unit}`;
  const open = binning.hasValuesAbove && last === binning.count - 1;
  if (binning.hasValuesBelow && first === 0) return open ? `all${unit}` : `less than ${high}${unit}`;
  if (open) return `${low}${unit} and more`;
  if (measure.isInteger && binning.step === 1 && first === last) return `${low}${unit}`;
  if (measure.isInteger && binning.step === 1) return `${low} to ${axisText(edgeOf(binning, last))}${unit}`;
  return `${low} to ${high}${unit}`;
}

export function rangeToAddress(measure, { first, last }) {
  const binning = binningOf(measure);
  return [first, last + 1].map((bin) => Number(edgeOf(binning, bin).toPrecision(9))).join("~");
}

// null: not a range of this measure.
export function rangeFromAddress(measure, text) {
  const binning = binningOf(measure);
  const edges = text.split("~").map(Number);
  if (binning.count === 0 || edges.length !== 2 || !edges.every(Number.isFinite)) return null;
  const [first, end] = edges.map((edge) => Math.round(edge / binning.step) - binning.firstCell);
  const range = { first: Math.max(0, first), last: Math.min(binning.count, end) - 1 };
  return range.first <= range.last ? range : null;
}
