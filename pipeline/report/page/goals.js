// Goals and paths of the fingertips, and goals out of reach.
import { valueAt } from "./data.js";
import { forward, tipPosition } from "./kinematics.js";
import { isGoalMotion } from "./playback.js";
import { ballGeometry, boneGeometry, crossGeometry, fixedMesh, interpolatePoint, pathGeometry, placeBone, pointOf } from "./shapes.js";

const kMaxPathPoints = 400;

// The paths of the robot's tips, a list of points for each.
function tipPaths(plan, robot) {
  const paths = robot.tips.map(() => []);
  for (const motion of plan.motions.filter(isGoalMotion)) {
    const stride = Math.max(1, Math.ceil(motion.time.rows / kMaxPathPoints));
    for (let row = 0; row < motion.time.rows; row += stride) {
      const q = motion.position.values.subarray(row * motion.position.cols, (row + 1) * motion.position.cols);
      const poses = forward(robot, q);
      robot.tips.forEach((tip, index) => paths[index].push(tipPosition(tip, poses)));
    }
  }
  return paths;
}

function goalPaths({ human }, tips) {
  return Array.from({ length: tips }, (_, tip) =>
    Array.from({ length: human.tips.rows }, (_unused, row) => pointOf(human.tips, row, tip)));
}

function unreachableGoals({ human }, tips) {
  const points = [];
  for (let row = 0; row < human.tips.rows; ++row) {
    for (let tip = 0; tip < tips; ++tip) {
      const point = pointOf(human.tips, row, tip);
      if (Number.isFinite(point.x) && valueAt(human.reachable, row, tip) === 0) points.push(point);
    }
  }
  return points;
}

// {group, pose(human, poses of the robot's frames or null, pick)}; materials: {goal, goalLine, tipLine, gap, reach}
export function createGoals({ plan, robot }, materials) {
  const group = new THREE.Group();
  const tips = robot.tips.length;
  for (const path of tipPaths(plan, robot))
    if (path.length > 1) group.add(new THREE.LineSegments(pathGeometry(path), materials.tipLine));
  const lines = goalPaths(plan, tips).map((path) => {
    const line = new THREE.LineSegments(pathGeometry(path), materials.goalLine);
    line.computeLineDistances();
    return line;
  });
  const crosses = new THREE.LineSegments(crossGeometry(unreachableGoals(plan, tips), 0.008), materials.reach);
  const ball = ballGeometry(0.007), bone = boneGeometry();
  const goals = robot.tips.map(() => new THREE.Mesh(ball, materials.goal));
  const gaps = robot.tips.map(() => fixedMesh(bone, materials.gap));
  group.add(...lines, crosses, ...goals, ...gaps);
  return {
    group,
    pose(human, poses, pick) {
      robot.tips.forEach((tip, index) => {
        const goal = interpolatePoint(plan.human.tips, human, index);
        goals[index].visible = Number.isFinite(goal.x);
        if (goals[index].visible) goals[index].position.copy(goal);
        goals[index].scale.setScalar(pick?.kind === "finger" && pick.index === index ? 2 : 1);
        if (poses) placeBone(gaps[index], tipPosition(tip, poses), goal, 0.0018);
        else gaps[index].visible = false;
      });
    },
  };
}
