"""What a disk or a dataset can do to a run: a clear end, nothing half-written under its name, and a
folder that goes on when all is well again."""
import os
import resource
import shutil
import subprocess

import h5py

from many import COUNT, ManyCase
from support import MORPHE, main, morphe, sha256


class Full(ManyCase):
    def limited(self, kilobytes):
        """No file may grow beyond this: to a program it looks like a full disk."""
        limit = (kilobytes * 1024,) * 2
        return subprocess.run([MORPHE, *map(str, self.command(self.out))], capture_output=True,
                              text=True,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limit))

    def test_it_fills_up_at_any_place(self):
        whole = os.stat(self.plain / "plans.h5").st_size // 1024
        for kilobytes in (1, 20, whole // 3, whole - 20):
            with self.subTest(kilobytes):
                shutil.rmtree(self.out, ignore_errors=True)
                result = self.limited(kilobytes)
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                last = result.stderr.splitlines()[-1]
                self.assertTrue(last.startswith(str(self.out)), result.stderr)
                self.assertIn("cannot be", last)
                if self.out.exists():
                    self.assertNotIn("plans.h5", os.listdir(self.out))
                self.run_json()
                self.same_bytes()

    def test_older_plans_stay(self):
        shutil.copytree(self.plain, self.out)
        older = os.stat(self.out / "plans.h5").st_ino
        result = self.limited(os.stat(self.plain / "plans.h5").st_size // 2048)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(os.stat(self.out / "plans.h5").st_ino, older)
        self.same_bytes()


class Dataset(ManyCase):
    def setUp(self):
        super().setUp()
        self.copy = self.folder / "copy.h5"
        shutil.copy(self.dataset, self.copy)

    def damage(self, name):
        with h5py.File(self.copy) as file:
            chunk = file[f"demonstrations/{name}/sensors/position"].id.get_chunk_info(0)
        damaged = bytearray(self.copy.read_bytes())
        damaged[chunk.byte_offset + chunk.size // 2] ^= 0xFF
        self.copy.write_bytes(damaged)

    def test_one_damaged_demonstration_does_not_stop_the_others(self):
        self.damage("synthetic_000003")
        result = morphe(*self.command(self.out, "--json", "--jobs", 8, dataset=self.copy))
        self.assertEqual((result.returncode, result.stderr), (1, ""))
        self.assertIn('"failed": 1', result.stdout)
        with h5py.File(self.out / "plans.h5") as file:
            self.assertEqual(len(file["plans"]), COUNT - 1)
        shutil.copy(self.dataset, self.copy)
        self.assertEqual(self.run_json(dataset=self.copy)["reused"], COUNT - 1)
        self.same_bytes()

    def test_truncated_while_it_is_read(self):
        process = self.start(dataset=self.copy)
        os.truncate(self.copy, os.stat(self.copy).st_size // 2)
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 2, errors)
        self.assertEqual(errors.splitlines()[-1], f"{self.copy}: was changed by another process while being read")
        self.refuses(morphe(*self.command(self.out, dataset=self.copy)), self.copy, "HDF5")
        shutil.copy(self.dataset, self.copy)
        self.assertGreater(self.run_json(dataset=self.copy)["reused"], 0)
        self.same_bytes()

    def test_taken_away_while_it_is_read(self):
        process = self.start(dataset=self.copy)
        self.copy.unlink()
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 0, errors)
        self.same_bytes()


if __name__ == "__main__":
    main()
