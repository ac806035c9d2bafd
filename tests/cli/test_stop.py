"""SIGTERM and SIGINT end every command soon, at any time of its work, and leave nothing half written."""
import hashlib
import shutil
import signal
import subprocess
import time

from many import ManyCase
from support import MORPHE, RECORDINGS, REFERENCE, SOURCE, main, morphe

# Asked for are 2 s; a busy machine has time.
AT_MOST_S = 10
# Signals, and the shares of the time that the command takes after which they are sent.
STOPS = ((signal.SIGTERM, 0.2), (signal.SIGINT, 0.5), (signal.SIGTERM, 0.8))
KEPT = ("journal.sqlite", "journal.sqlite-journal", "demonstrations.h5.new")  # for the same command again


def files_in(folder):
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in folder.rglob("*") if path.is_file() and path.name not in KEPT}


class Stop(ManyCase):
    def ends(self, name, words, same_bytes=True):
        """Runs a command to its end, then ends it at shares of its time."""
        clean = self.folder / f"{name}_clean"
        clean.mkdir()
        begin = time.monotonic()
        result = morphe(*words(clean / "out"))
        took_s = time.monotonic() - begin
        self.assertEqual(result.returncode, 0, result.stderr)
        complete = files_in(clean)
        stopped = 0
        for number, share in STOPS:
            with self.subTest(name, signal=number.name, share=share):
                folder = self.folder / f"{name}_{number.name}_{share}"
                folder.mkdir()
                process = subprocess.Popen(
                    [MORPHE, *map(str, words(folder / "out"))], stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
                time.sleep(share * took_s)
                process.send_signal(number)
                try:
                    process.wait(AT_MOST_S)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()
                    self.fail(f"goes on for more than {AT_MOST_S} s")
                self.assertIn(process.returncode, (0, -number, 128 + number))
                left = files_in(folder)
                if process.returncode == 0:
                    self.assertEqual(left.keys(), complete.keys())
                else:
                    stopped += 1
                for file, sha in left.items():
                    self.assertIn(file, complete)
                    if same_bytes:
                        self.assertEqual(sha, complete[file], file)
                shutil.rmtree(folder)
        self.assertGreater(stopped, 0, "it always ended before the signal")

    def test_run(self):
        self.ends("run", lambda out: self.command(out, "--jobs", 1))

    def test_a_run_of_one_long_movement(self):
        """SIGTERM alone: its senders kill what goes on, so that nobody waits for the movement's end."""
        out = self.folder / "out"
        process = subprocess.Popen(
            [MORPHE, "run", REFERENCE, "--dataset", RECORDINGS / "ADL001DR2.csv", "--out", out, "--set",
             "map.starts=4000"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not (out / "plans.h5.part").exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        process.wait(AT_MOST_S)
        self.assertIn(process.returncode, (-signal.SIGTERM, 128 + signal.SIGTERM))
        self.assertFalse((out / "plans.h5.part").exists())

    def test_import(self):
        self.ends("import", lambda out: ["import", RECORDINGS, "--out", f"{out}.h5"])

    def test_synthesize(self):
        self.ends("synthesize", lambda out: ["synthesize", self.base / "synthetic.yaml", "--count", 60, "--out",
                                             f"{out}.h5"])

    def test_verify(self):
        self.ends("verify", lambda out: ["verify", self.plain / "plans.h5"])

    def test_report(self):
        self.ends("report", lambda out: ["report", self.plain, "--out", f"{out}.html"], same_bytes=False)

    def test_export(self):
        self.ends("export", lambda out: ["export", self.plain, "--format", "csv", "--out", out])

    def test_place(self):
        self.ends("place", lambda out: ["place", self.config, "--dataset", self.dataset, "--out", f"{out}.yaml"])

    def test_study(self):
        self.ends("study", lambda out: ["study", SOURCE / "configs/studies/retime.yaml", "--quick", "--out", out],
                  same_bytes=False)

    def test_robot_setup(self):
        self.ends("setup", lambda out: ["robot", "setup", SOURCE / "configs/robots/urdf/fr3.urdf", "--out",
                                        f"{out}.yaml"])


if __name__ == "__main__":
    main()
