"""`morphe verify` and tests/verify_plans.py accept what `run` wrote, and find every fault that is
put into a copy of it. Takes 15 s of processor time: two programs judge two dozen plans."""
import shutil

import h5py
import numpy as np

import formats
from support import (QUICK, REFERENCE, SOURCE, CommandCase, add_copy, json, main, morphe, python_verify,
                     shared_run, write_two_recordings)

PLAN = "ADL001DR2/000"
COARSE = ("--set", "retime.sample_rate_hz=50")  # not 500: a plan is judged in a fraction of the time
KEYS = ["plan", "sample", "time_s", "cause", "subject", "value", "limit"]


def setUpModule():
    global PLANS
    PLANS = shared_run(REFERENCE, *QUICK, *COARSE, dataset="two recordings") / "out/plans.h5"


def json_verify(file):
    return morphe("verify", file, "--json")


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
                                   "--dataset", dataset, "--out", out, *QUICK, *COARSE)
            self.assertGreater(summary["executable"], 0, config)
            for result in (morphe("verify", out / "plans.h5", "--json"), python_verify(out / "plans.h5")):
                self.assertEqual(json.loads(result.stdout)["violations"], [])


class Damaged(CommandCase):
    """Each damage changes one thing of one plan, and returns the cause and the subject that both programs
    must report, at one of some samples, and what else is asked of the rows of `morphe verify`. All stand
    in one file, beside the plans as they were, of which nothing may be said."""

    def setUp(self):
        super().setUp()
        self.copy = self.folder / "plans.h5"
        shutil.copy(PLANS, self.copy)

    def test_every_damage_is_found(self):
        damages = {name: damage for name, damage in vars(Damages).items() if not name.startswith("_")}
        with h5py.File(self.copy, "r+") as file:
            wanted = {name: damage(self, file, add_copy(file, PLAN, name)) for name, damage in damages.items()}
        own, other = (self.by_plan(program(self.copy), keys) for program, keys in
                      ((json_verify, [*KEYS, "unit"]), (python_verify, KEYS)))
        self.assertEqual((set(own), set(other)), (set(wanted), set(wanted)))
        text = morphe("verify", self.copy)
        self.assertEqual(text.returncode, 1)
        for name, (cause, subject, *more) in wanted.items():
            with self.subTest(name):
                rows, _ = (self.of(found[name], cause, subject, *more[:1]) for found in (own, other))
                lines = [line for line in text.stdout.splitlines() if line.startswith(f"{name}/000: ")]
                self.assertTrue(lines, text.stdout)
                self.assertIn(cause, "\n".join(lines))
                for judge in more[1:]:
                    judge(rows)

    def by_plan(self, result, keys):
        """The violations of every plan: {demonstration: rows}."""
        self.assertEqual(result.returncode, 1, result.stdout[:500] + result.stderr)
        found = {}
        for row in json.loads(result.stdout)["violations"]:
            self.assertEqual(sorted(row), sorted(keys))
            demonstration, movement = row["plan"].split("/")
            self.assertEqual(movement, "000")
            found.setdefault(demonstration, []).append(row)
        return found

    def of(self, violations, cause, subject, samples=None):
        """What is said of this cause and subject."""
        rows = [row for row in violations if row["cause"] == cause and subject in row["subject"]]
        self.assertTrue(rows, violations)
        if samples is not None:
            self.assertTrue([row for row in rows if row["sample"] in samples], rows)
        return rows

    def test_every_figure_of_the_certificate_is_recomputed(self):
        # What lies in the mapping's config, the posture, is not repeated from the file alone.
        changed = {"by_a_thousandth": set(), "by_a_hair": set()}
        with h5py.File(self.copy, "r+") as file:
            for (name, names), change in zip(changed.items(), (1e-3, 2e-8)):
                certificate = add_copy(file, PLAN, name)["certificate"].attrs
                for figure in set(formats.CERTIFICATE) - {"repaired"}:
                    # To 0.1 mm the clearance, to 1e-9 the rest; jerk also to what rounding makes of it.
                    if np.isfinite(certificate[figure]) and (
                            change > 1e-6 or figure not in ("clearance", "jerk_ratio")):
                        certificate[figure] += 2 * change * max(1, abs(certificate[figure]))
                        names.add(figure)
                certificate["repaired"] = np.uint8(1 - certificate["repaired"])
                self.assertGreater(len(names), 14)
        own, other = (json.loads(program(self.copy).stdout)["violations"] for program in (json_verify, python_verify))
        self.assertEqual({row["plan"] for row in own}, {f"{name}/000" for name in changed})
        for violations, judged in ((own, changed), (other, ["by_a_thousandth"])):
            for name in judged:
                rows = [row for row in violations if row["plan"] == f"{name}/000"]
                self.assertEqual({row["cause"] for row in rows}, {"certificate"})
                self.assertEqual({row["subject"] for row in rows} - {"repaired"}, changed[name])

    def test_a_file_of_an_earlier_version_is_read_without_the_figures_that_it_lacks(self):
        lacking = {f"{name}_error_{end}" for name in ("forearm", "swivel", "palm") for end in ("mean", "max")}
        lacking.add("wrist_speed_correlation")
        with h5py.File(self.copy, "r+") as file:
            for figure in lacking:
                del file["plans"][PLAN]["certificate"].attrs[figure]
        self.succeeds("list", self.copy)
        self.assertNotIn("swivel angle", self.succeeds("explain", self.copy, PLAN).stdout)
        rows = json.loads(json_verify(self.copy).stdout)["violations"]
        self.assertEqual({(row["cause"], row["subject"]) for row in rows},
                         {("certificate", name) for name in lacking} |
                         {("structure", f"certificate/@{name} is missing") for name in lacking})

    def test_an_infeasible_plan_with_a_trajectory(self):
        with h5py.File(self.copy, "r+") as file:
            plan = file["plans"][PLAN]
            plan.attrs["status"], plan.attrs["reason"] = np.bytes_("infeasible"), np.bytes_("no_goal")
        self.refuses(morphe("verify", self.copy), f"{self.copy}:/plans/{PLAN}/trajectory")
        self.assertEqual(python_verify(self.copy).returncode, 1)


class Damages:
    def a_joint_beyond_its_limit(self, file, plan):
        joint, sample = 3, 50
        limit, name = file["robot/upper"][joint], file["robot/joint_names"].asstr()[joint]
        plan["trajectory/position"][sample, joint] = limit + 0.01

        def judge(rows):
            worst = max(rows, key=lambda row: row["value"])
            self.assertGreaterEqual(worst["value"], limit + 0.01 - 1e-9)
            self.assertAlmostEqual(worst["limit"], limit)
        return "position", name, range(sample - 1, sample + 2), judge

    def a_plan_out_of_reach_that_is_called_executable(self, file, plan):
        plan["goals/reachable"][...] = 0
        plan.attrs["tracking_tolerance"] = plan.attrs["tracking_tolerance_grasp"] = 10.0  # whatever it allows

        def judge(rows):
            share, = rows
            self.assertEqual((share["value"], share["limit"]), (1, 0.5))
        return "status", "max_unreachable_share", None, judge

    def a_tip_too_far_away_for_what_it_is_called(self, file, plan):
        plan.attrs["max_tip_error"] = largest = 0.5 * plan["certificate"].attrs["tip_error_max"]

        def judge(rows):
            tip, = rows
            self.assertAlmostEqual(tip["value"], 2 * largest)
        return "status", "max_tip_error", None, judge

    def an_executable_plan_that_is_called_approximate(self, file, plan):
        plan.attrs["status"] = np.bytes_("approximate")
        return "status", "approximate"

    def a_joint_below_its_limit(self, file, plan):
        limit, name = file["robot/lower"][0], file["robot/joint_names"].asstr()[0]
        plan["trajectory/position"][12, 0] = limit - 0.01
        return "position", name, range(11, 14)

    def a_velocity_raised(self, file, plan):
        joint, sample = 5, 75
        limit, name = file["robot/velocity"][joint], file["robot/joint_names"].asstr()[joint]
        plan["trajectory/velocity"][sample, joint] = 1.5 * limit

        def judge(rows):
            worst = max(rows, key=lambda row: row["value"])
            self.assertGreaterEqual(worst["value"], 1.5 * limit - 1e-9)
            self.assertAlmostEqual(worst["limit"], limit)
        return "velocity", name, range(sample - 1, sample + 2), judge

    def an_end_that_is_not_at_rest(self, file, plan):
        name = file["robot/joint_names"].asstr()[1]
        plan["trajectory/velocity"][0, 1] = 1e-3
        return "rest", name, [0]

    def a_clock_that_runs_back(self, file, plan):
        times = plan["trajectory/time"][()]
        plan["trajectory/time"][25] = times[23]
        return "time", "time", range(23, 27)

    def a_number_that_is_none(self, file, plan):
        plan["trajectory/position"][10, 2] = np.nan
        return "finite", "position"

    def the_table_raised_into_the_hand(self, file, plan):
        index = list(file["robot/tips/name"].asstr()).index("index_tip")
        hand = plan["goals/tip_position"][len(plan["goals/time"]) // 2, index]
        plan["scene/table/position"][0] = hand
        return "object_collision", "/table", None, lambda rows: self.assertLess(min(row["value"] for row in rows), 0)

    def the_cup_moved_to_where_the_hand_starts(self, file, plan):
        index = list(file["robot/tips/name"].asstr()).index("index_tip")
        plan["scene/cup/position"][0] = plan["goals/tip_position"][0, index]
        return "object_collision", "/cup", range(25)  # up to the preshape

    def an_object_added_in_the_path(self, file, plan):
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
        return "object_collision", "/ball", None, lambda rows: self.assertTrue(
            [row for row in rows if abs(row["sample"] - at) <= 5], (at, rows))

    def a_goal_moved_by_10_mm_at_the_grasp(self, file, plan):
        names = list(file["robot/tips/name"].asstr())
        sample = plan["grasp"].attrs["sample"]
        when = plan["trajectory/demonstration_time"][sample]
        frame = int(np.abs(plan["goals/time"][()] - when).argmin())
        plan["goals/tip_position"][frame, names.index("thumb_tip"), 2] += 0.010
        tolerance = plan.attrs["tracking_tolerance_grasp"]

        def judge(rows):
            self.assertTrue([row for row in rows if abs(row["sample"] - sample) <= 5], (sample, rows))
            self.assertEqual({row["limit"] for row in rows}, {tolerance})
        return "tracking", "thumb_tip", None, judge

    def a_certificate_that_promises_too_much(self, file, plan):
        plan["certificate"].attrs["clearance"] = 0.5
        return "certificate", "clearance", [-1]


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
