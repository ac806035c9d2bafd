// The person's arm and hand in the 3D view, where they were seen.
import { ballGeometry, boneGeometry, fixedMesh, interpolatePoint, placeBone } from "./shapes.js";

const kUpperArm_m = 0.042, kForearm_m = 0.034, kPalm_m = 0.009, kFinger_m = 0.0075;

// {group, pose(interpolation)}: {index, next, share} among the frames of plan.human.
export function createPerson(plan, robot, material) {
  const group = new THREE.Group();
  const bone = boneGeometry();
  const add = () => {
    const mesh = fixedMesh(bone, material);
    group.add(mesh);
    return mesh;
  };
  const upperArm = add(), forearm = add();
  const joints = [0.046, 0.038, 0.03].map((radius) => {
    const ball = new THREE.Mesh(ballGeometry(radius), material);
    group.add(ball);
    return ball;
  });
  const fingers = Array.from({ length: 5 }, (_, finger) => ({
    palm: add(), finger: add(), tip: robot.tips.findIndex((tip) => tip.finger === finger),
  }));
  const { human } = plan;
  return {
    group,
    pose(interpolation) {
      const pointIn = (table, column = 0) => interpolatePoint(table, interpolation, column);
      const [shoulder, elbow, wrist] = [human.shoulder, human.elbow, human.wrist].map((table) => pointIn(table));
      placeBone(upperArm, shoulder, elbow, kUpperArm_m);
      placeBone(forearm, elbow, wrist, kForearm_m);
      [shoulder, elbow, wrist].forEach((position, index) => {
        joints[index].visible = Number.isFinite(position.x);
        if (joints[index].visible) joints[index].position.copy(position);
      });
      fingers.forEach(({ palm, finger, tip }, index) => {
        const middle = pointIn(human.fingers, index);
        placeBone(palm, wrist, middle, kPalm_m);
        finger.visible = tip >= 0;
        if (tip >= 0) placeBone(finger, Number.isFinite(middle.x) ? middle : wrist, pointIn(human.tips, tip), kFinger_m);
      });
    },
  };
}
