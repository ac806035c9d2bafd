"""`morphe simulate`: a grasp of the sample in physics; resumed, on any number of threads, the same bytes.
Takes 20 s of processor time: 30 grasps are simulated."""
import csv
import json
import shutil
import signal
import subprocess
import time
import unittest

import h5py

from support import MORPHE, CommandCase, main, morphe, planned_sample

GRASP, TABLE = "ADL001DR2/000", "simulation.csv"


def setUpModule():
    """One simulation is made once: several tests read it, or go on from a copy of it."""
    global PLANS, SIMULATED, PRINTED
    PLANS = planned_sample("--set", "grasp.close_fingers=true")
    with h5py.File(PLANS, "r+") as file:  # a second grasp, one that is infeasible, one that is broken
        plans = file["plans/ADL001DR2"]
        for copy in ("001", "002", "003"):
            plans.copy(plans["000"], copy)
        plans["002"].attrs["status"], plans["002"].attrs["reason"] = b"infeasible", b"no_path"
        del plans["002/trajectory"], plans["002/grasp"]
        plans["003/trajectory/position"][5, 2] = float("nan")
    probe = morphe("simulate", PLANS, "--out", PLANS.parent / "probe", "--only", "none")
    if "has no MuJoCo" in probe.stderr:
        assert probe.returncode == 2
        raise unittest.SkipTest("built without MuJoCo")
    SIMULATED = PLANS.parent / "simulated"
    done = morphe("simulate", PLANS, "--unverified", "--out", SIMULATED, *COARSE, "--rollouts", 2, "--jobs", 1)
    assert done.returncode == 0, done.stderr
    PRINTED = done.stdout


# A step twice as long as usual does for what is no question of physics.
COARSE = ("--load-directions", "none", "--time-step", 0.004)
FINE = ("--load-directions", "none")


def contents(folder):
    return {file.name: file.read_bytes() for file in folder.iterdir()}


class Simulate(CommandCase):
    def simulate(self, folder, *arguments, rollouts=2, how=COARSE):
        return self.succeeds("simulate", PLANS, "--unverified", "--out", self.folder / folder, *how, "--rollouts", rollouts,
                             *arguments)

    def rows(self, folder):
        return self.rows_of(self.folder / folder)

    def rows_of(self, folder):
        with open(folder / TABLE, newline="") as file:
            return list(csv.DictReader(file))

    def test_a_row_a_rollout_and_a_reason_for_every_plan_without(self):
        shutil.copytree(SIMULATED, self.folder / "out")
        self.assertEqual(self.simulate("out", "--json").stderr, "")
        rows = self.rows("out")
        by_plan = {name: [row for row in rows if row["plan"] == name] for name in
                   dict.fromkeys(row["plan"] for row in rows)}
        self.assertEqual(list(by_plan), [GRASP, "ADL001DR2/001", "ADL001DR2/002", "ADL001DR2/003",
                                         "ADL001AR1/000"])
        self.assertEqual([len(found) for found in by_plan.values()], [2, 2, 1, 1, 1])
        self.assertEqual([by_plan[name][0]["failure"] for name in list(by_plan)[2:]],
                         ["infeasible", "invalid_data", "no_grasp"])
        first, varied = by_plan[GRASP]
        self.assertEqual((first["friction"], first["mass_kg"]), ("0.8", "0.3"))
        self.assertNotEqual(varied["mass_kg"], "0.3")
        # The written trajectory is followed, whatever becomes of the grasp.
        self.assertLess(float(first["arm_error_deg"]), 0.2)
        self.assertLess(float(first["hand_error_deg"]), 1.0)
        self.assertIn("2 plans simulated, 3 skipped", PRINTED)
        self.assertIn("the plan is infeasible: no_path", PRINTED)

    def test_the_same_bytes_on_any_number_of_threads_and_after_a_kill(self):
        self.simulate("four", "--jobs", "4")
        self.assertEqual(contents(self.folder / "four"), contents(SIMULATED))
        arguments = [MORPHE, "simulate", PLANS, "--unverified", "--out", self.folder / "killed", *COARSE,
                     "--rollouts", "2", "--jobs", "1"]
        process = subprocess.Popen(list(map(str, arguments)), stdout=subprocess.DEVNULL)
        first = self.folder / "killed/ADL001DR2_000.json"
        while process.poll() is None and not first.exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertTrue(first.exists())
        before = first.stat().st_mtime_ns
        self.simulate("killed")
        self.assertEqual(first.stat().st_mtime_ns, before)  # what was done is not done again
        self.assertEqual(contents(self.folder / "killed"), contents(SIMULATED))

    def test_what_is_there_is_used_only_if_it_says_the_same(self):
        only = ("--only", GRASP)
        self.simulate("out", *only, rollouts=1)
        file = self.folder / "out/ADL001DR2_000.json"
        text = file.read_text()
        done = json.loads(text)
        self.assertEqual(done["format"], "morphe-simulation")
        self.assertEqual(len(done["rollouts"]), 1)
        file.write_text(text[:100])  # half of it: made anew
        self.simulate("out", *only, rollouts=1)
        self.assertEqual(file.read_text(), text)
        stamp = file.stat().st_mtime_ns
        self.simulate("out", *only, "--fresh", rollouts=1)
        self.assertNotEqual(file.stat().st_mtime_ns, stamp)
        self.assertEqual(file.read_text(), text)
        self.simulate("out", *only, "--friction", "0.01", rollouts=1)
        rows = self.rows("out")
        self.assertEqual((rows[0]["friction"], rows[0]["held"]), ("0.01", "0"))

    def test_nothing_of_the_engine_is_left_behind(self):
        self.succeeds("simulate", PLANS, "--unverified", "--out", "out", "--rollouts", "1", "--time-step", 0.004, "--only",
                      "ADL001DR2/001", cwd=self.folder)
        self.assertEqual([file.name for file in self.folder.iterdir()], ["out"])

    def test_glue_always_lifts_and_ice_never(self):
        for name, friction, torsional in (("glue", "2", "0.02"), ("ice", "0.01", "0.0001")):
            self.simulate(name, "--only", GRASP, "--friction", friction, "--torsional-friction", torsional,
                          how=FINE)
        self.assertEqual([row["held"] for row in self.rows("glue")], ["1"] * 2)
        self.assertEqual([row["held"] for row in self.rows("ice")], ["0"] * 2)

    def test_the_predicted_forces_tell_hold_from_fall(self):
        result = self.simulate("out", "--only", GRASP, "--friction-range", "0.1", "1.2",
                               "--mass-range", "0.05", "3", rollouts=6, how=FINE)
        rows = self.rows("out")
        for row in rows:
            required = float(row["required_force_lift_N"])
            ratio = float(row["commanded_force_N"]) / required
            foretold = "holds" if ratio >= 1.15 else "near_limit" if ratio >= 1 / 1.15 else "falls"
            self.assertEqual(row["forecast"], foretold)
            self.assertGreaterEqual(float(row["required_force_worst_N"]),
                                    0.98 * float(row["required_force_gravity_N"]))
            # It presses with what it is sent to.
            if row["failure"] not in ("displaced_while_closing", "no_opposing_contacts"):
                self.assertLess(abs(float(row["measured_force_N"]) - float(row["commanded_force_N"])), 2.5)
            self.assertEqual(row["contact_source"], "planned")
        self.assertEqual({row["held"] for row in rows}, {"0", "1"})
        self.assertIn("lifts foretold to hold or fall: right in", result.stdout)

    def test_a_plan_that_carries_its_target_is_executed_to_its_end(self):
        plans = planned_sample("--set", "segment.plan_until=return")
        # Glue: two fingers with the torsion of a real pad let a cup swing when the palm turns.
        result = self.succeeds("simulate", plans, "--out", self.folder / "out", *FINE, "--rollouts", 1, "--json",
                               "--friction", "2", "--torsional-friction", "0.02", "--only", GRASP)
        plan = json.loads(result.stdout)["plans"][0]
        self.assertEqual((plan["plan"], plan["tasks"]), (GRASP, 1))
        row, = self.rows("out")
        task = json.loads((self.folder / "out/ADL001DR2_000.json").read_text())["rollouts"][0]["task"]
        self.assertEqual(row["task"], task["failure"])
        self.assertEqual(plan["tasks_done"], 1 if task["failure"] == "none" else 0)
        self.assertEqual(float(row["rise_m"]), task["rise_m"])
        self.assertGreater(task["rise_m"], 0.2)  # to the mouth; a lift would end at 0.1 m
        self.assertLess(task["arm_error"], 1.0)
        # A plan that ends with its grasp is lifted.
        self.assertEqual({(row["task"], row["rise_m"]) for row in self.rows_of(SIMULATED)}, {("", "")})

    def test_a_file_of_servos(self):
        servos = self.folder / "servos.yaml"
        servos.write_text("index_proximal: {stiffness: 20}\n")
        self.simulate("plain", "--only", GRASP, rollouts=1)
        self.simulate("stiff", "--only", GRASP, "--servos", servos, rollouts=1)
        self.assertNotEqual(self.rows("plain"), self.rows("stiff"))
        servos.write_text("index: {stiffness: 20}\n")
        result = morphe("simulate", PLANS, "--unverified", "--out", self.folder / "none", "--servos", servos)
        self.refuses(result, f"{servos}:1: index")

    def test_wrong_arguments(self):
        def refused(*arguments):
            result = morphe("simulate", PLANS, "--out", self.folder / "out", *arguments)
            self.assertEqual(result.returncode, 2, result.stdout)
            self.assertEqual(result.stdout, "")
            self.assertFalse((self.folder / "out").exists())
            return result.stderr
        self.assertIn("--rollouts must be 1 to 10000", refused("--rollouts", "0"))
        self.assertIn("--friction: must be a number", refused("--friction", "nan"))
        self.assertIn("--time-step must be", refused("--time-step", "1"))
        self.assertIn("--mass must be above 0", refused("--mass", "-1"))
        self.assertIn("--load-directions", refused("--load-directions", "seven"))
        self.assertIn("--mass-range must be", refused("--mass-range", "3", "1"))
        self.assertIn("--frictoin", refused("--frictoin", "1"))
        self.assertEqual(morphe("simulate", PLANS).returncode, 2)

    def test_a_broken_file(self):
        out = self.folder / "out"
        self.refuses(morphe("simulate", self.folder / "none.h5", "--out", out), self.folder / "none.h5")
        broken = self.folder / "broken.h5"
        shutil.copy(PLANS, broken)
        with h5py.File(broken, "r+") as file:
            del file["plans/ADL001DR2/000/trajectory/velocity"]
        result = morphe("simulate", broken, "--out", out)
        self.refuses(result, f"{broken}:/plans/ADL001DR2/000/trajectory/velocity")
        self.assertFalse(out.exists())


if __name__ == "__main__":
    main()
