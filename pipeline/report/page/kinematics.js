// The poses of a robot's frames in its base: base_from_parent * transform * motion(ratio * q + offset).

// The matrix of 16 numbers, row by row.
export const matrixOf = (numbers) => new THREE.Matrix4().set(...numbers);

const kPrepared = new WeakMap();

const prepared = (robot) => {
  if (!kPrepared.has(robot)) {
    kPrepared.set(robot, robot.frames.map(({ transform, axis }) =>
      ({ fixed: matrixOf(transform), axis: new THREE.Vector3(...axis) })));
  }
  return kPrepared.get(robot);
};

// base_from_frame of every frame at joint positions q.
export function forward(robot, q) {
  const poses = [];
  poses[-1] = new THREE.Matrix4(); // the base
  const moved = new THREE.Matrix4();
  const constants = prepared(robot);
  robot.frames.forEach(({ parent, joint, ratio, offset, prismatic }, index) => {
    const { fixed, axis } = constants[index];
    const pose = new THREE.Matrix4().copy(fixed);
    if (joint >= 0) {
      const value = ratio * q[joint] + offset;
      if (prismatic) moved.makeTranslation(axis.x * value, axis.y * value, axis.z * value);
      else moved.makeRotationAxis(axis, value);
      pose.multiply(moved);
    }
    pose.premultiply(poses[parent]);
    poses.push(pose);
  });
  return poses;
}

// A tip's position in the base.
export function tipPosition({ frame, transform }, poses) {
  return new THREE.Vector3(transform[3], transform[7], transform[11]).applyMatrix4(poses[frame]);
}

// The joint that moves a frame, -1: none.
export function jointOf(robot, frame) {
  let movingFrame = frame;
  while (movingFrame >= 0 && robot.frames[movingFrame].joint < 0) movingFrame = robot.frames[movingFrame].parent;
  return movingFrame < 0 ? -1 : robot.frames[movingFrame].joint;
}

// True for the palm and every frame that moves with it.
export function isOfHand(robot, frame) {
  let each = frame;
  while (each >= 0 && each !== robot.palm_frame) each = robot.frames[each].parent;
  return each >= 0;
}
