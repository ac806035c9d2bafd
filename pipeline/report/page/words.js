// Numbers and names as they are shown.

const kUnseen = /[\p{Cc}\p{Cs}\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]/gu;

// A text of which nothing is invisible: control characters and marks of writing direction as \u{…}.
export const plainText = (text) =>
  String(text).replace(kUnseen, (unseen) => `\\u{${unseen.codePointAt(0).toString(16)}}`);

const kMostShown = 300;

// The same, no longer than what any cell has room for.
export function shortText(text) {
  const whole = String(text);
  const shown = plainText(whole.slice(0, kMostShown));
  return whole.length > kMostShown ? `${shown}…` : shown;
}

export function threeDigits(x) {
  if (x === 0) return "0";
  const size = Math.abs(x);
  let text = size.toPrecision(3);
  if (size < 1e-4 || size >= 1e6) text = size.toExponential(2);
  else if (size >= 999.5) text = size.toFixed(0);
  return x < 0 ? `−${text}` : text;
}

// A number on an axis: no zeros behind it.
export const axisText = (x) => String(Number(x.toPrecision(6))).replace("-", "−");

export const counted = (count, one, many = `${one}s`) =>
  `${count.toLocaleString("en")} ${count === 1 ? one : many}`;

export function medianOf(values) {
  const sorted = values.filter((x) => !Number.isNaN(x)).sort((a, b) => a - b);
  const half = sorted.length / 2;
  if (sorted.length === 0) return NaN;
  return (sorted[Math.ceil(half) - 1] + sorted[Math.floor(half)]) / 2;
}

// A number or, where there is none, a dash.
export const figureText = (x) =>
  (x === null || x === undefined || Number.isNaN(x) ? "–" : threeDigits(x));
