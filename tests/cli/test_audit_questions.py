"""A recording whose file is wrong about the laboratory: it is asked about, and what is to be pasted makes it
right. The truth is that of a shipped recording."""
import numpy as np

from recorded import Recorded, point_csv, vicon_csv
from support import QUICK, RECORDINGS, REFERENCE, TWO_RECORDINGS, main, morphe
from test_journeys import STATIC, TRIAL, Journey, recorded_from_csv


class WrongLaboratory(Journey):
    def setUp(self):
        super().setUp()
        self.trial, self.static = recorded_from_csv(TRIAL), recorded_from_csv(STATIC)

    def write(self, change):
        (self.folder / "reach.csv").write_text(vicon_csv(change(self.trial)))
        (self.folder / "static.csv").write_text(vicon_csv(change(self.static)))

    def expect_markers(self, file, truth, tolerance=2e-6):
        names, position, _ = self.stream_of(file, "markers")
        kept = [truth.names.index(name) for name in names]
        self.assertLess(np.nanmax(np.abs(position - truth.position[:, kept])), tolerance)

    def test_mirrored_along_any_axis(self):
        for axes in ("-x y z", "x -y z", "y x z"):
            with self.subTest(axes):
                self.write(lambda recorded: recorded.seen_as(axes))
                self.arrives("import", "reach.csv", "--static-trial", "static.csv", "--forward", "recorded",
                             "--out", "out.h5")
                self.assertEqual(self.tries, 2)
                self.assertIn("mirror image of a person's", self.said)
                self.assertIn(f"--axes '{axes}'", self.said.split("to paste:")[1])
                self.expect_markers(self.folder / "out.h5", self.trial)

    def test_mirrored_with_a_row_written_twice(self):
        """The answer is tested on the rows that the import uses."""
        self.write(lambda recorded: recorded.seen_as("-x y z"))
        rows = (self.folder / "reach.csv").read_text().splitlines(True)
        (self.folder / "reach.csv").write_text("".join([*rows[:60], *rows[59:]]))
        self.arrives("import", "reach.csv", "--static-trial", "static.csv", "--forward", "recorded",
                     "--out", "out.h5")
        self.assertIn("mirror image of a person's", self.said)
        self.expect_markers(self.folder / "out.h5", self.trial)

    def test_lying_on_the_side(self):
        self.write(lambda recorded: recorded.seen_as("x -z y"))
        self.arrives("import", "reach.csv", "--static-trial", "static.csv", "--forward", "recorded",
                     "--out", "out.h5")
        self.assertIn("does not stand upright: its up is y instead of z", self.said)
        self.expect_markers(self.folder / "out.h5", self.trial)

    def test_a_tenth_of_the_size(self):
        self.write(lambda recorded: Recorded(recorded.names, recorded.position / 10))
        self.arrives("import", "reach.csv", "--static-trial", "static.csv", "--forward", "recorded",
                     "--out", "out.h5")
        self.assertIn("--unit cm", self.said.split("to paste:")[1])
        self.expect_markers(self.folder / "out.h5", self.trial, 2e-5)

    def test_stated_axes_are_believed_and_flagged(self):
        self.write(lambda recorded: recorded.seen_as("-x y z"))
        run = self.succeeds("run", REFERENCE, "--dataset", self.folder / "reach.csv", "--static-trial",
                            self.folder / "static.csv", "--axes", "x y z", "--out", self.folder / "out",
                            "--set", "audit.refuse=[mirrored]")
        self.assertIn("doubtful_recording: the body is the mirror image", run.stdout)

    def test_one_of_a_dataset_is_skipped_with_its_reason(self):
        recorded = self.folder / "recorded"
        recorded.mkdir()
        for name in ("ADL001DR2.csv", "ADL001_static.csv"):
            (recorded / name).write_bytes((RECORDINGS / name).read_bytes())
        mirrored = recorded_from_csv(RECORDINGS / "ADL001FR1.csv").seen_as("-x y z")
        (recorded / "FR1.csv").write_text(vicon_csv(mirrored))
        run = morphe("run", REFERENCE, "--dataset", recorded, "--out", self.folder / "out", *QUICK)
        self.assertEqual(run.returncode, 1, run.stderr)
        self.assertIn("FR1.csv: axes: the body is the mirror image of a person's", run.stdout + run.stderr)
        self.assertIn("1 executable", run.stdout)


class WrongNames(Journey):
    def test_a_palm_taken_for_the_wrist_gets_no_unit_that_nobody_writes(self):
        rng = np.linspace(0, 1, 60)[:, None]
        palm = np.hstack([0.2 + 0 * rng, 0.3 + 0.2 * rng, 0.8 + 0 * rng])
        offsets = {"right_palm": (0, 0, 0), "right_index_tip": (-0.056, 0.049, 0.019),
                   "right_thumb_tip": (-0.056, -0.027, 0.027), "right_index_mcp": (0, 0, 0.021)}
        points = np.stack([palm + np.array(offset) for offset in offsets.values()], axis=1)
        (self.folder / "palm.csv").write_text(point_csv(Recorded(offsets, points), metres=1, time="time"))
        asked = morphe("import", "palm.csv", "--out", "out.h5", cwd=self.folder)
        self.assertEqual(asked.returncode, 2)
        self.assertIn("--unit m: a guess", asked.stderr)
        self.assertIn("the names cannot be right", asked.stderr)


if __name__ == "__main__":
    main()
