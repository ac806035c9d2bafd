// Table, target and obstacles in the 3D view.
import { loadBlock, rowOf } from "./data.js";
import { createContactMarks } from "./grasp.js";
import { interpolationAt } from "./playback.js";
import { fixedMesh, meshGeometry, objectGeometry, poseMatrix } from "./shapes.js";

export const kTable = "table";

// The recorded pose at a time of the demonstration; constant before the first and after the last sample.
export function poseMatrixAt({ time, pose }, demonstration_s) {
  const { index, next, share } = interpolationAt(time, demonstration_s);
  const from = rowOf(pose, index), to = rowOf(pose, next);
  if (share === 0) return poseMatrix(from);
  const rotation = (row) => new THREE.Quaternion(row[4], row[5], row[6], row[3]);
  return new THREE.Matrix4().compose(
      new THREE.Vector3(...from.slice(0, 3)).lerp(new THREE.Vector3(...to.slice(0, 3)), share),
      rotation(from).slerp(rotation(to), share), new THREE.Vector3(1, 1, 1));
}

// Obstacles have a colour of their own, and their edges shine through what is before them.
// {group, marks (of contacts), pose(state, demonstration_s), highlight(pick, nearest, touching)};
// targetOnly: only the target is shown, as lines.
export function createObjects({ plan, robot, target }, materials, targetOnly, onChange) {
  const group = new THREE.Group();
  const meshes = plan.objects.map(() => null);
  const marks = createContactMarks(plan.grasp?.contacts ?? [], materials.contact);
  const add = (object, index, geometry) => {
    const isTarget = object.name === target;
    const isObstacle = !isTarget && object.name !== kTable;
    const material = isTarget ? materials.target : isObstacle ? materials.obstacle : materials.object;
    const mesh = fixedMesh(geometry, material);
    mesh.userData.material = material;
    mesh.visible = !targetOnly || isTarget;
    const edges = new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), materials.edge);
    mesh.add(edges);
    if (isObstacle && !targetOnly) mesh.add(new THREE.LineSegments(edges.geometry, materials.hiddenEdge));
    if (targetOnly) mesh.material = materials.invisible;
    if (isTarget && !targetOnly) mesh.add(marks);
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
        const carriedPose = object.name === target && state ? rowOf(state.motion.object_pose, state.index) : null;
        if (carriedPose && Number.isFinite(carriedPose[0])) mesh.matrix.copy(poseMatrix(carriedPose));
        else mesh.matrix.copy(poseMatrixAt(object, demonstration_s));
        mesh.matrixWorldNeedsUpdate = true;
      });
    },
    highlight(pick, nearest, touching) {
      if (targetOnly) return;
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
