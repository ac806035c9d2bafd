// The person's arm and hand in the 3D view, where they were seen.
import { ballGeometry, boneGeometry, fixedMesh, placeBone, pointBetween } from "./shapes.js";

const kUpperArm_m = 0.042, kForearm_m = 0.034, kPalm_m = 0.009, kFinger_m = 0.0075;

// {group, pose(human)}: human = {index, next, share} among the frames of plan.human.
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
    pose(when) {
      const of = (table, column = 0) => pointBetween(table, when, column);
      const [shoulder, elbow, wrist] = [of(human.shoulder), of(human.elbow), of(human.wrist)];
      placeBone(upperArm, shoulder, elbow, kUpperArm_m);
      placeBone(forearm, elbow, wrist, kForearm_m);
      [shoulder, elbow, wrist].forEach((place, index) => {
        joints[index].visible = Number.isFinite(place.x);
        if (joints[index].visible) joints[index].position.copy(place);
      });
      fingers.forEach(({ palm, finger, tip }, index) => {
        const middle = of(human.fingers, index);
        placeBone(palm, wrist, middle, kPalm_m);
        finger.visible = tip >= 0;
        if (tip >= 0) placeBone(finger, Number.isFinite(middle.x) ? middle : wrist, of(human.tips, tip), kFinger_m);
      });
    },
  };
}
