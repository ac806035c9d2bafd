"""A target that stands elsewhere: the movement is transported to it, and all else holds as ever."""
import unittest
from pathlib import Path

import h5py
import numpy as np

import formats
from support import (QUICK, RECORDINGS, REFERENCE, CommandCase, json, main, morphe, python_verify,
                     sha256, temporary_folder)

MANIFEST = """\
format: vicon-csv
recordings:
  - {file: %s/ADL001DR2.csv, static_trial: %s/ADL001_static.csv, upper_arm: 0.274, forearm: 0.254}
""" % (RECORDINGS, RECORDINGS)
SHIFT, YAW = np.array([0.05, -0.03, 0.0]), np.radians(15)


def setUpModule():
    global FOLDER
    holder = temporary_folder()
    unittest.addModuleCleanup(holder.cleanup)
    FOLDER = Path(holder.name).resolve()
    (FOLDER / "recordings.yaml").write_text(MANIFEST)


def run(name, *settings):
    pairs = [x for setting in settings for x in ("--set", setting)]
    result = morphe("run", REFERENCE, "--dataset", FOLDER / "recordings.yaml", "--out", FOLDER / name,
                    *QUICK, *pairs)
    assert result.returncode == 0, result.stderr
    return FOLDER / name / "plans.h5"


def numbers(values):
    return "[" + ", ".join(f"{value:.17g}" for value in values) + "]"


class Moved(CommandCase):
    @classmethod
    def setUpClass(cls):
        cls.paths = [run("still"), run("moved", f"scene.target.pose_offset.position={numbers(SHIFT)}",
                                       f"scene.target.pose_offset.rpy={numbers([0, 0, YAW])}")]
        cls.files = [h5py.File(path) for path in cls.paths]
        cls.still, cls.moved = [file["plans/ADL001DR2/000"] for file in cls.files]

    @classmethod
    def tearDownClass(cls):
        for file in cls.files:
            file.close()

    def test_it_is_executable_and_says_so(self):
        self.assertEqual(formats.text(self.moved.attrs["status"]), "executable")
        self.assertIn("transported: cup is 58 mm from its recorded position, rotated by 15 degrees",
                      formats.text(self.moved.attrs["detail"]))
        self.assertIn("transported", list(self.moved["goals/estimated"].asstr()))
        self.assertNotIn("transported", list(self.still["goals/estimated"].asstr()))
        self.assertEqual(self.json_of("verify", self.paths[1])["violations"], [])
        self.assertEqual(json.loads(python_verify(self.paths[1]).stdout)["violations"], [])

    def test_the_cup_stands_there(self):
        self.assertIn("axis: y, angle: 105 deg", REFERENCE.read_text())
        # world_from_base of the config: Ry(105 deg) Rz(90 deg).
        c, s = np.cos(np.radians(105)), np.sin(np.radians(105))
        world_from_base = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]) @ [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
        before, after = [plan["grasp/object_pose"][()] for plan in (self.still, self.moved)]
        np.testing.assert_allclose(world_from_base @ (after - before)[:3, 3], SHIFT, atol=1e-9)
        turn = world_from_base @ after[:3, :3] @ before[:3, :3].T @ world_from_base.T
        c, s = np.cos(YAW), np.sin(YAW)
        np.testing.assert_allclose(turn, [[c, -s, 0], [s, c, 0], [0, 0, 1]], atol=1e-9)

    def test_the_grasp_is_the_demonstrations(self):
        # Thumb and index have goals: each plan meets its own to `tracking_tolerance_grasp`.
        still, moved = [plan["grasp/tips_in_object"][()] for plan in (self.still, self.moved)]
        goals = np.isfinite(self.still["goals/tip_position"][-1, :, 0])
        self.assertEqual(goals.sum(), 2)
        apart = np.linalg.norm(still - moved, axis=1)[goals]
        self.assertLess(apart.max(), 2 * self.still.attrs["tracking_tolerance_grasp"])
        # The goals themselves are the same, to rounding.
        for frame in range(-5, 0):
            seen = [(pose := plan["grasp/object_pose"][()])[:3, :3].T
                    @ (plan["goals/tip_position"][frame] - pose[:3, 3]).T for plan in (self.still, self.moved)]
            np.testing.assert_allclose(seen[0][:, goals], seen[1][:, goals], atol=1e-9)

    def test_it_begins_as_recorded(self):
        for key in ("tip_position", "wrist_position", "elbow_position", "shoulder_position"):
            still, moved = [plan["goals"][key][()] for plan in (self.still, self.moved)]
            np.testing.assert_allclose(still[0], moved[0], atol=1e-9)
        np.testing.assert_allclose(self.still["goals/shoulder_position"][()],
                                   self.moved["goals/shoulder_position"][()], atol=1e-9)

    def test_the_arm_keeps_its_lengths(self):
        goals = [plan["goals"] for plan in (self.still, self.moved)]
        for first, second in (("shoulder_position", "elbow_position"), ("elbow_position", "wrist_position")):
            lengths = [np.linalg.norm(g[first][()] - g[second][()], axis=1) for g in goals]
            np.testing.assert_allclose(*lengths, atol=1e-9)

    def test_no_move_gives_the_same_plans(self):
        zero = run("zero", "scene.target.pose_offset.position=[0, 0, 0]", "scene.target.pose_offset.rpy=[0, 0, 0]")
        said = morphe("diff", zero, self.paths[0], "--all").stdout
        self.assertIn("1 plan in both, all equal; the files differ otherwise:", said)
        self.assertIn("assumptions", said, "which name the settings")

    def test_it_is_asked_for_one_way_only(self):
        result = morphe("run", REFERENCE, "--dataset", FOLDER / "recordings.yaml", "--out",
                        self.folder / "both", "--set", "scene.target.pose={position: [0, 0, 0]}",
                        "--set", "scene.target.pose_offset.position=[0.1, 0, 0]")
        self.assertEqual(result.returncode, 2)
        self.assertIn("pose: not allowed together with pose_offset", result.stderr)


if __name__ == "__main__":
    main()
