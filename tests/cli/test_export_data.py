"""`morphe export --format table` and `lerobot`, --where and --split: every Parquet file is read by two
independent readers (tests/parquet_readers), and its values are those of the plans."""
import csv
import json
import math
import os
import resource
import shutil
import subprocess
import unittest

import h5py
import numpy as np

import formats
from support import MORPHE, CommandCase, main, morphe, planned_sample, sha256
from verify_geometry import Robot
from verify_plans import positions_at

FIRST, SECOND, THIRD = "ADL001DR2/000", "ADL001AR1/000", "ADL001AR1/001"
READERS = MORPHE.parents[1] / "parquet_readers"
DEFAULTS = ["timestamp", "frame_index", "episode_index", "index", "task_index"]
STATISTICS = ["min", "max", "mean", "std", "count", "q01", "q10", "q50", "q90", "q99"]


def setUpModule():
    """One file that verify accepts, and one with a third plan, which is infeasible."""
    global PLANS, THREE
    PLANS = planned_sample()
    THREE = PLANS.with_name("three.h5")
    shutil.copy(PLANS, THREE)
    with h5py.File(THREE, "r+") as file:
        file.copy(file["plans"][SECOND], file["plans/ADL001AR1"], "001")
        other = file["plans"][THIRD]
        other.attrs["status"], other.attrs["reason"] = b"infeasible", b"no_path"
        other.attrs["detail"] = b"a wall, | 'in' the way"
        del other["trajectory"]
        for path in (FIRST, SECOND, THIRD):
            file["plans"][path].attrs["source"], file["plans"][path].attrs["licence"] = b"UE, a | b", b"MIT"


def read_parquet(*files):
    """Of each file {column: values} and its metadata, after both readers read the same."""
    if not (READERS / "node_modules").is_dir():
        raise unittest.SkipTest("the readers of Parquet files are not installed")  # scripts/test looks for this
    result = subprocess.run(["node", READERS / "read.mjs", *map(str, files)], capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    tables = []
    for name, read in json.loads(result.stdout).items():
        first, second = read["hyparquet"], read["duckdb"]
        assert first["columns"] == second["columns"], name
        assert first["rows"] == second["rows"], name
        assert sum(read["groups"]) == len(first["rows"]), name
        columns = dict(zip(first["columns"], map(list, zip(*first["rows"]))))
        tables.append((columns, dict(zip(first["columns"], second["types"])), read["metadata"]))
    return tables


class Data(CommandCase):
    def export(self, kind, *options, plans=None, folder="out"):
        out = self.folder / folder
        unverified = ["--unverified"] if plans else []
        return out, self.succeeds("export", plans or PLANS, "--format", kind, "--out", out, *unverified, *options)

    def refused(self, *options, plans=None):
        """Nothing is left, and one line is said."""
        out = self.folder / "new/out"
        result = morphe("export", plans or PLANS, "--out", out, *options)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertFalse(out.parent.exists())
        return result.stderr


class Table(Data):
    def test_holds_what_the_file_says(self):
        out, _ = self.export("table", plans=THREE)
        self.assertEqual(sorted(file.name for file in out.iterdir() if file.name != ".lock"),
                         ["README.md", "plans.csv", "plans.parquet"])
        with open(out / "plans.csv", newline="") as text:
            rows = list(csv.DictReader(text))
        (columns, types, metadata), = read_parquet(out / "plans.parquet")
        self.assertEqual(list(columns), list(rows[0]))
        as_text = {"BOOLEAN": lambda value: str(value).lower(), "DOUBLE": float, "BIGINT": int, "VARCHAR": str}
        for name, values in columns.items():
            for row, value in zip(rows, values, strict=True):
                told = row[name] if value is None or types[name] in ("VARCHAR", "BOOLEAN") else \
                    as_text[types[name]](row[name])
                self.assertEqual(told, "" if value is None else as_text[types[name]](value), name)
        self.assertEqual(columns["plan"], [FIRST, SECOND, THIRD])
        self.assertEqual(json.loads(metadata["units"])["clearance"], "m")
        with h5py.File(THREE) as file:
            for k, path in enumerate(columns["plan"]):
                plan = file["plans"][path]
                said = {**plan.attrs, **plan["certificate"].attrs}
                for column, attribute in {
                        "status": "status", "reason": "reason", "subject": "subject", "task": "task",
                        "source": "source", "licence": "licence", "detail": "detail", "target": "target",
                        "clearance": "clearance", "tempo": "duration_ratio", "jerk_ratio": "jerk_ratio",
                        "humanlikeness": "humanlikeness_final", "tip_error_max": "tip_error_max",
                        "joint_limit_margin": "joint_limit_margin", "branch": "branch",
                        "upper_arm_error": "upper_arm_error_mean"}.items():
                    value, own = said[attribute], columns[column][k]
                    if isinstance(value, bytes):
                        self.assertEqual(own or "", value.decode(), column)
                    else:
                        self.assertTrue(own == value or (own is None and math.isnan(value)), column)
                by_kind = plan.get("certificate/clearance_by_kind")
                if by_kind:
                    for kind, clearance in zip(by_kind["kind"].asstr(), by_kind["clearance"]):
                        self.assertEqual(columns[f"clearance_{kind}"][k], clearance)
                if "trajectory" in plan:
                    self.assertEqual(columns["duration"][k], plan["trajectory/time"][-1])
            self.assertEqual(columns["licence"], ["MIT"] * 3)

    def test_card_tells_the_yield(self):
        out, _ = self.export("table", plans=THREE)
        card = (out / "README.md").read_text()
        for text in ("3 movements planned: 2 executable (66.7 %), 1 infeasible (33.3 %).", "| `no_path` | 1 |",
                     "| UE, a \\| b | MIT | 3 |", "| ADL001 | 3 |", "| seed of the config | 1 |", "| `clearance` | m |",
                     "| verified | **no**: was not verified"):
            self.assertIn(text, card)

    def test_same_bytes(self):
        first, _ = self.export("table", "--split", "person")
        again, _ = self.export("table", "--split", "person", folder="again")
        for name in ("plans.csv", "plans.parquet", "README.md"):
            self.assertEqual(sha256(first / name), sha256(again / name))
        self.assertIn("| verified | yes", (first / "README.md").read_text())


class Where(Data):
    def chosen(self, condition):
        out, result = self.export("table", "--where", condition, "--replace", plans=THREE)
        with open(out / "plans.csv", newline="") as text:
            names = [row["plan"] for row in csv.DictReader(text)]
        self.assertIn(f"{len(names)} of 3 plans satisfy --where\n", result.stdout)
        return names

    def test_chooses(self):
        with h5py.File(THREE) as file:
            clearances = {path: 1e3 * file["plans"][path]["certificate"].attrs["clearance"] for path in (FIRST, SECOND)}
        high = max(clearances, key=clearances.get)
        between = sum(clearances.values()) / 2
        self.assertEqual(self.chosen(f"clearance > {between} mm and status = executable"), [high])
        self.assertEqual(self.chosen("reason = no_path"), [THIRD])
        self.assertEqual(self.chosen("not status = infeasible and tempo < 100"), [FIRST, SECOND])
        self.assertIn("tempo \\< 100", (self.folder / "out/README.md").read_text())

    def test_holds_for_every_format(self):
        for kind in ("csv", "ros", "ros-json", "robomimic", "lerobot"):
            out, _ = self.export(kind, "--where", f"plan = {FIRST}", folder=kind)
            if kind == "robomimic":
                with h5py.File(out / "robomimic.hdf5") as file:
                    self.assertEqual(len(file["data"]), 1)
            elif kind == "lerobot":
                self.assertEqual(json.loads((out / "meta/info.json").read_text())["total_episodes"], 1)
            else:
                index = json.loads((out / f"index_{kind}.json").read_text())
                self.assertEqual([plan["plan"] for plan in index["plans"]], [FIRST])
                self.assertEqual(index["where"], f"plan = {FIRST}")

    def test_a_bad_condition_is_one_line(self):
        for condition, *words in (("clearence > 2 mm", "at character 1", "did you mean 'clearance'?"),
                                  ("clearance > 2", "at character 13", "2 m, cm, mm, um"),
                                  ("tempo < 1.8 and", "at character 16"),
                                  ("plan = nobody", "none of 2 plans satisfies it")):
            for kind in ("table", "csv", "lerobot"):
                said = self.refused("--format", kind, "--where", condition)
                self.assertTrue(said.startswith("--where '"), said)
                for word in words:
                    self.assertIn(word, said)


class Split(Data):
    def test_sides_are_the_same_in_every_format(self):
        out, _ = self.export("table", "--split", "demonstration", plans=THREE, folder="table")
        with open(out / "plans.csv", newline="") as text:
            sides = {row["plan"]: row["split"] for row in csv.DictReader(text)}
        self.assertEqual(sides[SECOND], sides[THIRD])
        self.assertEqual(set(sides.values()), {"train", "valid"})
        out, _ = self.export("robomimic", folder="robomimic")
        with h5py.File(out / "robomimic.hdf5") as file:
            for side, names in file["mask"].items():
                for name in names:
                    self.assertEqual(sides[formats.text(file["data"][formats.text(name)].attrs["plan"])], side)
        out, _ = self.export("csv", "--split", "demonstration", folder="csv")
        index = json.loads((out / "index_csv.json").read_text())
        self.assertEqual({plan["plan"]: plan["split"] for plan in index["plans"]}, {k: sides[k] for k in (FIRST, SECOND)})
        out, _ = self.export("lerobot", "--split", "demonstration", folder="lerobot")
        info = json.loads((out / "meta/info.json").read_text())
        self.assertEqual(info["splits"], {"train": "0:1", "valid": "1:2"})
        (columns, _, _), = read_parquet(out / "plans.parquet")
        self.assertEqual([(plan, side) for plan, side in zip(columns["plan"], columns["split"])],
                         sorted(((plan, sides[plan]) for plan in (FIRST, SECOND)), key=lambda pair: pair[1]))

    def test_one_person_is_not_divided(self):
        out, _ = self.export("lerobot", "--split", "person")
        self.assertEqual(json.loads((out / "meta/info.json").read_text())["splits"], {"train": "0:2"})


class LeRobot(Data):
    FPS = 30

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.out = PLANS.with_name("lerobot")
        result = morphe("export", PLANS, "--format", "lerobot", "--out", cls.out)
        assert result.returncode == 0, result.stderr
        cls.printed = result.stdout
        cls.info = json.loads((cls.out / "meta/info.json").read_text())
        cls.files = {path.relative_to(cls.out).as_posix() for path in cls.out.rglob("*") if path.is_file()}

    def test_files(self):
        self.assertEqual(self.files - {".lock"}, {
            "README.md", "plans.parquet", "meta/info.json", "meta/stats.json", "meta/tasks.parquet",
            "meta/episodes/chunk-000/file-000.parquet", "data/chunk-000/file-000.parquet"})
        self.assertIn("30 frames per second: for learning, not for execution\n", self.printed)
        card = (self.out / "README.md").read_text()
        self.assertTrue(card.startswith("---\ntags:\n- LeRobot\n"))
        self.assertIn("**For learning, not for execution.**", card)

    def test_info(self):
        info = self.info
        self.assertEqual(list(info), [
            "codebase_version", "robot_type", "total_episodes", "total_frames", "total_tasks", "chunks_size",
            "data_files_size_in_mb", "video_files_size_in_mb", "fps", "splits", "data_path", "video_path", "features"])
        self.assertEqual((info["codebase_version"], info["robot_type"], info["fps"], info["total_episodes"],
                          info["splits"], info["video_path"]), ("v3.0", "pa10_dlr_hit2", 30, 2, {"train": "0:2"}, None))
        self.assertEqual(info["data_path"].format(chunk_index=0, file_index=0), "data/chunk-000/file-000.parquet")
        features = info["features"]
        self.assertEqual(list(features)[-5:], DEFAULTS)
        for name, feature in features.items():
            self.assertEqual(set(feature), {"dtype", "shape", "names"})
            self.assertNotIn("/", name)
            if name in DEFAULTS:
                self.assertEqual((feature["shape"], feature["names"]), ([1], None))
            else:
                self.assertEqual([len(feature["names"])], feature["shape"])

    def test_frames_are_on_the_certified_curve(self):
        (data, types, _), = read_parquet(self.out / "data/chunk-000/file-000.parquet")
        self.assertEqual(list(data), list(self.info["features"]))
        kinds = {"float32": "FLOAT", "int64": "BIGINT"}
        for name, feature in self.info["features"].items():
            self.assertEqual(types[name], kinds[feature["dtype"]] + ("[]" if feature["shape"] != [1] else ""))
        data = {name: np.array(values) for name, values in data.items()}
        self.assertEqual(len(data["index"]), self.info["total_frames"])
        np.testing.assert_array_equal(data["index"], np.arange(len(data["index"])))
        with h5py.File(PLANS) as file:
            robot = Robot(file["robot"])
            for episode, path in enumerate((FIRST, SECOND)):
                own = {name: values[data["episode_index"] == episode] for name, values in data.items()}
                trajectory = file["plans"][path]["trajectory"]
                motion = {name: trajectory[name][()] for name in
                          ("time", "position", "velocity", "acceleration", "demonstration_time", "phase")}
                k = np.arange(len(own["index"]))
                end = motion["time"][-1]
                self.assertEqual(len(k), math.ceil(end * self.FPS - 1e-6) + 1)
                np.testing.assert_array_equal(own["frame_index"], k)
                np.testing.assert_array_equal(own["timestamp"], (k / self.FPS).astype(np.float32))
                at = np.minimum(k / self.FPS, end)
                position = positions_at(motion, at)
                np.testing.assert_allclose(own["observation.state"], position, atol=1e-6)
                # The float nearest to the curve's value, or its neighbour where that was within 1e-12.
                np.testing.assert_array_max_ulp(own["observation.state"].astype(np.float32),
                                                position.astype(np.float32), maxulp=1)
                np.testing.assert_array_equal(own["action"][:-1], own["observation.state"][1:])
                np.testing.assert_array_equal(own["action"][-1], own["observation.state"][-1])
                self.assertEqual(np.abs(own["observation.velocity"][-1]).max(), 0)
                slope = (positions_at(motion, at[1:-1] + 1e-6) - positions_at(motion, at[1:-1] - 1e-6)) / 2e-6
                np.testing.assert_allclose(own["observation.velocity"][1:-1], slope, atol=1e-5)
                # A frame at the time of a sample may be a rounding before it.
                before, after = (motion["phase"][np.clip(np.searchsorted(motion["time"], at + shift) - 1, 0, None)]
                                 for shift in (-1e-9, 1e-9))
                self.assertTrue(((own["phase"] == before) | (own["phase"] == after)).all())
                poses = robot.frame_poses(position)
                palm = poses[:, robot.palm]
                np.testing.assert_allclose(own["observation.palm"][:, :3], palm[:, :3, 3], atol=1e-6)
                w, x, y, z = own["observation.palm"][:, 3:].T
                np.testing.assert_allclose(np.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]),
                                           palm[:, :3, 0].T, atol=1e-5)
                tips = np.concatenate([(poses[:, frame] @ transform)[:, :3, 3] for frame, transform in
                                       zip(robot.tips["frame"], robot.tips["transform"])], axis=1)
                np.testing.assert_allclose(own["observation.tips"], tips, atol=1e-6)

    def test_episodes_tasks_and_statistics(self):
        (data, _, _), (episodes, types, _), (tasks, _, metadata) = read_parquet(
            self.out / "data/chunk-000/file-000.parquet", self.out / "meta/episodes/chunk-000/file-000.parquet",
            self.out / "meta/tasks.parquet")
        self.assertEqual(list(tasks), ["task_index", "task"])
        self.assertEqual(tasks["task_index"], list(range(self.info["total_tasks"])))
        self.assertEqual(json.loads(metadata["pandas"])["index_columns"], ["task"])
        self.assertEqual(episodes["episode_index"], [0, 1])
        self.assertEqual(episodes["dataset_from_index"][0], 0)
        self.assertEqual(episodes["dataset_to_index"][0], episodes["dataset_from_index"][1])
        self.assertEqual(episodes["dataset_to_index"][1], self.info["total_frames"])
        for key in ("data/chunk_index", "data/file_index", "meta/episodes/chunk_index", "meta/episodes/file_index"):
            self.assertEqual(episodes[key], [0, 0])
        stats = json.loads((self.out / "meta/stats.json").read_text())
        self.assertEqual(list(stats), list(self.info["features"]))
        for name, feature in self.info["features"].items():
            self.assertEqual(list(stats[name]), STATISTICS)
            values = np.array(data[name], float).reshape(len(data[name]), -1)
            self.same_statistics(stats[name], values, 500)
            for k in (0, 1):
                own = {key: episodes[f"stats/{name}/{key}"][k] for key in STATISTICS}
                self.same_statistics(own, values[np.array(data["episode_index"]) == k], 1e9)
            integer = feature["dtype"] == "int64"
            self.assertEqual(types[f"stats/{name}/min"], "BIGINT[]" if integer else "DOUBLE[]")
        for k, words in enumerate(episodes["tasks"]):
            index = {value for value, own in zip(data["task_index"], data["episode_index"]) if own == k}
            self.assertEqual([tasks["task"][i] for i in index], words)
            self.assertEqual(episodes["length"][k], data["episode_index"].count(k))

    def same_statistics(self, own, values, parts):
        spread = np.ptp(values, axis=0)
        self.assertEqual(own["count"], [len(values)])
        np.testing.assert_array_equal(own["min"], values.min(axis=0))
        np.testing.assert_array_equal(own["max"], values.max(axis=0))
        np.testing.assert_allclose(own["mean"], values.mean(axis=0), atol=1e-9 * max(1, np.abs(values).max()))
        np.testing.assert_allclose(own["std"], values.std(axis=0), atol=1e-7 * max(1, np.abs(values).max()))
        for key, share in zip(STATISTICS[5:], (0.01, 0.1, 0.5, 0.9, 0.99)):
            self.assertLessEqual((np.abs(np.array(own[key]) - np.quantile(values, share, axis=0)) -
                                  spread / parts).max(), 1e-9, key)

    def test_any_rate(self):
        for fps in (1, 50, 240):
            out, _ = self.export("lerobot", "--fps", fps, folder=f"at_{fps}")
            self.assertEqual(json.loads((out / "meta/info.json").read_text())["fps"], fps)
        self.assertIn("whole number of frames", self.refused("--format", "lerobot", "--fps", 29.97))

    def test_refuses_what_does_not_fit(self):
        for options, word in ((("--group", "arm"), "--group"), (("--delay", "1"), "--delay"),
                              (("--approach", "joined"), "no plan has an approach")):
            self.assertIn(word, self.refused("--format", "lerobot", *options))
        result = morphe("export", PLANS, "--format", "lerobt", "--out", self.folder / "new")
        self.assertEqual((result.returncode, list(self.folder.iterdir())), (2, []))
        self.assertIn("did you mean 'lerobot'?", result.stderr)

    def test_another_dataset_in_the_folder_is_not_read_along(self):
        out, _ = self.export("lerobot")
        stray = out / "data/chunk-000/file-001.parquet"
        shutil.copy(out / "data/chunk-000/file-000.parquet", stray)
        before = {path: sha256(path) for path in out.rglob("*") if path.is_file() and path.name != ".lock"}
        self.refuses(morphe("export", PLANS, "--format", "lerobot", "--out", out, "--replace", "--fps", 20),
                     stray, "another dataset")
        self.assertEqual({path: sha256(path) for path in out.rglob("*") if path.is_file() and path.name != ".lock"}, before)


class Faults(Data):
    def test_forged_plans_are_refused(self):
        forged = self.folder / "forged.h5"
        shutil.copy(PLANS, forged)
        with h5py.File(forged, "r+") as file:
            file["plans"][FIRST]["certificate"].attrs["clearance"] = 0.5
        for kind in ("table", "lerobot"):
            self.assertIn("is rejected by verify", self.refused("--format", kind, plans=forged))
        with h5py.File(forged, "r+") as file:
            del file["plans"][FIRST]["certificate"]
        for kind in ("table", "lerobot"):
            for extra in ((), ("--unverified",)):
                self.assertIn("certificate", self.refused("--format", kind, *extra, plans=forged))

    def test_an_invented_licence_is_refused(self):
        forged = self.folder / "forged.h5"
        shutil.copy(PLANS, forged)
        with h5py.File(forged, "r+") as file:
            del file["plans"][FIRST].attrs["licence"]
        self.assertIn("licence", self.refused("--format", "table", plans=forged))

    def test_a_full_disk_leaves_nothing(self):
        self.succeeds("export", PLANS, "--format", "table", "--out", self.folder / "first")  # notes the verdict
        for kind, sizes in (("table", (0, 1, 4)), ("lerobot", (0, 1, 16))):
            for kilobytes in sizes:
                with self.subTest(kind=kind, kilobytes=kilobytes):
                    out = self.folder / "new/out"
                    limit = (kilobytes * 1024,) * 2
                    result = subprocess.run(
                        [MORPHE, "export", PLANS, "--format", kind, "--out", out], capture_output=True, text=True,
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit))
                    self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                    self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                    self.assertIn("cannot be written", result.stderr)
                    self.assertFalse(out.parent.exists(), [str(path) for path in out.parent.rglob("*")])


if __name__ == "__main__":
    main()
