"""Plans among triangle meshes: made, judged by `morphe verify` and by tests/verify_plans.py, and
refused where a hand or its goal is in something closed. Takes 13 s of processor time: ten scenes are
planned in."""
import shutil
import struct
import unittest

import h5py
import numpy as np

from formats import text
from support import QUICK, SOURCE, CommandCase, json, main, morphe, python_verify

SHELF = SOURCE / "configs/pipelines/pa10_dlr_hit2_shelf.yaml"
RECORDING = """\
format: vicon-csv
recordings:
  - {{file: {0}/ADL001DR2.csv, static_trial: {0}/ADL001_static.csv, upper_arm: 0.274, forearm: 0.254}}
"""
PLAN = "ADL001DR2/000"
# The judge in Python takes as long as there are samples, times triangles, times capsules.
COARSE = ("--set", "retime.sample_rate_hz=25")
SIDES = ((0, 2, 3, 1), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5), (4, 5, 7, 6))


def write_box(file, low, high, walls=6, cells=1):
    """A binary STL; `walls` 5: open above. `cells`: squares along each side of a wall."""
    corners = np.array([[(high if k >> a & 1 else low)[a] for a in range(3)] for k in range(8)], float)
    steps = np.arange(cells + 1) / cells
    u, v = np.meshgrid(steps, steps, indexing="ij")
    soup = []
    for a, b, _, d in SIDES[:walls]:
        grid = corners[a] + u[..., None] * (corners[b] - corners[a]) + v[..., None] * (corners[d] - corners[a])
        p, q, r, s = grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]
        soup += [np.stack([p, q, r], axis=2), np.stack([p, r, s], axis=2)]
    soup = np.concatenate([part.reshape(-1, 3, 3) for part in soup])
    rows = np.zeros(len(soup), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("no", "<u2")]))
    rows["corners"] = soup
    file.write_bytes(bytes(80) + struct.pack("<I", len(rows)) + rows.tobytes())


class MeshCase(CommandCase):
    def setUp(self):
        super().setUp()
        self.manifest = self.folder / "one.yaml"
        self.manifest.write_text(RECORDING.format(SOURCE / "datasets/ue-adl"))
        self.plans = self.folder / "out/plans.h5"

    def run_with(self, config, *more):
        self.succeeds("run", config, "--dataset", self.manifest, "--out", self.folder / "out", *QUICK, *COARSE, *more)
        with h5py.File(self.plans) as file:
            plan = file["plans"][PLAN]
            return text(plan.attrs["reason"]), text(plan.attrs["detail"])

    def refuses_to_plan(self, config, *more):
        """What cannot be free ends in collision, or out of it and too far from its goals."""
        reason, _ = self.run_with(config, *more)
        self.assertIn(reason, ("start_in_collision", "goal_in_collision", "tracking"))
        with h5py.File(self.plans) as file:
            self.assertNotIn("trajectory", file["plans"][PLAN])

    def config_with(self, *objects):
        """The reference pipeline with boxes: name, low, high and whether open above."""
        config = self.folder / "config.yaml"
        lines = [f"extends: {SOURCE}/configs/pipelines/pa10_dlr_hit2.yaml", "scene:", "  objects:"]
        for name, low, high, walls in objects:
            write_box(self.folder / f"{name}.stl", low, high, walls)
            lines.append(f"    - {{name: {name}, shape: mesh, file: {name}.stl, position: [0, 0, 0]}}")
        config.write_text("\n".join(lines) + "\n")
        return config

    def violations(self):
        """What both judges say; they must agree on whether there is anything."""
        own, other = morphe("verify", self.plans, "--json"), python_verify(self.plans)
        self.assertEqual(own.returncode, other.returncode, own.stdout + other.stdout + other.stderr)
        return json.loads(own.stdout)["violations"], json.loads(other.stdout)["violations"]


class Shelf(MeshCase):
    def test_the_hand_finds_its_way_in(self):
        reason, detail = self.run_with(SHELF)
        self.assertEqual(reason, "", detail)
        self.assertNotIn("not a closed mesh", detail)
        self.assertEqual(self.violations(), ([], []))
        with h5py.File(self.plans) as file:
            plan, shelf = file["plans"][PLAN], file["plans"][PLAN]["scene/shelf"]
            self.assertEqual(text(shelf.attrs["shape"]), "mesh")
            self.assertNotIn("size", shelf.attrs)
            self.assertEqual(shelf["vertices"].shape, (24, 3))
            self.assertEqual(shelf["triangles"].shape, (36, 3))
            self.assertEqual(text(shelf["vertices"].attrs["unit"]), "m")
            self.assertAlmostEqual(np.ptp(shelf["vertices"][:, 0]), 0.39)
            found = {text(row) for row in plan["findings/other_body"]}
            self.assertIn("shelf", found)
            self.assertEqual(plan["certificate"].attrs["repaired"], 1)
            tip = list(file["robot/tips/name"].asstr()).index("index_tip")
            hand = plan["goals/tip_position"][len(plan["goals/time"]) // 2, tip]
        self.moved_into_the_path(hand)

    def moved_into_the_path(self, hand):
        copy = self.folder / "out/whole.h5"
        shutil.copy(self.plans, copy)
        with h5py.File(self.plans, "r+") as file:
            shelf = file["plans"][PLAN]["scene/shelf"]
            shelf["position"][0] = hand  # the foot of the leg
        for rows in self.violations():
            self.assertTrue([row for row in rows if row["cause"] == "object_collision" and "/shelf" in row["subject"]])
        shutil.copy(copy, self.plans)
        with h5py.File(self.plans, "r+") as file:
            shelf = file["plans"][PLAN]["scene/shelf"]
            shelf["vertices"][3, 1] = np.nan
        for rows in self.violations():
            self.assertEqual([row["subject"] for row in rows], ["shelf"])

    def test_its_hull_holds_the_cup(self):
        scene = (SOURCE / "configs/scenes/shelf_over_the_cup.yaml").read_text()
        (self.folder / "scene.yaml").write_text(scene.replace("shape: mesh", "shape: convex").replace(
            "file: shelf.stl", f"file: {SOURCE}/configs/scenes/shelf.stl"))
        self.refuses_to_plan(SHELF, "--set", f"scene.file={self.folder}/scene.yaml")

    def test_the_mapping_may_know_it(self):
        """A block beside the way, which the mapping's clearance term keeps off."""
        config = self.config_with(("block", (0.345, 0.0, 0.012), (0.40, 0.2, 0.10), 6))
        reason, detail = self.run_with(config)
        self.assertEqual(reason, "", detail)
        self.assertEqual(self.violations(), ([], []))


class Hollow(MeshCase):
    """Around the hand and most of the arm."""
    ROOM = ((-0.2, -0.2, -0.5), (0.8, 0.9, 0.9))

    def test_closed(self):
        self.refuses_to_plan(self.config_with(("crate", *self.ROOM, 6)))

    def test_open(self):
        """Around all of the robot, open above."""
        low, high = (-0.6, -0.9, -0.6), (1.2, 1.2, 1.6)
        reason, detail = self.run_with(self.config_with(("basin", low, high, 5)))
        self.assertEqual(reason, "", detail)
        self.assertIn("basin is not a closed mesh: only its surface is an obstacle", detail)
        self.assertEqual(self.violations(), ([], []))

    def test_goal_inside(self):
        self.refuses_to_plan(self.config_with(("brick", (0.14, 0.16, 0.02), (0.25, 0.26, 0.12), 6)))


class Files(MeshCase):
    def test_many_triangles(self):
        """A table of 120,000 triangles, 12 cm under the real one."""
        write_box(self.folder / "fine.stl", (-0.4, -0.1, -0.25), (0.8, 0.8, -0.15), 6, 100)
        config = self.config_with()
        config.write_text(config.read_text() +
                          "    - {name: fine, shape: mesh, file: fine.stl, position: [0, 0, 0]}\n")
        reason, detail = self.run_with(config)
        self.assertEqual(reason, "", detail)
        self.assertEqual(morphe("verify", self.plans).returncode, 0)

    def test_truncated(self):
        config = self.config_with(("cut", (0, 0, 0), (1, 1, 1), 6))
        file = self.folder / "cut.stl"
        file.write_bytes(file.read_bytes()[:-200])
        self.refuses(morphe("run", config, "--dataset", self.manifest, "--out", self.folder / "out"),
                     f"{config}:4", "objects[0].file", "cut.stl")

    def test_no_number(self):
        config = self.config_with(("odd", (0, 0, 0), (1, 1, float("nan")), 6))
        self.refuses(morphe("run", config, "--dataset", self.manifest, "--out", self.folder / "out"),
                     f"{config}:4", "objects[0].file", "odd.stl")


if __name__ == "__main__":
    main()
