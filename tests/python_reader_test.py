#!/usr/bin/python3
"""The package morphe (python/): what it reads is what the program and HDF5 say, what it computes is what the program
and the judge in Python compute, and each error names file and place.

python_reader_test.py MORPHE [unittest options]
"""
import csv
import importlib.util
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests/cli")]
sys.dont_write_bytecode = True
import morphe  # noqa: E402
from support import MORPHE, QUICK, CommandCase, carried_run, from_home_run, main, shared_run  # noqa: E402
from verify_geometry import Robot as IndependentRobot  # noqa: E402

FIRST = "ADL001DR2/000"
# The same polynomial in another order of operations. A derivative has the rounding of its terms, which is larger by
# one over the step for each order.
ROUNDING = 1e-12


def setUpModule():
    global HOME, CARRIED, FR3
    HOME, CARRIED = from_home_run(), carried_run()
    FR3 = shared_run(ROOT / "configs/pipelines/fr3.yaml", *QUICK, "--report") / "out/plans.h5"


class Reads(CommandCase):
    def test_everything_that_is_stored(self):
        for path in (HOME, CARRIED, FR3):
            with h5py.File(path) as file, morphe.Plans(path) as plans:
                self.assertEqual(list(plans.names), [f"{d}/{m}" for d in file["plans"] for m in file["plans"][d]])
                self.assertEqual([joint.name for joint in plans.robot.joints], list(file["robot/joint_names"].asstr()))
                for limit in ("lower", "upper", "velocity", "acceleration", "jerk"):
                    self.assertEqual([getattr(joint, limit) for joint in plans.robot.joints], file["robot"][limit][()].tolist())
                self.assertEqual([joint.unit for joint in plans.robot.joints], ["rad"] * 7 + (["m"] if path == FR3 else ["rad"] * 15))
                for plan in plans:
                    self.same_plan(plan, file["plans"][plan.name])

    def same_plan(self, plan, group):
        for name in ("status", "reason", "detail", "subject", "task", "hand", "target", "source", "licence"):
            self.assertEqual(getattr(plan, name), group.attrs[name].decode(), name)
        for name, value in group["certificate"].attrs.items():
            np.testing.assert_equal(getattr(plan.certificate, name), value)
        for name in ("trajectory", "approach", "retreat"):
            motion = getattr(plan, name)
            self.assertEqual(motion is None, name not in group)
            for rows in ("time", "position", "velocity", "acceleration", "demonstration_time", "clearance") if motion else ():
                np.testing.assert_array_equal(getattr(motion, rows), group[name][rows][()])
        self.assertEqual([phase.name for phase in plan.phases], list(group["phases/name"].asstr()))
        self.assertEqual([each.cause for each in plan.findings], list(group["findings/cause"].asstr()))
        np.testing.assert_array_equal(plan.goals.tip_position, group["goals/tip_position"][()])
        self.assertEqual({each.name for each in plan.scene}, set(group["scene"]))
        contacts = group.get("grasp/contacts")
        if contacts is not None:
            np.testing.assert_array_equal([each.point for each in plan.grasp.contacts], contacts["point"][()])
            self.assertEqual(plan.grasp.quality.epsilon_lower, group["grasp/quality"].attrs["epsilon_lower"])

    def test_the_program_lists_the_same(self):
        for path in (HOME, CARRIED, FR3):
            listed = self.json_of("list", path)
            with morphe.Plans(path) as plans:
                self.assertEqual([each.__dict__ for each in plans.assumptions], listed["assumptions"])
                for row, plan in zip(listed["plans"], plans, strict=True):
                    self.assertEqual((row["plan"], row["reason"]), (plan.name, plan.reason))
                    if plan.trajectory:
                        for name in ("clearance", "tip_error_max", "duration_ratio", "duration"):
                            value = plan.duration if name == "duration" else getattr(plan.certificate, name)
                            self.assertAlmostEqual(row["figures"][name], value, 12)
                        self.assertEqual({each["kind"]: each["clearance"] for each in row["clearances"]},
                                         {each.kind: each.clearance for each in plan.certificate.clearance_by_kind})

    def test_assumptions_are_those_of_the_program(self):
        for path in (HOME, CARRIED, FR3):
            told = {(each["kind"], each["subject"]) for each in self.json_of("verify", path)["assumptions"]}
            with morphe.Plans(path) as plans:
                read = {(each.kind, each.subject) for plan in plans for each in plan.assumptions}
                self.assertEqual(read, told)
                plan = plans[0]
                self.assertEqual(sum(len(plan.assumptions_of(kind)) for kind in morphe.ASSUMPTION_KINDS), len(plan.assumptions))
                self.assertIn("torque", [each.subject for each in plan.assumptions_of("not_looked_at")])
                with self.assertRaisesRegex(ValueError, "unknown kind 'guessed'; the kinds are inferred, "):
                    plan.assumptions_of("guessed")

    def test_filters(self):
        with morphe.Plans(FR3) as plans:
            (infeasible,) = plans.select(status="infeasible")
            self.assertEqual(infeasible.reason, "goal_in_collision")
            with self.assertRaisesRegex(morphe.NoTrajectoryError, f"^{infeasible.name} has no trajectory: infeasible, goal_in_collision: "):
                infeasible.at(0)
            self.assertEqual(len(list(plans.select(status=("executable", "approximate", "partial")))), len(plans) - 1)
            self.assertEqual([plan.name for plan in plans.select(demonstration="ADL001FR1", target="")], ["ADL001FR1/000"])
            grasps = list(plans.select(where=lambda plan: plan.grasp is not None and plan.trajectory is not None))
            self.assertTrue(grasps and all(plan.target == "cup" for plan in grasps))
            with self.assertRaisesRegex(ValueError, "unknown status 'feasible'; the statuses are executable, "):
                list(plans.select(status="feasible"))
            with self.assertRaisesRegex(KeyError, f"no plan 'ADL001DR2/00'; did you mean '{FIRST}'"):
                plans["ADL001DR2/00"]
            self.assertEqual(plans[len(plans) - 1].name, plans.names[-1])
            self.assertIn(b"<robot", plans.read_input("robots/urdf/fr3.urdf"))


class Curve(CommandCase):
    def test_every_motion_is_what_the_program_exports(self):
        out = self.folder / "out"
        self.succeeds("export", HOME, "--format", "csv", "--rate", "137", "--out", out)
        with morphe.Plans(HOME) as plans:
            plan = plans[FIRST]
        for motion, suffix in ((plan.trajectory, ""), (plan.approach, "_approach"), (plan.retreat, "_retreat")):
            with open(out / f"ADL001DR2_000{suffix}.csv", newline="") as text:
                rows = list(csv.DictReader(text))
            time = np.array([row["time_s"] for row in rows], float)
            np.testing.assert_array_equal(motion.times(137), time)
            state, step = motion.at(time), np.diff(motion.time).min()
            for order, (name, unit) in enumerate((("position", "rad"), ("velocity", "rad_s"), ("acceleration", "rad_s2"))):
                told = np.array([[row[f"{joint}_{name}_{unit}"] for joint in motion.joints] for row in rows], float)
                np.testing.assert_allclose(getattr(state, name), told, rtol=0, atol=ROUNDING / step**max(order - 1, 0))
            told = np.array([row["demonstration_time_s"] for row in rows], float)
            np.testing.assert_allclose(motion.demonstration_time_at(time), told, rtol=0, atol=ROUNDING)

    def test_samples_are_what_is_stored(self):
        with morphe.Plans(CARRIED) as plans:
            motion = plans[FIRST].trajectory
        for name in ("position", "velocity", "acceleration"):
            np.testing.assert_array_equal(getattr(motion.at(motion.time), name), getattr(motion, name))
            np.testing.assert_array_equal(getattr(motion.at(motion.time[7]), name), getattr(motion, name)[7])

    def test_each_derivative_is_that_of_the_one_before(self):
        with morphe.Plans(CARRIED) as plans:
            motion = plans[FIRST].trajectory
        step = 1e-6
        time = (motion.time[:-1] + motion.time[1:]) / 2
        before, here, after = motion.at(time - step), motion.at(time), motion.at(time + step)
        for name, derivative in (("position", "velocity"), ("velocity", "acceleration"), ("acceleration", "jerk")):
            slope = (getattr(after, name) - getattr(before, name)) / (2 * step)
            np.testing.assert_allclose(getattr(here, derivative), slope, rtol=1e-6, atol=1e-5)

    def test_limits_are_used_as_the_certificate_says(self):
        for path in (HOME, FR3):
            with morphe.Plans(path) as plans:
                for plan in plans.select(status="executable"):
                    states = [motion.at(np.linspace(0, motion.duration, 4000)) for motion in (plan.trajectory,)]
                    for name in ("velocity", "acceleration", "jerk"):
                        limits = np.array([getattr(joint, name) for joint in plan.robot.joints])
                        used = max(np.max(np.abs(getattr(state, name)) / limits) for state in states)
                        certified = getattr(plan.certificate, f"{name}_ratio")
                        self.assertLessEqual(used, certified * (1 + 1e-6))
                        self.assertGreater(used, 0.5 * certified)

    def test_nothing_outside(self):
        with morphe.Plans(CARRIED) as plans:
            plan = plans[FIRST]
        end = plan.duration
        np.testing.assert_array_equal(plan.at(end + 1e-10).position, plan.trajectory.position[-1])
        for time in (-0.001, end + 0.001, np.nan, [0, end + 1]):
            with self.assertRaisesRegex(ValueError, "is outside the trajectory, which lasts from 0.0 to"):
                plan.at(time)
        with self.assertRaisesRegex(ValueError, "a rate must be above 0, not 0 Hz"):
            plan.trajectory.times(0)
        self.assertEqual(plan.at([[0, 0.1, 0.2]]).jerk.shape, (1, 3, len(plan.robot.joints)))


class Kinematics(CommandCase):
    def test_frames_are_those_of_the_independent_judge(self):
        for path in (HOME, FR3):
            with h5py.File(path) as file, morphe.Plans(path) as plans:
                independent = IndependentRobot(file["robot"])
                plan = next(plans.select(status="executable"))
                time = np.linspace(0, plan.duration, 40)
                expected = independent.frame_poses(plan.at(time).position)[:, :-1]
                np.testing.assert_allclose(plan.frame_poses(time), expected, rtol=0, atol=ROUNDING)

    def test_palm_and_tips_are_where_the_grasp_says(self):
        for path in (HOME, CARRIED, FR3):
            with morphe.Plans(path) as plans:
                for plan in plans.select(target="cup", status="executable"):
                    grasp = plan.grasp
                    time = plan.trajectory.time[grasp.sample]
                    np.testing.assert_allclose(plan.palm_pose(time), grasp.object_pose @ grasp.palm_pose_in_object, rtol=0, atol=1e-9)
                    tips = grasp.tips_in_object @ grasp.object_pose[:3, :3].T + grasp.object_pose[:3, 3]
                    np.testing.assert_allclose(plan.tip_poses(time)[:, :3, 3], tips, rtol=0, atol=1e-9)

    def test_wrong_names_and_shapes(self):
        with morphe.Plans(FR3) as plans:
            robot = plans.robot
        with self.assertRaisesRegex(KeyError, "the robot has no joint 'fr3_joint9'; did you mean 'fr3_joint"):
            robot.joint_index("fr3_joint9")
        self.assertEqual(robot.frames[robot.frame_index(robot.frames[3].name)].name, robot.frames[3].name)
        with self.assertRaisesRegex(ValueError, r"has 8 joints, but the positions have the shape \[7\]"):
            robot.tip_poses(np.zeros(7))


class Refuses(CommandCase):
    def altered(self, change):
        path = Path(shutil.copy(CARRIED, self.folder / "plans.h5"))
        with h5py.File(path, "r+") as file:
            change(file)
        return path

    def refused(self, path, place, problem):
        with self.assertRaises(morphe.FileError) as caught:
            with morphe.Plans(path) as plans:
                list(plans)
        error = caught.exception
        file = str(path / "plans.h5" if path.is_dir() else path)
        self.assertEqual((error.file, error.path), (file, place))
        self.assertIn(problem, error.problem)
        self.assertEqual(str(error).count("\n"), 0)
        self.assertTrue(str(error).startswith(f"{file}: {place}"))

    def test_files_that_are_no_plans(self):
        self.refused(self.folder / "none.h5", "", "does not exist")
        self.refused(self.folder, "", "does not exist")
        (self.folder / "text.h5").write_text("no HDF5")
        self.refused(self.folder / "text.h5", "", "is not a readable HDF5 file")
        (self.folder / "cut.h5").write_bytes(CARRIED.read_bytes()[:100000])
        self.refused(self.folder / "cut.h5", "", "is not a readable HDF5 file")
        self.refused(CARRIED.parent / "demonstrations.h5", "/@format", "is 'morphe-demonstrations', not 'morphe-plans'")
        self.refused(self.altered(lambda file: file.attrs.modify("version", 2)), "/@version", "is 2, but this package reads version 3")

    def test_each_part_that_is_missing_or_wrong(self):
        plan = f"plans/{FIRST}"
        samples = f"/{plan}/trajectory/time"

        def replaced(name, values):
            def change(file):
                attributes = dict(file[name].attrs)
                del file[name]
                file[name] = values
                file[name].attrs.update(attributes)
            return change

        def external(file):
            del file[samples]
            file[samples] = h5py.ExternalLink("other.h5", "/x")

        def elsewhere(file):
            del file[samples]
            file.create_dataset(samples, (9,), "f8", external=[(str(self.folder / "other"), 0, h5py.h5f.UNLIMITED)])

        def virtual(file):
            layout = h5py.VirtualLayout((9,), "f8")
            layout[:] = h5py.VirtualSource("other.h5", "x", (9,))
            del file[samples]
            file.create_virtual_dataset(samples, layout)

        def unlike(name):
            return lambda file: file[plan].attrs.__setitem__(name, np.bytes_("fine"))

        for place, problem, change in (
                (samples, "is missing", lambda file: file.__delitem__(samples)),
                (samples, "is a link, which a plans.h5 does not have", external),
                (samples, "has its values in another file", elsewhere),
                (samples, "has its values in another file", virtual),
                (f"/{plan}/grasp@sample", "is 100000, which is no sample", lambda file: file[f"{plan}/grasp"].attrs.modify("sample", 100000)),
                (samples, "does not increase strictly", replaced(samples, np.zeros(9))),
                (samples, "is not a dataset", lambda file: (file.__delitem__(samples), file.create_group(samples))),
                (f"/{plan}/trajectory/position", "has the shape [3, 22], not [", replaced(f"{plan}/trajectory/position", np.zeros((3, 22)))),
                (f"/{plan}/trajectory/phase", "has the value 99", lambda file: file[f"{plan}/trajectory/phase"].__setitem__(3, 99)),
                (f"/{plan}/trajectory", "is missing, but the plan is executable", lambda file: file.__delitem__(f"{plan}/trajectory")),
                (f"/{plan}@status", "is 'fine', not executable, ", unlike("status")),
                (f"/{plan}@begin_s", "is not a number", unlike("begin_s")),
                (f"/{plan}/grasp/contacts/point", "is missing", lambda file: file.__delitem__(f"{plan}/grasp/contacts/point")),
                ("/robot/frames/parent", "of frame 4 is 7, which is not a frame before it",
                 lambda file: file["robot/frames/parent"].__setitem__(4, 7)),
                ("/robot/lower", "does not contain numbers", replaced("robot/lower", np.array([b"a"] * 22))),
                ("/robot@palm_frame", "names the frame 99", lambda file: file["robot"].attrs.modify("palm_frame", 99)),
        ):
            with self.subTest(f"{place}: {problem}"):
                self.refused(self.altered(change), place, problem)


class Verifies(CommandCase):
    def test_the_verdict_is_the_programs(self):
        self.assertEqual(morphe.verify(FR3.parent, program=MORPHE), morphe.Verdict(4, 0, 0, 1))
        self.assertEqual(morphe.verify(CARRIED, program=MORPHE, dataset=CARRIED.parent / "demonstrations.h5").executable, 2)

    def test_a_lie_is_raised_with_its_place(self):
        path = Path(shutil.copy(CARRIED, self.folder / "plans.h5"))
        with h5py.File(path, "r+") as file:
            file[f"plans/{FIRST}/trajectory/position"][5, 0] += 0.5
        with self.assertRaises(morphe.VerifyError) as caught, mock.patch.dict(os.environ, MORPHE=str(MORPHE)):
            morphe.verify(path)
        told = json.loads(subprocess.run([MORPHE, "verify", path, "--json"], capture_output=True, text=True).stdout)["violations"]
        self.assertEqual(caught.exception.violations, told)
        first = told[0]
        self.assertTrue(str(caught.exception).startswith(f"{path}: {FIRST}: {first['cause']} of {first['subject']} at "), str(caught.exception))

    def test_no_verdict_is_an_error(self):
        with self.assertRaisesRegex(morphe.Error, "no such program, so nothing was verified"):
            morphe.verify(CARRIED, program=self.folder / "none")
        (self.folder / "text.h5").write_text("no HDF5")
        with self.assertRaisesRegex(morphe.Error, "text.h5: is not a readable HDF5 file"):
            morphe.verify(self.folder / "text.h5", program=MORPHE)
        with self.assertRaisesRegex(morphe.FileError, "none.h5: does not exist"):
            morphe.verify(self.folder / "none.h5", program=MORPHE)


class Plots(CommandCase):
    def test_a_picture(self):
        if importlib.util.find_spec("matplotlib") is None:
            self.skipTest("python3-matplotlib is not installed")
        with morphe.Plans(HOME) as plans:
            figure = morphe.plot(plans[FIRST], joints=["S1", "E1"])
        self.assertEqual([len(axes.lines) for axes in figure.axes], [2, 4, 2])
        figure.savefig(self.folder / "plan.png")
        self.assertEqual((self.folder / "plan.png").read_bytes()[1:4], b"PNG")

    def test_without_matplotlib_it_says_what_to_install(self):
        with morphe.Plans(HOME) as plans, mock.patch.dict(sys.modules, {"matplotlib": None, "matplotlib.figure": None}):
            with self.assertRaisesRegex(ImportError, "morphe.plot needs matplotlib: apt install python3-matplotlib"):
                morphe.plot(plans[FIRST])


class Shown(CommandCase):
    """What the documents show runs, in a process of its own that has the package alone."""

    def python(self, *words, path=ROOT / "python", python=sys.executable):
        done = subprocess.run([python, "-B", *map(str, words)], cwd=self.folder, capture_output=True, text=True, env={
            "PATH": f"{MORPHE.parent}:/usr/bin:/bin", "PYTHONPATH": str(path), "XDG_CACHE_HOME": os.environ["XDG_CACHE_HOME"]})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_examples_of_the_documents(self):
        (self.folder / "outputs/sample").mkdir(parents=True)
        os.symlink(HOME, self.folder / "outputs/sample/plans.h5")
        ran = 0
        for page in ("docs/python.md", "python/README.md"):
            for number, example in enumerate(re.findall(r"^```python\n(.*?)^```$", (ROOT / page).read_text(encoding="utf-8"), re.M | re.S)):
                if "morphe.plot" in example and importlib.util.find_spec("matplotlib") is None:
                    continue
                with self.subTest(f"{page}, example {number + 1}"):
                    self.python("-c", example)
                    ran += 1
        self.assertGreater(ran, 3)

    def test_the_script(self):
        said = self.python(ROOT / "examples/python/read_plans.py", FR3)
        self.assertLessEqual(len((ROOT / "examples/python/read_plans.py").read_text().splitlines()), 25)
        self.assertTrue(said.startswith("fr3, 8 joints, written by morphe "), said)
        self.assertIn("ADL006DR2/000: infeasible: goal_in_collision: ", said)
        self.assertRegex(said, rf"{FIRST}: executable, \d\.\d{{3}} s, \d+\.\d\d mm clear\n")
        self.assertIn("  grasps cup at ", said)

    def test_the_wheel_in_an_environment_of_its_own(self):
        pips = sorted(Path("/usr/share/python-wheels").glob("pip-*.whl"))  # of python3-venv
        if not pips or any(importlib.util.find_spec(name) is None for name in ("build", "setuptools", "wheel")):
            self.skipTest("packages_wheel.txt and python3-venv are not installed")
        done = subprocess.run([ROOT / "scripts/wheel", "--out", self.folder / "wheel"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        wheel = Path(done.stdout.strip())
        self.assertEqual(wheel.name, f"morphe-{morphe.__version__}-py3-none-any.whl")
        here = self.folder / "environment"
        # To run pip from its wheel takes a third of the time of installing it first.
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", here], check=True, capture_output=True)
        # Debian's h5py has a name of its own for pip, which does not find it.
        subprocess.run([here / "bin/python", pips[-1] / "pip", "install", "--no-index", "--no-deps", "--quiet", wheel],
                       check=True, capture_output=True)
        said = self.python("-c", f"import morphe; print(morphe.__file__); print(len(morphe.Plans({str(FR3)!r})))",
                           path="", python=here / "bin/python")
        file, count = said.split()
        self.assertTrue(file.startswith(f"{here}/lib/"), file)
        self.assertEqual(count, "5")
        self.assertTrue((Path(file).parent / "py.typed").exists())

    def test_one_version_and_its_types(self):
        version = re.search(r"^project\(morphe VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
        self.assertEqual(morphe.__version__, version)
        if shutil.which("mypy") is None:
            self.skipTest("mypy is not installed")
        done = subprocess.run(["mypy", "--cache-dir", MORPHE.parent / "shared_runs/mypy", "--config-file", "pyproject.toml"],
                              cwd=ROOT / "python", capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


if __name__ == "__main__":
    main()
