"""`morphe diff` finds every change made with h5py, and `morphe run --from` none: a plans.h5 is all that
it takes to make it again."""
import shutil

import h5py
import numpy as np

from many import COUNT, ManyCase
from support import SOURCE, json, main, morphe, sha256


class Diff(ManyCase):
    def setUp(self):
        super().setUp()
        self.other = self.folder / "other.h5"
        shutil.copy(self.plain / "plans.h5", self.other)

    def diff(self, *arguments):
        return morphe("diff", self.plain / "plans.h5", self.other, *arguments)

    def found(self):
        """{(plan, dataset): (max_abs, change)}"""
        result = self.diff("--json")
        report = json.loads(result.stdout)
        self.assertEqual((result.returncode, report["equal"]), (1, False) if report["plans"] else (0, True))
        return {(row["plan"], row["dataset"]): (row["max_abs"], row["change"]) for row in report["plans"]}

    def edit(self, change):
        with h5py.File(self.other, "r+") as file:
            change(file)

    def test_equal(self):
        self.assertEqual(self.found(), {})
        self.assertRegex(self.diff().stdout, r"^equal: \d+ plans\n$")

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
        self.assertIn(f"name one of {several}/a/plans.h5, {several}/b/plans.h5", refused.stderr)
        empty = self.folder / "empty"
        empty.mkdir()
        refused = morphe("diff", empty, self.plain)
        self.assertEqual((refused.returncode, "holds no plans.h5" in refused.stderr), (2, True))

    def test_one_number(self):
        def change(file):
            file["plans/synthetic_000002/000/trajectory/position"][3, 2] += 0.25
        self.edit(change)
        found = self.found()
        key = ("synthetic_000002/000", "trajectory/position")
        self.assertEqual(list(found), [key])
        self.assertAlmostEqual(found[key][0], 0.25, 12)
        text = self.diff()
        self.assertEqual(text.returncode, 1)
        self.assertIn("synthetic_000002/000 trajectory/position: by at most 0.25\n", text.stdout)
        self.assertRegex(text.stdout, r"\n1 of \d+ plans differ\n$")

    def test_the_last_bit_and_the_sign_of_zero(self):
        def change(file):
            value = file["plans/synthetic_000001/000/goals/time"][1]
            file["plans/synthetic_000001/000/goals/time"][1] = np.nextafter(value, np.inf)
            file["plans/synthetic_000001/000"].attrs.modify("margin", -0.0)
        with h5py.File(self.plain / "plans.h5") as file:
            margin = file["plans/synthetic_000001/000"].attrs["margin"]
        self.edit(change)
        found = self.found()
        self.assertEqual(list(found), [("synthetic_000001/000", "@margin"),
                                       ("synthetic_000001/000", "goals/time")])
        self.assertEqual(found["synthetic_000001/000", "@margin"][0], margin)
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
        self.assertEqual(found[name, "trajectory/clearance"], (None, "2 values are NaN in one file alone"))
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


class From(ManyCase):
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
                      "--set", "retime.limit_share=0.7")
        for folder in (configs, elsewhere, self.folder / "scenes"):
            shutil.rmtree(folder)
        self.succeeds("run", "--from", made / "plans.h5", "--dataset", self.dataset, "--out", self.out)
        self.assertEqual(sha256(self.out / "plans.h5"), sha256(made / "plans.h5"))

    def test_a_mesh_is_not_stored(self):
        shutil.copy(SOURCE / "configs/scenes/shelf.stl", self.folder)
        mesh = "objects: [{name: shelf, shape: mesh, file: shelf.stl, scale: 0.001, position: [2, 2, 0]}]"
        (self.folder / "scene.yaml").write_text(mesh)
        for scene in (mesh, "file: scene.yaml"):
            with self.subTest(scene):
                config = self.folder / "config.yaml"
                config.write_text(self.config.read_text().replace("scene: {", f"scene: {{{scene}, "))
                made = self.folder / "made/plans.h5"
                self.succeeds("run", config, "--dataset", self.dataset, "--out", made.parent, "--fresh")
                again = morphe("run", "--from", made, "--dataset", self.dataset, "--out", self.out)
                self.refuses(again, made, "holds no mesh files", "shelf.stl cannot be read")
                self.assertNotIn("morphe_from", again.stderr)

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
