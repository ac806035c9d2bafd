"""Files that somebody made to hurt, outputs that are in the way, streams that take nothing, two runs
at once: one clear error and exit 2, or the result; nothing else is touched. MORPHE_RACES=200 in the
environment begins so many pairs of runs, MORPHE_DAMAGED=100 reads so many flipped and so many cut files:
most of its minute of processor time begins a process for each."""
import json
import os
import random
import shutil
import socket
import sqlite3
import subprocess

import h5py
import numpy as np

from many import COUNT, ManyCase
from support import MORPHE, REFERENCE, SOURCE, CommandCase, main, morphe, planned_sample, sha256

ESCAPE = "\x1b[31m"
RACES = int(os.environ.get("MORPHE_RACES", 25))
DAMAGED = int(os.environ.get("MORPHE_DAMAGED", 424))


def setUpModule():
    """Sampled coarsely: a file in which more bytes are structure, and fewer are values with a checksum."""
    global SAMPLE
    SAMPLE = planned_sample("--set", "retime.sample_rate_hz=25")


def with_streams(*arguments, out=None, err=None, closed=()):
    """The exit code and what was said, with standard streams that take nothing or are closed."""
    def close():
        for descriptor in closed:
            os.close(descriptor)
    result = subprocess.run([MORPHE, *map(str, arguments)], stdout=out or subprocess.PIPE,
                            stderr=err or subprocess.PIPE, preexec_fn=close, text=True)
    return result.returncode, result.stdout or "", result.stderr or ""


class StandardStreams(ManyCase):
    def test_a_full_or_closed_stderr_does_not_end_a_run(self):
        with open("/dev/full", "w") as full:
            code, _, _ = with_streams(*self.command(self.out, "--verbose"), err=full)
        self.assertEqual(code, 0)
        self.same_bytes()
        shutil.rmtree(self.out)
        code, _, _ = with_streams(*self.command(self.out, "--verbose"), closed=(2,))
        self.assertEqual(code, 0)
        self.same_bytes()

    def test_a_stderr_whose_reader_left(self):
        read, write = os.pipe()
        os.close(read)
        with os.fdopen(write, "w") as left:
            code, _, _ = with_streams(*self.command(self.out, "--verbose"), err=left)
        self.assertEqual(code, 0)
        self.same_bytes()

    def test_a_full_or_closed_stdout_is_said(self):
        for command in (("list", SAMPLE), ("verify", SAMPLE), ("--help",), ("verify", "--help"),
                        ("--version",), ("inspect", self.dataset, "--json")):
            with self.subTest(command):
                with open("/dev/full", "w") as full:
                    code, _, said = with_streams(*command, out=full)
                self.assertEqual((code, said), (2, "standard output: cannot be written: "
                                                   "No space left on device\n"))
                code, _, said = with_streams(*command, closed=(1,))
                self.assertEqual((code, said), (2, "standard output: cannot be written: "
                                                   "Bad file descriptor\n"))

    def test_no_file_gets_a_closed_stream(self):
        code, _, _ = with_streams(*self.command(self.out), closed=(0, 1, 2))
        self.assertEqual(code, 2)
        self.same_bytes()


class Names(CommandCase):
    """What a file calls things reaches neither the terminal nor a file's name as it is."""

    def spoiled(self, spoil):
        file = self.folder / "plans.h5"
        shutil.copy(SAMPLE, file)
        with h5py.File(file, "r+") as plans:
            spoil(plans)
        return file

    def silent(self, *arguments):
        result = morphe(*arguments)
        self.assertNotIn("\x1b", result.stdout + result.stderr)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        return result.stderr

    def test_demonstrations_and_objects(self):
        for spoil in (lambda f: f["plans"].move("ADL001AR1", f"x\n{ESCAPE}"),
                      lambda f: f["plans/ADL001AR1/000/scene"].move("cup", f"cup\n{ESCAPE}")
                      if "cup" in f["plans/ADL001AR1/000/scene"]
                      else f["plans/ADL001AR1/000/scene"].move(
                          next(iter(f["plans/ADL001AR1/000/scene"])), f"x\n{ESCAPE}"),
                      lambda f: f["plans/ADL001AR1/000"].attrs.create("subject", f"S\n{ESCAPE}")):
            file = self.spoiled(spoil)
            for command in (("list", file), ("verify", file),
                            ("export", file, "--format", "csv", "--out", self.folder / "e")):
                self.assertIn("\\u001b[31m", self.silent(*command))
            self.assertFalse((self.folder / "e").exists())

    def test_what_is_wrong_with_a_file_is_spelled(self):
        file = self.spoiled(lambda f: f.attrs.create("format", f"morphe\n{ESCAPE}"))
        self.assertIn("morphe\\u000a\\u001b[31m", self.silent("verify", file))
        config = self.folder / "a.yaml"
        config.write_text(f'extends: {REFERENCE}\n"x\\e[31m\\ny": 1\n')
        self.assertIn("x\\u001b[31m\\u000ay", self.silent("run", config, "--out", self.folder / "o"))


class Outputs(CommandCase):
    def test_an_output_that_is_an_input(self):
        recording = self.folder / "a.csv"
        shutil.copy(SOURCE / "datasets/ue-adl/ADL001AR1.csv", recording)
        before = sha256(recording)
        self.refuses(morphe("import", recording, "--out", recording), recording, "would replace it")
        self.assertEqual(sha256(recording), before)
        plans = self.folder / "plans.h5"
        shutil.copy(SAMPLE, plans)
        self.refuses(morphe("report", plans, "--out", plans), plans, "would replace it")
        self.assertEqual(sha256(plans), sha256(SAMPLE))

    def test_devices(self):
        self.refuses(morphe("report", SAMPLE, "--out", "/dev/null"), "/dev/null", "is a device, pipe or socket")
        self.refuses(morphe("import", SOURCE / "datasets/ue-adl/ADL001AR1.csv", "--out", "/dev/stdout"),
                     "/dev/stdout")

    def test_a_link_where_the_part_file_comes(self):
        victim = self.folder / "victim"
        victim.write_text("kept")
        os.symlink(victim, self.folder / "page.html.part")
        self.refuses(morphe("report", SAMPLE, "--out", self.folder / "page.html"),
                     self.folder / "page.html.part", "exists and is not a regular file")
        self.assertEqual(victim.read_text(), "kept")


class Runs(ManyCase):
    def test_a_foreign_plans_h5_is_not_replaced(self):
        """A text, plans of another config beside a journal, and without one."""
        other = self.folder / "other"
        self.succeeds(*self.command(other, "--set", "map.coarse_step_s=0.25"))
        for journal, plans in ((True, "text"), (False, "text"), (True, other / "plans.h5")):
            with self.subTest((journal, plans)):
                shutil.rmtree(self.out, ignore_errors=True)
                shutil.copytree(self.plain, self.out)
                if not journal:
                    os.remove(self.out / "journal.sqlite")
                if plans == "text":
                    (self.out / "plans.h5").write_text("mine")
                else:
                    shutil.copy(plans, self.out / "plans.h5")
                before = sha256(self.out / "plans.h5")
                self.refuses(morphe(*self.command(self.out)), self.out / "plans.h5", "--fresh")
                self.assertEqual(sha256(self.out / "plans.h5"), before)
                self.run_json("--fresh")
                self.same_bytes()

    def test_own_plans_are_known_after_a_run_that_was_killed(self):
        """One of another config: its journal has the new config, the folder the old plans."""
        shutil.copytree(self.plain, self.out)
        process = self.start("--set", "map.coarse_step_s=0.25")
        process.kill()
        process.communicate()
        self.run_json()
        self.same_bytes()

    def test_a_merge_replaces_no_plans_but_its_own(self):
        self.run_json("--shard", "1/1")
        merged = self.folder / "merged"
        for _ in range(2):
            self.succeeds("merge", self.out, "--out", merged)
        (merged / "plans.h5").write_text("mine")
        self.refuses(morphe("merge", self.out, "--out", merged), merged / "plans.h5")
        self.assertEqual((merged / "plans.h5").read_text(), "mine")

    def test_two_runs_at_once_in_a_new_folder(self):
        """One works, the other says so; begun again it finds everything done."""
        few = self.folder / "few.h5"  # the race is at the beginning
        self.succeeds("synthesize", self.base / "synthetic.yaml", "--out", few, "--count", 2)
        self.succeeds(*self.command(self.out, dataset=few))
        for turn in range(RACES):
            out = self.folder / f"new/{turn}"
            command = [MORPHE, *map(str, self.command(out, "--jobs", 1, "--quiet", dataset=few))]
            two = [subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
                   for _ in range(2)]
            said = [process.communicate()[1] for process in two]
            codes = sorted(process.returncode for process in two)
            self.assertIn(codes, ([0, 2], [0, 0]), said)  # the second may have come after the first
            if codes == [0, 2]:
                self.assertIn(f"{out}: another command is writing to it: ", "".join(said))
            self.assertEqual(sha256(out / "plans.h5"), sha256(self.out / "plans.h5"))
            self.assertEqual(sorted(os.listdir(out)), ["journal.sqlite", "plans.h5"])
            shutil.rmtree(out)

    def test_a_run_that_fails_takes_nothing_from_one_that_works(self):
        process = self.start()
        broken = morphe("run", self.config, "--dataset", self.folder / "nowhere.h5", "--out", self.out)
        self.assertEqual(broken.returncode, 2)
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.same_bytes()

    def test_rows_that_are_missing_in_a_journal(self):
        for change, merges in (("DELETE FROM plans WHERE rowid = 3", False),
                               ("DELETE FROM scheduled WHERE rowid = 3", False),
                               ("DELETE FROM results WHERE rowid = 3", False),
                               ("UPDATE results SET summary = '{'", False),
                               ("UPDATE metadata SET value = 'x' WHERE key = 'demonstrations'", False),
                               ("UPDATE metadata SET value = 'x' WHERE key = 'robot'", False)):
            with self.subTest(change):
                shutil.rmtree(self.out, ignore_errors=True)
                shutil.copytree(self.plain, self.out)
                with sqlite3.connect(self.out / "journal.sqlite") as journal:
                    journal.execute(change)
                merged = self.folder / "merged"
                result = morphe("merge", self.out, "--out", merged)
                self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                self.assertIn(str(self.out), result.stderr)
                self.assertFalse(merged.exists())

    def test_a_plan_that_went_out_of_the_journal_is_not_missing_in_silence(self):
        shutil.copytree(self.plain, self.out)
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            journal.execute("DELETE FROM plans WHERE rowid = 3")
        self.refuses(morphe(*self.command(self.out)), self.out / "journal.sqlite", "is damaged",
                     "of", "plans found", "--fresh")

    def test_plans_that_changed_places(self):
        shutil.copytree(self.plain, self.out)
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            rows = journal.execute("SELECT rowid, bytes, sha256 FROM plans WHERE number = 0").fetchall()
            (a, *of_a), (b, *of_b) = rows[:2]
            journal.execute("UPDATE plans SET bytes = ?, sha256 = ? WHERE rowid = ?", (*of_b, a))
            journal.execute("UPDATE plans SET bytes = ?, sha256 = ? WHERE rowid = ?", (*of_a, b))
        self.refuses(morphe(*self.command(self.out)), self.out / "journal.sqlite", "is damaged")


class Recordings(ManyCase):
    def spoiled(self, spoil):
        """The dataset with its first demonstration spoiled."""
        file = self.folder / "spoiled.h5"
        shutil.copy(self.dataset, file)
        with h5py.File(file, "r+") as data:
            spoil(data["demonstrations/synthetic_000000"])
        return file

    def one_fails(self, spoil, *mentioned):
        """That one alone, in inspect at once, in a run as a failed demonstration."""
        file = self.spoiled(spoil)
        place = f"{file}:/demonstrations/synthetic_000000/"
        result = morphe("inspect", file)
        self.assertEqual(result.returncode, 2)
        self.assertTrue(result.stderr.startswith(place), result.stderr)
        for word in mentioned:
            self.assertIn(word, result.stderr)
        result = morphe(*self.command(self.out, "--fresh", dataset=file))
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"] synthetic_000000: {place}", result.stderr)
        self.assertIn(f"{COUNT} demonstrations", result.stdout)

    def put(self, name, change):
        def spoil(group):
            values = group[name][()]
            change(values)
            group[name][...] = values
        return spoil

    def test_times_that_stand_still_race_or_run_away(self):
        """Time steps of nothing ended in a division by zero."""
        def still(t): t[:] = 1.0
        def racing(t): t[:] = 1e-305 * np.arange(len(t))
        def away(t): t[-1] = 1e300
        def back(t): t[5] = t[3]
        def nan(t): t[7] = np.nan
        for change in (still, racing, away, back, nan):
            with self.subTest(change.__name__):
                self.one_fails(self.put("sensors/time", change), "sensors/time: ")

    @staticmethod
    def put_object(group, name="cup", size=(0.03, 0.1), position=(0.3, 0.4, 0.75), w=1.0):
        cup = group.require_group("objects").create_group(name)
        cup.attrs["shape"] = "cylinder"
        cup.attrs["size"] = np.array(size)
        cup["time"] = np.array([0.0, 0.1])
        cup["position"] = np.array([position, position])
        cup["orientation"] = np.array([[w, 0, 0, 0]] * 2)
        return cup

    def test_objects_without_a_pose(self):
        """A pose that is not there made a run that never ended."""
        for what, word in (({"position": (np.nan,) * 3}, "is not a possible position"), ({"w": 0}, "is not a rotation"),
                           ({"size": (-0.03, 0.1)}, "is not a possible size")):
            with self.subTest(word):
                self.one_fails(lambda group: self.put_object(group, **what), word)

        def back(group):
            self.put_object(group)["time"][...] = [0.1, 0.0]
        self.one_fails(back, "must be greater than in the previous row")

    def test_an_object_named_as_one_of_the_scene_fails_its_demonstration_alone(self):
        """Written, it ended the run. The table is nobody's clash: one that was recorded is the table."""
        file = self.spoiled(lambda group: self.put_object(group))
        config = self.folder / "cup.yaml"
        config.write_text(self.config.read_text().replace(
            "scene: {", "scene: {objects: [{name: cup, shape: sphere, size: [0.01], position: [0.2, 0, 2]}], "))
        result = morphe("run", config, "--dataset", file, "--set", "audit.refuse=[]", "--out", self.out)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("synthetic_000000: scene/cup: the name appears twice\n", result.stderr)
        self.assertIn(", 1 failed", result.stdout)
        file = self.spoiled(lambda group: self.put_object(group, "table", (0.4, 0.02)))
        result = morphe("run", self.config, "--dataset", file, "--out", self.folder / "table")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_a_rate_of_a_csv(self):
        lines = (SOURCE / "datasets/ue-adl/ADL001AR1.csv").read_text(encoding="utf-8-sig").splitlines()
        file = self.folder / "a.csv"
        for rate in ("1e300", "1e9"):
            lines[1] = rate
            file.write_text("\n".join(lines) + "\n")
            result = morphe("inspect", file, "--forward", "recorded")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertTrue(result.stderr.startswith(str(file)), result.stderr)

    def test_rates_of_a_config(self):
        for setting in ("reconstruct.rate_hz=1e9", "retime.sample_rate_hz=1e9"):
            result = morphe(*self.command(self.out, "--set", setting))
            self.assertEqual(result.returncode, 2)
            self.assertIn(setting.split("=")[0].split(".")[1], result.stderr)


class Hdf5(CommandCase):
    def test_links_into_other_files_pipes_and_devices(self):
        plans = self.folder / "plans.h5"
        shutil.copy(SAMPLE, plans)
        with h5py.File(plans, "r+") as file:
            del file["plans/ADL001AR1/000/goals"]
            file["plans/ADL001AR1/000/goals"] = h5py.ExternalLink(
                str(SAMPLE), "/plans/ADL001AR1/000/goals")
        for command in ("verify", "list"):
            self.refuses(morphe(command, plans), f"{plans}:/plans/ADL001AR1/000/goals",
                         "is a link into another file")
        pipe = self.folder / "pipe.h5"
        os.mkfifo(pipe)
        listening = socket.socket(socket.AF_UNIX)
        listening.bind(str(self.folder / "socket.h5"))
        for name in (pipe, "/dev/zero", self.folder / "socket.h5"):
            for command in ("verify", "list", "inspect"):
                with self.subTest((command, name)):
                    result = subprocess.run([MORPHE, command, name], capture_output=True, text=True,
                                            timeout=20)
                    self.assertEqual(result.returncode, 2, result.stderr)
                    self.assertTrue(result.stderr.startswith(str(name)), result.stderr)
        listening.close()

    def test_flipped_files(self):
        """424 files (MORPHE_DAMAGED): each is read, or refused in one line that names it; none crashes a reader."""
        whole = SAMPLE.read_bytes()
        choose = random.Random(25)
        for k in range(DAMAGED):
            flipped = bytearray(whole)
            # Half of them near the beginning, where the library finds its way.
            at = choose.randrange(8, 4096 if k % 2 else len(whole))
            flipped[at] ^= 1 << choose.randrange(8)
            with self.subTest(flip=k, at=at):
                self.read_or_refused(flipped)

    def test_cut_files(self):
        """As many: the library compares the size of a file with what it says before it reads on."""
        whole = SAMPLE.read_bytes()
        choose = random.Random(26)
        for _ in range(DAMAGED):
            length = choose.randrange(len(whole))
            with self.subTest(length=length):
                self.assertEqual(self.read_or_refused(whole[:length]), 2)

    def read_or_refused(self, content):
        file = self.folder / "damaged.h5"
        file.write_bytes(content)
        result = morphe("list", file)
        if result.returncode != 0:
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertTrue(result.stderr.startswith(str(file)), result.stderr)
        return result.returncode


class Verify(CommandCase):
    def test_numbers_that_no_plan_has(self):
        """On each of these it worked without end, or took all memory."""
        file = self.folder / "plans.h5"

        def capsule(plans):
            to = plans["robot/capsules/to"][()]
            to[3, 0] = 1e200
            plans["robot/capsules/to"][...] = to

        def last(plans):
            plans["plans/ADL001AR1/000/trajectory/time"][-1] = 1e12

        def goals(plans):
            time = plans["plans/ADL001AR1/000/goals/time"]
            time[...] = time[0] + 1e-12 * np.arange(len(time))
        for spoil, subject in ((capsule, "robot/capsules"), (last, "trajectory/time"), (goals, "goals/time")):
            with self.subTest(subject):
                shutil.copy(SAMPLE, file)
                with h5py.File(file, "r+") as plans:
                    spoil(plans)
                result = morphe("verify", file, "--json")
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(("structure", subject), {(row["cause"], row["subject"])
                                                       for row in json.loads(result.stdout)["violations"]})


class Yaml(CommandCase):
    def test_a_chain_of_configs(self):
        for k in range(3000):
            (self.folder / f"{k}.yaml").write_text(f"extends: {k + 1}.yaml\n")
        result = morphe("run", self.folder / "0.yaml", "--out", self.folder / "out")
        self.assertEqual(result.returncode, 2)
        self.assertIn("more than 100 configs extend one another", result.stderr)

    def test_an_alias_of_itself_on_the_command_line(self):
        result = morphe("run", REFERENCE, "--out", self.folder / "out", "--set", "map=&a [*a]")
        self.assertEqual(result.returncode, 2)
        self.assertIn("contains itself", result.stderr)


class Ros(CommandCase):
    def test_times_beyond_what_a_message_can_tell(self):
        plans = self.folder / "plans.h5"
        shutil.copy(SAMPLE, plans)
        with h5py.File(plans, "r+") as file:
            file["plans/ADL001AR1/000/trajectory/time"][-1] = 2.0**31
        for kind in ("ros", "ros-json"):
            out = self.folder / kind
            said = self.succeeds("export", plans, "--unverified", "--format", kind, "--out", out).stdout
            self.assertIn("ADL001AR1/000 skipped: is longer than a ROS message can express", said)


if __name__ == "__main__":
    main()
