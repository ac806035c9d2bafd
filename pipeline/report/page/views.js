// Where the camera of a 3D view stands and where it looks.
import { valueAt } from "./data.js";
import { boundsOf } from "./plan_parts.js";
import { interpolationAt } from "./playback.js";
import { pointOf } from "./shapes.js";
import { clearDirection, subjectOf, subjectPoints } from "./subject.js";

// "subject", where a movement opens: what the plan is about, from where it is in sight.
export const kViews = ["front", "side", "top", "eyes", "fit", "subject"];

const meanOf = (points) => points.reduce((sum, point) => sum.add(point), new THREE.Vector3()).divideScalar(points.length);

// The mean of the goals at the grasp, or another point.
function gazeTarget({ group, shownPlan: { plan, robot } }, fallback) {
  const interpolation = interpolationAt(plan.human.time, plan.grasp?.demonstration_s ?? valueAt(plan.human.time, plan.human.time.rows - 1));
  const seen = robot.tips.map((_, tip) => pointOf(plan.human.tips, interpolation.index, tip)).filter(({ x }) => Number.isFinite(x));
  return seen.length === 0 ? fallback : meanOf(seen).applyMatrix4(group.matrix);
}

// How much nearer than everything a subject is seen, and how far the view turns from the middle of
// everything to it.
const kNearer = 0.66, kTowardSubject = 0.6;

function subjectView({ group, shownPlan }, centre, radius, preferred) {
  const subject = subjectOf(shownPlan);
  const points = subjectPoints(shownPlan, subject);
  if (points.length === 0) return { direction: preferred, to: centre, radius };
  const toBase = new THREE.Matrix4().getInverse(group.matrix);
  const direction = clearDirection(shownPlan, subject,
      preferred.clone().transformDirection(toBase), new THREE.Vector3(0, 0, 1).transformDirection(toBase));
  return { direction: direction.transformDirection(group.matrix), radius: kNearer * radius,
           to: centre.clone().lerp(meanOf(points).applyMatrix4(group.matrix), kTowardSubject) };
}

// {from, to} of a view; distanceFor(radius): from where a ball fills the view.
export function viewpoint(name, shownParts, distanceFor) {
  const box = boundsOf(shownParts);
  const centre = box.isEmpty() ? new THREE.Vector3(0, 0.3, 0) : box.getCenter(new THREE.Vector3());
  const radius = box.isEmpty() ? 0.6 : Math.max(0.12, 0.42 * box.getSize(new THREE.Vector3()).length());
  const [first] = shownParts;
  const left = first?.shownPlan.robot.side === "left" ? -1 : 1;
  const from = (direction, to, size) => ({ from: to.clone().addScaledVector(direction.normalize(), distanceFor(size)), to });
  const whole = (x, y, z) => from(new THREE.Vector3(x, y, z), centre, radius);
  const slanted = new THREE.Vector3(left * 0.9, 0.75, 0.55);
  if (name === "subject" && first) {
    const found = subjectView(first, centre, radius, slanted.normalize());
    return from(found.direction, found.to, found.radius);
  }
  // Assumed: the eyes are 0.2 m beside the shoulder, 0.25 m above and 0.1 m in front of it.
  if (name === "eyes" && first) return { from: new THREE.Vector3(-0.2 * left, 0.1, 0.25), to: gazeTarget(first, centre) };
  if (name === "front") return whole(0, 1, 0.12);
  if (name === "side") return whole(left, 0, 0.12);
  if (name === "top") return whole(0, -0.001, 1);
  return from(slanted, centre, radius);
}
