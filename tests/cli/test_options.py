"""Options that change nothing are refused; a dataset says all that is wrong with it at once, with what to
paste, and plans the rest."""
import json
import os
import shlex
import shutil

import h5py

from support import QUICK, RECORDINGS, REFERENCE, SOURCE, TWO_RECORDINGS, CommandCase, main, morphe

OPTIONS = {"--axes": "x y z", "--unit": "mm", "--rate": "100", "--hand": "left",
           "--joint-order": "mano", "--static-trial": RECORDINGS / "ADL001_static.csv"}
ADROIT = SOURCE / "datasets/adroit-dapg/door_demo_06.csv"


def write_two_recordings(folder):
    """A manifest alone in its folder."""
    manifest = folder / "recordings.yaml"
    manifest.write_text(TWO_RECORDINGS.replace("recorded/", f"{RECORDINGS}/"))
    return manifest


class WithoutEffect(CommandCase):
    def commands(self, dataset):
        yield "import", dataset, "--out", self.folder / "no.h5"
        yield "inspect", dataset
        yield "run", REFERENCE, *QUICK, "--dataset", dataset, "--out", self.folder / "no"

    def refused(self, option, *command):
        result = morphe(*command)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertTrue(result.stderr.startswith(f"{option} has no effect"), result.stderr)
        self.assertEqual(sorted(set(os.listdir(self.folder)) - {"lab", "in.h5"}), [])
        return result.stderr

    def test_in_a_folder_whose_manifest_lists_all(self):
        lab = self.folder / "lab"
        lab.mkdir()
        manifest = write_two_recordings(lab)
        for option, value in OPTIONS.items():
            for command in self.commands(lab):
                with self.subTest(option, command=command[0]):
                    said = self.refused(option, *command, option, value)
                    self.assertIn(f"all recordings of {lab} are listed in {manifest}", said)
                    self.assertIn("change it there", said)

    def test_a_static_trial_beside_a_manifest(self):
        lab = self.folder / "lab"
        lab.mkdir()
        manifest = write_two_recordings(lab)
        for command in self.commands(manifest):
            self.refused("--static-trial", *command, "--static-trial", RECORDINGS / "ADL001_static.csv")

    def test_on_demonstrations_that_were_imported(self):
        file = self.folder / "in.h5"
        self.succeeds("import", ADROIT, "--out", file)
        for option, value in {**OPTIONS, "--forward": "recorded", "--format": "adroit-csv"}.items():
            for command in list(self.commands(file))[1:]:
                with self.subTest(option, command=command[0]):
                    self.assertIn("have been imported; give the recordings",
                                  self.refused(option, *command, option, value))

    def test_on_a_format_that_does_not_need_them(self):
        for option in ("--axes", "--unit", "--rate", "--joint-order"):
            for command in self.commands(ADROIT):
                with self.subTest(option, command=command[0]):
                    self.assertIn("adroit-csv", self.refused(option, *command, option, OPTIONS[option]))
        self.refused("--joint-order", "inspect", RECORDINGS / "ADL001FR1.csv", "--joint-order", "mano")

    def test_of_names_and_static_trials_that_no_recording_of_a_folder_has(self):
        lab = self.folder / "lab"
        lab.mkdir()
        shutil.copy(ADROIT, lab)
        names = lab / "names.yaml"
        names.write_text("Schulter: right_shoulder\n")
        for command in self.commands(lab):
            self.assertIn("names", self.refused("--names", *command, "--names", names))
            self.assertIn("markers", self.refused("--static-trial", *command, "--static-trial",
                                                  RECORDINGS / "ADL001_static.csv"))

    def test_of_a_table_that_is_not_printed(self):
        run = "run", REFERENCE, "--dataset", ADROIT, "--out", self.folder / "no"
        for option in (("--sort", "name"), ("--only", "infeasible")):
            for silent in ("--json", "--quiet"):
                self.refused(option[0], *run, *option, silent)
            self.refused(option[0], "diff", "a.h5", "b.h5", *option, "--json")
        self.refused("--all", "diff", "a.h5", "b.h5", "--all", "--json")
        self.refused("--dataset", "explain", "a.h5", "--dataset", ADROIT)
        self.refused("--mass-range", "simulate", "a.h5", "--out", self.folder / "no", "--rollouts", "1",
                     "--mass-range", "0.1", "0.2")
        self.refused("--seed", "simulate", "a.h5", "--out", self.folder / "no", "--rollouts", "1", "--seed", "1")
        self.refused("--points", "inspect", ADROIT, "--points", "--json")
        self.refused("--tilt", "place", REFERENCE, "--mount", "any", "--tilt", "5")
        self.refused("--tilt", "place", REFERENCE, "--fix", "rotation", "--tilt", "5")
        self.refused("--mount", "place", REFERENCE, "--mount", "wall", "--fix", "rotation")

    def test_of_a_robot_that_is_set_up(self):
        robots = SOURCE / "configs/robots"
        arm = robots / "urdf/fr3.urdf"
        out = ("--out", self.folder / "no.yaml")
        self.refused("--mount", "robot", "setup", arm, *out, "--mount", *"000000")
        self.refused("--hand", "robot", "setup", arm, robots / "urdf/allegro.urdf", *out, "--hand", "palm")
        for option in (("--arm", "x"), ("--elbow", "x"), ("--package", f"x={robots}"), ("--limit", "x=0..1"), ("--capsules", "3")):
            self.refused(option[0], "robot", "setup", robots / "pa10.yaml", robots / "dlr_hit2.yaml", *out, *option)

    def test_those_that_change_a_part_are_noted_for_the_others(self):
        lab = self.folder / "lab"
        (lab / "listed").mkdir(parents=True)
        write_two_recordings(lab / "listed")
        shutil.copy(RECORDINGS / "ADL001FR1.csv", lab)
        out = self.folder / "in.h5"
        self.succeeds("import", lab, "--hand", "left", "--out", out)
        with h5py.File(out) as h5:
            hands = {name: group.attrs["hand"].decode() for name, group in h5["demonstrations"].items()}
            notes = list(h5["demonstrations/ADL001DR2/import_notes"].asstr())
        self.assertEqual(hands, {"ADL001DR2": "right", "ADL001AR1": "right", "ADL001FR1": "left"})
        self.assertIn(f"--hand not applied: {lab}/listed/recordings.yaml decides", notes)

    def test_a_manifest_that_is_given_obeys(self):
        lab = self.folder / "lab"
        lab.mkdir()
        manifest = write_two_recordings(lab)
        listed = self.json_of("inspect", manifest, "--hand", "left")["demonstrations"]
        self.assertEqual({entry["hand"] for entry in listed}, {"left"})


class AllAtOnce(CommandCase):
    def setUp(self):
        super().setUp()
        (self.folder / "bad.csv").write_text("Trajectories\n100\n")
        self.manifest = write_two_recordings(self.folder)
        with open(self.manifest, "a") as manifest:
            manifest.write("  - {file: bad.csv}\n  - {file: nowhere.csv}\n")

    def test_the_bad_recordings_of_a_manifest(self):
        result = morphe("import", self.manifest, "--out", self.folder / "read.h5")
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"cannot be read: {self.folder}/bad.csv:2: ", result.stderr)
        self.assertIn(f"cannot be read: {self.folder}/nowhere.csv: ", result.stderr)
        with h5py.File(self.folder / "read.h5") as h5:
            self.assertEqual(list(h5["demonstrations"]), ["ADL001DR2", "ADL001AR1"])
        out = self.folder / "out"
        planned = morphe("run", REFERENCE, *QUICK, "--dataset", self.manifest, "--out", out)
        self.assertEqual(planned.returncode, 1, planned.stderr)
        self.assertIn("4 demonstrations, 2 movements", planned.stdout)
        self.assertIn("2 failed", planned.stdout)

    def test_a_manifest_of_bad_ones_alone(self):
        self.manifest.write_text("recordings:\n  - {file: bad.csv}\n  - {file: nowhere.csv}\n")
        result = morphe("import", self.manifest, "--out", self.folder / "no.h5")
        self.assertEqual(result.returncode, 2)
        lines = result.stderr.splitlines()
        self.assertTrue(lines[0].startswith(f"{self.folder}/bad.csv:2: "), lines)
        self.assertTrue(lines[1].startswith(f"{self.folder}/nowhere.csv: "), lines)
        self.assertFalse((self.folder / "no.h5").exists())

    def test_the_errors_of_a_manifest(self):
        self.manifest.write_text("forearm: -1\nrecordings:\n  - {file: bad.csv, upper_arm: 0, hnad: left}\n"
                                 "  - {name: a, rate_hz: fast}\n")
        result = morphe("import", self.manifest, "--out", self.folder / "no.h5")
        self.assertEqual(result.returncode, 2)
        for key in ("forearm", "upper_arm", "hnad", "file", "rate_hz"):
            self.assertIn(key, result.stderr)

    def test_several_paths_are_inspected(self):
        shutil.copy(RECORDINGS / "ADL001FR1.csv", self.folder)
        stored = self.folder / "stored.h5"
        self.succeeds("import", ADROIT, "--out", stored)
        result = morphe("inspect", self.folder / "ADL001FR1.csv", self.folder / "bad.csv", stored, "--json")
        self.assertEqual(result.returncode, 1, result.stderr)
        told = json.loads(result.stdout)
        self.assertEqual([entry["name"] for entry in told["demonstrations"]], ["door_demo_06", "ADL001FR1"])
        self.assertEqual([entry["file"] for entry in told["skipped"]], [str(self.folder / "bad.csv")])


class Questions(CommandCase):
    def unitless(self, name):
        file = self.folder / "lab" / name
        file.parent.mkdir(exist_ok=True)
        rows = [f"{k / 100},{0.3 + 0.001 * k},0.2,0.9,{0.2 + 0.002 * k},0.4,0.8,{0.1 + 0.003 * k},0.6,0.8"
                for k in range(100)]
        file.write_text("time,right_shoulder_x,right_shoulder_y,right_shoulder_z,right_elbow_x,right_elbow_y,"
                        "right_elbow_z,right_wrist_x,right_wrist_y,right_wrist_z\n" + "\n".join(rows) + "\n")
        return file

    def test_each_skipped_recording_has_its_command(self):
        files = [self.unitless(f"{name}.csv") for name in "ab"]
        shutil.copy(RECORDINGS / "ADL001FR1.csv", self.folder / "lab")
        result = morphe("import", self.folder / "lab", "--out", self.folder / "read.h5", cwd=self.folder)
        self.assertEqual(result.returncode, 1, result.stderr)
        said = result.stderr.split("to import what is asked about, check and paste:\n")[1]
        (command,) = [line for line in said.splitlines() if line.startswith("morphe import ")]
        for file in files:
            self.assertIn(str(file), command)
        self.assertIn("--unit m", command)
        words = shlex.split(command)[1:]
        self.succeeds(*words, cwd=self.folder)
        with h5py.File(self.folder / words[words.index("--out") + 1]) as h5:
            self.assertEqual(sorted(h5["demonstrations"]), ["a", "b"])

    def test_of_a_manifest_the_lines_are_told(self):
        file = self.unitless("a.csv")
        manifest = self.folder / "lab/some.yaml"
        manifest.write_text(f"recordings:\n  - {{file: a.csv}}\n  - {{file: {RECORDINGS}/ADL001FR1.csv}}\n")
        result = morphe("import", manifest, "--out", self.folder / "read.h5")
        self.assertEqual(result.returncode, 1, result.stderr)
        said = result.stderr.split("to import what is asked about, check and paste:\n")[1]
        self.assertIn(f"for {file}\n", said)
        self.assertIn(f"add to {manifest}", said)
        self.assertIn("\nunit: m\n", said)


if __name__ == "__main__":
    main()
