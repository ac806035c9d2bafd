"""A user's own things beside what was recorded: where table, target and shoulder stand, meshes that
stand on the table, a mesh that is grasped."""
import re
from pathlib import Path

import h5py
import numpy as np

from formats import text
from support import REFERENCE, SOURCE, CommandCase, main, morphe, sha256, temporary_folder
from test_meshes import PLAN, MeshCase, write_box

LOW, HIGH = np.array([10, -20, 5]), np.array([110, 40, 85])  # mm, its origin outside


def in_frame(pose, points):
    """Points of the base seen from a frame whose pose in the base is given."""
    return (np.atleast_2d(points) - pose[:3, 3]) @ pose[:3, :3]


def turned(quaternion, points):
    w, x, y, z = quaternion
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    return points @ rotation.T


def write_prism(file, radius, height, sides=12):
    """An upright prism as OBJ, in mm, its foot at z = 0 around the origin."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = radius * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    rows = [f"v {x:.6f} {y:.6f} {z}" for z in (0, height) for x, y in ring]
    rows += [f"v 0 0 0", f"v 0 0 {height}"]
    for k in range(sides):
        a, b = k + 1, (k + 1) % sides + 1
        rows += [f"f {a} {b} {b + sides}", f"f {a} {b + sides} {a + sides}",
                 f"f {b} {a} {2 * sides + 1}", f"f {a + sides} {b + sides} {2 * sides + 2}"]
    file.write_text("\n".join(rows) + "\n")


class OwnMesh(CommandCase):
    """Beside synthetic recordings, which an arm alone follows: a run takes a tenth of a second."""
    CONFIG = f"""\
robot: {{{{file: {SOURCE}/configs/robots/pa10.yaml}}}}
placement: {{{{rotation: [{{{{axis: y, angle: 105 deg}}}}, {{{{axis: z, angle: 90 deg}}}}], shoulder_offset: [0.1, -0.3, 0.3]}}}}
map: {{{{key_frames: 1, starts: 1, candidates: 1, reach_search_starts: 1, coarse_step_s: 0.2}}}}
scene:
  objects:
    - {{{{name: toolbox, shape: mesh, file: toolbox.stl, {{}}position: {{}}, avoid_in_mapping: false}}}}
"""

    @classmethod
    def setUpClass(cls):
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        synthetic = Path(holder.name) / "synthetic.yaml"
        synthetic.write_text("movements: {movements_per_recording: [1, 1]}\nglove: {rate_hz: 30}\n")
        cls.dataset = synthetic.with_name("two.h5")
        made = morphe("synthesize", synthetic, "--out", cls.dataset, "--count", 2)
        assert made.returncode == 0, made.stderr

    def setUp(self):
        super().setUp()
        write_box(self.folder / "toolbox.stl", LOW, HIGH)
        self.config = self.folder / "mine.yaml"

    def run_it(self, more, position, *arguments, out="out"):
        self.config.write_text(self.CONFIG.format(more, position))
        self.plans = self.folder / out / "plans.h5"
        return morphe("run", self.config, "--dataset", self.dataset, "--out", self.plans.parent, *arguments)

    def each_plan(self):
        with h5py.File(self.plans) as file:
            for demonstration in file["plans"].values():
                yield from demonstration.values()

    def test_in_millimetres_on_the_table(self):
        """First try: the run says what is missing. Second try: it stands where it should."""
        placed = "relative_to: table, anchor: bottom_centre, rpy: [0, 0, 90 deg], "
        self.refuses(self.run_it(placed, "[0.45, 0.3, 0]"), f"{self.config}:6", "objects[0].file",
                     "toolbox.stl is 100 m long: give scale: 0.001 if its numbers are mm (0.1 m)")
        self.assertFalse(self.plans.exists())
        second = self.run_it("scale: 0.001, " + placed, "[0.45, 0.3, 0]")
        self.assertEqual(second.returncode, 0, second.stderr)
        self.assertNotIn("note: toolbox", second.stdout)
        for plan in self.each_plan():
            box, table = plan["scene/toolbox"], plan["reference_frames/table"][()]
            corners = turned(box["orientation"][0], box["vertices"][()]) + box["position"][0]
            seen = in_frame(table, corners)
            self.assertTrue(np.allclose(seen.min(axis=0), [0.42, 0.25, 0], rtol=0, atol=1e-6))
            self.assertTrue(np.allclose(seen.max(axis=0), [0.48, 0.35, 0.08], rtol=0, atol=1e-6))
        self.world_is_that_of_the_scene(second.stdout)

    def world_is_that_of_the_scene(self, printed):
        """table: the box's centre, half its thickness up; shoulder: the goals' without their offset;
        what is printed are medians of these numbers in mm."""
        rows = {"base of pa10": [], "person's shoulder": [], "centre of the target": []}
        for plan in self.each_plan():
            world, scene, table = plan["reference_frames"], plan["scene"], plan["reference_frames/table"][()]
            self.assertEqual(text(world["table"].attrs["frame"]), "base")
            self.assertEqual(text(world["shoulder"].attrs["unit"]), "m")
            centre = table[:3, 3] - table[:3, 2] * scene["table"].attrs["size"][2] / 2
            self.assertTrue(np.allclose(centre, scene["table/position"][0], rtol=0, atol=1e-12))
            self.assertTrue(np.allclose(table[:3, :3], world["recording"][:3, :3], rtol=0, atol=1e-12))
            self.assertTrue(np.allclose(world["target"][:3, 3], scene["cup/position"][0], rtol=0, atol=1e-12))
            shoulder = plan["goals/shoulder_position"][0] - plan["goals"].attrs["common_base_offset"]
            self.assertTrue(np.allclose(world["shoulder"], shoulder, rtol=0, atol=1e-12))
            for row, point in zip(rows.values(), (np.zeros(3), shoulder, world["target"][:3, 3])):
                row.append(np.concatenate([point, in_frame(table, point)[0],
                                           in_frame(world["recording"][()], point)[0]]))
        for name, points in rows.items():
            numbers = [float(n) for n in re.search(f"^{name} +(.*)$", printed, re.M)[1].split()]
            middle = np.median(points, axis=0)
            spread = np.linalg.norm((points - middle).reshape(-1, 3), axis=1).max()
            self.assertTrue(np.allclose(numbers, 1e3 * np.append(middle, spread), rtol=0, atol=0.51),
                            (name, numbers))

    def test_what_hangs_over_the_table_or_goes_into_it_is_noted(self):
        placed = "scale: 0.001, relative_to: table, anchor: bottom_centre, "
        hanging = "note: toolbox is 700 mm above the table without support; to place it on the table: "
        self.assertIn(hanging, self.run_it(placed, "[0.45, 0.3, 0.7]").stdout)
        self.assertIn(hanging, self.succeeds("list", self.plans).stdout)
        self.assertIn("note: toolbox is 30 mm deep in the table", self.run_it(placed, "[0.45, 0.3, -0.03]").stdout)
        self.assertNotIn("note: toolbox", self.run_it(placed, "[2, 0.3, -0.03]").stdout, "beside it")

    def test_the_same_bytes_on_any_number_of_threads(self):
        placed = "scale: 0.001, relative_to: target, "
        for jobs in (1, 2):
            self.assertEqual(self.run_it(placed, "[0.3, 0, 0.2]", "--jobs", jobs, out=f"jobs{jobs}").returncode, 0)
        self.assertEqual(*[sha256(self.folder / f"jobs{jobs}/plans.h5") for jobs in (1, 2)])
        beside = [in_frame(plan["reference_frames/target"][()], plan["scene/toolbox/position"][0])
                  for plan in self.each_plan()]
        self.assertEqual(len(beside), 2)
        self.assertTrue(np.allclose(beside, [0.3, 0, 0.2], rtol=0, atol=1e-9))

    def test_nothing_to_stand_on(self):
        """Without a target nothing is there that one could be beside."""
        result = self.run_it("scale: 0.001, relative_to: target, ", "[0.3, 0, 0]",
                             "--set", "scene.target.infer=false")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("no_reference_frame: toolbox is placed relative to the target, which does not exist in this", result.stdout)
        for plan in self.each_plan():
            self.assertEqual(text(plan.attrs["reason"]), "no_reference_frame")


class MeshTarget(MeshCase):
    """A mug of 12 sides, 30 mm in radius, is grasped where the recording's cup was."""

    def test_is_grasped_and_judged(self):
        write_prism(self.folder / "mug.obj", 30, 100)
        config = self.folder / "mug.yaml"
        config.write_text(f"extends: {REFERENCE}\nscene:\n  target: "
                          "{name: mug, body: {file: mug.obj, scale: 0.001}}\n")
        reason, detail = self.run_with(config)
        self.assertEqual(reason, "", detail)
        with h5py.File(self.plans) as file:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["target"]), "mug")
            self.assertEqual(text(plan["scene/mug"].attrs["shape"]), "mesh")
            foot, = in_frame(plan["reference_frames/table"][()], plan["scene/mug/position"][0])
            self.assertLess(abs(foot[2]), 1e-9)
            self.assertIn("grasp", plan)
        self.assertEqual(self.violations(), ([], []))
        self.planted()

    def planted(self):
        """The mug half as wide again: the fingers, which may touch it, are too deep in it."""
        with h5py.File(self.plans, "r+") as file:
            vertices = file["plans"][PLAN]["scene/mug/vertices"]
            wide = vertices[()]
            wide[:, :2] *= 1.5
            vertices[...] = wide
        for rows in self.violations():
            self.assertTrue([row for row in rows if row["cause"] == "object_collision" and row["subject"].endswith("/mug")])


if __name__ == "__main__":
    main()
