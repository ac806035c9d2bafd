"""A plans.h5 keeps all that its plans were made from: config, settings, robot, scene and meshes. They are bound
by one hash, judged without the disk, and say nothing of where they were. What is not the plan's fault is never
called a violation: too few file descriptors, little memory, no temporary folder."""
import json
import os
import resource
import shutil
import subprocess
import unittest

import h5py
import numpy as np

from formats import strings, text
from support import MORPHE, QUICK, REFERENCE, SOURCE, CommandCase, main, morphe, python_verify, shared_run

import forged_plans
import verify_plans

SHELF = SOURCE / "configs/pipelines/pa10_dlr_hit2_shelf.yaml"


def setUpModule():
    global PLAIN, SHELVES
    PLAIN = shared_run(REFERENCE, *QUICK, dataset="two recordings") / "out/plans.h5"
    SHELVES = shared_run(SHELF, *QUICK, "--set", "retime.sample_rate_hz=25", dataset="one recording") / "out/plans.h5"


class Stored(CommandCase):
    def test_settings_and_hash(self):
        with h5py.File(PLAIN) as file:
            self.assertEqual(text(file.attrs["settings"]).splitlines(),
                             ["config=pipelines/pa10_dlr_hit2.yaml", *QUICK[1::2]])
            self.assertEqual(text(file.attrs["inputs_sha256"]), verify_plans.inputs_hash(file))

    def test_a_mesh_is_kept_with_its_bytes(self):
        with h5py.File(SHELVES) as file:
            stored = file["inputs/scenes/shelf.stl"][()]
            self.assertEqual(bytes(stored), (SOURCE / "configs/scenes/shelf.stl").read_bytes())

    def test_another_mesh_gives_another_hash_and_is_found(self):
        copy = self.folder / "plans.h5"
        tally = forged_plans.Tally()
        kinds = [kind for kind in forged_plans.KINDS if kind.startswith("a_mesh_")]
        self.assertEqual(len(kinds), 6)
        rng = np.random.default_rng(1)
        for kind in kinds:
            forged_plans.forge_batch([SHELVES], [kind], rng, self.folder, MORPHE, tally)
        self.assertEqual((set(tally.made), set(tally.missed)), (set(kinds), set()))
        shutil.copy(SHELVES, copy)
        with h5py.File(copy, "r+") as file:
            content = file["inputs/scenes/shelf.stl"][()] + b"\n"  # the same mesh
            del file["inputs/scenes/shelf.stl"]
            file["inputs/scenes/shelf.stl"] = np.bytes_(content)
        for result in (morphe("verify", copy, "--json"), python_verify(copy)):
            self.assertEqual(result.returncode, 1)
            self.assertIn("inputs_sha256", [row["subject"] for row in json.loads(result.stdout)["violations"]])

    def test_the_key_that_was_changed_is_named(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLAIN, copy)
        with h5py.File(copy, "r+") as file:
            config = text(file.attrs["config"])
            file.attrs["config"] = np.bytes_(config.replace("starts: 4", "starts: 5").encode())
        rows = json.loads(morphe("verify", copy, "--json").stdout)["violations"]
        self.assertIn("@config: map.starts 5 -> 4", [row["subject"] for row in rows])
        self.assertIn("config_sha256", [row["subject"] for row in rows])

    def test_absolute_paths_are_not_told(self):
        """Neither by the robot's file, by those that the config extends, nor by --set."""
        place = self.folder / "home/jane"
        shutil.copytree(SOURCE / "configs/robots", place / "robots")
        shutil.copytree(SOURCE / "configs/pipelines", place / "pipelines")
        shutil.copytree(SOURCE / "configs/scenes", place / "scenes")
        config = self.folder / "own/config.yaml"
        config.parent.mkdir()
        config.write_text(f"extends: {place}/pipelines/pa10_dlr_hit2_shelf.yaml\n"
                          f"robot: {{file: '{place}/robots/pa10_dlr_hit2.yaml'}}\n")
        self.succeeds("run", config, "--dataset", SHELVES.parent / "demonstrations.h5", "--out", self.folder / "out",
                      *QUICK, "--set", f"scene.file={place}/scenes/shelf_over_the_cup.yaml",
                      "--set", "retime.sample_rate_hz=25")
        plans = self.folder / "out/plans.h5"
        with h5py.File(plans) as file:
            for where, string in strings(file):
                self.assertNotIn("jane", string, where)
                self.assertNotIn(str(self.folder), string, where)
        self.succeeds("verify", plans)


class ShortMachine(CommandCase):
    def judged(self, plans, limits=(), **environment):
        """The exit code, after limits of resources were set; nothing but 0 and 2 is right."""
        def limit():
            for what, most in limits:
                resource.setrlimit(what, (most, most))
        result = subprocess.run([MORPHE, "verify", plans, "--jobs", "2"], capture_output=True, text=True,
                                env={**os.environ, **environment}, preexec_fn=limit)
        if "error while loading shared libraries" in result.stderr:
            return 2  # the program has not begun
        self.assertIn(result.returncode, (0, 2), (limits, environment, result.stdout, result.stderr))
        self.assertNotIn("violation", result.stderr)
        if result.returncode == 2:
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        return result.returncode

    def test_no_temporary_folder(self):
        closed = self.folder / "closed"
        closed.mkdir(mode=0o500)
        for plans in (PLAIN, SHELVES):
            for folder in (self.folder / "missing", closed, "/dev/full"):
                self.assertEqual(self.judged(plans, TMPDIR=str(folder)), 0)
        self.assertEqual(list(closed.iterdir()), [])

    def test_a_temporary_folder_for_every_command(self):
        """Closed, missing or no folder: the verdict on honest plans is the same, and what a command writes has the same bytes."""
        closed = self.folder / "closed"
        closed.mkdir(mode=0o500)
        for folder in ("missing", "closed", "full"):
            place = "/dev/full" if folder == "full" else self.folder / folder
            environment = {**os.environ, "TMPDIR": str(place), "XDG_CACHE_HOME": str(place)}
            for command in (("list", PLAIN), ("diff", PLAIN, PLAIN), ("explain", PLAIN),
                            ("verify", PLAIN, "--dataset", PLAIN.parent / "demonstrations.h5"),
                            ("export", PLAIN, "--format", "csv", "--out", self.folder / f"csv_{folder}"),
                            ("report", PLAIN, "--out", self.folder / f"{folder}.html")):
                result = subprocess.run([MORPHE, *map(str, command)], capture_output=True, text=True, env=environment)
                self.assertEqual((result.returncode, result.stderr), (0, ""), command)
                self.assertNotIn("not verified", result.stdout)
        written = [sorted((path.name, path.read_bytes()) for path in (self.folder / f"csv_{folder}").iterdir())
                   for folder in ("missing", "closed", "full")]
        self.assertEqual(written[0], written[1])
        self.assertEqual(written[0], written[2])

    def test_few_file_descriptors(self):
        for plans in (PLAIN, SHELVES):
            codes = [self.judged(plans, [(resource.RLIMIT_NOFILE, count)]) for count in range(3, 10)]
            self.assertEqual((codes[0], codes[-1]), (2, 0))

    def test_little_memory(self):
        """Never a verdict on the plan; libraries may still crash where an allocation fails."""
        for plans in (PLAIN, SHELVES):
            for megabytes in (80, 90, 100, 150):
                def limit(most=megabytes << 20):
                    resource.setrlimit(resource.RLIMIT_AS, (most, most))
                result = subprocess.run([MORPHE, "verify", plans], capture_output=True, text=True, preexec_fn=limit)
                self.assertNotEqual(result.returncode, 1, (megabytes, result.stdout))


if __name__ == "__main__":
    main()
