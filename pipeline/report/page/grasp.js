// The grasp of a movement: contacts and quality of the plan, and what became of it in physics.
import { build } from "./elements.js";
import { ballGeometry, boneGeometry, fixedMesh, placeBone } from "./shapes.js";
import { counted, figureText, plainText } from "./words.js";

const kDegreesARadian = 180 / Math.PI;
const kArrow_m = 0.04, kPin_m = 0.0015;

// A pin a contact, in the target's frame: where the pad touches, and from where it presses.
export function createContactMarks(contacts, material) {
  const group = new THREE.Group();
  const seen = (v) => v && v.every((x) => x !== null);
  for (const { point, normal } of contacts.filter((one) => seen(one.point) && seen(one.normal))) {
    const end = new THREE.Vector3(...point);
    const begin = new THREE.Vector3(...normal).multiplyScalar(-kArrow_m).add(end);
    const shaft = fixedMesh(boneGeometry(), material), head = fixedMesh(ballGeometry(3 * kPin_m), material);
    placeBone(shaft, begin, end, kPin_m);
    head.matrix.makeTranslation(end.x, end.y, end.z);
    for (const part of [shaft, head]) {
      part.renderOrder = 1;
      group.add(part);
    }
  }
  return group;
}

const millimetres = (metres, digits) => (metres === null ? "–" : `${(1e3 * metres).toFixed(digits)}`.replace("-", "−"));
const newtonsText = (value) => (value === null || value === undefined ? "no force suffices" : `${figureText(value)} N`);

// null of a plan without contacts that was not simulated.
export function graspSection(grasp, physics) {
  const parts = [...(grasp?.contacts ? contactParts(grasp) : []), ...(physics ? physicsParts(physics) : [])];
  return parts.length > 0 ? parts : null;
}

const figureList = (entries) => build("dl", { class: "figures" }, ...entries.map(([name, value]) =>
  build("div", {}, build("dt", {}, name), build("dd", {}, value))));

// How the palm came, in the target's frame.
const approachOf = (direction) => (direction?.every((x) => x !== null)
    ? [["approach direction (target frame)", direction.map((x) => x.toFixed(2).replace("-", "−")).join(", ")]] : []);

function contactParts({ contacts, quality, grasp_force, approach_direction }) {
  const head = ["contact", "link", "origin", "gap mm", "pad angle °", "force N", "confidence"];
  const cells = (one) => [one.link, one.origin, millimetres(one.signed_distance, 2), figureText(one.pad_angle * kDegreesARadian),
                          figureText(one.normal_force), one.confidence.toFixed(2)];
  const table = build("table", { class: "contacts" },
      build("thead", {}, build("tr", {}, ...head.map((name) => build("th", { scope: "col" }, name)))),
      build("tbody", {}, ...contacts.map((one) => build("tr", {},
          build("th", { scope: "row" }, plainText(one.tip)),
          ...cells(one).map((text, k) => build("td", { class: k < 2 ? null : "number" }, plainText(text)))))));
  const known = quality.epsilon_lower !== null;
  const judged = !known ? build("p", {}, "Fewer than two contacts touch: the grasp quality is unknown.")
      : figureList([
        ["Ferrari-Canny ε (bounds)",
         `${figureText(quality.epsilon_lower)} … ${figureText(quality.epsilon_upper)}`],
        ["required force per finger, worst direction", newtonsText(quality.required_force_worst)],
        ["required force per finger, gravity only", newtonsText(quality.required_force_gravity)],
        ["available force per finger", newtonsText(quality.available_force)],
        ["friction, torsion, mass",
         `${figureText(quality.friction_coefficient)}, ${millimetres(quality.torsional_friction, 1)} mm, ${figureText(quality.mass)} kg`],
        ["grasp force", grasp_force ? "stored with the trajectory" : "no force balances the load"], ...approachOf(approach_direction)]);
  return [build("h3", {}, "Grasp"), table, judged];
}

function physicsParts(physics) {
  const title = build("h3", {}, `Physics simulation (${plainText(physics.engine)})`);
  if (physics.skip_reason !== "none")
    return [title, build("p", {}, `Not simulated: ${plainText(physics.skip_reason)}: ${plainText(physics.detail)}`)];
  const causes = (failures) => Object.entries(failures).map(([name, count]) => `${plainText(name)} ${count}`).join(", ");
  const six = physics.load_directions > 0 ? [["held under load in six directions",
    `${physics.load_directions_held} of ${physics.load_directions}${physics.load_directions_held < physics.load_directions
        ? ` (${causes(physics.direction_failures)})` : ""}`]] : [];
  return [title, figureList([
    ["held 5 s after the lift", `${physics.held} of ${counted(physics.rollouts, "rollout")}`],
    ["failures", causes(physics.failures) || "none"],
    ...six,
    ["droop, slip, drift (medians of held)",
     `${millimetres(physics.droop_m, 2)}, ${millimetres(physics.slip_m, 2)}, ${millimetres(physics.drift_m, 3)} mm`],
    ["tracking error, arm and hand",
     `${figureText(physics.arm_error)}°, ${figureText(physics.hand_error)}°`],
    ["largest torque (share of limit)", `${(100 * physics.torque_ratio).toFixed(0)} %`],
    ["force required to lift, commanded", `${newtonsText(physics.required_force_N)}, ${newtonsText(physics.commanded_force_N)}`],
    ["friction, torsion, mass",
     `${figureText(physics.friction)}, ${millimetres(physics.torsional_friction_m, 1)} mm, ${figureText(physics.mass_kg)} kg`],
    ["grasp force", physics.contact_source === "planned" ? "from the plan" : "at the nearest points of the fingers with goals"]])];
}
