"""A run that is stopped keeps what it has imported; the next one uses it if no recording has changed."""
import os
import shutil
import signal
import subprocess

import h5py

from support import MORPHE, QUICK, RECORDINGS, REFERENCE, CommandCase, main, morphe, sha256

SAID = "the recordings are unchanged and not imported again"


class StoppedImport(CommandCase):
    def setUp(self):
        super().setUp()
        self.lab, self.out = self.folder / "lab", self.folder / "out"
        self.lab.mkdir()
        for name in ("ADL001FR1", "ADL001AR1", "ADL001DR2", "ADL001_static"):
            shutil.copy(RECORDINGS / f"{name}.csv", self.lab)
        (self.lab / "bad.csv").write_text("Trajectories\n100\n")
        self.command = ["run", REFERENCE, "--dataset", self.lab, "--out", self.out, *QUICK]

    def stop(self, number):
        """Stops a run once it has planned a movement."""
        process = subprocess.Popen([MORPHE, *map(str, self.command), "--jobs", "1"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for line in process.stderr:
            if line.startswith("[1/"):
                break
        process.send_signal(number)
        process.communicate()
        self.assertNotEqual(process.returncode, 0)
        self.assertTrue((self.out / "demonstrations.h5.new").exists())
        self.assertFalse((self.out / "demonstrations.h5").exists())

    def test_the_next_run_uses_it(self):
        undisturbed = self.folder / "undisturbed"
        morphe("run", REFERENCE, "--dataset", self.lab, "--out", undisturbed, *QUICK)
        for number in (signal.SIGKILL, signal.SIGTERM):
            with self.subTest(number):
                shutil.rmtree(self.out, ignore_errors=True)
                self.stop(number)
                again = morphe(*self.command)
                self.assertEqual(again.returncode, 1, again.stderr)
                self.assertIn(SAID, again.stderr)
                self.assertIn("bad.csv", again.stderr)
                self.assertIn("1 failed", again.stdout)
                if number == signal.SIGTERM:  # a killed run may not have committed its plan
                    self.assertIn("reused from an earlier run", again.stdout)
                self.assertEqual(sorted(os.listdir(self.out)),
                                 ["demonstrations.h5", "journal.sqlite", "plans.h5", "recordings.yaml"])
                for name in ("demonstrations.h5", "plans.h5"):
                    self.assertEqual(sha256(self.out / name), sha256(undisturbed / name))
                self.assertEqual((self.out / "recordings.yaml").read_text().splitlines()[1:],
                                 (undisturbed / "recordings.yaml").read_text().splitlines()[1:])

    def test_what_changed_is_imported(self):
        text = (self.lab / "ADL001FR1.csv").read_text(encoding="utf-8-sig")

        def shorter():
            (self.lab / "ADL001FR1.csv").write_text("\n".join(text.splitlines()[:-20]) + "\n")

        for change, options in ((shorter, ()), ((self.lab / "bad.csv").unlink, ()),
                                ((self.lab / "ADL001AR1.csv").unlink, ()), (lambda: None, ("--hand", "left")),
                                (lambda: None, ("--fresh",))):
            with self.subTest(change, options=options):
                self.stop(signal.SIGKILL)
                change()
                again = morphe(*self.command, *options)
                self.assertNotIn(SAID, again.stderr)
                shutil.rmtree(self.out)

    def test_after_an_error_it_is_removed(self):
        self.out.mkdir()
        with h5py.File(self.out / "plans.h5", "w"):
            pass
        self.assertEqual(morphe(*self.command).returncode, 2)
        self.assertEqual(os.listdir(self.out), ["plans.h5"])


if __name__ == "__main__":
    main()
