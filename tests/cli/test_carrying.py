"""From the grasp to its release the target goes with the hand: plans that go on beyond the grasp."""
import sys
import unittest

import h5py
import numpy as np

from formats import text
from support import (ONE_RECORDING, QUICK, REFERENCE, SOURCE, CommandCase, json, main, morphe, python_verify,
                     shared_run, write_recordings)

sys.path.insert(0, str(SOURCE / "tests"))
from verify_plans import Robot, in_base

PLAN = "ADL001DR2/000"


class Carrying(CommandCase):
    def plan(self, *settings):
        manifest = write_recordings(self.folder, ONE_RECORDING)
        self.plans = self.folder / "out/plans.h5"
        self.succeeds("run", REFERENCE, "--dataset", manifest, "--out", self.folder / "out", *QUICK,
                      "--set", "segment.plan_until=transport", *settings)

    def violations(self):
        own, other = morphe("verify", self.plans, "--json"), python_verify(self.plans)
        self.assertEqual(own.returncode, other.returncode, own.stdout + other.stdout + other.stderr)
        return json.loads(own.stdout)["violations"], json.loads(other.stdout)["violations"]

    def test_the_cup_goes_to_the_mouth_and_the_forearm_not_through_it(self):
        self.plan()
        self.assertEqual(self.violations(), ([], []))
        with h5py.File(self.plans) as file:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["status"]), "executable")
            cup = plan["scene/cup"]
            self.assertNotIn("attached_frame", cup.attrs)
            self.assertGreaterEqual(cup["time"][0], cup.attrs["attach_s"] - 1e-9)
            self.assertLessEqual(cup["time"][-1], cup.attrs["release_s"] + 1e-9)
            way = np.linalg.norm(cup["position"] - cup["position"][0], axis=1)
            self.assertGreater(way.max(), 0.3)
            # The tips' goals stay where they are on it, as far as they keep their distance.
            names = list(file["robot/tips/name"].asstr())
            tips = [plan["goals/tip_position"][:, names.index(name)] for name in ("thumb_tip", "index_tip")]
            middle = [np.interp(cup["time"], plan["goals/time"], (tips[0] + tips[1])[:, i] / 2) for i in range(3)]
            self.assertLess(np.ptp(np.linalg.norm(cup["position"][()].T - middle, axis=0)), 1e-6)
        self.planted()

    def planted(self):
        """The cup where the forearm is while it is carried: fingers may touch it, the forearm not."""
        with h5py.File(self.plans, "r+") as file:
            robot, plan = Robot(file["robot"]), file["plans"][PLAN]
            cup, motion = plan["scene/cup"], plan["trajectory"]
            half = len(cup["time"]) // 2
            sample = int(np.abs(motion["demonstration_time"] - cup["time"][half]).argmin())
            poses = robot.frame_poses(motion["position"][sample:sample + 1])
            k = [text(name) for name in robot.capsule_names].index("forearm_right")
            ends = [in_base(poses, robot.capsules["frame"][k], robot.capsules[end][k])[0] for end in ("from", "to")]
            cup["position"][half] = (ends[0] + ends[1]) / 2
        for rows in self.violations():
            self.assertTrue([row for row in rows if row["subject"] == "forearm_right/cup"], rows)

    def test_rigidly_in_the_palm(self):
        self.plan("--set", "scene.target.carried_by=palm", "--set", "repair.max_iterations=1",
                  "--set", "repair.attempts=1")
        self.assertEqual(self.violations(), ([], []))
        with h5py.File(self.plans) as file:
            cup = file["plans"][PLAN]["scene/cup"]
            self.assertEqual(cup["time"].shape, (1,))
            self.assertEqual(text(cup.attrs["attached_frame"]), file["robot/frames/name"].asstr()[file["robot"].attrs["palm_frame"]])

    def test_not_before_it_is_grasped(self):
        with h5py.File(shared_run(REFERENCE, *QUICK, dataset="two recordings") / "out/plans.h5") as file:
            cup = file["plans"][PLAN]["scene/cup"]
            self.assertEqual(cup["time"].shape, (1,))
            self.assertNotIn("attached_frame", cup.attrs)


if __name__ == "__main__":
    main()
