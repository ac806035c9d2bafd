"""From a plan to a controller: `morphe export` with joint groups, rates, a delay and the ways from
home and back, held against an evaluation of the quintics in NumPy."""
import csv
import json
import shutil

import h5py
import numpy as np

from support import QUICK, SOURCE, CommandCase, main, morphe, sha256, shared_run

FROM_HOME = SOURCE / "configs/pipelines/pa10_dlr_hit2_from_home.yaml"
SMALL = (*QUICK, "--set", "map.key_frames=2", "--set", "map.reach_search_starts=4")
NAME, PLAN = "ADL001DR2_000", "plans/ADL001DR2/000"
ORDERS = ("position", "velocity", "acceleration")
LIMITS = ("velocity", "acceleration", "jerk")


def setUpModule():
    global PLANS
    PLANS = shared_run(FROM_HOME, *SMALL, dataset="one recording") / "out/plans.h5"
    with h5py.File(PLANS) as file:
        assert "approach" in file[PLAN] and "retreat" in file[PLAN], "the plan should be executable"


def powers(z, order):
    """[len(z), 6] derivative of 1, z, z^2 … of an order."""
    return np.stack([np.prod(np.arange(p, p - order, -1)) * z ** (p - order) if p >= order else 0 * z
                     for p in range(6)], axis=1)


class Curve:
    """A motion of the file between its samples: each piece from its six conditions, as a system of
    equations."""

    def __init__(self, group):
        self.time = group["time"][()]
        self.ends = np.stack([group[name][()] for name in ORDERS])  # [3, T, n]
        self.steps = np.diff(self.time)
        scale = self.steps[None, :, None] ** np.arange(3)[:, None, None]
        right = np.concatenate([self.ends[:, :-1] * scale, self.ends[:, 1:] * scale])
        conditions = np.concatenate([powers(np.array([z]), order) for z in (0.0, 1.0) for order in range(3)])
        self.coefficients = np.linalg.solve(conditions, right.reshape(6, -1)).reshape(right.shape)

    def __call__(self, t, order):
        """[len(t), n] of position (0), velocity, acceleration, jerk (3)."""
        t = np.atleast_1d(t)
        k = np.clip(np.searchsorted(self.time, t, side="right") - 1, 0, len(self.steps) - 1)
        rows = powers((t - self.time[k]) / self.steps[k], order)
        return np.einsum("tp,ptn->tn", rows, self.coefficients[:, k]) / self.steps[k][:, None] ** order


def read(file):
    """Times, names of the positions' columns, [3, T, n] of an exported CSV."""
    with open(file, newline="") as text:
        rows = list(csv.reader(text))
    head, cells = rows[0], [row[3:] for row in rows[1:]]
    values, n = np.array(cells, float), (len(head) - 3) // 3
    time = np.array([row[0] for row in rows[1:]], float)
    return time, head[3:3 + n], np.stack([values[:, :n], values[:, n:2 * n], values[:, 2 * n:]])


class Controllers(CommandCase):
    def exported(self, *options, plans=None):
        out = self.folder / "_".join(["out", *map(str, options)]).replace("/", "-")
        trust = ["--unverified"] if plans else []
        self.printed = self.succeeds("export", plans or PLANS, "--format", "csv", "--out", out, *options, *trust).stdout
        return out

    def open(self):
        file = h5py.File(PLANS)
        self.addCleanup(file.close)
        return file

    def test_any_rate_lies_on_the_certified_curve(self):
        file = self.open()
        limits = {name: file["robot"][name][()] for name in LIMITS}
        for rate in (1000, 500, 333.3, 60, 7):
            out = self.exported("--rate", rate)
            for what in ("", "_approach", "_retreat"):
                curve = Curve(file[PLAN][what[1:] or "trajectory"])
                time, _, rows = read(out / f"{NAME}{what}.csv")
                np.testing.assert_allclose(time[:-1], np.arange(len(time) - 1) / rate, atol=1e-12)
                self.assertEqual(time[-1], curve.time[-1])
                self.assertLessEqual(time[-1] - time[-2], (1 + 1e-6) / rate)
                np.testing.assert_array_equal(rows[:, -1], curve.ends[:, -1])
                for order in range(3):
                    np.testing.assert_allclose(rows[order], curve(time, order), rtol=0, atol=1e-9)
                self.limits_hold(time, rows, limits)

    def limits_hold(self, time, rows, limits):
        """At the points, and for one who only sees the positions: a difference quotient of a curve
        is a mean of its derivative."""
        for order, name in ((1, "velocity"), (2, "acceleration")):
            self.assertLessEqual((np.abs(rows[order]).max(0) / limits[name]).max(), 1 + 1e-6)
        quotient = rows[0]
        for order, name in enumerate(LIMITS, 1):
            if len(time) <= order:
                return
            quotient = order * np.diff(quotient, axis=0) / (time[order:] - time[:-order])[:, None]
            self.assertLessEqual((np.abs(quotient).max(0) / limits[name]).max(), 1 + 1e-4, name)

    def test_without_a_rate_points_are_the_samples(self):
        time, _, rows = read(self.exported() / f"{NAME}.csv")
        trajectory = self.open()[PLAN]["trajectory"]
        np.testing.assert_array_equal(time, trajectory["time"][()])
        for order, name in enumerate(ORDERS):
            np.testing.assert_array_equal(rows[order], trajectory[name][()])

    def test_groups_are_the_robot_parted(self):
        out = self.exported("--group", "arm,hand", "--group", "all", "--group", "thumb=thumb_abduction..thumb_middle")
        joints = list(self.open()["robot/joint_names"].asstr())
        parts = {name: read(out / f"{NAME}{end}.csv")
                 for name, end in (("arm", "_arm"), ("hand", "_hand"), ("all", ""), ("thumb", "_thumb"))}
        names = {name: [column.removesuffix("_position_rad") for column in part[1]] for name, part in parts.items()}
        self.assertEqual(names["all"], joints)
        self.assertEqual(names["arm"] + names["hand"], joints)
        self.assertEqual(names["arm"], ["S1", "S2", "S3", "E1", "E2", "W1", "W2"])
        self.assertEqual(names["thumb"], [joint for joint in joints if joint.startswith("thumb")])
        for name, (time, _, rows) in parts.items():
            np.testing.assert_array_equal(time, parts["all"][0])
            np.testing.assert_array_equal(rows, parts["all"][2][:, :, [joints.index(j) for j in names[name]]])
        self.assertTrue((out / f"{NAME}_approach_arm.csv").exists())

    def test_a_joined_motion_has_no_seam(self):
        file = self.open()
        robot, plan = file["robot"], file[PLAN]
        ways = [Curve(plan[name]) for name in ("approach", "trajectory", "retreat")]
        time, _, rows = read(self.exported("--approach", "joined") / f"{NAME}.csv")
        ends = np.cumsum([way.time[-1] for way in ways])
        self.assertEqual(len(time), sum(len(way.time) for way in ways) - 2)
        np.testing.assert_allclose(time[-1], ends[-1], rtol=0, atol=1e-12)
        self.assertGreater(np.diff(time).min(), 0)
        # The trajectory is as it was certified, the ways within what was left between them.
        first, after = len(ways[0].time) - 1, len(ways[0].time) + len(ways[1].time) - 1
        np.testing.assert_array_equal(rows[:, first:after], ways[1].ends)
        np.testing.assert_allclose(rows[0, :first], ways[0].ends[0, :-1], rtol=0, atol=1e-6)
        np.testing.assert_allclose(rows[0, after:], ways[2].ends[0, 1:], rtol=0, atol=1e-6)
        # Home and the end of the retreat stay where they were.
        np.testing.assert_array_equal(rows[:, 0], ways[0].ends[:, 0])
        np.testing.assert_allclose(rows[:, -1], ways[2].ends[:, -1], rtol=0, atol=1e-12)
        # One curve: a quintic between any two rows, within the limits over the seams too.
        whole = {"time": time, **dict(zip(ORDERS, rows))}
        curve = Curve({name: {(): value} for name, value in whole.items()})
        for seam in ends[:2]:
            for order, name in enumerate(LIMITS, 1):
                near = curve(np.linspace(seam - 0.01, seam + 0.01, 401), order)
                self.assertLessEqual((np.abs(near) / robot[name][()]).max(), 1 + 1e-6)
            for order in range(3):
                np.testing.assert_allclose(curve(seam - 1e-9, order), curve(seam + 1e-9, order), rtol=0, atol=1e-5)

    def test_joined_and_resampled_and_delayed(self):
        time, _, rows = read(self.exported("--approach", "joined", "--delay", 0.25) / f"{NAME}.csv")
        curve = Curve({name: {(): value} for name, value in {"time": time, **dict(zip(ORDERS, rows))}.items()})
        fine, _, at = read(self.exported("--approach", "joined", "--delay", 0.25, "--rate", 1000) / f"{NAME}.csv")
        np.testing.assert_allclose(fine[:-1], np.arange(len(fine) - 1) / 1000, atol=1e-12)
        self.assertEqual(fine[-1], time[-1])
        for order in range(3):
            np.testing.assert_allclose(at[order], curve(fine, order), rtol=0, atol=1e-9)
        waits = fine <= 0.25
        self.assertEqual(waits.sum(), 251)
        np.testing.assert_allclose(at[0, waits], np.tile(at[0, 0], (251, 1)), rtol=0, atol=1e-7)

    def test_the_ways_can_be_left_out(self):
        out = self.exported("--approach", "none")
        self.assertEqual(sorted(file.name for file in out.iterdir()), [f"{NAME}.csv", "index_csv.json"])

    def test_the_index_tells_a_script_what_to_run(self):
        out = self.exported("--group", "arm", "--group", "hand", "--rate", 250)
        index, file = json.loads((out / "index_csv.json").read_text()), self.open()
        self.assertEqual((index["format"], index["robot"], index["rate_hz"], index["resampled"], index["delay_s"],
                          index["approach"]), ("csv", "pa10_dlr_hit2", 250, True, 0, "apart"))
        self.assertEqual(index["config_sha256"], file.attrs["config_sha256"].decode())
        joints = list(file["robot/joint_names"].asstr())
        self.assertEqual(sum((group["joints"] for group in index["groups"].values()), []), joints)
        for name in ("lower", "upper", *LIMITS):
            values = sum((group[name] for group in index["groups"].values()), [])
            np.testing.assert_array_equal(values, file["robot"][name][()])
        (plan,) = index["plans"]
        self.assertEqual((plan["plan"], plan["status"], index["skipped"]), ("ADL001DR2/000", "executable", []))
        self.assertEqual([motion["motion"] for motion in plan["motions"]], ["approach", "trajectory", "retreat"])
        listed = {"index_csv.json"}
        for motion in plan["motions"]:
            self.assertEqual(list(motion["files"]), ["arm", "hand"])
            for name in motion["files"].values():
                time, _, _ = read(out / name)
                self.assertEqual((len(time), time[-1]), (motion["points"], motion["duration_s"]))
                listed.add(name)
        self.assertEqual({file.name for file in out.iterdir()}, listed)

    def test_json_and_yaml_are_one_message(self):
        for kind in ("ros", "ros-json"):
            self.succeeds("export", PLANS, "--format", kind, "--out", self.folder / "ros", "--group", "arm",
                          "--rate", 125)
        message = json.loads((self.folder / f"ros/{NAME}_arm.json").read_text())
        time, names, rows = read(self.exported("--group", "arm", "--rate", 125) / f"{NAME}_arm.csv")
        self.assertEqual(message["header"], {"stamp": {"sec": 0, "nanosec": 0}, "frame_id": "base"})
        self.assertEqual([f"{joint}_position_rad" for joint in message["joint_names"]], names)
        for order, key in enumerate(("positions", "velocities", "accelerations")):
            np.testing.assert_array_equal([point[key] for point in message["points"]], rows[order])
        clock = [point["time_from_start"] for point in message["points"]]
        np.testing.assert_allclose([t["sec"] + 1e-9 * t["nanosec"] for t in clock], time, rtol=0, atol=1e-9)
        text = (self.folder / f"ros/{NAME}_arm.yaml").read_text()
        self.assertEqual(text.count("\n"), 3 + len(message["points"]))  # a point a line
        try:
            import yaml
        except ImportError:
            return
        head = "\n".join(text.splitlines()[:3 + 20])
        self.assertEqual(yaml.safe_load(head), {**message, "points": message["points"][:20]})

    def test_another_run_is_not_replaced_in_silence(self):
        first = self.exported()
        before = {file.name: sha256(file) for file in first.iterdir()}
        self.succeeds("export", PLANS, "--format", "csv", "--out", first)  # the same again is nothing new
        other = self.folder / "other.h5"
        shutil.copy(PLANS, other)
        with h5py.File(other, "r+") as file:
            file[PLAN]["trajectory/velocity"][3, 0] += 1e-9
        result = morphe("export", other, "--unverified", "--format", "csv", "--out", first)
        self.refuses(result, first / f"{NAME}.csv", "already exists", "--replace")
        self.assertEqual({file.name: sha256(file) for file in first.iterdir()}, before)
        self.succeeds("export", other, "--unverified", "--format", "csv", "--out", first, "--replace")
        self.assertNotEqual(sha256(first / f"{NAME}.csv"), before[f"{NAME}.csv"])

    def test_motions_that_do_not_meet_are_left_out(self):
        for dataset, said in (("position", "does not end where the trajectory begins: the position of S1 jumps"),
                              ("velocity", "does not end where the trajectory begins: the velocity of S1 jumps")):
            broken = self.folder / f"{dataset}.h5"
            shutil.copy(PLANS, broken)
            with h5py.File(broken, "r+") as file:
                file[PLAN]["approach"][dataset][-1, 0] += 0.1
            self.exported("--approach", "joined", "--rate", 50, "--group", "arm", plans=broken)
            self.assertIn(said, self.printed)
            shutil.rmtree(self.folder / "out_--approach_joined_--rate_50_--group_arm")
        moving = self.folder / "moving.h5"
        shutil.copy(PLANS, moving)
        with h5py.File(moving, "r+") as file:
            file[PLAN]["trajectory/velocity"][0, 0] = 0.1
        self.exported("--delay", 1, "--approach", "none", plans=moving)
        self.assertIn("does not begin at rest: the velocity of S1 jumps by 0.1", self.printed)

    def test_what_is_wrong_names_what_to_do(self):
        plain = self.folder / "plain.h5"
        shutil.copy(PLANS, plain)
        with h5py.File(plain, "r+") as file:
            del file[PLAN]["approach"], file[PLAN]["retreat"]
        csv_of = ("--format", "csv")
        for plans, options, words in (
                (PLANS, (*csv_of, "--group", "leg"), ("--group leg: must be all, arm, hand", "FIRST..LAST")),
                (PLANS, (*csv_of, "--group", "a=S1..S9"), ("no joint 'S9'", "S1, S2")),
                (PLANS, (*csv_of, "--group", "a=S2..S1"), ("swap them",)),
                (PLANS, (*csv_of, "--group", "a=S1"), ("FIRST..LAST",)),
                (PLANS, (*csv_of, "--group", "../a=S1..S2"), ("'/'",)),
                (PLANS, (*csv_of, "--group", "arm", "--group", "arm"), ("already",)),
                (PLANS, (*csv_of, "--rate", "0"), ("--rate",)),
                (PLANS, (*csv_of, "--rate", "nan"), ("--rate",)),
                (PLANS, (*csv_of, "--delay", "-1"), ("--delay",)),
                (PLANS, (*csv_of, "--approach", "glued"), ("apart", "joined", "none")),
                (plain, (*csv_of, "--approach", "joined"), ("section `approach`", "omit --approach")),
                (PLANS, ("--format", "robomimic", "--group", "arm"), ("omit --group",)),
                (PLANS, ("--format", "robomimic", "--delay", "1"), ("omit --delay",))):
            out = self.folder / "new/out"
            result = morphe("export", plans, *options, "--out", out, *["--unverified"] * (plans == plain))
            self.assertEqual(result.returncode, 2, (options, result.stdout, result.stderr))
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertFalse(out.parent.exists(), options)

    def test_a_hand_alone_has_no_arm(self):
        hand = self.folder / "hand.h5"
        shutil.copy(PLANS, hand)
        with h5py.File(hand, "r+") as file:
            file["robot"].attrs["palm_frame"] = 0
            file["robot/frames/joint"][0] = -1
        result = morphe("export", hand, "--unverified", "--format", "csv", "--group", "arm", "--out", self.folder / "out")
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("has no joints of an arm: omit --group", result.stderr)

    def test_robomimic_at_a_rate(self):
        self.succeeds("export", PLANS, "--format", "robomimic", "--rate", 20, "--out", self.folder / "set")
        time, _, rows = read(self.exported("--rate", 20, "--approach", "none") / f"{NAME}.csv")
        with h5py.File(self.folder / "set/robomimic.hdf5") as file:
            demo = file["data/demo_0"]
            self.assertEqual(json.loads(file["data"].attrs["env_args"])["env_kwargs"]["control_freq"], 20)
            np.testing.assert_array_equal(demo["obs/joint_positions"][()], rows[0, :-1])
            np.testing.assert_array_equal(demo["actions_abs"][()], rows[0, 1:])


main()
