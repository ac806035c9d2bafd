// The person in the 3D view: arm and hand where they were seen, and a torso with a head, which is
// drawn from the shoulder alone.
import { rowOf } from "./data.js";
import { matrixOf } from "./kinematics.js";
import { ballGeometry, boneGeometry, fixedMesh, interpolatePoint, placeBone } from "./shapes.js";

const kUpperArm_m = 0.047, kForearm_m = 0.038, kFinger_m = 0.0085;
const kJoints_m = [0.05, 0.04, 0.028]; // shoulder, elbow, wrist
// Assumed, for the drawing only: half the distance between the shoulders, and a torso's outline as
// [half width, height above the shoulder]; its depth is a share of its width.
const kHalfShoulders_m = 0.18, kDepthShare = 0.62;
const kOutline_m = [[0, -0.5], [0.15, -0.5], [0.135, -0.3], [0.165, -0.12], [0.16, -0.02], [0.11, 0.035], [0.055, 0.06],
                    [0.05, 0.14], [0, 0.14]];
const kHead_m = [0.078, 0.098, 0.118], kHeadHeight_m = 0.24;
// Assumed as well: the palm, and where thumb and fingers begin on it, toward the thumb and the fingers.
const kPalm_m = [0.014, 0.041, 0.05];
const kKnuckles_m = [[0.036, 0.03], [0.03, 0.09], [0.01, 0.094], [-0.01, 0.09], [-0.029, 0.082]];

// A group at the shoulder, in the axes of the world; side: 1 right, -1 left.
function createTorso(material, side) {
  const torso = new THREE.Group();
  const points = kOutline_m.map(([x, z]) => new THREE.Vector2(x, z));
  const body = new THREE.Mesh(new THREE.LatheBufferGeometry(points, 24).rotateX(Math.PI / 2), material);
  body.scale.set(1, kDepthShare, 1);
  const head = new THREE.Mesh(new THREE.SphereBufferGeometry(1, 20, 14), material);
  head.scale.set(...kHead_m);
  head.position.z = kHeadHeight_m;
  for (const part of [body, head]) {
    part.position.x = -side * kHalfShoulders_m;
    torso.add(part);
  }
  torso.matrixAutoUpdate = false;
  return torso;
}

// base_from_hand at an instant, its z toward the fingers and y toward the thumb; null: unknown.
function handPose({ wrist_orientation: table }, { index, next, share }, wrist) {
  const [w, x, y, z] = rowOf(table, share < 0.5 ? index : next);
  if (!Number.isFinite(w + wrist.x)) return null;
  return new THREE.Matrix4().compose(wrist, new THREE.Quaternion(x, y, z, w), new THREE.Vector3(1, 1, 1));
}

// {group, arm (its part that was recorded), pose(interpolation)}: {index, next, share} among the
// frames of plan.human.
export function createPerson({ plan, robot }, { person: material, torso: torsoMaterial }) {
  const group = new THREE.Group(), arm = new THREE.Group();
  const add = (geometry) => {
    const mesh = fixedMesh(geometry, material);
    arm.add(mesh);
    return mesh;
  };
  const upperArm = add(boneGeometry(0.86)), forearm = add(boneGeometry(0.68));
  const joints = kJoints_m.map((radius) => {
    const ball = new THREE.Mesh(ballGeometry(radius), material);
    arm.add(ball);
    return ball;
  });
  const palm = add(ballGeometry(1)), bone = boneGeometry(0.9);
  const fingers = Array.from({ length: 5 }, (_, finger) => ({
    proximal: add(bone), distal: add(bone), tip: robot.tips.findIndex((tip) => tip.finger === finger),
  }));
  const torso = plan.upright ? createTorso(torsoMaterial, robot.side === "left" ? -1 : 1) : null;
  group.add(arm, ...(torso ? [torso] : []));
  const { human } = plan;
  const baseFromWorld = new THREE.Matrix4().getInverse(matrixOf(plan.world_from_base));

  function poseHand(wrist, interpolation) {
    const hand = handPose(human, interpolation, wrist);
    palm.visible = hand !== null;
    if (hand) {
      palm.matrix.copy(hand).multiply(new THREE.Matrix4().makeTranslation(0, 0, 0.9 * kPalm_m[2]))
        .scale(new THREE.Vector3(...kPalm_m));
      palm.matrixWorldNeedsUpdate = true;
    }
    fingers.forEach(({ proximal, distal, tip }, index) => {
      const knuckle = hand ? new THREE.Vector3(0, ...kKnuckles_m[index]).applyMatrix4(hand) : wrist;
      const middle = interpolatePoint(human.fingers, interpolation, index);
      const isMiddleSeen = Number.isFinite(middle.x);
      placeBone(proximal, knuckle, middle, kFinger_m);
      distal.visible = tip >= 0;
      if (tip >= 0) placeBone(distal, isMiddleSeen ? middle : knuckle, interpolatePoint(human.tips, interpolation, tip), kFinger_m);
    });
  }

  return {
    group, arm,
    pose(interpolation) {
      const [shoulder, elbow, wrist] = [human.shoulder, human.elbow, human.wrist].map((table) => interpolatePoint(table, interpolation));
      placeBone(upperArm, shoulder, elbow, kUpperArm_m);
      placeBone(forearm, elbow, wrist, kForearm_m);
      [shoulder, elbow, wrist].forEach((position, index) => {
        joints[index].visible = Number.isFinite(position.x);
        if (joints[index].visible) joints[index].position.copy(position);
      });
      if (torso) {
        torso.visible = Number.isFinite(shoulder.x);
        torso.matrix.copy(baseFromWorld).setPosition(shoulder);
        torso.matrixWorldNeedsUpdate = true;
      }
      poseHand(wrist, interpolation);
    },
  };
}
