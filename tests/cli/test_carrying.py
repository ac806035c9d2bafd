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


def upwards(orientation):
    """The third axis of an object."""
    w, x, y, z = orientation
    return np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])


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

    def forged(self, change):
        """The causes and subjects of the violations of the plan after a change, which both judges find."""
        honest = self.plans.read_bytes()
        with h5py.File(self.plans, "r+") as file:
            change(file["plans"][PLAN])
        own, other = ({(row["cause"], row["subject"]) for row in rows} for rows in self.violations())
        self.plans.write_bytes(honest)
        return own, other

    def test_forged_scenes_and_releases(self):
        self.plan()
        with h5py.File(self.plans) as file:
            cup = file["plans"][PLAN]["scene/cup"]
            size, positions = cup.attrs["size"], cup["position"][()]
        def bead(plan):  # above the cup, farther from the hand than from its rim
            scene, half = plan["scene"], len(positions) // 2
            scene.copy("table", "bead")
            scene["bead"].attrs["shape"], scene["bead"].attrs["size"] = np.bytes_("sphere"), np.array([0.004])
            scene["bead/position"][0] = positions[half] + upwards(scene["cup/orientation"][half]) * size[1] / 2
            scene["bead/orientation"][0] = [1, 0, 0, 0]
        def released_in_the_air(plan):
            names, ends = list(plan["phases/name"].asstr()), plan["phases/end_s"][()]
            last = max(k for k, name in enumerate(names) if name == "transport")
            ends[last] -= 0.5
            plan["phases/end_s"][...] = ends
            plan["scene/cup"].attrs["release_s"] = ends[last]
        def put_down_too_deep(plan):
            plan["scene/table/position"][0] += 4e-3 * upwards(plan["scene/table/orientation"][0])
        for change, found in ((bead, ("object_collision", "cup/bead")),
                              (released_in_the_air, ("release", "cup")),
                              (put_down_too_deep, ("object_collision", "cup/table"))):
            for causes in self.forged(change):
                self.assertIn(found, causes)

    def test_an_object_in_the_cups_way(self):
        scene = self.folder / "bead.yaml"
        scene.write_text("objects: [{name: bead, shape: sphere, size: [0.008], "
                         "position: [-0.0270, -0.0666, 0.4832], avoid_in_mapping: false}]\n")
        self.plan("--set", f"scene.file={scene}")
        with h5py.File(self.plans) as file:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["reason"]), "goal_in_collision")
            self.assertRegex(text(plan.attrs["detail"]), "^delivered until the end of grasp, .*: cup is .* mm too close to bead, ")
            self.assertIn("scene.target.carried_by=palm", text(plan.attrs["detail"]))
        self.assertEqual(self.violations(), ([], []))

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
