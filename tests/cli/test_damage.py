"""The studies of tests/audit: damaged recordings are questioned, unchanged ones are not."""
import json
import subprocess
import sys
import types

import h5py
import numpy as np
from support import MORPHE, RECORDINGS, SOURCE, CommandCase, main

sys.path.append(str(SOURCE / "tests/audit"))
from answers import Answer, Flag, PlannedMovement, compare_plans  # noqa: E402
from damage_list import Damage, all_damages, undecidable_table  # noqa: E402
from damages import Moments, Patient, exchange, lose_rows, spike  # noqa: E402
from synthetic_takes import NOISE_MM, TrueMotion, as_clusters, synthesize  # noqa: E402
from take import Roles, Take  # noqa: E402
from verdicts import Case, Study  # noqa: E402


def reach():
    """Four markers on a hand that moves by 0.2 m in a second, with thumb and index."""
    names = ["RHAN1", "RHAN2", "RHAN3", "RHAN4", "RTHUM", "RFTP"]
    places = np.array([[0, 0, 0], [30, 0, 0], [0, 40, 0], [20, 30, 10], [-20, 90, -10], [20, 110, -20]], float)
    motion = np.linspace(0, 200, 101)[:, None, None] * [0, 1, 0]
    return Take(names, places + motion)


def patient_of(take):
    return Patient(take.copy(), Roles(take), Moments(10, 40, 70, 90), np.random.default_rng(1))


def answer_of(shift_m=0.0, joint_rad=0.0, flags=(), detail="", limits=(0.1, 0.9)):
    time = np.linspace(0.1, 0.9, 81)
    tips = np.tile(time[:, None, None], (1, 2, 3)) + [shift_m, 0, 0]
    movement = PlannedMovement("executable", detail, ["reach", "grasp"], 0.7, limits, time,
                               np.tile(time[:, None], (1, 3)) + joint_rad, tips, np.array([True, True]))
    return Answer(flags=list(flags), movements=[movement])


def flag(code, begin_s, end_s):
    return Flag(code, "flagged", begin_s, end_s, "RFTP", code)


class Verdicts(CommandCase):
    def verdict(self, answer, damage=Damage("one", lambda p: None, ("spike",), told="hidden"), rows=(40, 40)):
        recording = types.SimpleNamespace(name="reach", config=None)
        study = Study(MORPHE, self.folder)
        study.healthy = lambda *_: answer_of()
        study.ask = lambda *_: answer
        case = Case(recording, damage, Take([], np.zeros((101, 0, 3)), damaged=rows), self.folder)
        return (study.stated(case, answer, answer_of()) or study.unstated(case, answer, answer_of())).verdict

    def test_a_plan_that_differs_without_a_word_is_silent(self):
        self.assertEqual(self.verdict(answer_of()), "harmless")
        self.assertEqual(self.verdict(answer_of(shift_m=0.0009)), "harmless")
        self.assertEqual(self.verdict(answer_of(shift_m=0.0011)), "SILENT")
        self.assertEqual(self.verdict(answer_of(joint_rad=0.051)), "SILENT")
        self.assertEqual(self.verdict(answer_of(limits=(0.1, 1.1))), "SILENT")
        self.assertEqual(self.verdict(Answer()), "SILENT")

    def test_what_no_file_can_tell_is_undecidable_unless_a_flag_names_it(self):
        tilt = Damage("tilt", lambda p: None, ("vertical",), undecidable="people lean")
        self.assertEqual(self.verdict(answer_of(shift_m=0.1), tilt), "undecidable")
        self.assertEqual(self.verdict(answer_of(shift_m=0.1, flags=[flag("vertical", np.nan, np.nan)]), tilt), "noticed")

    def test_the_page_has_the_studys_tables(self):
        page = (SOURCE / "docs/audit.md").read_text()
        self.assertIn(undecidable_table() + "<!-- until here -->", page)
        table = page.split("<!-- study: ")[1].split("<!-- until here -->")[0].splitlines()[3:]
        self.assertGreaterEqual(len(table), 5)
        for row in table:
            counts = [int(cell) for cell in row.strip("|").split("|")[1:]]
            self.assertTrue(80 <= sum(counts) <= len(all_damages()), row)

    def test_only_a_flag_that_fits_in_code_and_time_counts(self):
        def differing(*flags):
            return answer_of(shift_m=0.1, flags=flags)
        self.assertEqual(self.verdict(differing(flag("spike", 0.4, 0.4))), "noticed")
        self.assertEqual(self.verdict(differing(flag("spike", np.nan, np.nan))), "noticed")
        self.assertEqual(self.verdict(differing(flag("spike", 0.8, 0.9))), "SILENT")
        self.assertEqual(self.verdict(differing(flag("jitter", 0.4, 0.4))), "SILENT")
        self.assertEqual(self.verdict(answer_of(shift_m=0.1, detail="RFTP: hidden in 3 frames")), "told")

    def test_a_question_counts_if_its_answer_removes_the_damage(self):
        unit = Damage("unit", lambda p: None, asks=("unit",))
        self.assertEqual(self.verdict(Answer(2, "unit?", {"unit"}), unit), "asked")
        self.assertEqual(self.verdict(Answer(2, "axes?", {"axes"}), unit), "SILENT")

    def test_what_is_mended_wrongly_is_wrong(self):
        mended = Flag("spike", "mended", 0.4, 0.4, "RFTP", "mended")
        self.assertEqual(self.verdict(answer_of(flags=[mended])), "mended")
        self.assertEqual(self.verdict(answer_of(shift_m=0.1, flags=[mended])), "WRONG")

    def test_two_plans_of_which_one_has_another_movement(self):
        self.assertIn("0 movements instead of 1", compare_plans(Answer(), answer_of())[0])


class Damages(CommandCase):
    def test_they_change_what_they_say(self):
        patient = patient_of(reach())
        exchange(patient, "RTHUM", "RFTP", slice(40, None))
        np.testing.assert_array_equal(patient.take.at("RTHUM")[40:], reach().at("RFTP")[40:])
        np.testing.assert_array_equal(patient.take.at("RTHUM")[:40], reach().at("RTHUM")[:40])
        self.assertEqual(patient.take.damaged, (40, 100))
        patient = patient_of(reach())
        spike(patient, "index", 200)
        moved = np.linalg.norm(patient.take.position - reach().position, axis=2)
        self.assertAlmostEqual(moved[40, 5], 200)
        self.assertEqual(np.count_nonzero(moved), 1)
        patient = patient_of(reach())
        lose_rows(patient, 20, renumbered=True)
        np.testing.assert_array_equal(patient.take.position[40], reach().position[60])
        self.assertEqual(patient.take.frame[-1], 81)

    def test_every_damage_has_a_name_of_its_own(self):
        names = [damage.name for damage in all_damages()]
        self.assertEqual(len(set(names)), len(names))
        self.assertGreater(len(names), 70)


class SyntheticTakes(CommandCase):
    def test_bones_are_rigid_and_the_static_trial_fits(self):
        synthesize(MORPHE, 1, 1, self.folder)
        with h5py.File(self.folder / "synthetic.h5") as made, h5py.File(self.folder / "synthetic.truth.h5") as truth:
            motion = TrueMotion(truth["demonstrations/synthetic_000000"],
                                made["demonstrations/synthetic_000000/calibration"])
        for segment in (0, 1):
            end = np.einsum("nji,nj->ni", motion.turns[segment], np.diff(motion.joints, axis=1)[:, segment])
            np.testing.assert_allclose(end, end[:1].repeat(len(end), axis=0), atol=1e-6)
            np.testing.assert_allclose(np.linalg.det(motion.turns[segment]), 1)
        take = as_clusters(motion, np.random.default_rng(1))
        for part, markers in Roles(take).clusters.items():
            apart = np.linalg.norm(take.at(markers[0]) - take.at(markers[1]), axis=1)
            self.assertLess(apart.std(), 3 * NOISE_MM, part)
            still = np.linalg.norm(take.static.at(markers[0]) - take.static.at(markers[1]), axis=1)
            self.assertAlmostEqual(apart.mean(), still.mean(), delta=1)


class Studies(CommandCase):
    def run_script(self, name, *arguments):
        return subprocess.run([sys.executable, "-B", SOURCE / "tests/audit" / name, MORPHE, *map(str, arguments)],
                              capture_output=True, text=True)

    def test_no_damage_is_silent(self):
        file = self.folder / "verdicts.json"
        result = self.run_script("damage.py", "--quick", "--json", file)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        verdicts = {one["damage"]: one["verdict"] for one in json.loads(file.read_text())}
        self.assertEqual(verdicts["exchange_digits_from"], "mended")
        self.assertEqual(verdicts["axes_about_vertical_90"], "harmless")
        self.assertEqual(verdicts["axes_mirrored_x"], "asked")

    def test_no_false_alarm(self):
        result = self.run_script("false_alarms.py", "--dataset", RECORDINGS / "recordings.yaml", "--synthetic", "2")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertEqual(result.stdout.count(" 0 with a false alarm"), 4)

    def test_no_such_recording(self):
        result = self.run_script("damage.py", "--recordings", "somebody")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no recording or damage of these names", result.stderr)


if __name__ == "__main__":
    main()
