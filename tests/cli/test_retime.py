"""The modes of retiming through the whole pipeline, and limits that are none."""
import re
import shutil

import h5py
import numpy as np

import formats
from support import (QUICK, RECORDINGS, SOURCE, CommandCase, json, line_of, main, morphe,
                     python_verify, replace)

MANIFEST = """\
format: vicon-csv
forward: recorded
recordings:
  - {file: drink.csv, static_trial: static.csv, name: drink, upper_arm: 0.274, forearm: 0.254}
"""
PLAN = "plans/drink/000"


class Retime(CommandCase):
    def setUp(self):
        super().setUp()
        shutil.copytree(SOURCE / "configs", self.folder / "configs")
        for name, recording in (("drink", "ADL001DR2"), ("static", "ADL001_static")):
            (self.folder / f"configs/pipelines/{name}.csv").symlink_to(RECORDINGS / f"{recording}.csv")
        self.config = self.folder / "configs/pipelines/pa10_dlr_hit2.yaml"
        self.robot = self.folder / "configs/robots/pa10.yaml"
        replace(self.config, r"\.\./\.\./datasets/ue-adl/recordings\.yaml", "recordings.yaml")
        (self.config.parent / "recordings.yaml").write_text(MANIFEST)

    def planned(self, **settings):
        """The plan with these settings of `retime`, and how often its time is the human's."""
        out = self.folder / "-".join(["out", *map(str, settings.values())])
        pairs = [f"retime.{key}={value}" for key, value in settings.items()]
        self.succeeds("run", self.config, "--out", out, *QUICK, *(x for p in pairs for x in ("--set", p)))
        plans = out / "plans.h5"
        self.assertEqual(self.json_of("verify", plans)["violations"], [])
        self.assertEqual(json.loads(python_verify(plans).stdout)["violations"], [])
        file = h5py.File(plans)
        self.addCleanup(file.close)
        return file[PLAN]

    def duration(self, plan):
        self.assertEqual(formats.text(plan.attrs["reason"]), "")
        time = plan["trajectory/time"][()]
        np.testing.assert_allclose(np.diff(time), 0.002, atol=1e-9)
        return time[-1]

    def test_each_mode_keeps_its_word(self):
        human, fastest = self.planned(), self.planned(mode="fastest")
        took_s = fastest.attrs["end_s"] - fastest.attrs["begin_s"]
        self.assertLess(self.duration(fastest), self.duration(human))
        self.assertGreater(self.duration(human), took_s)  # joints are too slow for this reach
        # At the human's tempo somewhere, nowhere above it.
        pace = np.diff(human["trajectory/demonstration_time"][()]) / 0.002
        self.assertLess(pace.max(), 1.03)
        self.assertGreater((pace > 0.97).mean(), 0.05)
        # The fastest is at a limit nearly all the time.
        with h5py.File(self.folder / "out-fastest/plans.h5") as file:
            limits = {name: file["robot"][name][()] for name in ("velocity", "acceleration", "jerk")}
        moved = fastest["trajectory"]
        jerk = np.diff(moved["acceleration"][()], axis=0) / 0.002
        used = np.maximum(np.abs(moved["velocity"][1:]) / limits["velocity"],
                          np.abs(moved["acceleration"][1:]) / limits["acceleration"])
        used = np.maximum(used, np.abs(jerk) / limits["jerk"]).max(axis=1)
        self.assertGreater(np.mean(used > 0.8), 0.5)
        stretched = self.planned(mode="duration", duration_s=3)
        self.assertAlmostEqual(self.duration(stretched), 3, delta=1e-9)
        for plan in (fastest, stretched):
            np.testing.assert_array_equal(plan["path/position"][()], human["path/position"][()])

    def test_a_duration_that_is_too_short_is_a_result(self):
        plan = self.planned(mode="duration", duration_s=0.3)
        self.assertEqual(formats.text(plan.attrs["status"]), "infeasible")
        self.assertEqual(formats.text(plan.attrs["reason"]), "duration_too_short")
        self.assertIn("cannot be followed in 0.3 s", formats.text(plan.attrs["detail"]))
        self.assertNotIn("trajectory", plan)

    def test_options_that_contradict_are_refused(self):
        out = self.folder / "out"
        for settings, word in ((["mode=quick"], "mode"), (["mode=duration"], "duration_s"),
                               (["duration_s=2"], "duration"), (["limit_scaling=1.5"], "limit_scaling"),
                               (["sample_rate_hz=.nan"], "sample_rate_hz"), (["max_tip_speed=0"], "max_tip_speed")):
            pairs = [x for setting in settings for x in ("--set", f"retime.{setting}")]
            result = morphe("run", self.config, "--out", out, *pairs)
            self.assertEqual(result.returncode, 2, (settings, result.stdout))
            self.assertIn(word, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1)
            self.assertFalse(out.exists())

    def test_limits_that_are_no_limits_of_a_joint_are_refused(self):
        line = line_of(self.robot, "name: S1,")
        for limit in ("velocity", "acceleration", "jerk"):
            for bad in ("0", "-1", ".nan"):
                text = self.robot.read_text()
                replace(self.robot, rf"{limit}: [\d.]+", f"{limit}: {bad}")
                result = morphe("run", self.config, "--out", self.folder / "out")
                self.refuses(result, f"{self.config.parent}/../robots/pa10.yaml:{line}", limit)
                self.robot.write_text(text)

    def test_without_limits_the_tempo_is_the_humans(self):
        text = self.robot.read_text()
        for limit in ("velocity", "acceleration", "jerk"):
            text = re.sub(rf"\b{limit}: [\d.]+", f"{limit}: 1000000", text)
        self.robot.write_text(text)
        hand = self.folder / "configs/robots/dlr_hit2.yaml"
        hand.write_text(re.sub(r"\b(velocity|acceleration|jerk): [\d.]+", r"\1: 1000000", hand.read_text()))
        plan = self.planned()
        self.assertAlmostEqual(plan["certificate"].attrs["duration_ratio"], 1, delta=5e-3)


if __name__ == "__main__":
    main()
