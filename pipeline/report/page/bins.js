// Bins of a measure: multiples of a round step, about twenty. Few values far off share the last bin,
// or the first.
import { valuesOf } from "./measures.js";
import { axisText } from "./words.js";

const kBins = 20;

function roundStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((m) => m * power).find((step) => step >= least * 0.999999);
}

const quantile = (sorted, share) => sorted[Math.round(share * (sorted.length - 1))];

// Ends of what most values fill.
function mostlyWithin(sorted) {
  const [least, most] = [sorted[0], sorted[sorted.length - 1]];
  const [low, high] = [quantile(sorted, 0.02), quantile(sorted, 0.98)];
  const far = 2 * (high - low);
  if (far === 0) return { low: least, high: most };
  return { low: low - least > far ? low : least, high: most - high > far ? high : most };
}

function stepOf(measure, low, high) {
  const span = high > low ? high - low : Math.max(Math.abs(high), 1e-6);
  const step = roundStep(span / kBins);
  return measure.whole ? Math.max(1, step) : step;
}

function makeBinning(measure) {
  const values = valuesOf(measure);
  const sorted = values.filter((x) => !Number.isNaN(x)).sort();
  const missing = values.length - sorted.length;
  if (sorted.length === 0) return { bins: new Int16Array(values.length).fill(-1), count: 0, missing };
  const { low, high } = measure.words ? { low: 0, high: 1 } : mostlyWithin(sorted);
  const step = stepOf(measure, low, high);
  const cell = (x) => Math.floor(x / step + 1e-9);
  const from = cell(low), count = cell(high) - from + 1;
  const bins = Int16Array.from(values, (x) =>
    Number.isNaN(x) ? -1 : Math.min(count - 1, Math.max(0, cell(x) - from)));
  return {
    bins, count, missing, step, from,
    less: cell(sorted[0]) < from,
    more: cell(sorted[sorted.length - 1]) > from + count - 1,
  };
}

const binnings = new Map();

// {bins [row] (-1: no value), count, missing, step, from, less, more: the first or last bin has
// what lies beyond it, too}
export function binningOf(measure) {
  if (!binnings.has(measure.id)) binnings.set(measure.id, makeBinning(measure));
  return binnings.get(measure.id);
}

export const edgeOf = ({ from, step }, bin) => (from + bin) * step;

// What bins first … last hold, in words.
export function rangeWords(measure, { first, last }) {
  const binning = binningOf(measure);
  if (measure.words) return first === last ? measure.words[first] : measure.words.join(" or ");
  const low = axisText(edgeOf(binning, first));
  const high = axisText(edgeOf(binning, last + 1));
  const unit = measure.unit === "" ? "" : ` ${measure.unit}`;
  const open = binning.more && last === binning.count - 1;
  if (binning.less && first === 0) return open ? `all${unit}` : `less than ${high}${unit}`;
  if (open) return `${low}${unit} and more`;
  if (measure.whole && binning.step === 1 && first === last) return `${low}${unit}`;
  if (measure.whole && binning.step === 1) return `${low} to ${axisText(edgeOf(binning, last))}${unit}`;
  return `${low} to ${high}${unit}`;
}

export function textOfRange(measure, { first, last }) {
  const binning = binningOf(measure);
  return [first, last + 1].map((bin) => Number(edgeOf(binning, bin).toPrecision(9))).join("~");
}

// null: not a range of this measure.
export function rangeOfText(measure, text) {
  const binning = binningOf(measure);
  const edges = text.split("~").map(Number);
  if (binning.count === 0 || edges.length !== 2 || !edges.every(Number.isFinite)) return null;
  const [first, end] = edges.map((edge) => Math.round(edge / binning.step) - binning.from);
  const range = { first: Math.max(0, first), last: Math.min(binning.count, end) - 1 };
  return range.first <= range.last ? range : null;
}
