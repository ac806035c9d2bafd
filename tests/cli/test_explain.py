"""`morphe explain`: an infeasible movement's story, and what it advises holds when it is tried."""
import json
import shutil

import h5py
import support
from support import MORPHE, SOURCE, morphe  # noqa: F401

# A cup that stands too far away for the robot: the person reaches it, the robot does not.
AWAY = ("--set", "placement.shoulder_offset=[0.1, -0.55, 0.3]")


class Explain(support.CommandCase):
    @classmethod
    def setUpClass(cls):
        holder = support.temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.shared = support.Path(holder.name).resolve()
        manifest = support.write_two_recordings(cls.shared)
        cls.run_folder = cls.shared / "away"
        result = morphe("run", support.REFERENCE, "--dataset", manifest, "--out", cls.run_folder,
                        *support.QUICK, *AWAY)
        assert result.returncode == 0, result.stderr
        cls.table = result.stdout

    def test_the_table_says_what_to_try(self):
        self.assertIn("infeasible", self.table)
        self.assertIn("try: ", self.table)

    def test_a_story_has_every_step(self):
        said = self.succeeds("explain", self.run_folder).stdout
        for step in ("segmentation", "mapping", "problems", "repair", "remaining", "time law", "certificate", "took", "try"):
            self.assertIn(f"\n  {step} ", said)
        self.assertIn("re-solve, low clearance weights", said)

    def test_a_comparison_with_an_estimated_arm_is_marked(self):
        file = self.folder / "plans.h5"
        shutil.copy(self.run_folder / "plans.h5", file)
        with h5py.File(file, "r+") as h5:
            names = [f"{name}/{movement}" for name in h5["plans"] for movement in h5["plans"][name]]
            support.estimate_arm(h5["plans"][names[0]])
            self.assertGreater(len(names), 1)
        for name, marked in ((names[0], True), (names[1], False)):
            story = self.succeeds("explain", file, name).stdout
            self.assertRegex(story, r"humanlikeness A ~\d\.\d{4} m\^2 from an estimated shoulder and elbow"
                             if marked else r"humanlikeness A \d\.\d{4} m\^2[,\n]")
            self.assertEqual("~" in story, marked, story)

    def test_the_posture_of_a_plan_with_a_trajectory(self):
        """What is driven is the certificate's; what the wrist and the tips need is never more."""
        manifest = support.write_two_recordings(self.folder)
        self.succeeds("run", support.REFERENCE, "--dataset", manifest, "--out", self.folder / "near", *support.QUICK)
        with h5py.File(self.folder / "near/plans.h5") as file:
            names = [f"{name}/{movement}" for name in file["plans"] for movement in file["plans"][name]]
            certificates = {name: dict(file["plans"][name]["certificate"].attrs) for name in names}
        judged = 0
        for name in names:
            if "executable" not in (text := self.succeeds("explain", self.folder / "near", name).stdout):
                continue
            for words in ("\n  posture ", "upper arm", "forearm", "swivel angle", "palm", "wrist speed r", "\n  wrist "):
                self.assertIn(words, text)
            posture = self.json_of("explain", self.folder / "near", name)["plans"][0]["posture"]
            self.assertTrue(posture["elbow_circle"])
            for figure in ("upper_arm", "forearm", "swivel", "palm"):
                self.assertEqual(posture[figure]["driven"], certificates[name][f"{figure}_error_mean"])
                self.assertLessEqual(posture[figure]["least"], posture[figure]["driven"] + 0.02)
            self.assertLessEqual(posture["palm_of_fingers"], posture["palm"]["least"])
            offset = posture["wrist_offset"]
            self.assertGreater(offset["rms"], offset["after"]["base"])
            for change in ("links", "hand", "palm_angle", "tips"):
                self.assertGreaterEqual(offset["after"][change], offset["after"][f"{change}_and_base"])
            # PA10 (docs of configs/robots/pa10.yaml).
            for length, published in zip(offset["lengths"], (0.45, 0.48)):
                self.assertAlmostEqual(length, published, 6)
            self.assertLessEqual(offset["from_human"], sum(offset["parts"].values()))
            judged += 1
        self.assertGreater(judged, 0)
        self.assertIsNone(self.json_of("explain", self.run_folder)["plans"][0]["posture"])

    def causes_of_upper_arm(self, *settings):
        """The causes in each plan of the shipped recordings whose figure is not small."""
        folder = self.folder / "construct"
        self.succeeds("run", support.REFERENCE, "--out", folder, *settings)
        with h5py.File(folder / "plans.h5") as file:
            names = list(file["plans"])
        figures = [self.json_of("explain", folder, name)["plans"][0]["posture"]["upper_arm"] for name in names]
        return [figure["causes"] for figure in figures if figure["causes"] != ["small"]]

    def test_a_base_moved_by_120_mm_is_the_placement(self):
        """The shipped one is 300 mm above the person's shoulder."""
        causes = self.causes_of_upper_arm("--set", "placement.shoulder_offset=[0.10, -0.30, 0.18]")
        self.assertGreater(len(causes), 2)
        for found in causes:
            self.assertIn("placement", found)

    def test_an_arm_without_a_weight_is_due_to_weights(self):
        causes = self.causes_of_upper_arm("--set", "map.humanlike_arm=0", "--set", "map.palm_direction=0",
                                          "--set", "map.wrist_motion=0")
        self.assertGreater(causes.count(["weights_or_solver"]), len(causes) / 2)

    def test_courses_of_repair_are_stored(self):
        with h5py.File(self.run_folder / "plans.h5") as file:
            plans = [plan for name in file["plans"] for plan in file["plans"][name].values()
                     if len(plan["findings/cause"]) > 0]
            self.assertTrue(plans)
            for plan in plans:
                names = list(plan["repair/name"].asstr())
                self.assertEqual(names[0], "re-solve, low clearance weights")
                self.assertEqual(plan["repair/level"][0], 0)
                self.assertTrue(set(plan["repair/level"]) <= {0, 1})
                last = plan["repair/finding_count"][()][plan["repair/accepted"][()] == 1]
                left = len(plan["remaining_findings/cause"]) if "remaining_findings" in plan else 0
                if len(last):
                    self.assertEqual(last[-1], left)

    def test_advice_is_settings_that_the_program_takes(self):
        told = self.json_of("explain", self.run_folder)["plans"]
        self.assertTrue(told)
        for plan in told:
            self.assertEqual(plan["status"], "infeasible")
            self.assertGreaterEqual(len(plan["advice"]), 1)
            for advice in plan["advice"]:
                self.assertIn(advice["kind"], ("may_solve", "relaxes_tolerance", "changes_assumption",
                                               "changes_input"))
                self.assertEqual(advice["kind"] == "changes_input", advice["settings"] == [])
                self.assertNotIn("trial", advice)

    def test_what_is_tried_is_what_a_run_gives(self):
        told = self.json_of("explain", self.run_folder, "--try")["plans"]
        tried = [(plan["plan"], advice) for plan in told for advice in plan["advice"] if "trial" in advice]
        self.assertTrue(tried)
        name, advice = next(((name, advice) for name, advice in tried
                             if advice["trial"]["status"] == "executable"), tried[0])
        again = self.folder / "again"
        settings = [word for one in advice["settings"] for word in ("--set", one)]
        self.succeeds("run", support.REFERENCE, "--dataset", self.run_folder / "demonstrations.h5",
                      "--out", again, *support.QUICK, *AWAY, *settings)
        with h5py.File(again / "plans.h5") as file:
            self.assertEqual(file["plans"][name].attrs["status"].decode(), advice["trial"]["status"])

    def test_one_plan_by_its_name(self):
        with h5py.File(self.run_folder / "plans.h5") as file:
            name = next(iter(file["plans"]))
        said = self.succeeds("explain", self.run_folder, f"{name}/000").stdout
        self.assertTrue(said.startswith(f"{name}/000: "))
        self.assertEqual(self.succeeds("explain", self.run_folder / "plans.h5", name).stdout, said)

    def test_wrong_names(self):
        self.refuses(morphe("explain", self.run_folder, "nobody/000"), self.run_folder, "'nobody/000'", "DEMONSTRATION/000")
        with h5py.File(self.run_folder / "plans.h5") as file:
            name = next(iter(file["plans"]))
        self.refuses(morphe("explain", self.run_folder, f"{name}/0"), self.run_folder, f"did you mean '{name}/000'?")
        self.refuses(morphe("explain", self.folder), self.folder, "plans.h5")
        other = self.folder / "other.h5"
        other.write_bytes((self.run_folder / "demonstrations.h5").read_bytes() + b"\0")
        self.refuses(morphe("explain", self.run_folder, "--try", "--dataset", other), "explain --try", "is not the dataset from which")


support.main()
