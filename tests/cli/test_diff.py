"""`morphe diff` finds every change made with h5py, and `morphe run --from` none: a plans.h5 is all that
it takes to make it again. Takes 12 s of processor time: thirty files are compared, a process each."""
import fcntl
import os
import pty
import re
import shutil
import struct
import subprocess
import termios
from unittest import mock

import h5py
import numpy as np

from many import CONFIG, ManyCase
from support import MORPHE, SOURCE, estimate_arm, json, main, morphe, sha256


class FewCase(ManyCase):
    """Half as many recordings, of which plans are sampled at 50 Hz, not 500: compared in no time."""

    @classmethod
    def setUpClass(cls):
        with mock.patch.multiple("many", COUNT=6, CONFIG=CONFIG + "retime: {sample_rate_hz: 50}\n"):
            super().setUpClass()


class Diff(FewCase):
    def setUp(self):
        super().setUp()
        self.other = self.folder / "other.h5"
        shutil.copy(self.plain / "plans.h5", self.other)

    def diff(self, *arguments):
        return morphe("diff", self.plain / "plans.h5", self.other, "--unverified", *arguments)

    def found(self):
        """{(plan, dataset): (max_abs, change)}"""
        result = self.diff("--json")
        report = json.loads(result.stdout)
        self.assertEqual((result.returncode, report["equal"]), (1, False) if report["differences"] else (0, True))
        return {(row["plan"], row["dataset"]): (row["max_abs"], row["change"]) for row in report["differences"]}

    def edit(self, change):
        with h5py.File(self.other, "r+") as file:
            change(file)

    def test_equal(self):
        self.assertEqual(self.found(), {})
        self.assertRegex(self.diff().stdout, r"^equal: \d+ plans\n$")
        self.assertEqual(self.diff("--all", "--sort", "duration_ratio").returncode, 0)

    def test_a_runs_folder_stands_for_its_plans(self):
        for command in (["diff", self.plain, self.plain], ["verify", self.plain],
                        ["export", self.plain, "--format", "csv", "--out", self.folder / "csv"]):
            self.assertEqual(morphe(*command).returncode, 0, command)
        several = self.folder / "several"
        for robot in ("a", "b"):
            (several / robot).mkdir(parents=True)
            shutil.copy(self.other, several / robot / "plans.h5")
        refused = morphe("verify", several)
        self.assertEqual(refused.returncode, 2)
        self.assertIn(f"give one of {several}/a/plans.h5, {several}/b/plans.h5", refused.stderr)
        empty = self.folder / "empty"
        empty.mkdir()
        refused = morphe("diff", empty, self.plain)
        self.assertEqual((refused.returncode, "contains no plans.h5" in refused.stderr), (2, True))

    def test_one_number(self):
        def change(file):
            file["plans/synthetic_000002/000/trajectory/position"][3, 2] += 0.25
        self.edit(change)
        found = self.found()
        key = ("synthetic_000002/000", "trajectory/position")
        self.assertEqual(list(found), [key])
        self.assertAlmostEqual(found[key][0], 0.25, 12)
        text = self.diff("--all")
        self.assertEqual(text.returncode, 1)
        with h5py.File(self.plain / "plans.h5") as file:
            time = file["plans/synthetic_000002/000/trajectory/time"][3]
            value = file["plans/synthetic_000002/000/trajectory/position"][3, 2]
            joint = file["robot/joint_names"].asstr()[2]
        self.assertIn(f"synthetic_000002/000 trajectory/position: max change 0.25 rad ({value:.6g} -> "
                      f"{value + 0.25:.6g}) at sample 3 ({time:.2f} s), {joint}\n", text.stdout)
        self.assertRegex(text.stdout, r"\n\d+ plans in both, 1 of them differs\n")
        self.assertNotIn("trajectory/position", self.diff().stdout)

    def test_metres_are_printed_as_millimetres(self):
        def change(file):
            file["plans/synthetic_000002/000/goals/tip_position"][7, 0, 1] += 0.0125
            plan = file["plans/synthetic_000001/000"]
            plan["certificate"].attrs["clearance"] = plan["certificate"].attrs["clearance"] - 0.002
        self.edit(change)
        text = self.diff("--all").stdout
        self.assertRegex(text, r"goals/tip_position: max change 12\.5 mm \(.* -> .*\) at frame 7 \(.* s\), \w+, y\n")
        self.assertRegex(text, r"\nclearance +mm +(\S+ +){3}-2\.0 +synthetic_000001/000 ")
        report = json.loads(self.diff("--json").stdout)
        clearance = report["figures"]["clearance"]
        self.assertEqual(clearance["plan"], "synthetic_000001/000")
        self.assertAlmostEqual(clearance["max_change"], -0.002, 12)
        row, = [row for row in report["rows"] if row["plan"] == "synthetic_000001/000"]
        self.assertAlmostEqual(row["second"]["clearance"] - row["first"]["clearance"], -0.002, 12)

    def test_figures_against_an_estimated_arm_are_marked(self):
        def change(file):
            for number, name in enumerate(("synthetic_000001/000", "synthetic_000002/000")):
                plan = file["plans"][name]
                if number == 0:
                    estimate_arm(plan)
                for key, more in (("upper_arm_error_mean", 0.1), ("humanlikeness_final", 0.01),
                                  ("clearance", -0.002)):
                    plan["certificate"].attrs[key] += more
        self.edit(change)
        text = self.diff().stdout
        for figure in ("humanlikeness A", "upper arm"):
            self.assertRegex(text, rf"\n{figure} +\S+ +~\d\S* +~\d\S* +")
        self.assertRegex(text, r"\nclearance +mm +-?\d\S* +-?\d\S* +")
        marks = {name: re.findall(r"~\S+", re.search(rf"\n{name} .*", text)[0])
                 for name in ("synthetic_000001/000", "synthetic_000002/000")}
        self.assertEqual(marks, {"synthetic_000001/000": ["~+100.0", "~+5.7"], "synthetic_000002/000": []})
        rows = {row["plan"]: row for row in json.loads(self.diff("--json").stdout)["rows"]}
        self.assertEqual([[rows[name][side]["arm_estimated"] for side in ("first", "second")]
                          for name in marks], [[False, True], [False, False]])
        listed = morphe("list", self.other, "--unverified").stdout
        for name, count in (("synthetic_000001/000", 4), ("synthetic_000002/000", 0)):
            row = re.search(rf"\n{name} .*", listed)[0]
            self.assertEqual(len(re.findall(r" ~\d", row)), count, row)

    def test_a_branch_in_words(self):
        name = "synthetic_000002/000"
        with h5py.File(self.plain / "plans.h5") as file:
            words = list(file["plans"][name]["branch_words"].asstr()[()])
        part, value = words[0].split(" ")
        opposite = {"left": "right", "right": "left"}[value]
        def change(file):
            plan = file["plans"][name]
            attributes = dict(plan["branch_words"].attrs)
            del plan["branch_words"]
            plan["branch_words"] = np.array([f"{part} {opposite}", *words[1:], "W2 wound up by +1 turn"], dtype="S")
            plan["branch_words"].attrs.update(attributes)
            plan.attrs["branch"] = plan.attrs["branch"] ^ 1
        self.edit(change)
        said = f"shoulder {value} -> {opposite}, now W2 wound up by +1 turn"
        self.assertRegex(self.diff().stdout,
                         rf"\n1 plan in another branch:\n  {name}: {re.escape(said)}; palm \S+ -> \S+ degrees\n")
        report = json.loads(self.diff("--json").stdout)
        self.assertEqual(report["branch_changes"], [{"plan": name, "change": said}])
        row, = [row for row in report["rows"] if row["plan"] == name]
        self.assertEqual(row["first"]["branch_words"], words)
        self.assertEqual({tuple(other["first"]["branch_words"]) for other in report["rows"]}, {tuple(words)})
        plans = len(report["rows"])
        self.assertGreater(plans, 2)
        listed = morphe("list", self.other, "--unverified").stdout
        self.assertEqual(re.findall(r"\n  branch: .*", listed), [f"\n  branch: {said}, unlike {plans - 1} of {plans} plans"])
        self.assertNotIn("  branch: ", morphe("list", self.plain / "plans.h5").stdout)
        self.assertEqual(row["second"]["branch"], row["first"]["branch"] ^ 1)
        self.assertRegex(self.succeeds("list", self.other, "--unverified").stdout, rf"\n  1 in shoulder {opposite}, .*: {name}\n")

    def test_a_file_of_an_earlier_version_has_its_branches_computed(self):
        def change(file):
            for plan in (plan for movements in file["plans"].values() for plan in movements.values()):
                for key in ("branch_words", "branch_changes"):
                    if key in plan:
                        del plan[key]
                if "branch" in plan.attrs:
                    del plan.attrs["branch"]
        self.edit(change)
        report = json.loads(self.diff("--json").stdout)
        self.assertEqual(report["branch_changes"], [])
        self.assertEqual([row["first"]["branch"] for row in report["rows"]],
                         [row["second"]["branch"] for row in report["rows"]])

    def test_plans_that_are_no_longer_executable(self):
        """A limit that no plan keeps: each is named with its reason."""
        with h5py.File(self.plain / "plans.h5") as file:
            executable = [f"{name}/{movement}" for name in file["plans"] for movement in file["plans"][name]
                          if file["plans"][name][movement].attrs["status"] == b"executable"]
        self.run_json("--set", "retime.mode=duration", "--set", "retime.duration_s=0.01")
        shutil.copy(self.out / "plans.h5", self.other)
        text = self.diff().stdout
        self.assertIn("retime.mode human -> duration", text)
        self.assertIn(f"\n{len(executable)} plans no longer executable:\n", text)
        for name in executable:
            self.assertRegex(text, rf"\n  {name}: (executable|repaired) -> infeasible \(duration_too_short\)\n"
                                   r"    duration_too_short: ")
        report = json.loads(self.diff("--json").stdout)
        self.assertEqual([row["plan"] for row in report["status_changes"]], executable)
        self.assertEqual(report["status_changes"][0]["second"]["reason"], "duration_too_short")
        self.assertEqual(report["figures"]["duration_ratio"]["plans"], 0)

    def test_a_weight_moves_humanlikeness_the_right_way(self):
        self.run_json("--set", "map.humanlike_arm=100")
        shutil.copy(self.out / "plans.h5", self.other)
        report = json.loads(self.diff("--json").stdout)
        self.assertEqual(report["config_changes"], ["map.humanlike_arm 3 -> 100"])
        a = report["figures"]["humanlikeness"]
        self.assertLess(a["median_second"], a["median_first"])
        with h5py.File(self.plain / "plans.h5") as one, h5py.File(self.other) as other:
            for row in report["rows"]:
                for side, file in ("first", one), ("second", other):
                    stored = file["plans"][row["plan"]]["certificate"].attrs["humanlikeness_final"]
                    if row[side]["humanlikeness"] is not None:
                        self.assertEqual(row[side]["humanlikeness"], stored)
        text = self.diff().stdout
        self.assertRegex(text, r"\nhumanlikeness A +cm\^2 +\S+ +\S+ +-")

        rows = self.diff("--only", "synthetic_000002/*").stdout.split("\nB - A", 1)[1]
        self.assertIn("\nsynthetic_000002/000 ", rows)
        self.assertNotIn("synthetic_000001", rows)
        self.refuses(self.diff("--sort", "speed"), "--sort", "'speed' is not one of name, mapped_tip_error,")

    def test_the_last_bit_and_the_sign_of_zero(self):
        def change(file):
            value = file["plans/synthetic_000001/000/goals/time"][1]
            file["plans/synthetic_000001/000/goals/time"][1] = np.nextafter(value, np.inf)
            file["plans/synthetic_000001/000"].attrs.modify("required_clearance", -0.0)
        with h5py.File(self.plain / "plans.h5") as file:
            margin = file["plans/synthetic_000001/000"].attrs["required_clearance"]
        self.edit(change)
        found = self.found()
        self.assertEqual(list(found), [("synthetic_000001/000", "@required_clearance"),
                                       ("synthetic_000001/000", "goals/time")])
        self.assertEqual(found["synthetic_000001/000", "@required_clearance"][0], margin)
        self.assertLess(found["synthetic_000001/000", "goals/time"][0], 1e-15)

    def test_nan_on_one_side_shapes_names_and_status(self):
        def change(file):
            plan = file["plans/synthetic_000000/000"]
            plan["trajectory/clearance"][:2] = np.nan
            times = plan["path/demonstration_time"][:-1]
            del plan["path/demonstration_time"]
            plan["path/demonstration_time"] = times
            plan["path/demonstration_time"].attrs["unit"] = "s"
            plan.attrs.modify("status", np.bytes_("infeasible"))
            plan.attrs["comment"] = "ours"
            del plan["goals/estimated"]
        self.edit(change)
        found = self.found()
        name = "synthetic_000000/000"
        self.assertEqual(found[name, "trajectory/clearance"], (None, "2 values are NaN in only one of the files"))
        self.assertRegex(found[name, "path/demonstration_time"][1], r"^shape \[\d+\] -> \[\d+\]$")
        self.assertEqual(found[name, "@status"], (None, "'executable' -> 'infeasible'"))
        self.assertEqual(found[name, "@comment"], (None, "only in the second"))
        self.assertEqual(found[name, "goals/estimated"], (None, "only in the first"))
        self.assertEqual(len(found), 5)

    def test_plans_of_one_file_alone(self):
        def change(file):
            file.move("plans/synthetic_000004", "plans/renamed")
        self.edit(change)
        found = self.found()
        self.assertEqual(found["synthetic_000004/000", ""], (None, "only in the first"))
        self.assertEqual(found["renamed/000", ""], (None, "only in the second"))

    def test_another_config_names_the_key(self):
        self.run_json("--set", "seed=2")
        shutil.copy(self.out / "plans.h5", self.other)
        found = self.found()
        self.assertEqual(found["", "@config"], (None, "seed 1 -> 2"))
        self.assertIn(("", "@config_sha256"), found)

    def test_files_that_are_none(self):
        self.other.write_text("another file")
        self.refuses(self.diff(), self.other)
        self.refuses(morphe("diff", self.other, self.plain / "plans.h5"), self.other)
        self.other.unlink()
        self.refuses(self.diff(), self.other)


class Table(FewCase):
    """The table of `run` and `list`."""

    def rows(self, text):
        return re.findall(r"^(\S+/\d{3}) +(\w+) +(.*)$", text, re.M)

    def test_list_prints_what_run_printed(self):
        printed = self.succeeds(*self.command(self.out)).stdout
        listed = self.succeeds("list", self.out).stdout
        self.assertEqual(self.rows(printed), self.rows(listed))
        with h5py.File(self.out / "plans.h5") as file:
            plans = [f"{name}/{movement}" for name in file["plans"] for movement in file["plans"][name]]
            column = listed.splitlines()[0].split().index("duration") - len(listed.splitlines()[0].split())
            for name, status, values in self.rows(listed):
                tempo = file["plans"][name]["certificate"].attrs["duration_ratio"]
                self.assertEqual(values.split()[column], "-" if np.isnan(tempo) else f"{tempo:.2f}")
        self.assertEqual([name for name, *_ in self.rows(listed)], plans)

    def test_sort_and_only(self):
        listed = self.rows(self.succeeds("list", self.plain).stdout)
        tempos = [values.split()[-1] for _, _, values in self.rows(
            self.succeeds("list", self.plain, "--sort", "duration_ratio").stdout)]
        known = [float(tempo) for tempo in tempos if tempo != "-"]
        self.assertEqual(known, sorted(known, reverse=True))
        self.assertNotIn("-", tempos[:len(known)])
        self.assertEqual(len(tempos), len(listed))
        for word, hint in (("synthetic_00000[0-9]", ""), ("bad", ""), ("executabel", "; did you mean 'executable'?"),
                           ("synthetic_00001", "; did you mean 'synthetic_000001'?")):
            for command in (("list", self.plain), ("diff", self.plain, self.plain)):
                self.refuses(morphe(*command, "--only", word), "--only",
                             f"no plan has the status, reason or name '{word}'{hint}")
        self.assertEqual(self.rows(self.succeeds("list", self.plain, "--only", "partial").stdout), [])
        some = self.succeeds("list", self.plain, "--only", "synthetic_00000?", "--only", "executable").stdout
        self.assertEqual([row[0] for row in self.rows(some)],
                         [name for name, status, _ in listed if name < "synthetic_00001" and status != "infeasible"])
        ran = self.succeeds(*self.command(self.out, "--only", "synthetic_000003")).stdout
        self.assertEqual({name[:16] for name, *_ in self.rows(ran)}, {"synthetic_000003"})
        self.refuses(morphe(*self.command(self.folder / "no", "--sort", "speed")), "--sort", "'speed' is not one of")
        self.assertFalse((self.folder / "no").exists())

    def test_long_names_keep_the_columns(self):
        long = "a name " + 60 * "é"
        copy = self.folder / "long.h5"
        shutil.copy(self.plain / "plans.h5", copy)
        with h5py.File(copy, "r+") as file:
            file.move("plans/synthetic_000002", f"plans/{long}")
        lines = self.succeeds("list", copy, "--unverified").stdout.splitlines()
        rows = [line for line in lines if re.search(r"/\d{3} ", line)]
        self.assertTrue([row for row in rows if row.startswith(long + "/000  ")])
        self.assertEqual({len(row) for row in rows if " executable " in row}, {len(rows[0])})
        for width in (80, 60, 40):
            narrow = self.in_a_terminal(width, "list", copy, "--unverified")
            self.assertLessEqual(max(len(line) for line in narrow.splitlines()), width)
            self.assertIn("hidden columns:", narrow)

    def test_names_that_are_shortened_stay_different(self):
        copy = self.folder / "alike.h5"
        shutil.copy(self.plain / "plans.h5", copy)
        names = [f"recording_of_{who}_in_the_kitchen_on_a_monday" for who in ("anna", "otto", "emma")]
        with h5py.File(copy, "r+") as file:
            for k, name in enumerate(names, 1):
                file.move(f"plans/synthetic_{k:06}", f"plans/{name}")
        for width in (40, 60, 80):
            narrow = self.in_a_terminal(width, "list", copy, "--unverified", "--only", "recording_*")
            shown = [line.split("  ")[0] for line in narrow.splitlines() if re.search(r"/\d{3} ", line)]
            self.assertEqual(len(set(shown)), len(shown), narrow)
            self.assertEqual(len(shown), len([line for line in self.succeeds(
                "list", copy, "--unverified", "--only", "recording_*").stdout.splitlines() if re.search(r"/\d{3} ", line)]))

    def in_a_terminal(self, width, *arguments):
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 50, width, 0, 0))
        process = subprocess.Popen([MORPHE, *map(str, arguments)], stdout=slave, stdin=slave)
        os.close(slave)
        out = b""
        while True:
            try:
                part = os.read(master, 65536)
            except OSError:
                break
            if not part:
                break
            out += part
        process.wait()
        os.close(master)
        return out.decode().replace("\r\n", "\n")


class From(FewCase):
    def test_the_same_bytes_without_the_config(self):
        self.succeeds("run", "--from", self.plain / "plans.h5", "--dataset", self.dataset, "--out",
                      self.out)
        self.same_bytes()
        self.succeeds("diff", self.plain / "plans.h5", self.out / "plans.h5")

    def test_settings_scene_and_files_are_those_of_the_run(self):
        configs, elsewhere = self.folder / "configs", self.folder / "elsewhere"
        (configs / "deep").mkdir(parents=True)
        elsewhere.mkdir()
        (elsewhere / "base.yaml").write_text(self.config.read_text().replace(
            "scene: {", "scene: {file: ../scenes/post.yaml, "))
        (self.folder / "scenes").mkdir()
        (self.folder / "scenes/post.yaml").write_text(
            "objects:\n  - {name: post, shape: cylinder, size: [0.02, 0.2], position: [1, 1, 0]}\n")
        (configs / "deep/config.yaml").write_text("extends: ../../elsewhere/base.yaml\nseed: 5\n")
        made = self.folder / "made"
        self.succeeds("run", configs / "deep/config.yaml", "--dataset", self.dataset, "--out", made,
                      "--set", "retime.limit_scaling=0.7")
        for folder in (configs, elsewhere, self.folder / "scenes"):
            shutil.rmtree(folder)
        self.succeeds("run", "--from", made / "plans.h5", "--dataset", self.dataset, "--out", self.out)
        self.assertEqual(sha256(self.out / "plans.h5"), sha256(made / "plans.h5"))

    def test_meshes_are_those_of_the_run(self):
        shutil.copy(SOURCE / "configs/scenes/shelf.stl", self.folder)
        mesh = "objects: [{name: shelf, shape: mesh, file: shelf.stl, scale: 0.001, position: [2, 2, 0]}]"
        (self.folder / "scene.yaml").write_text(mesh)
        for scene in (mesh, "file: scene.yaml"):
            with self.subTest(scene):
                config = self.folder / "config.yaml"
                config.write_text(self.config.read_text().replace("scene: {", f"scene: {{{scene}, "))
                made = self.folder / "made/plans.h5"
                self.succeeds("run", config, "--dataset", self.dataset, "--out", made.parent, "--fresh")
                self.succeeds("run", "--from", made, "--dataset", self.dataset, "--out", self.out, "--fresh")
                self.assertEqual(sha256(self.out / "plans.h5"), sha256(made))

    def test_another_dataset_is_refused(self):
        other = self.folder / "other.h5"
        shutil.copy(self.dataset, other)
        with h5py.File(other, "r+") as file:
            del file["demonstrations/synthetic_000000"]
        self.refuses(morphe("run", "--from", self.plain / "plans.h5", "--dataset", other, "--out",
                            self.out), other, "is not the dataset of these plans")
        self.assertFalse(self.out.exists())

    def test_usage(self):
        plans = self.plain / "plans.h5"
        self.refuses(morphe("run", "--from", plans, "--out", self.out), "--from", "--dataset")
        self.refuses(morphe("run", self.config, "--from", plans, "--out", self.out), "run")
        self.refuses(morphe("run", "--out", self.out), "run", "CONFIG")
        self.refuses(morphe("run", "--from", plans, "--dataset", self.dataset, "--out", self.out,
                            "--set", "seed=2"), "--set")


if __name__ == "__main__":
    main()
