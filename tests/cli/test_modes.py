"""What `map` can be asked for beside the paper's objective: the baselines as modes, a free offset of
the base, and hands without an arm or without five fingers. Truth: the files the goals come from, and
kinematics of the tests' own (tests/verify_plans.py). Takes 18 s of processor time: ten plans are made, of which
one is 20 s long, and judged by both verifiers."""
import csv
import os
import sys
from pathlib import Path

import h5py
import numpy as np

import formats
from support import (QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, json, main, morphe,
                     python_verify, temporary_folder)

sys.path.insert(0, str(SOURCE / "tests"))
from verify_plans import Robot  # noqa: E402

COARSE = ("--set", "retime.sample_rate_hz=50")  # not 500: judged in a fraction of the time
SMALL = (*QUICK, "--set", "map.reach_search_starts=4")
ONE_RECORDING = """\
format: vicon-csv
recordings:
  - {file: recorded/ADL001DR2.csv, static_trial: recorded/ADL001_static.csv, upper_arm: 0.274, forearm: 0.254}
"""
DOOR = f"""\
format: adroit-csv
forward: recorded
recordings:
  - {{file: {SOURCE}/datasets/adroit-dapg/door_demo_06.csv, name: door}}
"""
FREE_ARM = """\
robot: {{file: {robot}}}
scene: {{table: {{infer: false}}, target: {{infer: false}}}}
check: {{tracking_tolerance_grasp: 0.012, tracking_tolerance: 0.030}}
"""
FOUR_FINGERS = """\
name: arm9_hand4
parts:
  - generate: {arm: {joints: 9, length: 0.577}}
  - parent: arm
    generate: {hand: {fingers: 4, length: 0.205, breadth: 0.0913}}
"""


def ran(folder, config, dataset, *arguments):
    """The plans.h5 of a run, opened, and judged by both verifiers."""
    result = morphe("run", config, "--dataset", dataset, "--out", folder, "--jobs", 2, "--json", *COARSE, *arguments)
    assert result.returncode == 0, result.stderr
    for verdict in (morphe("verify", folder / "plans.h5", "--json"), python_verify(folder / "plans.h5")):
        assert verdict.returncode == 0, verdict.stdout + verdict.stderr
        assert json.loads(verdict.stdout)["violations"] == []
    return h5py.File(folder / "plans.h5", "r")


def first_plan(file):
    movements = next(iter(file["plans"].values()))
    return next(iter(movements.values()))


def attribute(plan, name):
    return formats.text(plan.attrs[name])


class Runs(CommandCase):
    """One recording of a person who drinks, onto the reference robot."""

    @classmethod
    def setUpClass(cls):
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        base = Path(holder.name)
        os.symlink(RECORDINGS, base / "recorded")
        (base / "one.yaml").write_text(ONE_RECORDING)
        cls.files = {}
        for name, more in {"humanlike": [], "inverse_kinematics": ["map.mode=inverse_kinematics"],
                           "fingertip_only": ["map.mode=fingertip_only"],
                           "joint_to_joint": ["map.mode=joint_to_joint"],
                           "free_offset": ["map.base_offset.limit=0.04"]}.items():
            sets = [argument for setting in more for argument in ("--set", setting)]
            cls.files[name] = ran(base / name, REFERENCE, base / "one.yaml", *SMALL, *sets)
            cls.addClassCleanup(cls.files[name].close)
        cls.plans = {name: first_plan(file) for name, file in cls.files.items()}

    def mean_a(self, name):
        return np.nanmean(self.plans[name]["mapped/humanlikeness"][:, 0])

    def largest_error(self, name):
        return np.nanmax(self.plans[name]["mapped/tip_error"][()])

    def test_every_mode_asks_for_the_same_goals(self):
        goals = self.plans["humanlike"]["goals/tip_position"][()]
        for name in ("inverse_kinematics", "fingertip_only", "joint_to_joint"):
            with self.subTest(name):
                self.assertTrue(np.array_equal(self.plans[name]["goals/tip_position"][()], goals,
                                               equal_nan=True))
                config = formats.text(self.files[name].attrs["config"])
                self.assertIn(f"mode: '{name}'", config)

    def test_without_humanlikeness_tips_are_met_and_the_elbow_is_not(self):
        self.assertLess(self.largest_error("humanlike"), 1e-3)
        for name in ("inverse_kinematics", "fingertip_only"):
            with self.subTest(name):
                self.assertLess(self.largest_error(name), 1e-3)
                self.assertGreater(self.mean_a(name), self.mean_a("humanlike"))

    def test_joint_to_joint_has_the_humans_directions_and_misses_the_tips(self):
        plan, robot = self.plans["joint_to_joint"], Robot(self.files["joint_to_joint"]["robot"])
        self.assertEqual((attribute(plan, "status"), attribute(plan, "reason")), ("infeasible", "tracking"))
        self.assertGreater(self.largest_error("joint_to_joint"), 0.05)
        self.assertIn("finger angles", plan["goals/estimated"].asstr()[()])
        poses = robot.frame_poses(plan["mapped/position"][()])
        group = self.files["joint_to_joint"]["robot"]
        elbow, wrist = [f for f, chain in zip(group["joint_centres/frame"][()], group["joint_centres/chain"].asstr()[()])
                        if chain == "arm"]
        shoulder = group.attrs["shoulder_frame"]
        origins = [poses[:, frame, :3, 3] for frame in (shoulder, elbow, wrist)]
        human = [plan[f"goals/{name}_position"][()] for name in ("shoulder", "elbow", "wrist")]
        for k in (0, 1):
            a, b = origins[k + 1] - origins[k], human[k + 1] - human[k]
            cosine = (a * b).sum(1) / np.linalg.norm(a, axis=1) / np.linalg.norm(b, axis=1)
            angle = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
            self.assertLess(np.median(angle), 2)

    def test_stored_errors_are_those_of_the_tips_in_every_mode(self):
        for name, plan in self.plans.items():
            robot = Robot(self.files[name]["robot"])
            poses = robot.frame_poses(plan["mapped/position"][()])
            for tip, frame in enumerate(robot.tips["frame"]):
                at = poses[:, frame] @ robot.tips["transform"][tip][:, 3]
                error = np.linalg.norm(at[:, :3] - plan["goals/tip_position"][:, tip], axis=1)
                with self.subTest(name, tip=tip):
                    self.assertTrue(np.allclose(error, plan["mapped/tip_error"][:, tip], atol=1e-9,
                                                equal_nan=True))

    def test_a_free_offset_moves_the_base_and_says_so(self):
        moved, unmoved = self.plans["free_offset"]["goals"], self.plans["humanlike"]["goals"]
        self.assertNotIn("base_offset", unmoved.attrs)
        offset = moved.attrs["base_offset"]
        self.assertLessEqual(np.abs(offset).max(), 0.04)
        self.assertGreater(np.abs(offset).max(), 0)
        # The world, seen from a base elsewhere: one shift for all goals and for the table.
        shift = moved["tip_position"][()] - unmoved["tip_position"][()]
        shift = shift[~np.isnan(shift).any(axis=2)]
        self.assertLess(np.ptp(shift, axis=0).max(), 1e-12)
        self.assertAlmostEqual(np.linalg.norm(shift[0]), np.linalg.norm(offset), places=12)
        table = [self.plans[name]["scene/table/position"][0] for name in ("free_offset", "humanlike")]
        self.assertLess(np.abs(table[0] - table[1] - shift[0]).max(), 1e-12)
        # The human's shoulder still lies on the robot's.
        arm = moved.attrs["common_base_offset"] - unmoved.attrs["common_base_offset"]
        self.assertLess(np.abs(arm + shift[0]).max(), 1e-12)
        objective = {name: self.plans[name]["mapped/objective"][()].mean() for name in ("free_offset", "humanlike")}
        self.assertLess(objective["free_offset"] + (offset ** 2).sum(), objective["humanlike"])

    def test_bad_values_are_refused(self):
        for setting, words in {"map.mode=elbow_only": "'elbow_only'", "map.humanlike_hull=-1": "at least 0",
                               "map.base_offset.limit=-1": "at least 0"}.items():
            with self.subTest(setting):
                result = morphe("run", REFERENCE, "--out", self.folder / "out", "--set", setting)
                self.assertEqual(result.returncode, 2)
                self.assertIn(words, result.stderr)


class HandAlone(CommandCase):
    """The 21-keypoint recording onto the DLR/HIT II hand, by the shipped config."""

    @classmethod
    def setUpClass(cls):
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.config = SOURCE / "configs/pipelines/dlr_hit2_keypoints.yaml"
        cls.dataset = SOURCE / "datasets/dex-retargeting/recordings.yaml"
        cls.sets = (*QUICK, "--set", "map.reach_search_starts=1")
        cls.file = ran(Path(holder.name) / "out", cls.config, cls.dataset, *cls.sets)
        cls.addClassCleanup(cls.file.close)
        cls.plan = first_plan(cls.file)

    def test_the_whole_recording_is_one_movement_without_an_arm(self):
        self.assertEqual(len(self.file["plans/human_joint_right"]), 1)
        self.assertEqual(len(self.plan["phases/name"]), 0)
        self.assertAlmostEqual(self.plan.attrs["end_s"], 620 / 30, delta=0.05)
        self.assertTrue(np.isnan(self.plan["goals/elbow_position"][()]).all())
        self.assertTrue(np.isnan(self.plan["mapped/humanlikeness"][()]).all())
        self.assertEqual(len(self.plan["scene"]), 0)

    def test_it_is_approximate_and_certified(self):
        """The hand moves, and no goal of five tips at once is in its reach: it must not be called executable."""
        self.assertEqual(attribute(self.plan, "status"), "approximate")
        self.assertIn("fingertip goals are out of reach", attribute(self.plan, "detail"))
        certificate = self.plan["certificate"].attrs
        self.assertLessEqual(certificate["tip_error_max"], 0.08)
        self.assertGreaterEqual(certificate["clearance"], 0.001)

    def test_goals_are_the_recorded_tips_in_the_palms_frame(self):
        """From tip to tip, which no frame changes; bones of constant length make a difference."""
        with open(self.dataset.parent / "human_joint_right.csv") as file:
            rows = np.array([[float(cell) for cell in row] for row in list(csv.reader(file))[1:]])
        tips = rows[:, 1:].reshape(len(rows), 21, 3)[:, 4::4]
        goals, time = self.plan["goals/tip_position"][()], self.plan["goals/time"][()]
        recorded = tips[np.clip(np.round(time * 30).astype(int), 0, len(tips) - 1)]
        for a, b in ((0, 1), (1, 4), (2, 3)):
            ours = np.linalg.norm(goals[:, a] - goals[:, b], axis=1)
            theirs = np.linalg.norm(recorded[:, a] - recorded[:, b], axis=1)
            self.assertLess(np.median(np.abs(ours - theirs)), 0.008)
        # The wrist stands where the offset has left it.
        wrist = self.plan["goals/wrist_position"][()]
        self.assertLess(np.abs(wrist + self.plan["goals"].attrs["base_offset"]).max(), 1e-12)

    def test_an_arm_finds_no_movement_in_it(self):
        file = ran(self.folder / "out", REFERENCE, self.dataset, *SMALL)
        with file:
            self.assertEqual(attribute(first_plan(file), "reason"), "no_movement")


class GeneratedHands(CommandCase):
    """A real recording of a hand with five fingertips, onto hands of four and of five fingers."""

    def plan_with(self, robot):
        name = Path(robot).stem
        (self.folder / "door.yaml").write_text(DOOR)
        (self.folder / f"{name}.run.yaml").write_text(FREE_ARM.format(robot=robot))
        # Arms of nine and more joints need more than the quickest search.
        search = ("--set", "map.candidates=3", "--set", "map.coarse_step_s=0.05")
        file = ran(self.folder / name, self.folder / f"{name}.run.yaml", self.folder / "door.yaml", *SMALL, *search)
        self.addCleanup(file.close)
        return first_plan(file)

    def test_four_fingers_get_the_ends_of_the_curve_and_its_middle(self):
        (self.folder / "arm9_hand4.yaml").write_text(FOUR_FINGERS)
        four = self.plan_with(self.folder / "arm9_hand4.yaml")
        five = self.plan_with(SOURCE / "configs/robots/arm24_hand5.yaml")
        for plan in (four, five):
            self.assertEqual(attribute(plan, "reason"), "")
            error, reachable = plan["mapped/tip_error"][()], plan["goals/reachable"][()] == 1
            self.assertGreater(reachable.mean(), 0.9)
            self.assertLess(error[reachable].max(), 1e-3)
        a, b = four["goals/tip_position"][()], five["goals/tip_position"][()]
        self.assertEqual((a.shape[1], b.shape[1]), (4, 5))
        for finger, human in ((0, 0), (1, 1), (3, 4)):
            self.assertLess(np.abs(a[:, finger] - b[:, human]).max(), 1e-8)
        between = np.minimum(np.linalg.norm(a[:, 2] - b[:, 2], axis=1), np.linalg.norm(a[:, 2] - b[:, 3], axis=1))
        self.assertLess(between.max(), np.linalg.norm(b[:, 2] - b[:, 3], axis=1).max())


if __name__ == "__main__":
    main()
