"""`morphe run` on the shipped recordings: what it finds, what it writes, and that it writes the same
bytes whatever the number of threads and the place it is called from."""
import hashlib
import os
import re
import shutil
import socket
import unittest
from pathlib import Path

import h5py
import numpy as np

import formats
from support import (QUICK, REFERENCE, SOURCE, CommandCase, json, main, morphe, python_verify, sha256,
                     shared_run, temporary_folder, write_two_recordings)

DEMONSTRATIONS = ["ADL001DR2", "ADL004DR2", "ADL006DR2", "ADL001FR1", "ADL001AR1"]
DRINKING = DEMONSTRATIONS[:3]


class ShippedSample(unittest.TestCase):
    """One run of the shipped config as it stands, judged from its files."""

    @classmethod
    def setUpClass(cls):
        shared = shared_run(REFERENCE, "--json")
        cls.out, cls.printed = shared / "out", (shared / "stdout.txt").read_text()
        cls.file = h5py.File(cls.out / "plans.h5", "r")
        cls.addClassCleanup(cls.file.close)
        cls.plans = [cls.file["plans"][name][movement] for name in cls.file["plans"]
                     for movement in cls.file["plans"][name]]

    def moving(self):
        return [plan for plan in self.plans if formats.text(plan.attrs["status"]) == "executable"]

    def test_prints_a_summary_as_json_and_nothing_else(self):
        summary = json.loads(self.printed)
        self.assertEqual(list(summary), ["demonstrations", "movements", "executable", "approximate", "partial",
                                         "infeasible", "repaired", "failed", "reasons", "stage_cpu_s", "frames",
                                         "frames_per_cpu_second", "stage_ms_per_movement", "branches", "reused"])
        self.assertEqual(summary["demonstrations"], len(DEMONSTRATIONS))
        self.assertEqual(summary["movements"], len(self.plans))
        self.assertEqual(summary["executable"], len(self.moving()))
        self.assertEqual(summary["infeasible"], sum(summary["reasons"].values()))
        self.assertEqual(summary["approximate"], 0)
        self.assertEqual(summary["executable"] + summary["infeasible"], summary["movements"])
        self.assertEqual(summary["failed"], 0)

    def test_every_demonstration_has_plans_in_the_order_of_the_dataset(self):
        self.assertEqual(list(self.file["plans"]), DEMONSTRATIONS)
        for name in DEMONSTRATIONS:
            movements = list(self.file["plans"][name])
            self.assertGreater(len(movements), 0)
            self.assertEqual(movements, [f"{i:03}" for i in range(len(movements))])

    def test_drinking_is_executable(self):
        for name in DRINKING:
            for plan in self.file["plans"][name].values():
                with self.subTest(plan.name):
                    self.assertEqual(formats.text(plan.attrs["reason"]), "")
                    self.assertEqual(formats.text(plan.attrs["target"]), "cup")
                    self.assertLessEqual(plan["certificate"].attrs["tip_error_grasp"], 0.005)
                    self.assertIn("grasp", plan)

    def test_mapping_meets_reachable_goals_within_two_millimetres(self):
        for plan in self.plans:
            error, reachable = plan["mapped/tip_error"][()], plan["goals/reachable"][()]
            with self.subTest(plan.name):
                goal = ~np.isnan(plan["goals/tip_position"][()]).any(axis=2)
                self.assertTrue(np.array_equal(goal, ~np.isnan(error)))
                self.assertGreater((goal & (reachable == 1)).sum(), 0)
                self.assertLess(error[goal & (reachable == 1)].max(), 2e-3)

    def test_mapping_does_not_jump(self):
        for plan in self.plans:
            steps = np.abs(np.diff(plan["mapped/position"][()], axis=0))
            steps_10ms = steps * 0.01 / np.diff(plan["goals/time"][()])[:, None]
            with self.subTest(plan.name):
                self.assertLessEqual(steps_10ms.max(), 0.06)

    def test_tempo_stays_near_the_human_s(self):
        for plan in self.moving():
            with self.subTest(plan.name):
                self.assertLessEqual(plan["certificate"].attrs["duration_ratio"], 2.2)

    def test_plans_file_keeps_the_contract(self):
        self.assertFalse(set(formats.PLANS_ROOT) - set(self.file.attrs))
        self.assertEqual(formats.text(self.file.attrs["format"]), "morphe-plans")
        self.assertEqual(self.file.attrs["version"], 3)
        robot = self.file["robot"]
        self.assertFalse(set(formats.ROBOT_ATTRIBUTES) - set(robot.attrs))
        self.assertEqual(formats.text(self.file.attrs["robot"]), "pa10_dlr_hit2")
        robot_sizes = {}
        self.assertEqual(formats.faults(robot, formats.ROBOT, robot_sizes), [])
        for plan in self.plans:
            sizes = {letter: robot_sizes[letter] for letter in "nm"}
            with self.subTest(plan.name):
                self.assertFalse(set(formats.PLAN_ATTRIBUTES) - set(plan.attrs))
                self.assertFalse(set(formats.CERTIFICATE) - set(plan["certificate"].attrs))
                self.assertEqual(plan["goals"].attrs["common_base_offset"].shape, (3,))
                self.assertEqual(formats.faults(plan, formats.PLAN, sizes), [])
                for body in plan["scene"].values():
                    self.assertIn(formats.text(body.attrs["shape"]),
                                  ("sphere", "box", "cylinder", "capsule"))
                    self.assertIn("size", body.attrs)
                    self.assertEqual(formats.faults(body, formats.OBJECT, {}), [])

    def test_what_moves_keeps_the_contract(self):
        joints = len(self.file["robot/joint_names"])
        for plan in self.plans:
            with self.subTest(plan.name):
                self.assertEqual("trajectory" in plan, plan in self.moving())
                if plan not in self.moving():
                    continue
                sizes = {"n": joints, "m": len(self.file["robot/tips/name"])}
                self.assertEqual(formats.faults(plan["trajectory"], formats.TRAJECTORY, sizes), [])
                for name, meaning in formats.MEANINGS.items():
                    self.assertEqual(formats.text(plan[name].attrs["meaning"]), meaning)
                if "grasp" in plan:
                    self.assertEqual(formats.faults(plan["grasp"], formats.GRASP, sizes), [])
                    self.assertIn(plan["grasp"].attrs["sample"], range(sizes["T"]))

    def test_demonstrations_file_keeps_the_contract(self):
        with h5py.File(self.out / "demonstrations.h5") as file:
            self.assertEqual(formats.text(file.attrs["format"]), "morphe-demonstrations")
            self.assertEqual(file.attrs["version"], 3)
            self.assertEqual(list(file["demonstrations"]), DEMONSTRATIONS)
            for name, group in file["demonstrations"].items():
                with self.subTest(name):
                    self.assertFalse(set(formats.DEMONSTRATION_ATTRIBUTES) - set(group.attrs))
                    sizes = {}
                    self.assertEqual(formats.faults(group, formats.MARKERS, sizes), [])
                    self.assertEqual(len(group["markers"].attrs["names"]), sizes["M"])

    def test_hashes_are_those_of_config_and_dataset(self):
        config = formats.text(self.file.attrs["config"]).encode()
        self.assertEqual(formats.text(self.file.attrs["config_sha256"]),
                         hashlib.sha256(config).hexdigest())
        self.assertEqual(formats.text(self.file.attrs["dataset_sha256"]),
                         sha256(self.out / "demonstrations.h5"))

    def test_inputs_hold_the_text_of_every_file_named(self):
        kept = {}
        self.file["inputs"].visititems(
            lambda name, item: kept.update({name: formats.text(item[()])})
            if isinstance(item, h5py.Dataset) else None)
        named = ["pipelines/pa10_dlr_hit2.yaml", "robots/pa10_dlr_hit2.yaml", "robots/pa10.yaml",
                 "robots/dlr_hit2.yaml"]
        self.assertEqual(kept, {name: (SOURCE / "configs" / name).read_text() for name in named})

    def test_files_say_nothing_of_machine_place_or_time(self):
        foreign = [str(SOURCE), str(self.out), str(Path.home()), socket.gethostname()]
        moment = re.compile(r"\d{4}-\d\d-\d\d[T ]\d\d:\d\d|\b\d\d:\d\d:\d\d\b")
        absolute = re.compile(r"(^|[\s'\"])/\w+/")
        for name in ("plans.h5", "demonstrations.h5"):
            with h5py.File(self.out / name) as file:
                for where, string in formats.strings(file):
                    for word in foreign:
                        self.assertNotIn(word, string, where)
                    self.assertIsNone(moment.search(string), where)
                    if where != "a name":
                        self.assertIsNone(absolute.search(string), where)

    def test_both_verifiers_accept_it(self):
        verdict = morphe("verify", self.out / "plans.h5", "--json")
        other = python_verify(self.out / "plans.h5")
        for result in (verdict, other):
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            judged = json.loads(result.stdout)
            for own in ("assumptions", "looked_at"):  # which only our own tells
                judged.pop(own, None)
            self.assertEqual(judged,
                             {"executable": len(self.moving()), "approximate": 0, "partial": 0,
                              "infeasible": len(self.plans) - len(self.moving()), "violations": []})


class SameBytes(CommandCase):
    """plans.h5 depends on dataset, config and program alone."""

    @classmethod
    def setUpClass(cls):
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.base = Path(holder.name).resolve()
        cls.manifest = write_two_recordings(cls.base)
        shutil.copytree(shared_run(REFERENCE, *QUICK, dataset="two recordings") / "out", cls.base / "first")
        cls.first = sha256(cls.base / "first/plans.h5")

    @classmethod
    def run_into(cls, out, *arguments, config=REFERENCE, dataset=None, cwd=None):
        result = morphe("run", config, "--dataset", dataset or cls.manifest, "--out", cls.base / out,
                        *QUICK, *arguments, cwd=cwd)
        assert result.returncode == 0, result.stderr
        return sha256(cls.base / out / "plans.h5")

    def test_twice_into_the_same_folder(self):
        again = self.run_into("first", "--jobs", 1, "--fresh")
        self.assertEqual(again, self.first)

    def test_two_threads_and_another_folder(self):
        self.assertEqual(self.run_into("deep/second", "--jobs", 2), self.first)

    def test_another_working_folder_and_relative_paths(self):
        config = os.path.relpath(REFERENCE, self.folder)
        manifest = os.path.relpath(self.manifest, self.folder)
        third = self.run_into("third", config=config, dataset=manifest, cwd=self.folder)
        self.assertEqual(third, self.first)

    def test_a_copy_of_the_configs_elsewhere(self):
        shutil.copytree(SOURCE / "configs", self.folder / "copy/of/configs")
        config = self.folder / "copy/of/configs/pipelines" / REFERENCE.name
        self.assertEqual(self.run_into("copied", config=config), self.first)

    def test_an_imported_dataset_instead_of_the_manifest(self):
        imported = self.folder / "elsewhere.h5"
        self.succeeds("import", self.manifest, "--out", imported)
        self.assertEqual(self.run_into("fourth", dataset=imported), self.first)

    def test_another_seed_is_another_file(self):
        self.assertNotEqual(self.run_into("fifth", "--set", "seed=2"), self.first)


class OtherWaysToRun(CommandCase):
    def test_a_table_for_people_and_progress_beside_it(self):
        manifest = write_two_recordings(self.folder)
        result = self.succeeds("run", REFERENCE, "--dataset", manifest, "--out", self.folder / "out",
                               *QUICK)
        for name in ("ADL001DR2/000", "ADL001AR1/000", "2 demonstrations, 2 movements"):
            self.assertIn(name, result.stdout)
        self.assertEqual(re.findall(r"^\[\d/\d\] \w+", result.stderr, re.M),
                         ["[1/2] ADL001DR2", "[2/2] ADL001AR1"])
        self.assertEqual(sorted(os.listdir(self.folder / "out")),
                         ["demonstrations.h5", "journal.sqlite", "plans.h5"])

    def test_every_pipeline_config_loads_with_all_that_it_names(self):
        """A dataset without recordings: the config, its robot and its scene are all that is read."""
        (self.folder / "none.yaml").write_text("recordings: []\n")
        for config in sorted((SOURCE / "configs/pipelines").glob("*.yaml")):
            with self.subTest(config.name):
                summary = self.json_of("run", config, "--dataset", self.folder / "none.yaml",
                                       "--out", self.folder / config.stem)
                for robot in summary.get("robots", {"": summary}).values():
                    self.assertEqual((robot["demonstrations"], robot["failed"]), (0, 0))

    def test_every_robot_and_scene_loads(self):
        """Named by a config of one robot or one scene and nothing else."""
        (self.folder / "none.yaml").write_text("recordings: []\n")
        reference = "pa10_dlr_hit2.yaml"
        robots = {path.name: "" for path in sorted((SOURCE / "configs/robots").glob("*.yaml"))}
        scenes = sorted((SOURCE / "configs/scenes").glob("*.yaml"))
        pairs = [(robot, None) for robot in robots] + [(reference, scene) for scene in scenes]
        self.assertGreater(len(pairs), 2)
        for robot, scene in pairs:
            with self.subTest(robot=robot, scene=scene):
                config = self.folder / "config.yaml"
                config.write_text(f"robot: {{file: {SOURCE}/configs/robots/{robot}}}\n" +
                                  (f"scene: {{file: {scene}}}\n" if scene else ""))
                self.succeeds("run", config, "--dataset", self.folder / "none.yaml", "--out",
                              self.folder / "out")

    def test_no_folder_of_configs_is_left_out(self):
        """names, studies and synthetic: test_import.py, test_study.py and test_synthesize.py."""
        self.assertEqual({path.parent.name for path in (SOURCE / "configs").rglob("*.yaml")},
                         {"names", "pipelines", "robots", "scenes", "studies", "synthetic"})


if __name__ == "__main__":
    main()
