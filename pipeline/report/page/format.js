// Formats numbers and names for display.

const kInvisible = /[\p{Cc}\p{Cs}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/gu;

// The text with control characters and marks of writing direction as \u{…}.
export const plainText = (text) =>
  String(text).replace(kInvisible, (character) => `\\u{${character.codePointAt(0).toString(16)}}`);

const kMaxLength = 300;

// The same, shortened for a cell.
export function shortText(text) {
  const fullText = String(text);
  const shown = plainText(fullText.slice(0, kMaxLength));
  return fullText.length > kMaxLength ? `${shown}…` : shown;
}

export function threeDigits(x) {
  if (x === 0) return "0";
  const size = Math.abs(x);
  let text = size.toPrecision(3);
  if (size < 1e-4 || size >= 1e6) text = size.toExponential(2);
  else if (size >= 999.5) text = size.toFixed(0);
  return x < 0 ? `−${text}` : text;
}

// A number on an axis, without trailing zeros.
export const axisText = (x) => String(Number(x.toPrecision(6))).replace("-", "−");

export const countText = (count, one, many = `${one}s`) =>
  `${count.toLocaleString("en")} ${count === 1 ? one : many}`;

export function medianOf(values) {
  const sorted = values.filter((x) => !Number.isNaN(x)).sort((a, b) => a - b);
  const half = sorted.length / 2;
  if (sorted.length === 0) return NaN;
  return (sorted[Math.ceil(half) - 1] + sorted[Math.floor(half)]) / 2;
}

// A number, or a dash for an unknown one.
export const numberText = (x) =>
  (x === null || x === undefined || Number.isNaN(x) ? "–" : threeDigits(x));
