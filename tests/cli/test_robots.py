"""morphe run with several robots: one import, a folder each, one table. Takes half a minute of
processor time: nine shipped configs are run as they stand."""
import math

import h5py

from support import QUICK, REFERENCE, SOURCE, CommandCase, main, morphe, write_two_recordings


class Robots(CommandCase):
    def config(self, robots, **more):
        file = self.folder / "robots.yaml"
        lines = ["robots:", *(f"  - {robot}" for robot in robots), *(f"{k}: {v}" for k, v in more.items())]
        file.write_text("\n".join(lines) + "\n")
        return file

    def setUp(self):
        super().setUp()
        self.recordings = write_two_recordings(self.folder)

    def test_each_is_planned_as_by_itself(self):
        offset = "[0.1, -0.3, 0.25]"
        config = self.config([f"{{name: as_shipped, extends: {REFERENCE}}}",
                              f"{{name: lower, extends: {REFERENCE}, placement: {{shoulder_offset: {offset}}}}}"],
                             seed=3, dataset=f"{{file: {self.recordings}}}")
        out = self.folder / "out"
        done = self.succeeds("run", config, "--out", out, *QUICK)
        self.assertEqual(sorted(path.name for path in out.iterdir()), ["as_shipped", "demonstrations.h5", "lower"])
        rows = done.stdout.splitlines()
        self.assertRegex(rows[-2], r"^as_shipped +2 of 2 ")
        self.assertRegex(rows[-1], r"^lower +2 of 2 ")
        for name, own in (("as_shipped", ()), ("lower", ("--set", f"placement.shoulder_offset={offset}"))):
            alone = self.folder / name
            self.succeeds("run", REFERENCE, "--dataset", out / "demonstrations.h5", "--out", alone, *QUICK,
                          "--set", "seed=3", *own)
            compared = morphe("diff", out / name / "plans.h5", alone / "plans.h5")  # its inputs are others
            self.assertIn("2 plans in both, all equal", compared.stdout)
            self.succeeds("verify", out / name / "plans.h5")
        with h5py.File(out / "lower/plans.h5") as file:
            self.assertNotIn("\nrobots:", file.attrs["config"].decode())
        again = self.json_of("run", config, "--out", out, *QUICK)
        self.assertEqual([again["robots"][name]["reused"] for name in ("as_shipped", "lower")], [2, 2])
        from_file = self.folder / "from"
        self.succeeds("run", "--from", out / "lower/plans.h5", "--dataset", out / "demonstrations.h5", "--out", from_file)
        self.succeeds("diff", out / "lower/plans.h5", from_file / "plans.h5")  # equal

    def test_the_shipped_robots(self):
        """Seven combinations where morphe place put them: humanlike, and what they cannot is known. Of the
        whole search, since how humanlike they are is judged."""
        out = self.folder / "seven"
        report = self.json_of("run", SOURCE / "configs/pipelines/robots.yaml", "--out", out)
        self.assertEqual(len(report["robots"]), 7)
        for name, robot in report["robots"].items():
            # The two grippers are narrower than the widest cup.
            self.assertGreaterEqual(robot["executable"], 4 if name in ("fr3", "gen3_robotiq_2f85") else 5, name)
            self.succeeds("verify", out / name / "plans.h5")
            with h5py.File(out / name / "plans.h5") as file:
                certificates = [plan["certificate"].attrs for group in file["plans"].values() for plan in group.values()
                                if "certificate" in plan]
                angles = sorted(float(c["upper_arm_error_mean"]) for c in certificates
                                if not math.isnan(c["upper_arm_error_mean"]))
                # The FR3 hangs where its palm is a right angle off, and trades its upper arm for it.
                self.assertLess(math.degrees(angles[len(angles) // 2]), 35 if name == "fr3" else 15, name)

    def test_the_door_recordings_on_other_robots(self):
        for name in ("ur5e_shadow", "iiwa14_allegro"):
            out = self.folder / name
            report = self.json_of("run", SOURCE / f"configs/pipelines/{name}_adroit.yaml", "--out", out)
            self.assertGreaterEqual(report["executable"], 4, name)
            self.succeeds("verify", out / "plans.h5")

    def test_what_is_wrong_is_said_with_its_entry(self):
        both = f"{{file: {self.recordings}}}"
        entry = f"{{name: a, extends: {REFERENCE}}}"

        def refused(robots, line, *words):
            config = self.config(robots, dataset=both)
            result = morphe("run", config, "--out", self.folder / "out")
            self.refuses(result, f"{config}:{line}", *words)
            self.assertFalse((self.folder / "out").exists())

        refused([entry, entry], 3, "robots[1].name", "twice")
        refused([entry, f"{{name: ../b, extends: {REFERENCE}}}"], 3, "robots[1].name", "letters")
        refused([f"{{name: a, extends: {REFERENCE}, map: {{stars: 3}}}}"], 2, "robots[0].map.stars", "unknown key")
        refused([f"{{name: a, extends: {REFERENCE}, dataset: {both}}}"], 2, "robots[0].dataset", "the same for all")
        refused(["{name: a}"], 2, "robots[0].robot", "is missing")
        config = self.config([entry], dataset=both)
        self.refuses(morphe("place", config), f"{config}:2", "robots", "lists several robots")


if __name__ == "__main__":
    main()
