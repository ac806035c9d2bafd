"""The study of tests/variants, in its quick form, and what it consists of: variants of a recording show
the same motion, and a plan's branch is the one that is stored with it."""
import subprocess
import sys

import h5py
import numpy as np
from support import MORPHE, QUICK, SOURCE, CommandCase, json, main, shared_run

sys.path += [str(SOURCE / "tests/variants"), str(SOURCE / "tests/audit")]
from compare import compare  # noqa: E402
from planned import Planned  # noqa: E402
from take import Take  # noqa: E402
from variant_list import VARIANTS, cubic, mirrored_name, variant_of  # noqa: E402
from verify_branches import branch_of  # noqa: E402
from verify_geometry import Robot  # noqa: E402

MOST_APART_MM = {"renamed": 0, "last_digit": 1.01e-6, "noisy": 1.01e-3}


def reach():
    time = np.linspace(0, 1, 101)[:, None, None]
    places = np.array([[0, 0, 0], [30, 0, 0], [0, 40, 10]], float)
    return Take(["RHAN1", "RFTP", "STRN"], places + time**2 * [50, 200, 30])


class Variants(CommandCase):
    def test_they_show_the_same_motion(self):
        take = reach()
        for name, most in MOST_APART_MM.items():
            apart = np.abs(variant_of(take, name, 1).position - take.position).max()
            self.assertLessEqual(apart, most, name)
            self.assertEqual(apart > 0, most > 0, name)
        lengths = [np.linalg.norm(np.diff(one.position, axis=1), axis=2)
                   for one in (take, variant_of(take, "moved", 1), variant_of(take, "mirrored", 1))]
        np.testing.assert_allclose(lengths[0], lengths[1])
        np.testing.assert_allclose(lengths[0], lengths[2])
        faster = variant_of(take, "resampled", 1)
        self.assertEqual((faster.rate, len(faster.position)), (120, 121))
        np.testing.assert_allclose(faster.at("RFTP")[60], take.at("RFTP")[50], atol=1e-9)
        np.testing.assert_allclose(faster.at("RFTP")[61, 1], 200 * (61 / 120)**2, atol=1e-9)

    def test_a_gap_stays_a_gap(self):
        values = np.array([0., 1, np.nan, 9, 16])
        np.testing.assert_array_equal(np.isnan(cubic(values, np.array([0.5, 1, 1.5, 2.5, 3, 3.5]))),
                                      [False, False, True, True, False, False])

    def test_labels_change_sides(self):
        for name, other in (("RFTP", "LFTP"), ("LUAR1", "RUAR1"), ("right_index_tip", "left_index_tip"),
                            ("STRN", "STRN"), ("R", "R"), ("Lamp", "Lamp")):
            self.assertEqual(mirrored_name(name), other)
        for name in VARIANTS:
            self.assertEqual(len(set(variant_of(reach(), name, 1).names)), 3)


class Branches(CommandCase):
    @classmethod
    def setUpClass(cls):
        cls.plans = shared_run(SOURCE / "configs/pipelines/pa10_dlr_hit2.yaml", *QUICK, dataset="two recordings") / "out/plans.h5"

    def each_plan(self):
        with h5py.File(self.plans) as file:
            robot = Robot(file["robot"])
            for movements in file["plans"].values():
                for plan in movements.values():
                    yield robot, plan

    def test_the_stored_one_is_that_of_the_trajectory(self):
        for robot, plan in self.each_plan():
            driven = plan["trajectory"]
            branch = branch_of(robot, driven["position"][()], driven["demonstration_time"][()])
            self.assertEqual(plan.attrs["branch"], branch.number)
            self.assertEqual(list(plan["branch_words"].asstr()[()]), branch.words())
            self.assertEqual(len(branch.words()), 3)

    def test_run_and_explain_state_it(self):
        listed = self.succeeds("list", self.plans).stdout
        for robot, plan in self.each_plan():
            words = ", ".join(plan["branch_words"].asstr()[()])
            self.assertIn(words, listed)
            explained = self.succeeds("explain", self.plans, plan.name.removeprefix("/plans/")).stdout
            self.assertIn(f"  branch        {words}", explained)

    def test_plans_of_two_branches_differ(self):
        robot, plan = next(self.each_plan())
        time, q = np.arange(2.0), np.tile(0.3 * np.ones(len(robot.joints)), (2, 1))
        flipped = q + np.pi * np.eye(len(robot.joints))[[4, 4]] + np.pi * np.eye(len(robot.joints))[[6, 6]]
        flipped[:, 5] *= -1
        def planned(joints):
            return Planned("executable", branch_of(robot, joints, time), None, (time, joints), (time, joints), 1.0, 1.0, robot)
        names = dict(recording="reach", movement=0, robot="pa10", variant="noisy")
        same = compare(planned(q), planned(q + 0.04), **names)
        self.assertTrue(same.same_branch and same.same_joints() and same.same_status)
        other = compare(planned(flipped), planned(q), **names)
        self.assertEqual((other.same_branch, other.same_joints()), (False, False))
        self.assertAlmostEqual(other.joints_rad, np.pi)
        self.assertLess(other.palm_deg, 1e-3)  # a flip leaves the palm
        self.assertLess(other.elbow_mm, 1e-6)


class Study(CommandCase):
    def run_study(self, *arguments):
        return subprocess.run([sys.executable, "-B", SOURCE / "tests/variants/variants.py", MORPHE, *map(str, arguments)],
                              capture_output=True, text=True)

    def test_the_last_digit_and_the_place_change_nothing(self):
        file = self.folder / "variants.json"
        result = self.run_study("--quick", "--json", file, "--require", 1)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        document = json.loads(file.read_text())
        self.assertEqual({row["variant"] for row in document["differences"]}, {"last_digit", "moved"})
        for row in document["differences"]:
            self.assertEqual((row["status"], row["branch"]), ("executable", row["original_branch"]))
            self.assertLess(row["joints_rad"], 0.05)
        (name, plans), = document["originals"]["pa10_dlr_hit2"].items()
        self.assertEqual((name, plans[0]["stored"][0]), ("ADL001DR2", plans[0]["number"]))

    def test_no_such_recording(self):
        result = self.run_study("--recordings", "somebody")
        self.assertEqual((result.returncode, "no recording or variant of these names" in result.stderr), (1, True))


if __name__ == "__main__":
    main()
