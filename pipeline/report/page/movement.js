// A movement's page: the reason, 3D view and clock beside the plots, and tables below.
import { certificateOf } from "./certificate_box.js";
import { loadBlock, report, rows, valueAt } from "./data.js";
import { build, buildButton } from "./elements.js";
import { graspSection } from "./grasp.js";
import { figuresOf, reasonOf, titleOf } from "./movement_head.js";
import { clockRange, isGoalMotion, isPathChanged, stateAt, timedMotions, timeOfDemonstration } from "./playback.js";
import { createPlots } from "./plots.js";
import { createReadings } from "./readings.js";
import { createScene, kHasMeshes } from "./scene.js";
import { plotsOf } from "./series.js";
import { addressOf, on, pick, setTime, state } from "./state.js";
import { bandsOf, createTimeline } from "./timeline.js";
import { kViews } from "./views.js";

const kDisplayOptions = [["person", "person", true], ["goals", "goals", true], ["capsules", "capsules", !kHasMeshes],
                  ["meshes", "meshes", true], ["mappedPath", "mapped path", true], ["objects", "objects", true],
                  ["nearest", "nearest pair", true], ["contacts", "contacts", true], ["sideBySide", "apart", false]];
const kSpeeds = [0.1, 0.25, 0.5, 1, 2];

let page = null; // what was built once
let shownPlans = [];
let range = { begin: 0, end: 0 };
let openCount = 0;
const clock = { playing: false, speed: 1, loop: true, last: 0 };

// The rows of all runs for the same demonstration, this one first.
const rowsOfDemonstration = (rowIndex) => {
  const others = rows.filter((row, index) => index !== rowIndex && row.plan === rows[rowIndex].plan);
  return [rows[rowIndex], ...others];
};

async function loadShownPlan(row) {
  const run = report.runs[row.run];
  return { plan: await loadBlock(row.block), robot: run.robot, label: run.name, index: row.run,
           target: row.target, row };
}

// Builds the page before the first movement is opened.
export function prepareMovement(host) {
  page ??= buildPage(host);
}

export async function openMovement(host, rowIndex, time) {
  const opening = ++openCount;
  prepareMovement(host);
  stopClock();
  const loaded = await Promise.all(rowsOfDemonstration(rowIndex).map(loadShownPlan));
  if (opening !== openCount) return;
  shownPlans = loaded;
  const [{ plan, row }] = shownPlans;
  range = clockRange(plan);
  state.pick = null;
  page.title.replaceChildren(...titleOf(row));
  page.reason.replaceChildren(...reasonOf(plan, row));
  page.certificate.replaceChildren(certificateOf(row) ?? "");
  page.figures.replaceChildren(...figuresOf(row));
  page.options.sideBySide.parentElement.hidden = shownPlans.length < 2;
  page.options.mappedPath.parentElement.hidden = !shownPlans.some(isPathChanged);
  page.grasp.replaceChildren(...(graspSection(plan.grasp, row.physics) ?? []));
  page.options.contacts.parentElement.hidden = !shownPlans.some(({ plan: shown }) => shown.grasp?.contacts);
  page.options.meshes.parentElement.hidden = !shownPlans.some(({ robot }) => robot.meshes);
  const bands = bandsOf(plan);
  page.timeline.show(range, bands);
  page.scene?.show(shownPlans);
  page.readings.show(shownPlans[0]);
  state.time = Number.isFinite(time) ? Math.min(range.end, Math.max(range.begin, time)) : initialTime(plan);
  showInstant();
  page.plots.show(plotsOf(shownPlans), bands);
}

// Puts the focus where the keys of the clock are answered and no button is pressed by them.
export const focusMovement = () => page.view.focus({ preventScroll: true });

export function closeMovement() {
  stopClock();
  ++openCount;
  page?.plots.clear();
  shownPlans = [];
}

const initialTime = (plan) =>
  (plan.worst ? timeOfDemonstration(plan, plan.worst.demonstration_s) : clockRange(plan).begin);

function buildPage(host) {
  const parts = { title: build("h2", { tabindex: "-1" }), reason: build("div", { class: "reason" }),
                  certificate: build("div", {}),
                  figures: build("dl", { class: "figures" }), options: {},
                  grasp: build("section", { class: "grasp", "aria-label": "Grasp" }),
                  instant: build("output", { class: "instant" }) };
  const sceneHost = build("div", { class: "scene-host" });
  const readings = build("section", { class: "readings", "aria-label": "Values at this instant" });
  const plots = build("div", { class: "plots", tabindex: "0", role: "region", "aria-label": "Plots" });
  const timeline = build("div", { class: "timeline" });
  parts.view = build("div", { class: "scene", tabindex: "-1", role: "group",
    "aria-label": "Movement: space plays, arrow keys step" }, viewBar(parts), sceneHost, clockBar(parts), parts.instant, timeline);
  host.replaceChildren(
    build("div", { class: "movement-head" }, parts.title, parts.reason, parts.certificate),
    build("div", { class: "movement" },
        parts.view, plots),
    build("div", { class: "movement-foot" }, parts.figures, parts.grasp, readings));
  parts.scene = createScene(sceneHost);
  parts.scene?.onPick(({ planIndex, capsule }) => pickCapsule(shownPlans[planIndex], capsule));
  parts.timeline = createTimeline(timeline);
  parts.plots = createPlots(plots);
  parts.readings = createReadings(readings);
  on("time", showInstant);
  on("pick", showInstant);
  on("theme", () => {
    parts.scene?.theme();
    parts.plots.theme();
    showInstant();
  });
  addEventListener("resize", () => {
    parts.scene?.resize();
    parts.plots.resize();
  });
  return parts;
}

function viewBar(parts) {
  const bar = build("div", { class: "bar", role: "toolbar", "aria-label": "View" });
  kViews.forEach((name, index) => {
    bar.append(buildButton(name, { title: `key ${index + 1}` }, () => parts.scene?.view(name)));
  });
  for (const [option, name, checked] of kDisplayOptions) {
    const box = build("input", { type: "checkbox", checked });
    box.addEventListener("change", () => {
      parts.scene?.set(option, box.checked);
      showInstant();
    });
    parts.options[option] = box;
    bar.append(build("label", {}, box, ` ${name}`));
  }
  return bar;
}

function clockBar(parts) {
  parts.play = buildButton("Play", { class: "play", title: "space" }, togglePlay);
  parts.speed = build("select", { "aria-label": "Speed" },
      ...kSpeeds.map((speed) => build("option", { value: speed, selected: speed === 1 }, `${speed} ×`)));
  parts.speed.addEventListener("change", () => { clock.speed = Number(parts.speed.value); });
  parts.loop = build("input", { type: "checkbox", checked: true });
  parts.loop.addEventListener("change", () => { clock.loop = parts.loop.checked; });
  return build("div", { class: "bar", role: "toolbar", "aria-label": "Clock" },
      buildButton("◂ step", { title: "left arrow" }, () => step(-1)), parts.play,
      buildButton("step ▸", { title: "right arrow" }, () => step(1)), parts.speed,
      build("label", {}, parts.loop, " loop"));
}

function pickCapsule({ robot }, capsule) {
  let frame = robot.capsules[capsule].frame;
  while (frame >= 0 && robot.frames[frame].joint < 0) frame = robot.frames[frame].parent;
  if (frame >= 0) pick({ kind: "joint", index: robot.frames[frame].joint });
}

// The states of all runs at the first one's time of the demonstration.
function statesNow() {
  const [first, ...others] = shownPlans;
  const own = stateAt(first.plan, first.robot, state.time);
  const rest = others.map(({ plan, robot }) => {
    if (!own || !isGoalMotion(own.motion)) return stateAt(plan, robot, state.time);
    return stateAt(plan, robot, timeOfDemonstration(plan, own.demonstration_s));
  });
  return [own, ...rest];
}

function instantText(now) {
  if (!now) return "no motion";
  const phases = ["rest", "reach", "preshape", "grasp", "hold", "transport", "return",
                  "approach", "lift", "place", "release", "retreat", "home"];
  const phase = isGoalMotion(now.motion) ? phases[valueAt(now.motion.phase, now.index)] : now.motion.name;
  return `robot ${state.time.toFixed(3)} s · demonstration ${now.demonstration_s.toFixed(3)} s · ${phase}`;
}

function showInstant() {
  if (shownPlans.length === 0) return;
  const states = statesNow();
  const text = instantText(states[0]);
  page.scene?.update(states, state.pick);
  page.timeline.update(text);
  page.readings.update(states[0]);
  page.instant.textContent = text;
  if (!clock.playing) keepAddress();
}

let addressTimer = 0;

function keepAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => {
    if (state.row !== null) history.replaceState(null, "", addressOf(rows, state.row, state.time));
  }, 200);
}

function togglePlay() {
  if (clock.playing) stopClock();
  else startClock();
}

function startClock() {
  if (range.end <= range.begin) return;
  clock.playing = true;
  clock.last = performance.now();
  page.play.textContent = "Pause";
  if (state.time >= range.end) setTime(range.begin);
  requestAnimationFrame(tick);
}

function stopClock() {
  clock.playing = false;
  if (page) page.play.textContent = "Play";
}

function tick(now) {
  if (!clock.playing) return;
  let time = state.time + clock.speed * Math.max(0, now - clock.last) / 1000;
  clock.last = now;
  if (time > range.end) {
    if (clock.loop) time = range.begin;
    else {
      stopClock();
      time = range.end;
    }
  }
  setTime(time);
  requestAnimationFrame(tick);
}

// Moves the clock to the next or previous sample shown.
function step(count) {
  stopClock();
  const times = timedMotions(shownPlans[0].plan).flatMap(({ motion, begin }) =>
    Array.from(motion.time.values, (time) => begin + time));
  const eps = 1e-6;
  const next = count > 0 ? times.find((time) => time > state.time + eps)
      : times.findLast((time) => time < state.time - eps);
  if (next !== undefined) setTime(next);
}

function moveBy(seconds) {
  stopClock();
  setTime(Math.min(range.end, Math.max(range.begin, state.time + seconds)));
}

function changeSpeed(steps) {
  const index = Math.min(kSpeeds.length - 1, Math.max(0, kSpeeds.indexOf(clock.speed) + steps));
  clock.speed = kSpeeds[index];
  page.speed.value = clock.speed;
}

const toggle = (box) => { if (!box.parentElement.hidden) box.click(); };

// Handles a key of the movement's page; false if the key is not one of them.
export function movementKey(event) {
  if (shownPlans.length === 0) return false;
  const plain = {
    " ": togglePlay,
    Home: () => moveBy(-Infinity),
    End: () => moveBy(Infinity),
    ",": () => changeSpeed(-1),
    ".": () => changeSpeed(1),
    l: () => toggle(page.loop),
    g: () => toggle(page.options.mappedPath),
    p: () => toggle(page.options.person),
    c: () => toggle(page.options.capsules),
    ArrowLeft: () => (event.shiftKey ? moveBy(-0.1) : step(-1)),
    ArrowRight: () => (event.shiftKey ? moveBy(0.1) : step(1)),
  };
  kViews.forEach((name, index) => { plain[String(index + 1)] = () => page.scene?.view(name); });
  if (!Object.hasOwn(plain, event.key)) return false;
  plain[event.key]();
  return true;
}
