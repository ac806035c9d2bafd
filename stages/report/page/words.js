// Words for codes, and numbers and names as they are shown.

const kReasons = {
  unplanned: "Nothing was tried yet.",
  no_movement: "The demonstration has no complete reach, or it could not be rebuilt.",
  no_shoulder: "The person's shoulder was not seen in the whole movement.",
  no_goal: "No fingertip was seen, or the movement has fewer than five frames.",
  start_in_collision: "The robot touches something at the first sample, in every posture found.",
  goal_in_collision: "At some time every posture found that holds the goals touches something.",
  unreachable: "At some time no posture found holds the goals, obstacles or not.",
  no_path: "Something is in the way, and no way around it was found.",
  collision: "The motion between two samples touches something.",
  smoothing: "The path is free, the smooth curve through it is not.",
  limit: "A joint would go beyond its limits.",
  jump: "The joints jump from one frame to the next, and nothing closed the gap.",
  tracking: "A fingertip is farther from its goal than its phase allows.",
  path: "What was to be timed is no path of this robot.",
  duration: "The path cannot be followed in the time asked for.",
  no_approach: "There is no free way from the home posture to the first sample.",
  no_retreat: "There is no free way from the last sample back to the home posture.",
  no_frame: "An object of the scene stands relative to something that is not there.",
};

export const reasonSentence = (reason) => (Object.hasOwn(kReasons, reason) ? kReasons[reason] : "");

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
