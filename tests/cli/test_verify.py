"""`morphe verify` and tests/verify_plans.py accept what `run` wrote, and find every fault that is
put into a copy of it. MORPHE_SEARCH=small in the environment plans with a search that takes a second."""
import os
import shutil
import unittest
from pathlib import Path

import h5py
import numpy as np

import formats
from support import (QUICK, REFERENCE, SOURCE, CommandCase, json, main, morphe, python_verify,
                     temporary_folder, write_two_recordings)

SEARCH = {"small": QUICK, "whole": ()}[os.environ.get("MORPHE_SEARCH", "whole")]
PLAN = "ADL001DR2/000"
KEYS = ["plan", "sample", "time_s", "cause", "subject", "value", "limit"]


def setUpModule():
    global PLANS
    holder = temporary_folder()
    unittest.addModuleCleanup(holder.cleanup)
    folder = Path(holder.name).resolve()
    result = morphe("run", REFERENCE, "--dataset", write_two_recordings(folder), "--out",
                    folder / "out", *SEARCH)
    assert result.returncode == 0, result.stderr
    PLANS = folder / "out/plans.h5"


class Untouched(CommandCase):
    def test_is_accepted_by_both(self):
        for verdict in (self.json_of("verify", PLANS), json.loads(python_verify(PLANS).stdout)):
            self.assertEqual(verdict["executable"] + verdict["infeasible"], 2)
            self.assertEqual(verdict["violations"], [])
        self.assertIn(f"{verdict['executable']} executable", self.succeeds("verify", PLANS).stdout)


class OtherRecordings(CommandCase):
    """Certificates of other shipped demonstrations agree with both programs' own numbers."""

    def test_hands_that_five_tips_show_and_a_post_in_the_way(self):
        adroit = self.folder / "adroit.yaml"
        folder = SOURCE / "datasets/adroit-dapg"
        adroit.write_text("format: adroit-csv\nrecordings:\n"
                          + "".join(f"  - {{file: {folder}/door_demo_{n}.csv}}\n" for n in ("11", "12")))
        for config, dataset in (("adroit", adroit), ("obstacle", write_two_recordings(self.folder))):
            out = self.folder / config
            summary = self.json_of("run", SOURCE / f"configs/pipelines/pa10_dlr_hit2_{config}.yaml",
                                   "--dataset", dataset, "--out", out, *QUICK)
            self.assertGreater(summary["executable"], 0, config)
            for result in (morphe("verify", out / "plans.h5", "--json"), python_verify(out / "plans.h5")):
                self.assertEqual(json.loads(result.stdout)["violations"], [])


class Damaged(CommandCase):
    """Each test changes one thing of one plan. Both programs must exit with 1 and report it."""

    def setUp(self):
        super().setUp()
        self.copy = self.folder / "plans.h5"
        shutil.copy(PLANS, self.copy)

    def edited(self):
        file = h5py.File(self.copy, "r+")
        self.addCleanup(file.close)
        return file, file["plans"][PLAN]

    def found(self, file, cause, subject, samples=None):
        """Writes the edits, and returns what `morphe verify` says of this cause and subject."""
        file.close()
        own = morphe("verify", self.copy, "--json")
        other = python_verify(self.copy)
        for result, keys in ((own, [*KEYS, "unit"]), (other, KEYS)):
            self.assertEqual(result.returncode, 1, result.stdout[:500] + result.stderr)
            violations = json.loads(result.stdout)["violations"]
            self.assertEqual({row["plan"] for row in violations}, {PLAN})
            for row in violations:
                self.assertEqual(sorted(row), sorted(keys))
            rows = [row for row in violations
                    if row["cause"] == cause and subject in row["subject"]]
            self.assertTrue(rows, violations)
            if samples is not None:
                self.assertTrue([row for row in rows if row["sample"] in samples], rows)
        text = morphe("verify", self.copy)
        self.assertEqual(text.returncode, 1)
        self.assertIn(PLAN, text.stdout)
        self.assertIn(cause, text.stdout)
        return [row for row in json.loads(own.stdout)["violations"]
                if row["cause"] == cause and subject in row["subject"]]

    def test_a_joint_beyond_its_limit(self):
        file, plan = self.edited()
        joint, sample = 3, 200
        limit, name = file["robot/upper"][joint], file["robot/joint_names"].asstr()[joint]
        plan["trajectory/position"][sample, joint] = limit + 0.01
        worst = max(self.found(file, "position", name, range(sample - 1, sample + 2)),
                    key=lambda row: row["value"])
        self.assertGreaterEqual(worst["value"], limit + 0.01 - 1e-9)
        self.assertAlmostEqual(worst["limit"], limit)

    def test_a_plan_out_of_reach_that_is_called_executable(self):
        file, plan = self.edited()
        plan["goals/reachable"][...] = 0
        plan.attrs["tracking"] = plan.attrs["tracking_grasp"] = 10.0  # whatever it allows
        share, = self.found(file, "status", "out_of_reach_share")
        self.assertEqual((share["value"], share["limit"]), (1, 0.5))

    def test_a_tip_too_far_away_for_what_it_is_called(self):
        file, plan = self.edited()
        plan.attrs["farthest_tip"] = largest = 0.5 * plan["certificate"].attrs["position_error_max"]
        tip, = self.found(file, "status", "farthest_tip")
        self.assertAlmostEqual(tip["value"], 2 * largest)

    def test_an_executable_plan_that_is_called_approximate(self):
        file, plan = self.edited()
        plan.attrs["status"] = np.bytes_("approximate")
        self.found(file, "status", "approximate")

    def test_a_joint_below_its_limit(self):
        file, plan = self.edited()
        limit, name = file["robot/lower"][0], file["robot/joint_names"].asstr()[0]
        plan["trajectory/position"][50, 0] = limit - 0.01
        self.found(file, "position", name, range(49, 52))

    def test_a_velocity_raised(self):
        file, plan = self.edited()
        joint, sample = 5, 300
        limit, name = file["robot/velocity"][joint], file["robot/joint_names"].asstr()[joint]
        plan["trajectory/velocity"][sample, joint] = 1.5 * limit
        worst = max(self.found(file, "velocity", name, range(sample - 1, sample + 2)),
                    key=lambda row: row["value"])
        self.assertGreaterEqual(worst["value"], 1.5 * limit - 1e-9)
        self.assertAlmostEqual(worst["limit"], limit)

    def test_an_end_that_is_not_at_rest(self):
        file, plan = self.edited()
        name = file["robot/joint_names"].asstr()[1]
        plan["trajectory/velocity"][0, 1] = 1e-3
        self.found(file, "rest", name, [0])

    def test_a_clock_that_runs_back(self):
        file, plan = self.edited()
        times = plan["trajectory/time"][()]
        plan["trajectory/time"][100] = times[98]
        self.found(file, "time", "time", range(98, 102))

    def test_a_number_that_is_none(self):
        file, plan = self.edited()
        plan["trajectory/position"][10, 2] = np.nan
        self.found(file, "finite", "position")

    def test_the_table_raised_into_the_hand(self):
        file, plan = self.edited()
        index = list(file["robot/tips/name"].asstr()).index("index_tip")
        hand = plan["goals/tip_position"][len(plan["goals/time"]) // 2, index]
        plan["scene/table/position"][0] = hand
        rows = self.found(file, "object", "/table")
        self.assertLess(min(row["value"] for row in rows), 0)

    def test_the_cup_moved_to_where_the_hand_starts(self):
        file, plan = self.edited()
        index = list(file["robot/tips/name"].asstr()).index("index_tip")
        plan["scene/cup/position"][0] = plan["goals/tip_position"][0, index]
        self.found(file, "object", "/cup", range(100))  # up to the preshape

    def test_an_object_added_in_the_path(self):
        file, plan = self.edited()
        tip = list(file["robot/tips/name"].asstr()).index("index_tip")
        frame = len(plan["goals/time"]) // 3
        ball = plan["scene"].create_group("ball", track_order=True)
        ball.attrs["shape"] = np.bytes_("sphere")
        ball.attrs["size"] = np.array([0.02])
        for name, rows, unit, of in (("time", [0.0], "s", None),
                                     ("position", [plan["goals/tip_position"][frame, tip]], "m", "base"),
                                     ("orientation", [[1.0, 0, 0, 0]], "1", "base")):
            data = ball.create_dataset(name, data=np.array(rows))
            data.attrs["unit"] = np.bytes_(unit)
            if of:
                data.attrs["frame"] = np.bytes_(of)
        when = plan["goals/time"][frame]
        at = int(np.abs(plan["trajectory/demonstration_time"][()] - when).argmin())
        rows = self.found(file, "object", "/ball")
        self.assertTrue([row for row in rows if abs(row["sample"] - at) <= 20], (at, rows))

    def test_a_goal_moved_by_10_mm_at_the_grasp(self):
        file, plan = self.edited()
        names = list(file["robot/tips/name"].asstr())
        sample = plan["grasp"].attrs["sample"]
        when = plan["trajectory/demonstration_time"][sample]
        frame = int(np.abs(plan["goals/time"][()] - when).argmin())
        plan["goals/tip_position"][frame, names.index("thumb_tip"), 2] += 0.010
        rows = self.found(file, "tracking", "thumb_tip")
        self.assertTrue([row for row in rows if abs(row["sample"] - sample) <= 20], (sample, rows))
        self.assertEqual({row["limit"] for row in rows}, {plan_tolerance()})

    def test_a_certificate_that_promises_too_much(self):
        file, plan = self.edited()
        plan["certificate"].attrs["clearance"] = 0.5
        self.found(file, "certificate", "clearance", [-1])

    def test_every_figure_of_the_certificate_is_recomputed(self):
        # What lies in the mapping's config, the posture, is not repeated from the file alone.
        for change, programs in ((1e-3, (morphe, lambda _, file, __: python_verify(file))),
                                 (2e-8, (morphe,))):
            shutil.copy(PLANS, self.copy)
            file, plan = self.edited()
            certificate, changed = plan["certificate"].attrs, set()
            for name in set(formats.CERTIFICATE) - {"repaired"}:
                # To 0.1 mm the clearance, to 1e-9 the rest; jerk also to what rounding makes of it.
                if np.isfinite(certificate[name]) and (change > 1e-6 or name not in ("clearance", "jerk_ratio")):
                    certificate[name] += 2 * change * max(1, abs(certificate[name]))
                    changed.add(name)
            certificate["repaired"] = np.uint8(1 - certificate["repaired"])
            file.close()
            self.assertGreater(len(changed), 14)
            for program in programs:
                rows = json.loads(program("verify", self.copy, "--json").stdout)["violations"]
                self.assertEqual({row["cause"] for row in rows}, {"certificate"})
                self.assertEqual({row["subject"] for row in rows} - {"repaired"}, changed)

    def test_an_infeasible_plan_with_a_trajectory(self):
        file, plan = self.edited()
        plan.attrs["status"], plan.attrs["reason"] = np.bytes_("infeasible"), np.bytes_("no_goal")
        file.close()
        self.refuses(morphe("verify", self.copy), f"{self.copy}:/plans/{PLAN}/trajectory")
        self.assertEqual(python_verify(self.copy).returncode, 1)


def plan_tolerance():
    with h5py.File(PLANS) as file:
        return file["plans"][PLAN].attrs["tracking_grasp"]


class Unreadable(CommandCase):
    def test_a_missing_file(self):
        missing = self.folder / "missing.h5"
        self.refuses(morphe("verify", missing), missing)

    def test_a_folder(self):
        self.refuses(morphe("verify", self.folder), self.folder)

    def test_a_text_file(self):
        file = self.folder / "plans.h5"
        file.write_text("executable\n")
        self.refuses(morphe("verify", file), file)

    def test_an_empty_file(self):
        file = self.folder / "plans.h5"
        file.touch()
        self.refuses(morphe("verify", file), file)

    def test_a_truncated_file(self):
        whole = PLANS.read_bytes()
        file = self.folder / "plans.h5"
        for share in (0.01, 0.5, 0.99):
            with self.subTest(share):
                file.write_bytes(whole[:int(share * len(whole))])
                self.refuses(morphe("verify", file), file)

    def test_a_file_of_another_kind(self):
        other = PLANS.with_name("demonstrations.h5")
        self.refuses(morphe("verify", other), f"{other}:/", "morphe-demonstrations")

    def test_a_dataset_taken_away_or_damaged(self):
        file = self.folder / "plans.h5"
        where = f"/plans/{PLAN}/trajectory/position"
        shutil.copy(PLANS, file)
        with h5py.File(file, "r+") as plans:
            chunk = plans[where].id.get_chunk_info(0)
        damaged = bytearray(file.read_bytes())
        damaged[chunk.byte_offset + chunk.size // 2] ^= 0xFF
        file.write_bytes(damaged)
        self.refuses(morphe("verify", file), f"{file}:{where}")
        shutil.copy(PLANS, file)
        with h5py.File(file, "r+") as plans:
            del plans[where]
        self.refuses(morphe("verify", file), f"{file}:{where}")


if __name__ == "__main__":
    main()
