"""What a person sees who runs `morphe` in a terminal: progress that leaves no trace, a first Ctrl-C
that is answered at once and a second one that ends the run, with all that was finished."""
import os
import re
import signal
import sqlite3
import subprocess

from many import COUNT, ManyCase
from support import MORPHE, REFERENCE, SOURCE, CommandCase, main, morphe, write_two_recordings
from terminal import Terminal

# Asked for are 0.2 s and 0.5 s; a busy machine has time.
AT_ONCE_S = 5
ANSWER = "finishing the demonstrations in progress; interrupt again to stop now (finished ones are kept)"
# One movement of this takes minutes.
LONG = ("--set", "map.starts=4000", "--jobs", 1)


def without_speed(results):
    """What a run prints, but for the line that no two runs have alike."""
    return re.sub(r"^\d+ frames; .*\n", "", results, flags=re.M)


class Stopped(CommandCase):
    def setUp(self):
        super().setUp()
        self.dataset = write_two_recordings(self.folder)
        self.out = self.folder / "out"

    def command(self, *arguments):
        return ["run", REFERENCE, "--dataset", self.dataset, "--out", self.out, *arguments]

    def ends_whole(self):
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            self.assertEqual(journal.execute("PRAGMA integrity_check").fetchone(), ("ok",))
        self.assertFalse([name for name in os.listdir(self.out) if name.endswith(".part")])

    def test_two_times_control_c_in_the_middle_of_a_movement(self):
        terminal = Terminal(*self.command(*LONG))
        terminal.wait_for("ADL001DR2 for")
        terminal.type("\x03")
        self.assertLess(terminal.wait_for(ANSWER), AT_ONCE_S)
        terminal.type("\x03")
        code, ended_s = terminal.end()
        self.assertEqual(code, -signal.SIGINT)
        self.assertLess(ended_s, AT_ONCE_S)
        self.ends_whole()

    def test_the_same_with_sigterm(self):
        process = subprocess.Popen([MORPHE, *map(str, self.command(*LONG, "--verbose"))], text=True,
                                   stderr=subprocess.PIPE)
        while not (self.out / "plans.h5.part").exists():
            pass
        process.send_signal(signal.SIGTERM)
        self.assertIn(ANSWER + "\n", iter(process.stderr.readline, ""))
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=AT_ONCE_S)
        self.assertEqual(process.returncode, -signal.SIGTERM)
        self.ends_whole()

    def test_other_commands_end_at_once_and_leave_nothing(self):
        terminal = Terminal("synthesize", f"{SOURCE}/configs/synthetic/reach_to_grasp.yaml", "--count", 10**6,
                            "--out", self.folder / "many.h5")
        while not (self.folder / "many.h5.part").exists():
            terminal.read(0.01)
        terminal.type("\x03")
        code, ended_s = terminal.end()
        self.assertEqual(code, -signal.SIGINT)
        self.assertLess(ended_s, AT_ONCE_S)
        self.assertFalse([name for name in os.listdir(self.folder) if name.startswith("many")])

    def test_place_ends_at_once(self):
        terminal = Terminal("place", REFERENCE, "--dataset", self.dataset,
                            "--out", self.folder / "placed.yaml")
        terminal.wait_for("place: ")
        terminal.type("\x03")
        self.assertEqual(terminal.end()[0], -signal.SIGINT)
        self.assertFalse((self.folder / "placed.yaml").exists())

    def test_a_signal_that_is_ignored_stays_ignored(self):
        made = subprocess.Popen(["sh", "-c", 'trap "" INT; exec "$0" "$@"', MORPHE, "synthesize",
                                 f"{SOURCE}/configs/synthetic/reach_to_grasp.yaml", "--count", "20", "--out",
                                 self.folder / "some.h5"])
        while not (self.folder / "some.h5.part").exists():
            pass
        made.send_signal(signal.SIGINT)
        made.communicate()
        self.assertEqual(made.returncode, 0)


class Goes(ManyCase):
    def test_on_after_two_signals(self):
        terminal = Terminal(*self.command(self.out, "--jobs", 1, "--set", "map.starts=40", "--verbose"))
        terminal.wait_for("[2/")
        terminal.type("\x03")
        terminal.wait_for(ANSWER)
        terminal.type("\x03")
        self.assertIn(terminal.end()[0], (-signal.SIGINT, 130))
        again = self.json_of(*self.command(self.out, "--set", "map.starts=40"))
        self.assertGreaterEqual(again["reused"], 2)
        self.assertLess(again["reused"], COUNT)


class Seen(ManyCase):
    def test_progress_leaves_no_trace_on_a_terminal(self):
        terminal = Terminal(*self.command(self.out), columns=400)
        self.assertEqual(terminal.end()[0], 0)
        self.assertRegex(terminal.seen, rf"\r\x1b\[K\d+ of {COUNT}")
        printed = morphe(*self.command(self.out)).stdout.replace(f"; {COUNT} reused from an earlier run", "")
        self.assertEqual("\n".join(terminal.lines()), printed)

    def test_progress_fits_a_narrow_terminal(self):
        terminal = Terminal(*self.command(self.out), columns=60)
        self.assertEqual(terminal.end()[0], 0)
        self.assertRegex(terminal.seen, rf"\r\x1b\[K\d+ of {COUNT}")
        for shown in re.findall(r"\r\x1b\[K(\d+ of[^\r\n]*)", terminal.seen):
            self.assertLess(len(shown), 61, "wider than the terminal")

    def test_an_error_that_ends_a_run_has_a_line_of_its_own(self):
        broken = self.folder / "broken.yaml"
        broken.write_text(self.config.read_text() + "map: {}\n")
        terminal = Terminal("run", broken, "--dataset", self.dataset, "--out", self.out)
        self.assertEqual(terminal.end()[0], 2)
        self.assertRegex("\n".join(terminal.lines()), rf"^{broken}:\d+: map: the key appears twice\n$")
        limited = Terminal(*self.command("/dev/full/out"))
        self.assertEqual(limited.end()[0], 2)
        self.assertEqual("\n".join(limited.lines()), "/dev/full/out: cannot be created: Not a directory\n")

    def test_a_file_and_a_pipe_hold_results_alone(self):
        with open(self.folder / "results.txt", "wb") as file:
            terminal = Terminal(*self.command(self.out), stdout=file.fileno())
            self.assertEqual(terminal.end()[0], 0)
        results = (self.folder / "results.txt").read_text()
        self.assertNotIn("\x1b", results)
        self.assertTrue(results.startswith("plan "), results)
        self.assertEqual("\n".join(terminal.lines()), "", "the line is taken away")
        piped = morphe(*self.command(self.out, "--fresh"))
        self.assertEqual(without_speed(piped.stdout), without_speed(results))
        self.assertNotIn("\x1b", piped.stderr)
        self.assertEqual(len(re.findall(r"^\[\d+/\d+\] synthetic_\d+: \d+ movements?$", piped.stderr, re.M)), COUNT)

    def test_quiet_and_verbose(self):
        quiet = self.succeeds(*self.command(self.out, "--quiet"))
        self.assertEqual(quiet.stderr, "")
        self.assertRegex(quiet.stdout, rf"\A{self.out}/plans.h5: {COUNT} demonstrations, .*\n\Z")
        verbose = self.succeeds(*self.command(self.out, "--fresh", "--verbose"))
        self.assertEqual(verbose.stderr.count("not planned before"), COUNT)
        self.assertRegex(verbose.stdout, r"\n\d+ frames; \d+ frames/s per core; \d+ ms per movement: .*map \d+")
        self.assertEqual(morphe(*self.command(self.out, "--quiet", "--verbose")).returncode, 2)

    def test_one_is_no_plural(self):
        one = self.folder / "one.h5"
        printed = self.succeeds("synthesize", self.base / "synthetic.yaml", "--out", one, "--count", 1).stdout
        self.assertIn(": 1 demonstration, ", printed)
        self.assertIn(": 1 demonstration, ", self.succeeds(*self.command(self.out, dataset=one)).stdout)
        self.assertIn(": 1 demonstration, ", self.succeeds("inspect", one).stdout)

    def test_a_dumb_terminal_is_none(self):
        terminal = Terminal(*self.command(self.out), TERM="dumb")
        self.assertEqual(terminal.end()[0], 0)
        self.assertNotIn("\x1b", terminal.seen)


if __name__ == "__main__":
    main()
