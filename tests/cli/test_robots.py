"""morphe run with several robots: one import, a folder each, one table."""
import h5py

from support import QUICK, REFERENCE, CommandCase, main, morphe, write_two_recordings


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
            self.assertIn("0 of 2 plans differ", compared.stdout)
            self.succeeds("verify", out / name / "plans.h5")
        with h5py.File(out / "lower/plans.h5") as file:
            self.assertNotIn("\nrobots:", file.attrs["config"].decode())
        again = self.json_of("run", config, "--out", out, *QUICK)
        self.assertEqual([again["robots"][name]["reused"] for name in ("as_shipped", "lower")], [2, 2])
        from_file = self.folder / "from"
        self.succeeds("run", "--from", out / "lower/plans.h5", "--dataset", out / "demonstrations.h5", "--out", from_file)
        self.succeeds("diff", out / "lower/plans.h5", from_file / "plans.h5")  # equal

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
        self.refuses(morphe("place", config), f"{config}:2", "robots", "has several")


if __name__ == "__main__":
    main()
