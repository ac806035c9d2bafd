"""`morphe export`: what other programs read is what plans.h5 holds, and only what is executable."""
import csv
import json
import re
import shutil

import h5py
import numpy as np

import formats
from support import CommandCase, main, morphe, planned_sample, sha256

FIRST, SECOND = "ADL001DR2/000", "ADL001AR1/000"
# YAML 1.1, which ROS reads: without a point, or without a sign after the e, it is text.
YAML_FLOAT = re.compile(r"-?[0-9]+\.[0-9]*(e[-+][0-9]+)?$")


def setUpModule():
    global PLANS
    PLANS = planned_sample()
    # One with an approach (any motion will do), and a third that cannot be executed.
    with h5py.File(PLANS, "r+") as file:
        plans = file["plans"]
        assert {formats.text(plans[path].attrs["status"]) for path in (FIRST, SECOND)} == {"executable"}
        plans.copy(plans[FIRST]["trajectory"], plans[FIRST], "approach")
        plans.copy(plans[FIRST]["trajectory"], plans[FIRST], "retreat")
        plans.copy(plans[SECOND], plans["ADL001AR1"], "001")
        other = plans["ADL001AR1/001"]
        other.attrs["status"], other.attrs["reason"] = b"infeasible", b"no_path"
        other.attrs["detail"] = b"a wall is in the way"
        del other["trajectory"]


def yaml_points(file):
    """Of a trajectory's YAML: frame, names of joints, {name: [T, n]}, seconds, nanoseconds."""
    text = file.read_text()
    head, points = text.split("points:\n")
    start, names = re.fullmatch(r"(header: .*)\njoint_names: \[(.*)\]\n", head).groups()
    frame = re.fullmatch(r'header: {stamp: {sec: 0, nanosec: 0}, frame_id: "(.*)"}', start).group(1)
    names = re.findall(r'"([^"]*)"', names)
    found = {}
    for key in ("positions", "velocities", "accelerations"):
        rows = [row.split(", ") for row in re.findall(rf"{key}: \[([^]]*)\]", points)]
        assert all(YAML_FLOAT.match(cell) for row in rows for cell in row)
        found[key] = np.array(rows, float)
    clock = re.findall(r"^- {positions: .*, time_from_start: \{sec: (\d+), nanosec: (\d+)\}}$", points, re.M)
    assert len(points.splitlines()) == len(clock)  # a line a point, and nothing else
    return frame, names, found, np.array(clock, int)


class Export(CommandCase):
    def exported(self, kind, *options):
        """The files written, by name."""
        out = self.folder / "out"
        printed = self.succeeds("export", PLANS, "--format", kind, "--out", out, "--unverified", *options).stdout
        self.assertIn("ADL001AR1/001 skipped: no_path: a wall is in the way\n", printed)
        self.assertIn(" and the index written, 1 plan skipped\n", printed)
        return {file.name: file for file in out.iterdir() if not file.name.startswith("index_")}

    def plan(self, path):
        file = h5py.File(PLANS)
        self.addCleanup(file.close)
        return file["plans"][path], list(file["robot/joint_names"].asstr())

    def test_csv_holds_every_number(self):
        files = self.exported("csv")
        self.assertEqual(sorted(files), ["ADL001AR1_000.csv", "ADL001DR2_000.csv",
                                         "ADL001DR2_000_approach.csv", "ADL001DR2_000_retreat.csv"])
        for name, path in (("ADL001DR2_000.csv", f"{FIRST}/trajectory"),
                           ("ADL001DR2_000_approach.csv", f"{FIRST}/approach"),
                           ("ADL001DR2_000_retreat.csv", f"{FIRST}/retreat"),
                           ("ADL001AR1_000.csv", f"{SECOND}/trajectory")):
            with open(files[name], newline="") as text:
                rows = list(csv.DictReader(text))
            trajectory, joints = self.plan(path)
            column = lambda key: np.array([row[key] for row in rows], float)
            for key, dataset in (("time_s", "time"), ("demonstration_time_s", "demonstration_time")):
                np.testing.assert_array_equal(column(key), trajectory[dataset][()])
            for dataset, unit in (("position", "rad"), ("velocity", "rad_s"), ("acceleration", "rad_s2")):
                values = np.stack([column(f"{joint}_{dataset}_{unit}") for joint in joints], axis=1)
                np.testing.assert_array_equal(values, trajectory[dataset][()])
            meaning = formats.text(trajectory["phase"].attrs["meaning"])
            names = dict(pair.split("=") for pair in meaning.split(","))
            self.assertEqual([row["phase"] for row in rows],
                             [names[str(phase)] for phase in trajectory["phase"][()]])
            self.assertEqual(len(rows[0]), 3 + 3 * len(joints))

    def test_ros_points_are_the_samples(self):
        files = self.exported("ros")
        self.assertEqual(sorted(files), ["ADL001AR1_000.yaml", "ADL001DR2_000.yaml",
                                         "ADL001DR2_000_approach.yaml", "ADL001DR2_000_retreat.yaml"])
        trajectory, joints = self.plan(f"{FIRST}/trajectory")
        frame, names, found, clock = yaml_points(files["ADL001DR2_000.yaml"])
        self.assertEqual((frame, names), ("base", joints))
        for key, dataset in (("positions", "position"), ("velocities", "velocity"),
                             ("accelerations", "acceleration")):
            np.testing.assert_array_equal(found[key], trajectory[dataset][()])
        nanoseconds = clock @ [10**9, 1]
        self.assertGreater(np.diff(nanoseconds).min(), 0)
        self.assertLess(clock[:, 1].max(), 10**9)
        np.testing.assert_allclose(nanoseconds, 1e9 * trajectory["time"][()], atol=0.51, rtol=0)
        # What joint_trajectory_controller asks of the last point.
        self.assertLess(np.abs(found["velocities"][-1]).max(), 1e-7)

    def test_ros_yaml_is_read_as_numbers(self):
        try:
            import yaml
        except ImportError:
            self.skipTest("python3-yaml is not installed")
        text = self.exported("ros")["ADL001DR2_000.yaml"].read_text().splitlines()
        message = yaml.safe_load("\n".join(text[:text.index("points:") + 1 + 20]))
        self.assertEqual(set(message), {"header", "joint_names", "points"})
        for point in message["points"]:
            self.assertEqual(set(point), {"positions", "velocities", "accelerations", "time_from_start"})
            for key in ("positions", "velocities", "accelerations"):
                self.assertEqual({type(value) for value in point[key]}, {float})

    def palm_and_tips_are_where_the_grasp_says(self, seen, grasp):
        sample, pose = grasp.attrs["sample"] - 1, grasp["object_pose"][()]
        tips = grasp["tips_in_object"][()] @ pose[:3, :3].T + pose[:3, 3]
        np.testing.assert_allclose(seen["tip_positions"][sample].reshape(-1, 3), tips, atol=1e-12)
        palm = pose @ grasp["palm_pose_in_object"][()]
        np.testing.assert_allclose(seen["palm_position"][sample], palm[:3, 3], atol=1e-12)
        w, x, y, z = seen["palm_orientation"][sample]
        turned = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]
        np.testing.assert_allclose(turned, palm[:3, 0], atol=1e-12)

    def test_robomimic_observes_the_target_that_all_have(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            del file["plans/ADL001AR1"]
        self.succeeds("export", copy, "--unverified", "--format", "robomimic", "--out", self.folder / "out")
        plan, _ = self.plan(FIRST)
        with h5py.File(self.folder / "out/robomimic.hdf5") as file:
            self.assertEqual([len(file["mask"][name]) for name in ("train", "valid")], [1, 0])
            seen = file["data/demo_0/obs/target_position"][()]
            np.testing.assert_array_equal(seen, np.tile(plan["grasp/object_pose"][:3, 3], (len(seen), 1)))

    def phases_are_segments(self, segments, phase):
        meaning = dict(pair.split("=") for pair in formats.text(phase.attrs["meaning"]).split(","))
        names = [meaning[str(number)] for number in phase[:-1]]
        begin, end = segments["begin"][()], segments["end"][()]
        self.assertEqual(list(begin), [0, *end[:-1]])
        told = [formats.text(name) for name in segments.attrs["names"]]
        self.assertEqual(sum(([name] * (b - a) for name, a, b in zip(told, begin, end)), []), names)
        self.assertEqual([a for a, b in zip(told, told[1:]) if a == b], [])

    def test_robomimic_reads_it(self):
        """What get_dataset_info.py and SequenceDataset of robomimic ask of a file."""
        with h5py.File(self.exported("robomimic", "--fps", 500)["robomimic.hdf5"], swmr=True, libver="latest") as file:
            data = file["data"]
            demos = sorted(data, key=lambda name: int(name[len("demo_"):]))
            self.assertEqual(demos, ["demo_0", "demo_1"])
            for held in file["mask"].values():
                self.assertLessEqual({name.decode("utf-8") for name in np.array(held)}, set(demos))
            self.assertEqual(sorted(len(held) for held in file["mask"].values()), [1, 1])
            meta = json.loads(data.attrs["env_args"])
            self.assertEqual(meta["env_name"], "pa10_dlr_hit2")
            self.assertIsInstance(meta["type"], int)
            self.assertEqual(meta["env_kwargs"]["control_freq"], 500)
            scale, offset = data.attrs["action_scale"], data.attrs["action_offset"]
            for name, path in zip(demos, (FIRST, SECOND)):
                demo, (plan, joints) = data[name], self.plan(path)
                position, count = plan["trajectory/position"][()], demo.attrs["num_samples"]
                self.assertEqual(count, len(position) - 1)
                self.assertEqual(formats.text(demo.attrs["plan"]), path)
                actions = demo["actions"][()]
                self.assertEqual(actions.shape, (count, len(joints)))
                self.assertLessEqual(np.abs(actions).max(), 1)
                np.testing.assert_allclose(demo["actions_abs"][()], position[1:], atol=1e-12)
                np.testing.assert_allclose(offset + scale * actions, position[1:], atol=1e-12)
                np.testing.assert_allclose(demo["obs/joint_positions"][()], position[:-1], atol=1e-12)
                np.testing.assert_allclose(demo["next_obs/joint_positions"][()], position[1:], atol=1e-12)
                self.phases_are_segments(demo["phases"], plan["trajectory/phase"])
                for key in ("rewards", "dones"):
                    np.testing.assert_array_equal(demo[key][()], np.r_[np.zeros(count - 1), 1])
                self.assertEqual(set(demo["obs"]), set(demo["next_obs"]))
                for key in demo["obs"]:
                    values, following = demo["obs"][key][()], demo["next_obs"][key][()]
                    self.assertEqual(values.ndim, 2)
                    self.assertTrue(np.isfinite(values).all())
                    np.testing.assert_array_equal(values[1:], following[:-1])
                # A reach without a grasp has no target, and all must be observed alike.
                self.assertNotIn("target_position", demo["obs"])
                if "grasp" in plan:
                    self.palm_and_tips_are_where_the_grasp_says(demo["next_obs"], plan["grasp"])
            self.assertEqual(data.attrs["total"], sum(data[name].attrs["num_samples"] for name in demos))

    def test_the_same_bytes_again_and_nothing_else_touched(self):
        kept = self.folder / "out/kept.csv"
        kept.parent.mkdir()
        kept.write_text("mine")
        for kind in ("csv", "ros", "robomimic"):
            first = {name: sha256(file) for name, file in self.exported(kind).items()}
            self.assertEqual({name: sha256(file) for name, file in self.exported(kind).items()}, first)
        self.assertEqual(kept.read_text(), "mine")
        self.assertFalse([name for name in first if name.endswith(".part")])

    def test_nothing_executable_is_no_error(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            del file["plans/ADL001DR2"], file["plans/ADL001AR1/000"]
        for kind in ("csv", "ros", "robomimic"):
            out = self.folder / kind
            self.assertIn("0 files and the index written, 1 plan skipped",
                          self.succeeds("export", copy, "--unverified", "--format", kind, "--out", out).stdout)
            index = json.loads((out / f"index_{kind}.json").read_text())
            self.assertEqual([file.name for file in out.iterdir()], [f"index_{kind}.json"])
            self.assertEqual((index["plans"], index["skipped"]), (
                [], [{"plan": "ADL001AR1/001", "reason": "no_path: a wall is in the way"}]))

    def test_a_script_can_tell_approximate_plans(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            file["plans"][FIRST].attrs["status"] = "approximate"
        self.succeeds("export", copy, "--unverified", "--format", "csv", "--out", self.folder / "csv")
        index = json.loads((self.folder / "csv/index_csv.json").read_text())
        self.assertEqual({plan["plan"]: plan["status"] for plan in index["plans"]},
                         {FIRST: "approximate", SECOND: "executable"})
        self.succeeds("export", copy, "--unverified", "--format", "robomimic", "--out", self.folder / "robomimic")
        with h5py.File(self.folder / "robomimic/robomimic.hdf5") as file:
            self.assertEqual({formats.text(demo.attrs["plan"]): formats.text(demo.attrs["status"])
                              for demo in file["data"].values()},
                             {FIRST: "approximate", SECOND: "executable"})

    def test_what_is_no_number_is_not_handed_on(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            file["plans"][FIRST]["trajectory/velocity"][7, 3] = np.nan
            time = file["plans"][SECOND]["trajectory/time"]
            time[5] = time[4]
        printed = self.succeeds("export", copy, "--unverified", "--format", "csv", "--out", self.folder / "out").stdout
        self.assertIn(f"{FIRST} skipped: the trajectory contains values that are not finite numbers", printed)
        self.assertIn(f"{SECOND} skipped: the trajectory's time does not increase", printed)

    def test_refuses(self):
        out = self.folder / "new/out"
        for arguments in ((PLANS, "--format", "rosbag"), (PLANS,), (self.folder / "no.h5", "--format", "csv")):
            result = morphe("export", *arguments, "--out", out)
            self.assertEqual(result.returncode, 2, result.stdout)
            self.assertFalse(out.parent.exists())


if __name__ == "__main__":
    main()
