// Table, target and obstacles in the 3D view.
import { at, loadBlock, rowOf } from "./data.js";
import { createContactMarks } from "./grasp.js";
import { place } from "./player.js";
import { fixedMesh, meshGeometry, objectGeometry, poseMatrix } from "./shapes.js";

// As recorded, at a time of the demonstration; held before the first and after the last sample.
function recordedPose({ time, pose }, demonstration_s) {
  const { index, next, share } = place(time, demonstration_s);
  const from = rowOf(pose, index), to = rowOf(pose, next);
  if (share === 0) return poseMatrix(from);
  const turn = (row) => new THREE.Quaternion(row[4], row[5], row[6], row[3]);
  return new THREE.Matrix4().compose(
      new THREE.Vector3(...from.slice(0, 3)).lerp(new THREE.Vector3(...to.slice(0, 3)), share),
      turn(from).slerp(turn(to), share), new THREE.Vector3(1, 1, 1));
}

// {group, marks (of contacts), pose(state, demonstration_s), wear(pick, nearest, touching)};
// only: the target alone is shown, as lines.
export function createObjects({ plan, robot, target }, materials, only, onChange) {
  const group = new THREE.Group();
  const meshes = plan.objects.map(() => null);
  const marks = createContactMarks(plan.grasp?.contacts ?? [], materials.contact);
  const add = (object, index, geometry) => {
    const isTarget = object.name === target;
    const material = isTarget ? materials.target : materials.object;
    const mesh = fixedMesh(geometry, material);
    mesh.userData.material = material;
    mesh.visible = !only || isTarget;
    const edges = new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), materials.edge);
    mesh.add(edges);
    if (only) mesh.material = materials.none;
    if (isTarget && !only) mesh.add(marks);
    meshes[index] = mesh;
    group.add(mesh);
    onChange();
  };
  plan.objects.forEach(async (object, index) => {
    add(object, index, object.block ? meshGeometry(await loadBlock(object.block)) : objectGeometry(object));
  });
  return {
    group, marks,
    pose(state, demonstration_s) {
      plan.objects.forEach((object, index) => {
        const mesh = meshes[index];
        if (!mesh) return;
        const carried = object.name === target && state ? rowOf(state.motion.object_pose, state.index) : null;
        if (carried && Number.isFinite(carried[0])) mesh.matrix.copy(poseMatrix(carried));
        else mesh.matrix.copy(recordedPose(object, demonstration_s));
        mesh.matrixWorldNeedsUpdate = true;
      });
    },
    wear(pick, nearest, touching) {
      if (only) return;
      meshes.forEach((mesh, index) => {
        if (!mesh) return;
        const body = robot.capsules.length + index;
        const isPicked = pick?.kind === "pair" && (pick.first === body || pick.second === body);
        mesh.material = isPicked ? materials.picked
            : nearest.includes(body) ? materials.near
            : touching.has(body) ? materials.touchingObject : mesh.userData.material;
      });
    },
  };
}
