"""Parts of a dataset that are run apart, and `morphe merge`: the bytes of one run, or the list of what
is wrong."""
import os
import shutil
import sqlite3

import h5py

from many import COUNT, ManyCase
from support import main, morphe, sha256


class Shards(ManyCase):
    def run_shards(self, count, *arguments):
        folders = [self.folder / f"shard{i}" for i in range(1, count + 1)]
        for i, folder in enumerate(folders, 1):
            self.run_json("--shard", f"{i}/{count}", *arguments, out=folder)
        return folders

    def test_any_division_gives_the_same_bytes(self):
        for count in (1, 3, 16):
            with self.subTest(count):
                merged = self.folder / f"merged{count}"
                folders = self.run_shards(count)
                summary = self.json_of("merge", *reversed(folders), "--out", merged)
                self.assertEqual(summary["demonstrations"], COUNT)
                self.same_bytes(merged)
                self.assertEqual(os.listdir(merged), ["plans.h5"])
                for folder in folders:
                    shutil.rmtree(folder)

    def test_they_are_balanced_by_length_and_each_demonstration_is_in_one(self):
        with h5py.File(self.dataset) as file:
            frames = {name: max(len(group[stream]["time"]) for stream in ("sensors", "hand"))
                      for name, group in file["demonstrations"].items()}
        loads, seen = [], []
        for folder in self.run_shards(3):
            with h5py.File(folder / "plans.h5") as file:
                names = list(file["plans"])
            loads.append(sum(frames[name] for name in names))
            seen += names
        self.assertEqual(sorted(seen), sorted(frames))
        self.assertLessEqual(max(loads) - min(loads), max(frames.values()))

    def test_slurm_says_which(self):
        environment = {"SLURM_ARRAY_TASK_ID": "6", "SLURM_ARRAY_TASK_MIN": "5",
                       "SLURM_ARRAY_TASK_MAX": "7", "SLURM_ARRAY_TASK_COUNT": "3"}
        self.addCleanup(os.environ.update, dict(os.environ))
        for name in environment:
            self.addCleanup(os.environ.pop, name, None)
        os.environ.update(environment)
        self.run_json("--shard", "slurm")
        self.run_json("--shard", "2/3", out=self.folder / "plain")
        self.assertEqual(sha256(self.out / "plans.h5"), sha256(self.folder / "plain/plans.h5"))
        os.environ["SLURM_ARRAY_TASK_COUNT"] = "2"
        self.refuses(morphe(*self.command(self.out, "--shard", "slurm")), "--shard slurm", "gaps")
        del os.environ["SLURM_ARRAY_TASK_ID"]
        self.refuses(morphe(*self.command(self.out, "--shard", "slurm")), "--shard slurm",
                     "SLURM_ARRAY_TASK_ID")

    def test_shards_that_are_none(self):
        for shard in ("0/3", "4/3", "1", "1/0", "a/b", "-1/3", "1/3/5"):
            with self.subTest(shard):
                self.refuses(morphe(*self.command(self.out, f"--shard={shard}")), f"--shard {shard}")
                self.assertFalse(self.out.exists())

    def merge_refuses(self, folders, *mentioned):
        self.refuses(morphe("merge", *folders, "--out", self.folder / "merged"), "merge", *mentioned)
        self.assertFalse((self.folder / "merged").exists())

    def test_what_is_wrong_is_listed(self):
        one, two, three = self.run_shards(3)
        self.merge_refuses([one], "missing of 3 shards: 2, 3")
        self.merge_refuses([one, three, three], f"{three}: shard 3/3 was given twice",
                           "missing of 3 shards: 2")
        self.run_json("--shard", "2/3", "--set", "seed=2", "--fresh", out=two)
        self.merge_refuses([one, two, three], f"{two}: has another config: seed 1 -> 2",
                           "missing of 3 shards: 2")
        self.run_json("--shard", "2/4", "--fresh", out=two)
        self.merge_refuses([one, two, three], f"{two}: is shard 2/4, but the run has 3 shards")
        other = self.folder / "other.h5"
        shutil.copy(self.dataset, other)
        with h5py.File(other, "r+") as file:
            file["demonstrations/synthetic_000001"].attrs["task"] = "another"
        self.run_json("--shard", "2/3", "--fresh", out=two, dataset=other)
        self.merge_refuses([one, two, three], f"{two}: has another dataset")
        self.run_json("--shard", "2/3", "--fresh", out=two)
        with sqlite3.connect(two / "journal.sqlite") as journal:
            journal.execute("UPDATE metadata SET value = '0' WHERE key = 'complete'")
            journal.execute("DELETE FROM results WHERE name IN (SELECT name FROM scheduled LIMIT 2)")
        self.merge_refuses([one, two, three],
                           f"{two}: shard 2/3 is not finished: 2 of {COUNT // 3} demonstrations left")
        self.run_json("--shard", "2/3", out=two)
        self.succeeds("merge", one, two, three, "--out", self.folder / "merged")
        self.same_bytes(self.folder / "merged")

    def test_folders_that_are_none(self):
        empty = self.folder / "empty"
        empty.mkdir()
        self.refuses(morphe("merge", empty, "--out", self.folder / "merged"),
                     empty / "journal.sqlite", "does not exist")
        self.assertEqual(os.listdir(empty), [])

    def test_the_folder_of_a_run_is_not_written_over(self):
        self.refuses(morphe("merge", self.plain, "--out", self.plain), self.plain, "folder of a run")

    def test_a_read_only_shard(self):
        """Merging writes nothing into the shards."""
        folders = self.run_shards(2)
        before = {folder: sorted(os.listdir(folder)) for folder in folders}
        for folder in folders:
            for file in folder.iterdir():
                file.chmod(0o400)
            folder.chmod(0o500)
            self.addCleanup(folder.chmod, 0o700)
        self.succeeds("merge", *folders, "--out", self.folder / "merged")
        self.same_bytes(self.folder / "merged")
        self.assertEqual({folder: sorted(os.listdir(folder)) for folder in folders}, before)


if __name__ == "__main__":
    main()
