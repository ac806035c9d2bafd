"""`morphe verify --dataset`: what plans took from their recordings is compared with these, and `verify` says
what it compared. The lies that only this finds are kinds of tests/forged_carried.py (test_forged_plans.py)."""
import shutil

import h5py
import numpy as np

from support import (ONE_RECORDING, QUICK, REFERENCE, CommandCase, json, main, morphe, shared_run, write_recordings)


def setUpModule():
    global RUN
    RUN = shared_run(REFERENCE, *QUICK, dataset="two recordings") / "out"


class VerifyRecordings(CommandCase):
    def verdict(self, plans, dataset):
        result = morphe("verify", plans, "--dataset", dataset, "--json")
        self.assertIn(result.returncode, (0, 1), result.stderr)
        return json.loads(result.stdout)

    def causes(self, plans, dataset):
        return [(row["plan"], row["cause"], row["subject"]) for row in self.verdict(plans, dataset)["violations"]]

    def copy(self, change):
        copy = self.folder / "plans.h5"
        shutil.copy(RUN / "plans.h5", copy)
        with h5py.File(copy, "r+") as file:
            change(file)
        return copy

    def test_honest_plans_and_what_was_compared(self):
        compared = {"file": True, "curves": True, "inputs": True, "recordings": True}
        self.assertEqual(self.verdict(RUN, RUN / "demonstrations.h5")["violations"], [])
        self.assertEqual(self.verdict(RUN, RUN / "demonstrations.h5")["looked_at"], compared)
        self.assertEqual(self.json_of("verify", RUN)["looked_at"], {**compared, "recordings": False})
        without = morphe("verify", RUN).stdout
        self.assertIn("  compared      the file with its format; robot, config and plans with /inputs\n", without)
        self.assertIn("  not compared  plans with their recordings (--dataset F.h5)\n", without)
        within = morphe("verify", RUN, "--dataset", RUN / "demonstrations.h5").stdout
        self.assertIn("; plans with their recordings\n", within)
        self.assertNotIn("not compared", within)

    def test_honest_plans_that_touch_and_carry_their_target_or_have_none(self):
        for settings in (("grasp.touch_distance=0.010", "segment.plan_until=return"), ("segment.plan_until=transport",),
                         ("map.base_offset.limit=0.05",), ("check.tracking_tolerance=0.0001", "segment.partial=never")):
            words = [word for setting in settings for word in ("--set", setting)]
            run = shared_run(REFERENCE, *QUICK, "--set", "retime.sample_rate_hz=50", *words, dataset="two recordings") / "out"
            self.assertEqual(self.causes(run, run / "demonstrations.h5"), [], settings)

    def test_another_dataset(self):
        self.succeeds("import", write_recordings(self.folder, ONE_RECORDING), "--out", self.folder / "one.h5")
        self.assertEqual(self.causes(RUN, self.folder / "one.h5"),
                         [("", "recording", "dataset_sha256"), ("ADL001AR1", "recording", "is not in the dataset")])
        result = morphe("verify", RUN, "--dataset", self.folder / "none.h5")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("none.h5", result.stderr)

    def test_a_copy_and_an_object_of_its_own(self):
        copy = self.copy(lambda file: file.copy("plans/ADL001DR2", "plans/P99_reach"))
        self.assertEqual(self.causes(copy, RUN / "demonstrations.h5"),
                         [("P99_reach", "recording", "is not in the dataset")])
        def lower(file):
            plan = file["plans/ADL001DR2/000"]
            plan["scene/table/position"][0] += [0, 0, -0.01]
            plan["scene/table"].attrs["pose_origin"] = np.bytes_("recorded")
        found = self.causes(self.copy(lower), RUN / "demonstrations.h5")
        for subject in ("scene/table/position", "scene/table/pose_origin"):
            self.assertIn(("ADL001DR2/000", "recording", subject), found)

    def test_a_movement_left_out(self):
        def drop(file):
            del file["plans/ADL001AR1/000"]
            file.copy("plans/ADL001DR2/000", "plans/ADL001AR1/000")
        found = self.causes(self.copy(drop), RUN / "demonstrations.h5")
        self.assertTrue([row for row in found if row[0].startswith("ADL001AR1") and row[1] == "recording"], found)


if __name__ == "__main__":
    main()
