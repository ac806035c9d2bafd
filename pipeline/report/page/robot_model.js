// A robot in the 3D view: the capsules that are checked, meshes and tips.
import { loadBlock } from "./data.js";
import { forward, isOfHand, jointOf, tipPosition } from "./kinematics.js";
import { ballGeometry, boneGeometry, capsuleGeometry, fixedMesh, meshGeometry, placeBone, poseBetween } from "./shapes.js";

const vectorOf = (numbers) => new THREE.Vector3(...numbers);

const capsuleMesh = ({ from, to, radius }, material) => {
  const [a, b] = [vectorOf(from), vectorOf(to)];
  const mesh = fixedMesh(capsuleGeometry(radius, a.distanceTo(b)), material);
  return { mesh, local: poseBetween(a, b) };
};

// {group, capsulesGroup, pose(q) → base_from_frame of every frame, highlight(pick, nearest, touching),
// show({capsules, meshes})}; materials: {plain, hand, picked, near, touching}, and {mesh, tip} of a robot
// that is no ghost. Capsules that are
// picked, nearest or touching are shown even if the others are not.
export function createRobotModel(robot, materials, onChange) {
  const group = new THREE.Group();
  const capsulesGroup = new THREE.Group(), meshesGroup = new THREE.Group(), tipsGroup = new THREE.Group();
  group.add(capsulesGroup, meshesGroup, tipsGroup);
  const plain = robot.capsules.map(({ frame }) => (isOfHand(robot, frame) ? materials.hand : materials.plain));
  const capsules = robot.capsules.map((capsule, index) => capsuleMesh(capsule, plain[index]));
  capsules.forEach(({ mesh }, index) => {
    mesh.userData.capsule = index;
    capsulesGroup.add(mesh);
  });
  const tips = materials.tip ? robot.tips.map(() => new THREE.Mesh(ballGeometry(0.006), materials.tip)) : [];
  if (tips.length > 0) tipsGroup.add(...tips);
  const axis = fixedMesh(boneGeometry(), materials.picked);
  axis.visible = false;
  group.add(axis);
  const meshes = [];
  const addMesh = async ({ frame, block }) => {
    const mesh = fixedMesh(meshGeometry(await loadBlock(block)), materials.mesh);
    meshesGroup.add(mesh);
    meshes.push({ mesh, frame });
    onChange();
  };
  if (materials.mesh) (robot.meshes ?? []).forEach(addMesh);
  let poses = [], showsCapsules = true, marked = new Set();
  const showCapsules = () => capsules.forEach(({ mesh }, index) => { mesh.visible = showsCapsules || marked.has(index); });
  const setMatrix = (mesh, matrix) => {
    mesh.matrix.copy(matrix);
    mesh.matrixWorldNeedsUpdate = true;
  };
  return {
    group, capsulesGroup,
    show({ capsules: capsulesShown, meshes: meshesShown }) {
      showsCapsules = capsulesShown;
      meshesGroup.visible = meshesShown;
      showCapsules();
    },
    pose(q) {
      poses = forward(robot, q);
      robot.capsules.forEach(({ frame }, index) => {
        const { mesh, local } = capsules[index];
        mesh.matrix.multiplyMatrices(poses[frame], local);
        mesh.matrixWorldNeedsUpdate = true;
      });
      for (const { mesh, frame } of meshes) setMatrix(mesh, poses[frame]);
      tips.forEach((ball, index) => ball.position.copy(tipPosition(robot.tips[index], poses)));
      return poses;
    },
    // Picked, nearest and touching bodies get a material of their own.
    highlight(pick, nearest, touching) {
      const isPicked = (index) => (pick?.kind === "joint" && jointOf(robot, robot.capsules[index].frame) === pick.index) ||
          (pick?.kind === "finger" && robot.capsules[index].frame === robot.tips[pick.index]?.frame) ||
          (pick?.kind === "pair" && (pick.first === index || pick.second === index));
      marked = new Set();
      capsules.forEach(({ mesh }, index) => {
        if (touching.has(index) || isPicked(index) || nearest.includes(index)) marked.add(index);
        mesh.material = touching.has(index) ? materials.touching
            : isPicked(index) ? materials.picked
            : nearest.includes(index) ? materials.near : plain[index];
      });
      tips.forEach((tip, index) => {
        tip.scale.setScalar(pick?.kind === "finger" && pick.index === index ? 2 : 1);
      });
      showCapsules();
      showAxis(pick);
    },
  };

  function showAxis(pick) {
    axis.visible = false;
    if (pick?.kind !== "joint") return;
    const frame = robot.frames.findIndex(({ joint }) => joint === pick.index);
    if (frame < 0 || !poses[frame]) return;
    const offset = vectorOf(robot.frames[frame].axis).transformDirection(poses[frame]).multiplyScalar(0.12);
    const origin = new THREE.Vector3().setFromMatrixPosition(poses[frame]);
    placeBone(axis, origin.clone().sub(offset), origin.clone().add(offset), 0.003);
  }
}
