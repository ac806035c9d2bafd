// Where the fingertips should go and where they go: goals, their paths, what is out of reach.
import { at } from "./data.js";
import { forward, tipPlace } from "./kinematics.js";
import { isGoalMotion } from "./player.js";
import { ballGeometry, boneGeometry, crossGeometry, fixedMesh, pathGeometry, placeBone, pointBetween, pointOf } from "./shapes.js";

const kMostPoints = 400;

// Where the robot's tips go, a list of points for each.
function tipPaths(plan, robot) {
  const paths = robot.tips.map(() => []);
  for (const motion of plan.motions.filter(isGoalMotion)) {
    const every = Math.max(1, Math.ceil(motion.time.rows / kMostPoints));
    for (let row = 0; row < motion.time.rows; row += every) {
      const q = motion.position.values.subarray(row * motion.position.cols, (row + 1) * motion.position.cols);
      const poses = forward(robot, q);
      robot.tips.forEach((tip, index) => paths[index].push(tipPlace(tip, poses)));
    }
  }
  return paths;
}

function goalPaths({ human }, tips) {
  return Array.from({ length: tips }, (_, tip) =>
    Array.from({ length: human.tips.rows }, (_unused, row) => pointOf(human.tips, row, tip)));
}

function outOfReach({ human }, tips) {
  const points = [];
  for (let row = 0; row < human.tips.rows; ++row) {
    for (let tip = 0; tip < tips; ++tip) {
      const point = pointOf(human.tips, row, tip);
      if (Number.isFinite(point.x) && at(human.reachable, row, tip) === 0) points.push(point);
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
  const crosses = new THREE.LineSegments(crossGeometry(outOfReach(plan, tips), 0.008), materials.reach);
  const ball = ballGeometry(0.007), bone = boneGeometry();
  const goals = robot.tips.map(() => new THREE.Mesh(ball, materials.goal));
  const gaps = robot.tips.map(() => fixedMesh(bone, materials.gap));
  group.add(...lines, crosses, ...goals, ...gaps);
  return {
    group,
    pose(human, poses, pick) {
      robot.tips.forEach((tip, index) => {
        const goal = pointBetween(plan.human.tips, human, index);
        goals[index].visible = Number.isFinite(goal.x);
        if (goals[index].visible) goals[index].position.copy(goal);
        goals[index].scale.setScalar(pick?.kind === "finger" && pick.index === index ? 2 : 1);
        if (poses) placeBone(gaps[index], tipPlace(tip, poses), goal, 0.0018);
        else gaps[index].visible = false;
      });
    },
  };
}
