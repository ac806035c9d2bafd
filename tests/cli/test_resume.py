"""`morphe run` into a folder that holds results already: what is finished is not done again, what
changed is, and whatever ends a run, the next one gives the bytes of an undisturbed one. It takes more
than 10 s: dozens of runs of twelve recordings each.
MORPHE_KILLS=1000 in the environment ends so many runs."""
import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import time

import h5py

from many import COUNT, ManyCase
from support import MORPHE, SOURCE, main, morphe, replace, sha256

KILLS = int(os.environ.get("MORPHE_KILLS", 5))


class Continued(ManyCase):
    def explained(self, *arguments, dataset=None):
        """{demonstration: why it was done} and the number of those that were not."""
        result = self.succeeds(*self.command(self.out, "--explain", *arguments, dataset=dataset))
        lines = [line for line in result.stderr.splitlines()
                 if not line.startswith("[") and not line.startswith(f"{self.out}: ")]
        again = dict(line.split(": ", 1) for line in lines)
        reused = re.search(r"; (\d+) reused from an earlier run", result.stdout)
        return again, int(reused.group(1)) if reused else 0

    def test_nothing_is_done_twice(self):
        again, reused = self.explained()
        self.assertEqual((len(again), set(again.values()), reused), (COUNT, {"not planned before"}, 0))
        before = os.stat(self.out / "journal.sqlite").st_size
        self.assertEqual(self.explained(), ({}, COUNT))
        self.same_bytes()
        self.assertEqual(os.stat(self.out / "journal.sqlite").st_size, before)
        self.assertEqual(sorted(os.listdir(self.out)), ["journal.sqlite", "plans.h5"])

    def test_any_number_of_threads(self):
        for jobs in (2, 8):
            with self.subTest(jobs):
                self.run_json("--fresh", "--jobs", jobs)
                self.same_bytes()

    def test_plans_that_were_taken_away_come_back(self):
        shutil.copytree(self.plain, self.out)
        (self.out / "plans.h5").unlink()
        self.assertEqual(self.run_json()["reused"], COUNT)
        self.same_bytes()

    def test_another_config_is_another_run_and_says_which_key(self):
        shutil.copytree(self.plain, self.out)
        again, reused = self.explained("--set", "seed=2")
        self.assertEqual((len(again), reused), (COUNT, 0))
        self.assertEqual(set(again.values()), {"the config changed: seed 1 -> 2"})
        self.assertNotEqual(sha256(self.out / "plans.h5"), self.bytes)
        self.explained()
        self.same_bytes()

    def test_a_dataset_of_another_name_is_the_same(self):
        shutil.copytree(self.plain, self.out)
        shutil.copy(self.dataset, self.folder / "moved.h5")
        self.assertEqual(self.explained(dataset=self.folder / "moved.h5"), ({}, COUNT))

    def test_a_config_in_another_folder_gives_the_same_bytes(self):
        moved = self.folder / "elsewhere" / self.config.name
        moved.parent.mkdir()
        shutil.copy(self.config, moved)
        self.succeeds("run", moved, "--dataset", self.dataset, "--out", self.out)
        self.same_bytes()

    def test_only_the_demonstration_that_changed(self):
        shutil.copytree(self.plain, self.out)
        changed = self.folder / "changed.h5"
        shutil.copy(self.dataset, changed)
        with h5py.File(changed, "r+") as file:
            file["demonstrations/synthetic_000005"].attrs["task"] = "another"
        again, reused = self.explained(dataset=changed)
        self.assertEqual(again, {"synthetic_000005": "the recording changed"})
        self.assertEqual(reused, COUNT - 1)
        self.run_json(dataset=changed, out=self.folder / "anew")
        self.assertEqual(sha256(self.out / "plans.h5"), sha256(self.folder / "anew/plans.h5"))

    def test_demonstrations_that_came_and_went(self):
        shutil.copytree(self.plain, self.out)
        fewer = self.folder / "fewer.h5"
        shutil.copy(self.dataset, fewer)
        with h5py.File(fewer, "r+") as file:
            del file["demonstrations/synthetic_000000"]
        said = self.succeeds(*self.command(self.out, dataset=fewer)).stderr
        self.assertIn("1 demonstration is no longer in the dataset (synthetic_000000)", said)
        self.assertEqual(self.explained(dataset=fewer), ({}, COUNT - 1))
        with h5py.File(self.out / "plans.h5") as file:
            self.assertNotIn("synthetic_000000", file["plans"])
        self.assertEqual(self.explained(), ({}, COUNT))  # kept for when it comes back
        self.same_bytes()

    def test_the_same_dataset_with_every_recording_changed_is_planned_again(self):
        copy = self.folder / "copy.h5"
        shutil.copy(self.dataset, copy)
        self.explained(dataset=copy)
        with h5py.File(copy, "r+") as file:
            for group in file["demonstrations"].values():
                group.attrs["task"] = "another"
        again, _ = self.explained(dataset=copy)
        self.assertEqual(set(again.values()), {"the recording changed"})

    def test_another_robot_of_the_same_name(self):
        robot = self.folder / "pa10.yaml"
        shutil.copy(SOURCE / "configs/robots/pa10.yaml", robot)
        config = self.folder / "config.yaml"
        config.write_text(self.config.read_text().replace(f"{SOURCE}/configs/robots/pa10.yaml", "pa10.yaml"))
        command = ["run", config, "--dataset", self.dataset, "--out", self.out, "--explain"]
        self.succeeds(*command)
        replace(robot, "lower: -177 deg", "lower: -176 deg")
        lines = [line for line in self.succeeds(*command).stderr.splitlines() if line[0] != "["]
        self.assertEqual({line.split(": ", 1)[1] for line in lines}, {"the robot changed"})

    def test_another_build_does_everything_again(self):
        shutil.copytree(self.plain, self.out)
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            journal.execute("UPDATE results SET program = 'another'")
        again, reused = self.explained()
        self.assertEqual((set(again.values()), reused), ({"morphe was rebuilt"}, 0))
        self.same_bytes()

    def test_fresh_forgets(self):
        shutil.copytree(self.plain, self.out)
        self.assertEqual(self.run_json("--fresh")["reused"], 0)
        self.same_bytes()


class Refused(ManyCase):
    def refuses_unless_fresh(self, *mentioned):
        before = sha256(self.out / "plans.h5")
        self.refuses(morphe(*self.command(self.out)), self.out / "journal.sqlite", "--fresh",
                     *mentioned)
        self.assertEqual(sha256(self.out / "plans.h5"), before)
        self.assertEqual(self.run_json("--fresh")["reused"], 0)
        self.same_bytes()

    def test_another_dataset(self):
        """Of other names, and of the same names but other content."""
        shutil.copytree(self.plain, self.out)
        other = self.folder / "other.h5"
        shutil.copy(self.dataset, other)
        before = sha256(self.out / "plans.h5")
        with h5py.File(other, "r+") as file:
            for group in file["demonstrations"].values():
                group.attrs["task"] = "another"
        command = ["run", self.config, "--dataset", other, "--out", self.out]
        self.refuses(morphe(*command), self.out, "plans of another dataset (synthetic_000000",
                     "--fresh")
        with h5py.File(other, "r+") as file:
            for name in list(file["demonstrations"]):
                file["demonstrations"].move(name, f"new_{name}")
        self.refuses(morphe(*command), self.out, "plans of another dataset", "--fresh")
        self.assertEqual(sha256(self.out / "plans.h5"), before)
        self.assertEqual(self.run_json()["reused"], COUNT)
        self.succeeds(*command, "--fresh")
        self.assertNotEqual(sha256(self.out / "plans.h5"), before)

    def test_plans_without_a_journal(self):
        self.out.mkdir()
        shutil.copy(self.plain / "plans.h5", self.out)
        self.refuses(morphe(*self.command(self.out)), self.out / "plans.h5", "--fresh")
        self.succeeds(*self.command(self.out, "--fresh"))
        self.same_bytes()

    def test_a_folder_of_another_version(self):
        shutil.copytree(self.plain, self.out)
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            journal.execute("UPDATE metadata SET value = 'morphe 0.0.1' WHERE key = 'software'")
        self.refuses_unless_fresh("was written by morphe 0.0.1")

    def test_a_folder_of_a_shard(self):
        self.run_json("--shard", "1/3")
        self.refuses_unless_fresh("contains shard 1/3")

    def test_a_journal_that_is_none(self):
        shutil.copytree(self.plain, self.out)
        (self.out / "journal.sqlite").write_text("another file " * 1000)
        self.refuses_unless_fresh("not a journal")

    def test_a_plan_whose_bytes_changed(self):
        shutil.copytree(self.plain, self.out)
        with sqlite3.connect(self.out / "journal.sqlite") as journal:
            journal.execute("UPDATE plans SET bytes = zeroblob(length(bytes)) WHERE rowid = 5")
        self.refuses_unless_fresh("is damaged")

    def test_two_runs_at_once(self):
        first = self.start()
        self.refuses(morphe(*self.command(self.out)), self.out, "another command")
        self.refuses(morphe(*self.command(self.out, "--fresh")), self.out, "another command")
        first.communicate()
        self.assertEqual(first.returncode, 0)
        self.same_bytes()


class Ended(ManyCase):
    def test_killed_at_any_instant(self):
        """Once, or up to four times in a row: what goes on from there ends with the same bytes."""
        begin = time.monotonic()
        self.run_json(out=self.folder / "measured")
        duration = time.monotonic() - begin
        chance, killed = random.Random(7), 0
        while killed < KILLS:
            shutil.rmtree(self.out, ignore_errors=True)
            for _ in range(chance.randint(1, 4)):
                process = subprocess.Popen([MORPHE, *map(str, self.command(self.out))],
                                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                time.sleep(chance.uniform(0, duration))
                process.kill()
                killed += process.wait() == -signal.SIGKILL
            self.run_json()
            self.same_bytes()

    def test_stopped_by_a_signal(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            with self.subTest(number.name):
                shutil.rmtree(self.out, ignore_errors=True)
                process = self.start()
                process.send_signal(number)
                output, errors = process.communicate()
                self.assertEqual((process.returncode, output), (code, ""), errors)
                last = errors.splitlines()[-1]
                done = re.fullmatch(rf"{self.out}: stopped by {number.name}: (\d+) of {COUNT} "
                                    "demonstrations finished and kept; run the same command again "
                                    "to continue", last)
                self.assertTrue(done, last)
                self.assertEqual(os.listdir(self.out), ["journal.sqlite"])
                self.assertEqual(self.run_json()["reused"], int(done.group(1)))
                self.same_bytes()

    def test_one_that_is_stopped_keeps_the_older_plans(self):
        shutil.copytree(self.plain, self.out)
        process = self.start("--set", "seed=2")
        process.send_signal(signal.SIGTERM)
        process.communicate()
        self.assertEqual(process.returncode, 143)
        self.same_bytes()


if __name__ == "__main__":
    main()
