"""Two of the same command at once, for every command that writes: each works or is refused by one line, and
what is written is what one command alone writes. `--pairs N` repeats each pair N times (default 2; before a
release 200)."""
import shutil
import subprocess
import sys
from pathlib import Path

from many import ManyCase
from support import MORPHE, ONE_RECORDING, SOURCE, main, morphe, sha256, write_recordings

PAIRS = 2
if "--pairs" in sys.argv:
    PAIRS = int(sys.argv.pop(sys.argv.index("--pairs") + 1))
    sys.argv.remove("--pairs")

URDF = SOURCE / "configs/robots/urdf/fr3.urdf"
STUDY = """\
study: recordings
synthetic:
  - name: one
    config: synthetic.yaml
    quick_count: 1
    max_median_error_s: 10
"""
SMALL_PLACE = ("--candidates", 1, "--refine", 1, "--plan", 1, "--movements", 1)


def contents(folder):
    """{path: SHA-256} of all files, hidden ones too."""
    return {str(file.relative_to(folder)): sha256(file) for file in Path(folder).rglob("*") if file.is_file()}


class Pairs(ManyCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.base / "study.yaml").write_text(STUDY)
        for shard in (1, 2):
            ran = morphe(*cls.command(cls.base / f"shard{shard}", "--shard", f"{shard}/2"))
            assert ran.returncode == 0, ran.stderr
        cls.plans = cls.plain / "plans.h5"
        (cls.base / "recordings").mkdir()
        write_recordings(cls.base / "recordings", ONE_RECORDING)

    def pair(self, *command, may_differ=()):
        """`OUT` in the command stands for a folder that exists, `NEW` for one that does not."""
        out = self.folder / "pair"
        words = [MORPHE, *(str(word).replace("OUT", str(out)).replace("NEW", str(out / "new"))
                           for word in command)]
        expected = None
        for turn in range(-1, PAIRS):
            shutil.rmtree(out, ignore_errors=True)
            out.mkdir()
            processes = [subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                         for _ in range(2 if turn >= 0 else 1)]
            said = [process.communicate() for process in processes]
            codes = [process.returncode for process in processes]
            written = contents(out)
            for name in may_differ:
                written[name] = None
            if turn < 0:
                self.assertEqual(codes, [0], said)
                self.assertTrue(written)
                expected = written
                continue
            self.assertIn(0, codes, said)
            for code, (printed, complaint) in zip(codes, said):
                if code == 0:
                    continue
                self.assertEqual((code, printed), (2, ""), complaint)
                self.assertEqual(complaint.count("\n"), 1, complaint)
                self.assertIn(": another command is writing to it: wait until it has ended", complaint)
            self.assertEqual(written, expected, said)

    def test_export(self):
        for kind in ("csv", "ros-json", "robomimic"):
            self.pair("export", self.plans, "--format", kind, "--out", "NEW")
        self.pair("export", self.plans, "--format", "csv", "--out", "OUT", "--replace")

    def test_report(self):
        self.pair("report", self.plans, "--out", "OUT/page.html")
        self.pair("report", self.plans, "--svg", "NEW", "--worst", 2, "tip_error_max")
        self.pair("report", self.plans, "--out", "OUT/page.html", "--svg", "NEW", "--worst", 2, "tip_error_max")

    def test_merge(self):
        self.pair("merge", self.base / "shard1", self.base / "shard2", "--out", "NEW")

    def test_run(self):
        few = self.folder / "few.h5"
        self.succeeds("synthesize", self.base / "synthetic.yaml", "--out", few, "--count", 1)
        self.pair(*self.command("NEW", "--quiet", "--report", dataset=few), may_differ=["new/journal.sqlite"])

    def test_simulate(self):
        if "has no MuJoCo" in morphe("simulate", self.plans, "--out", self.folder / "probe").stderr:
            self.skipTest("built without MuJoCo")
        self.pair("simulate", self.plans, "--out", "NEW", "--rollouts", 1, "--quiet")

    def test_study(self):
        self.pair("study", self.base / "study.yaml", "--quick", "--quiet", "--out", "NEW")

    def test_place(self):
        self.pair("place", self.config, "--dataset", self.dataset, "--quiet", *SMALL_PLACE,
                  "--out", "OUT/placed.yaml", "--reach-map", "OUT/map.svg")

    def test_import(self):
        recordings = self.base / "recordings/recordings.yaml"
        self.pair("import", recordings, "--out", "OUT/in.h5")
        self.pair("import", recordings, "--out", "OUT/in.h5", "--clip", "NEW")
        lab = self.folder / "lab"
        lab.mkdir()
        shutil.copy(SOURCE / "datasets/adroit-dapg/door_demo_06.csv", lab)
        self.pair("import", lab, "--out", "OUT/in.h5")

    def test_synthesize(self):
        self.pair("synthesize", self.base / "synthetic.yaml", "--out", "OUT/in.h5", "--count", 1)

    def test_schema(self):
        self.pair("schema", "--out", "NEW")
        self.pair("schema", "robot", "--out", "OUT/robot.json")

    def test_robot(self):
        self.pair("robot", SOURCE / "configs/robots/pa10.yaml", "--svg", "OUT/robot.svg", "--urdf", "OUT/robot.urdf")
        self.pair("robot", "setup", URDF, "--out", "OUT/robot.yaml")


if __name__ == "__main__":
    main()
