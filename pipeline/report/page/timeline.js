// The clock's range under the 3D view: phases, marks, and a slider for hand and keyboard.
import { valueAt } from "./data.js";
import { build, buildButton } from "./elements.js";
import { plainText } from "./format.js";
import { isGoalMotion, timedMotions, timeOfDemonstration } from "./playback.js";
import { setTime, state } from "./state.js";

// {kind: "phase" | "origin" | "finding" | "mark", begin, end, name, description} on the plan's clock.
export function bandsOf(plan) {
  const bands = [];
  const add = (kind, from, to, name, description) => bands.push({ kind, begin: from, end: to, name, description });
  const onClock = (demonstration_s) => timeOfDemonstration(plan, demonstration_s);
  for (const { motion, begin, end } of timedMotions(plan)) {
    if (!isGoalMotion(motion)) add("phase", begin, end, motion.name, `${motion.name}, planned`);
  }
  for (const { name, begin_s, end_s, confidence } of plan.phases) {
    const description = `${name}, ${begin_s.toFixed(2)} to ${end_s.toFixed(2)} s of the demonstration, ` +
        `confidence ${Math.round(100 * confidence)} %`;
    if (name !== "rest") add("phase", onClock(begin_s), onClock(end_s), name, description);
  }
  for (const timedMotion of timedMotions(plan)) addOrigins(timedMotion, add);
  for (const { begin_s, end_s, cause, other, sentence } of plan.findings)
    add("finding", onClock(begin_s), onClock(end_s), findingName(cause, other), `before repair: ${plainText(sentence)}`);
  if (plan.grasp) add("mark", onClock(plan.grasp.demonstration_s), null, "grasp", "the grasp");
  if (plan.worst) add("mark", onClock(plan.worst.demonstration_s), null, "worst", plan.worst.sentence);
  return bands.map((band) => ({ ...band, end: band.end ?? band.begin }));
}

const findingName = (cause, other) => plainText(cause.replaceAll("_", " ") + (other ? ` with ${other}` : ""));

const kBandNames = { finding: "found in the mapped path", origin: "changed by repair", mark: "grasp or worst instant" };

// What the colours of the bands mean, of those that are there.
export function buildBandKey(bands) {
  const kinds = Object.keys(kBandNames).filter((kind) => bands.some((band) => band.kind === kind));
  return build("p", { class: "band-key small" },
      ...kinds.map((kind) => build("span", { class: `key-${kind}` }, kBandNames[kind])));
}

const kOrigins = ["mapped", "re_solved", "planned"];

function addOrigins({ motion, begin }, add) {
  const origin = (row) => valueAt(motion.origin, row);
  for (let from = 0; from < motion.time.rows;) {
    let to = from;
    while (to + 1 < motion.time.rows && origin(to + 1) === origin(from)) ++to;
    if (origin(from) > 0 && isGoalMotion(motion)) {
      const name = kOrigins[origin(from)];
      add("origin", begin + valueAt(motion.time, from), begin + valueAt(motion.time, to), name,
          `${name} (repair)`);
    }
    from = to + 1;
  }
}

// Bands of one name that begin at the same time share a mark.
function marksOf(bands) {
  const marks = new Map();
  for (const { kind, begin, name, description } of bands) {
    if (kind !== "finding" && kind !== "mark") continue;
    const title = `${name}, ${begin.toFixed(2)} s`;
    if (!marks.has(title)) marks.set(title, { begin, descriptions: [] });
    marks.get(title).descriptions.push(description);
  }
  return [...marks];
}

export function createTimeline(host) {
  const bandsHost = build("div", { class: "bands" });
  const slider = build("input", { type: "range", "aria-label": "Time", step: "any" });
  const cursor = build("div", { class: "timeline-cursor", "aria-hidden": "true" });
  const marks = build("div", { class: "marks", role: "group", "aria-label": "Instants" }), key = build("div");
  host.replaceChildren(build("div", { class: "track" }, bandsHost, cursor), slider, key, marks);
  slider.addEventListener("input", () => setTime(Number(slider.value)));
  bandsHost.addEventListener("click", (event) => {
    const box = bandsHost.getBoundingClientRect();
    setTime(range.begin + (event.clientX - box.left) / box.width * (range.end - range.begin));
  });
  let range = { begin: 0, end: 1 };
  const share = (time) => (time - range.begin) / (range.end - range.begin || 1);
  return {
    show(newRange, bands) {
      range = newRange;
      slider.min = range.begin;
      slider.max = range.end;
      bandsHost.replaceChildren(...bands.map((band) => bandElement(band, share)));
      key.replaceChildren(buildBandKey(bands));
      const all = marksOf(bands);
      marks.replaceChildren(all.length > 0 ? build("span", { class: "muted" }, "go to") : "",
          ...all.map(([name, { begin, descriptions }]) =>
            buildButton(name, { title: descriptions.join("\n") }, () => setTime(begin))));
    },
    update(text) {
      slider.value = state.time;
      slider.setAttribute("aria-valuetext", text);
      cursor.style.left = `${100 * Math.min(1, Math.max(0, share(state.time)))}%`;
    },
  };
}

function bandElement({ kind, begin, end, name, description }, share) {
  const element = build("span", { class: `band ${kind} band-${kind === "finding" ? kind : name}`, title: description },
      kind === "phase" ? name : "");
  const left = Math.min(1, Math.max(0, share(begin))), right = Math.min(1, Math.max(0, share(end)));
  element.style.left = `${100 * left}%`;
  element.style.width = kind === "mark" ? "" : `${100 * (right - left)}%`;
  return element;
}
