// The first movements of the table as pictures, which play while the mouse or the focus is on them.
import { loadBlock, report, rows } from "./data.js";
import { build, buildName, buildStatus, runClass } from "./elements.js";
import { countText, numberText, plainText } from "./format.js";
import { createFloor, createPlanParts, disposeParts, poseParts } from "./plan_parts.js";
import { clockRange, stateAt } from "./playback.js";
import { createStage } from "./stage.js";
import { addressOf, on } from "./state.js";
import { bodyNameOf, subjectOf } from "./subject.js";
import { viewpoint } from "./views.js";

const kMaxPosters = 12, kPosterWidth = 480, kPosterHeight = 300;
const kMarks = { pick: null, nearest: [], isFirst: true, showsMapped: false };
const kFrame_ms = 30; // at least, between two frames of a poster that plays

// A sentence on what a plan is about.
function captionOf(shownPlan, { kind, bodies, distance }) {
  const { row } = shownPlan;
  if (row.reason !== "") return row.reason;
  const names = bodies.map((body) => bodyNameOf(shownPlan, body));
  if (kind === "avoided") return `repaired: clear of ${names[1]}`;
  return kind === "tightest" ? `tightest: ${names.join(" – ")}, ${numberText(1e3 * distance)} mm` : row.task;
}

// The instant of a picture: that of the subject, or the grasp.
function timeOfPicture({ plan }, subject) {
  if (subject.kind === "avoided" || subject.kind === "worst") return subject.time;
  return Number.isFinite(plan.grasp?.time_s) && plan.motions.some(({ name }) => name === "trajectory")
    ? plan.grasp.time_s : clockRange(plan).end;
}

async function shownPlanOf(index) {
  const row = rows[index], run = report.runs[row.run];
  return { plan: await loadBlock(row.block), robot: run.robot, index: row.run, target: row.target, row };
}

// One picture: {element, link, item, load(), draw(), stop(), close()}. The stage is shared: parts are in
// it only while they are drawn.
function createPoster(item, stage, camera) {
  const row = rows[item];
  const canvas = build("canvas", { width: kPosterWidth, height: kPosterHeight, "aria-hidden": "true" });
  const about = build("span", { class: "muted small about" });
  const link = build("a", { class: "poster", href: addressOf(rows, item), tabindex: "-1" }, canvas,
      build("span", { class: "poster-name" },
          report.runs.length > 1 ? build("span", { class: runClass(row.run), "aria-hidden": "true" }) : null,
          buildName(row.plan), " ", buildStatus(row.status)), about);
  const pen = canvas.getContext("2d");
  let scene = null, playing = 0, isClosed = false, loading = null;

  async function read() {
    const shownPlan = await shownPlanOf(item);
    if (isClosed) return;
    const subject = subjectOf(shownPlan);
    about.textContent = plainText(captionOf(shownPlan, subject));
    const parts = createPlanParts(shownPlan, stage.materials, true, () => { if (scene && !playing) draw(); });
    scene = { shownPlan, parts, time: timeOfPicture(shownPlan, subject), floor: null, view: null };
    parts.goals.group.visible = false;
    parts.model.show({ capsules: !shownPlan.robot.meshes, meshes: true });
  }
  const load = () => (loading ??= read());

  function draw(time = null) {
    if (isClosed || !scene) return;
    const { shownPlan, parts } = scene;
    const state = stateAt(shownPlan.plan, shownPlan.robot, time ?? scene.time);
    stage.root.add(parts.group);
    poseParts(parts, state, { ...kMarks, showsTouching: shownPlan.row.status === "infeasible" });
    scene.view ??= viewpoint("subject", [parts], camera.distanceFor);
    scene.floor ??= createFloor([parts], stage.materials.floor);
    stage.root.add(scene.floor);
    camera.look(scene.view);
    stage.render(camera.camera);
    stage.root.remove(parts.group, scene.floor);
    pen.drawImage(stage.renderer.domElement, 0, 0);
  }

  async function play() {
    await load();
    if (playing || isClosed || !link.matches(":hover, :focus")) return;
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    const { begin, end } = clockRange(scene.shownPlan.plan);
    let started = 0, drawn = -Infinity;
    const tick = (now) => {
      if (!playing) return;
      started ||= now;
      if (now - drawn >= kFrame_ms) {
        draw(begin + (end > begin ? ((now - started) / 1000) % (end - begin + 0.5) : 0));
        drawn = now;
      }
      playing = requestAnimationFrame(tick);
    };
    playing = requestAnimationFrame(tick);
  }
  function rest() {
    if (!playing || link.matches(":hover, :focus")) return;
    cancelAnimationFrame(playing);
    playing = 0;
    draw();
  }
  link.addEventListener("pointerenter", play);
  link.addEventListener("focus", play);
  link.addEventListener("pointerleave", rest);
  link.addEventListener("blur", () => requestAnimationFrame(rest));
  return {
    element: build("li", {}, link), link, item, load, draw: () => draw(),
    stop() {
      cancelAnimationFrame(playing);
      playing = 0;
    },
    close() {
      this.stop();
      isClosed = true;
      if (scene) disposeParts(scene.parts);
    },
  };
}

function createPosterCamera() {
  const camera = new THREE.PerspectiveCamera(40, kPosterWidth / kPosterHeight, 0.01, 50);
  camera.up.set(0, 0, 1);
  return {
    camera,
    distanceFor: (radius) => radius / Math.sin(camera.fov * Math.PI / 360),
    look({ from, to }) {
      camera.position.copy(from);
      camera.lookAt(to);
      camera.updateMatrixWorld();
    },
  };
}

// {box, show(items: indices into rows), focus(item) → true if it is among the posters}
export function buildPosters() {
  const list = build("ul", { class: "posters", "aria-label": "Movements as pictures; arrow keys go from one to the next" });
  const more = build("p", { class: "muted small" });
  const box = build("div", { class: "poster-box" }, list, more);
  const stage = createStage(build("canvas"));
  if (!stage) return { box: "", show() {}, focus: () => false, stop() {} };
  stage.renderer.setSize(kPosterWidth, kPosterHeight, false);
  const camera = createPosterCamera();
  let posters = [], drawing = 0;

  // One picture a frame, so that the page answers meanwhile.
  async function drawAll() {
    const own = ++drawing;
    delete list.dataset.drawn;
    for (const poster of posters) {
      await new Promise(requestAnimationFrame);
      if (own !== drawing) return;
      await poster.load();
      if (own !== drawing) return;
      poster.draw();
    }
    list.dataset.drawn = posters.length;
  }
  const makeCurrent = (position) => posters.forEach(({ link }, k) => { link.tabIndex = k === position ? 0 : -1; });
  list.addEventListener("focusin", ({ target }) => makeCurrent(posters.findIndex(({ link }) => link === target)));
  list.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, Home: -Infinity, End: Infinity };
    if (!Object.hasOwn(steps, event.key) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const position = posters.findIndex(({ link }) => link === event.target) + steps[event.key];
    posters[Math.min(posters.length - 1, Math.max(0, position))].link.focus();
  });
  on("theme", () => {
    stage.theme();
    drawAll();
  });
  return {
    box,
    show(items) {
      const shown = items.slice(0, kMaxPosters);
      more.textContent = items.length > kMaxPosters
        ? `The first ${kMaxPosters} of ${countText(items.length, "movement")}, in the order of the table.` : "";
      const kept = new Map(posters.map((poster) => [poster.item, poster]));
      if (shown.length === posters.length && shown.every((item, k) => posters[k].item === item)) {
        if (!list.dataset.drawn) drawAll();
        return;
      }
      posters = shown.map((item) => kept.get(item) ?? createPoster(item, stage, camera));
      for (const [item, poster] of kept) if (!shown.includes(item)) poster.close();
      const focused = document.activeElement;
      list.replaceChildren(...posters.map(({ element }) => element));
      if (list.contains(focused)) focused.focus({ preventScroll: true }); // lost where it was moved
      makeCurrent(0);
      drawAll();
    },
    focus(item) {
      const poster = posters.find((each) => each.item === item);
      poster?.link.focus({ preventScroll: true });
      return poster !== undefined;
    },
    stop() {
      ++drawing;
      posters.forEach((poster) => poster.stop());
    },
  };
}
