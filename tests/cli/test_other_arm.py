"""The person's other arm as an obstacle: plans that pass through it without the key keep clear of it
with the key, by both judges; what of it was not recorded is said."""
import sys
import unittest
from pathlib import Path

import h5py
import numpy as np

from formats import text
from recorded import Recorded, joints_of, point_csv, recorded_from_csv
from support import (QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, json, main, morphe,
                     python_verify, temporary_folder)

sys.path.insert(0, str(SOURCE / "tests"))
from verify_plans import Robot, in_base

PLAN = "ADL001DR2/000"
LEFT = ["left_shoulder", "left_elbow", "left_wrist", "left_index_tip"]
BONES = (0.28, 0.25, 0.17)  # m
DEEP = 0.04  # m into the robot's forearm


def setUpModule():
    global FOLDER, RIGHT, ALONE
    holder = temporary_folder()
    unittest.addModuleCleanup(holder.cleanup)
    FOLDER = Path(holder.name).resolve()
    trial, still = [recorded_from_csv(RECORDINGS / f"ADL001{kind}.csv") for kind in ("DR2", "_static")]
    RIGHT = joints_of(trial, still)
    ALONE = run("alone", dataset("alone", RIGHT))


def dataset(name, recorded):
    (FOLDER / name).mkdir()
    (FOLDER / name / "ADL001DR2.csv").write_text(point_csv(recorded, 1, time="time"))
    manifest = FOLDER / f"{name}.yaml"
    manifest.write_text("format: point-csv\nunit: m\naxes: x y z\nforward: recorded\n"
                        f"recordings:\n  - {{file: {name}/ADL001DR2.csv}}\n")
    return manifest


def run(name, manifest, *settings):
    result = morphe("run", REFERENCE, "--dataset", manifest, "--out", FOLDER / name / "out", *QUICK,
                    *[x for setting in settings for x in ("--set", setting)])
    assert result.returncode == 0, result.stderr
    return FOLDER / name / "out/plans.h5"


def forearm_on_its_way(plans):
    """Where the middle of the robot's forearm is half-way through the movement, in the recording's
    world; when; its radius; and a direction that leads there from beside the robot's arm."""
    with h5py.File(plans) as file:
        robot, plan = Robot(file["robot"]), file["plans"][PLAN]
        motion, world_from_base = plan["trajectory"], np.linalg.inv(plan["reference_frames/recording"][()])
        half = len(motion["time"]) // 2
        poses = robot.frame_poses(motion["position"][half:half + 1])
        k = [text(name) for name in robot.capsule_names].index("forearm_right")
        ends = [in_base(poses, robot.capsules["frame"][k], robot.capsules[end][k])[0] for end in ("from", "to")]
        middle = (ends[0] + ends[1]) / 2
        turned = world_from_base[:3, :3]
        along = turned @ (ends[1] - ends[0])
        at = turned @ middle + world_from_base[:3, 3]
        return at, motion["demonstration_time"][half], robot.capsules["radius"][k], along / np.linalg.norm(along)


def crossing():
    """The recording, and in it a left arm that comes from the person's left up to the forearm and
    leaves again."""
    at, time, radius, along = forearm_on_its_way(ALONE)
    towards = np.array([1.0, 0.3, 0]) - along * (along @ [1.0, 0.3, 0])
    towards /= np.linalg.norm(towards)
    away = 0.5 * np.sin(np.clip(0.9 * (RIGHT.time - time), -np.pi / 2, np.pi / 2)) ** 2
    tip = at - (radius + 0.048 - DEEP + away)[:, None] * towards
    wrist, elbow = tip - BONES[2] * towards, tip - (BONES[2] + BONES[1]) * towards
    shoulder = elbow + np.array([0, 0, BONES[0]])
    left = np.stack([shoulder, elbow, wrist, tip], axis=1)
    return Recorded(RIGHT.names + LEFT, np.concatenate([RIGHT.position, left], axis=1))


class OtherArm(CommandCase):
    def judged(self, plans):
        own, other = morphe("verify", plans, "--json"), python_verify(plans)
        self.assertEqual(own.returncode, other.returncode, own.stdout + other.stdout + other.stderr)
        return json.loads(own.stdout)["violations"], json.loads(other.stdout)["violations"]

    def test_it_is_passed_through_without_the_key_and_passed_by_with_it(self):
        manifest = dataset("crossing", crossing())
        through = run("crossing", manifest)
        with h5py.File(through) as file, h5py.File(ALONE) as alone:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["status"]), "executable")
            self.assertNotIn("other hand", plan["scene"])
            np.testing.assert_array_equal(plan["trajectory/position"], alone["plans"][PLAN]["trajectory/position"])
        self.assertEqual(self.judged(through), ([], []))
        (FOLDER / "around").mkdir()
        around = run("around", manifest, "scene.other_arm=true")
        with h5py.File(around) as file, h5py.File(through, "r+") as planted:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["status"]), "executable", text(plan.attrs["detail"]))
            self.assertEqual(text(plan.attrs["target"]), "cup")
            hand = plan["scene/other hand"]
            np.testing.assert_allclose(hand.attrs["size"], [0.048, BONES[2]], atol=2e-3)
            found = {text(name) for name in plan["findings/other_body"]}
            self.assertTrue({"other hand", "other forearm"} & found, found)
            for name in ("other upper arm", "other forearm", "other hand"):
                file.copy(plan["scene"][name], planted["plans"][PLAN]["scene"])
        self.assertEqual(self.judged(around), ([], []))
        # The plan that was made without it runs into it: both judges see that.
        for rows in self.judged(through):
            self.assertTrue([row for row in rows if row["subject"].endswith("/other hand")], rows)

    def test_what_was_not_recorded_is_said(self):
        (FOLDER / "nothing").mkdir()
        plans = run("nothing", FOLDER / "alone.yaml", "scene.other_arm=true")
        with h5py.File(plans) as file, h5py.File(ALONE) as alone:
            plan = file["plans"][PLAN]
            self.assertIn("the person's other arm was not recorded: it is not an obstacle", text(plan.attrs["detail"]))
            np.testing.assert_array_equal(plan["trajectory/position"], alone["plans"][PLAN]["trajectory/position"])

    def test_a_wrong_radius_is_one_line(self):
        result = morphe("run", REFERENCE, "--dataset", FOLDER / "alone.yaml", "--out", self.folder / "out",
                        "--set", "scene.other_arm=true", "--set", "scene.other_arm_radii=[0.05, 0.05]")
        self.assertEqual(result.returncode, 2)
        self.assertIn("other_arm_radii: needs three radii: of upper arm, forearm and hand", result.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
