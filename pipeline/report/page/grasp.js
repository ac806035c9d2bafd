// The grasp of a movement: contacts and quality of the plan, and its physics simulation.
import { build } from "./elements.js";
import { countText, numberText, plainText } from "./format.js";
import { ballGeometry, boneGeometry, fixedMesh, placeBone } from "./shapes.js";

const kDegreesPerRadian = 180 / Math.PI;
const kArrow_m = 0.04, kPin_m = 0.0015;

// A pin per contact, in the target's frame: its head where the pad touches, its shaft along the normal.
export function createContactMarks(contacts, material) {
  const group = new THREE.Group();
  const isComplete = (v) => v && v.every((x) => x !== null);
  for (const { point, normal } of contacts.filter((contact) => isComplete(contact.point) && isComplete(contact.normal))) {
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
const newtonsText = (value) => (value === null || value === undefined ? "no force suffices" : `${numberText(value)} N`);

// The section's elements; null for a plan without contacts that was not simulated.
export function graspSection(grasp, physics) {
  const parts = [...(grasp?.contacts ? contactParts(grasp) : []), ...(physics ? physicsParts(physics) : [])];
  return parts.length > 0 ? parts : null;
}

const figureList = (entries) => build("dl", { class: "figures" }, ...entries.map(([name, value]) =>
  build("div", {}, build("dt", {}, name), build("dd", {}, value))));

// The direction from which the palm came.
const approachEntries = (direction) => (direction?.every((x) => x !== null)
    ? [["approach direction (target frame)", direction.map((x) => x.toFixed(2).replace("-", "−")).join(", ")]] : []);

function contactParts({ contacts, quality, grasp_force, approach_direction }) {
  const head = ["contact", "link", "origin", "state", "gap mm", "pad angle °", "force N", "confidence"];
  const cells = (contact) => [contact.link, contact.origin, contact.state, millimetres(contact.signed_distance, 2), numberText(contact.pad_angle * kDegreesPerRadian),
                          numberText(contact.normal_force), contact.confidence.toFixed(2)];
  const table = build("table", { class: "contacts" },
      build("thead", {}, build("tr", {}, ...head.map((name) => build("th", { scope: "col" }, name)))),
      build("tbody", {}, ...contacts.map((contact) => build("tr", {},
          build("th", { scope: "row" }, plainText(contact.tip)),
          ...cells(contact).map((text, k) => build("td", { class: k < 3 ? null : "number" }, plainText(text)))))));
  const isKnown = quality.epsilon_lower !== null;
  const qualityPart = !isKnown ? build("p", {}, "Fewer than two contacts touch: the grasp quality is unknown.")
      : figureList([
        ["Ferrari-Canny ε (bounds)",
         `${numberText(quality.epsilon_lower)} … ${numberText(quality.epsilon_upper)}`],
        ["required force per finger, worst direction", newtonsText(quality.required_force_worst)],
        ["required force per finger, gravity only", newtonsText(quality.required_force_gravity)],
        ["available force per finger", newtonsText(quality.available_force)],
        ["friction, torsion, mass",
         `${numberText(quality.friction_coefficient)}, ${millimetres(quality.torsional_friction, 1)} mm, ${numberText(quality.mass)} kg`],
        ["grasp force", grasp_force ? "stored with the trajectory" : "no force balances the load"], ...approachEntries(approach_direction)]);
  return [build("h3", {}, "Grasp"), table, qualityPart];
}

function physicsParts(physics) {
  const title = build("h3", {}, `Physics simulation (${plainText(physics.engine)})`);
  if (physics.skip_reason !== "none")
    return [title, build("p", {}, `Not simulated: ${plainText(physics.skip_reason)}: ${plainText(physics.detail)}`)];
  const failureText = (failures) => Object.entries(failures).map(([name, count]) => `${plainText(name)} ${count}`).join(", ");
  const directionEntries = physics.load_directions > 0 ? [["held under load in six directions",
    `${physics.load_directions_held} of ${physics.load_directions}${physics.load_directions_held < physics.load_directions
        ? ` (${failureText(physics.direction_failures)})` : ""}`]] : [];
  const taskEntries = physics.tasks > 0 ? [
    ["carried, put down and let go as planned", `${physics.tasks_done} of ${physics.tasks}`],
    ["displacement in the palm, error of the place, tilt (medians of held)",
     `${millimetres(physics.palm_offset_m, 1)} mm, ${millimetres(physics.place_error_m, 1)} mm, ${numberText(physics.tilt_deg)}°`]] : [];
  return [title, figureList([
    [physics.tasks > 0 ? "held until the release" : "held 5 s after the lift", `${physics.held} of ${countText(physics.rollouts, "rollout")}`],
    ...taskEntries,
    ["failures", failureText(physics.failures) || "none"],
    ...directionEntries,
    ["droop, slip, drift (medians of held)",
     `${millimetres(physics.droop_m, 2)}, ${millimetres(physics.slip_m, 2)}, ${millimetres(physics.drift_m, 3)} mm`],
    ["tracking error, arm and hand",
     `${numberText(physics.arm_error)}°, ${numberText(physics.hand_error)}°`],
    ["largest torque (share of limit)", `${(100 * physics.torque_ratio).toFixed(0)} %`],
    [`force required to ${physics.tasks > 0 ? "carry" : "lift"}, commanded`, `${newtonsText(physics.required_force_N)}, ${newtonsText(physics.commanded_force_N)}`],
    ["friction, torsion, mass",
     `${numberText(physics.friction)}, ${millimetres(physics.torsional_friction_m, 1)} mm, ${numberText(physics.mass_kg)} kg`],
    ["grasp force", physics.contact_source === "planned" ? "from the plan" : "at the nearest points of the fingers with goals"]])];
}
