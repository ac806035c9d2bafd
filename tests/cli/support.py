"""What the end-to-end tests share. Every test file is a script of its own:
/usr/bin/python3 -B test_run.py BUILD/morphe [unittest options]"""
import fcntl
import hashlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from unittest import mock

SOURCE = Path(__file__).resolve().parents[2]
sys.path.append(str(SOURCE / "tests"))
MORPHE = Path(sys.argv.pop(1)).resolve()
REFERENCE = SOURCE / "configs/pipelines/pa10_dlr_hit2.yaml"
RECORDINGS = SOURCE / "datasets/ue-adl"
# Which plans this program has accepted is not noted in the cache of whoever runs the tests.
os.environ["XDG_CACHE_HOME"] = str(MORPHE.parent / "shared_runs/cache")

# A search so small that a movement takes a second. What it finds is no good measure of the mapping.
QUICK = ("--set", "map.starts=4", "--set", "map.candidates=1", "--set", "map.coarse_step_s=0.1")
HOME = {"S1": 1.6, "S2": -1.2, "S3": -1.7, "E1": 1.7, "E2": -1.5, "W1": 0.3, "W2": 0.2}  # rad
TWO_RECORDINGS = """\
format: vicon-csv
hand: right
recordings:
  - {file: recorded/ADL001DR2.csv, static_trial: recorded/ADL001_static.csv, upper_arm: 0.274, forearm: 0.254}
  - {file: recorded/ADL001AR1.csv, static_trial: recorded/ADL001_static.csv, upper_arm: 0.274, forearm: 0.254}
"""
ONE_RECORDING = TWO_RECORDINGS.rpartition("  - ")[0]


def morphe(*arguments, cwd=None):
    return subprocess.run([MORPHE, *map(str, arguments)], cwd=cwd, capture_output=True, text=True)


def python_verify(file):
    """What tests/verify_plans.py says, in this process: one of its own takes longer to begin than to judge."""
    import verify_plans  # h5py and numpy, which not every test needs
    said, complaint = io.StringIO(), io.StringIO()
    arguments = ["verify_plans.py", str(file), "--json"]
    with mock.patch.object(sys, "argv", arguments), redirect_stdout(said), redirect_stderr(complaint):
        code = verify_plans.main()
    return subprocess.CompletedProcess(arguments, code, said.getvalue(), complaint.getvalue())


def add_copy(file, plan, name):
    """Adds to a plans.h5 that is open a copy of one of its plans as NAME/000, and returns it."""
    group = file["plans"].create_group(name, track_order=True)
    file.copy(file["plans"][plan], group, "000")
    return group["000"]


def estimate_arm(plan):
    """Says of a plan in a plans.h5 that the person's shoulder and elbow were not recorded."""
    names = plan["goals/estimated"]
    attributes = dict(names.attrs)
    del plan["goals/estimated"]
    names = plan["goals"].create_dataset("estimated", data=["shoulder", "elbow"])
    names.attrs.update(attributes)


def sha256(file):
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


def temporary_folder():
    """Never in the source tree; the path holds nothing that a message could be mistaken for."""
    return tempfile.TemporaryDirectory(prefix="morphe_cli_")


def write_recordings(folder, text):
    """A manifest that names the shipped files by relative paths."""
    os.symlink(RECORDINGS, folder / "recorded")
    manifest = folder / "recordings.yaml"
    manifest.write_text(text)
    return manifest


def write_two_recordings(folder):
    return write_recordings(folder, TWO_RECORDINGS)


def shared_run(config, *arguments, dataset=None):
    """The folder of a run that many tests read: made by the first that asks, kept beside the program
    and made anew when the program, a config or a recording changes. The dataset may be `two recordings`
    (TWO_RECORDINGS) or `one recording` (ONE_RECORDING). Nobody may write into it: a test that alters
    plans copies them first. stdout.txt holds what was printed."""
    given = [MORPHE, *(path for top in ("configs", "datasets") for path in (SOURCE / top).rglob("*"))]
    made = max(path.stat().st_mtime_ns for path in given)
    key = repr((made, MORPHE.stat().st_size, str(config), list(map(str, arguments)), str(dataset)))
    shared = MORPHE.parent / "shared_runs" / hashlib.sha256(key.encode()).hexdigest()[:16]
    shared.parent.mkdir(exist_ok=True)
    with open(shared.with_suffix(".lock"), "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (shared / "stdout.txt").exists():
            shutil.rmtree(shared, ignore_errors=True)
            shared.mkdir()
            shipped = {"two recordings": TWO_RECORDINGS, "one recording": ONE_RECORDING}
            if dataset in shipped:
                dataset = write_recordings(shared, shipped[dataset])
            words = ["--dataset", dataset] if dataset else []
            result = morphe("run", config, *words, "--out", shared / "out", *arguments)
            assert result.returncode == 0, result.stderr
            (shared / "stdout.txt").write_text(result.stdout)
    return shared


def planned_sample(*settings):
    """For setUpModule: two shipped recordings, planned with a small search; a plans.h5 of its own."""
    holder = temporary_folder()
    unittest.addModuleCleanup(holder.cleanup)
    shared = shared_run(REFERENCE, *QUICK, *settings, dataset="two recordings")
    return Path(shutil.copy(shared / "out/plans.h5", Path(holder.name).resolve()))


def from_home_run():
    """The plans.h5 of two recordings with approach, retreat and contacts, sampled coarsely and at home not far from
    where the recordings begin, so that a plan is judged in no time."""
    home = ", ".join(f"{{joint: {joint}, value: {value}}}" for joint, value in HOME.items())
    return shared_run(SOURCE / "configs/pipelines/pa10_dlr_hit2_from_home.yaml", *QUICK, "--set", "grasp.close_fingers=true",
                      "--set", "retime.sample_rate_hz=50", "--set", f"approach.home=[{home}]", "--set", "approach.limit_scaling=1",
                      dataset="two recordings") / "out/plans.h5"


def carried_run():
    """The plans.h5 of two recordings, of which one carries its target with contacts, beside the person's other arm."""
    return shared_run(REFERENCE, *QUICK, "--set", "grasp.touch_distance=0.010", "--set", "segment.plan_until=return",
                      "--set", "retime.sample_rate_hz=50", "--set", "scene.other_arm=true", dataset="two recordings") / "out/plans.h5"


def line_of(file, needle):
    for number, line in enumerate(Path(file).read_text().splitlines(), 1):
        if needle in line:
            return number
    raise AssertionError(f"{needle!r} does not stand in {file}")


class CommandCase(unittest.TestCase):
    """A fresh folder for every test, and what is asked of every answer."""
    maxDiff = None

    def setUp(self):
        holder = temporary_folder()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name).resolve()

    def succeeds(self, *arguments, cwd=None):
        result = morphe(*arguments, cwd=cwd)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result

    def json_of(self, *arguments):
        """Nothing but JSON on standard output."""
        return json.loads(self.succeeds(*arguments, "--json").stdout)

    def refuses(self, result, beginning, *mentioned):
        """Exit 2, and one line on standard error that begins with the place of the fault."""
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.startswith(f"{beginning}: "), (str(beginning), result.stderr))
        for word in mentioned:
            self.assertIn(word, result.stderr)


def replace(file, old, new):
    text = Path(file).read_text()
    assert re.search(old, text), f"{old!r} does not stand in {file}"
    Path(file).write_text(re.sub(old, lambda _: new, text, count=1))


def main():
    unittest.main(module="__main__")
