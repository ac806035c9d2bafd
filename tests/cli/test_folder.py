"""A folder is a dataset: recordings as a laboratory sorted them, each with its own static trial, none
lost, none twice; what else lies there is said to be left out."""
import os
import shutil
import unittest

import h5py

from support import QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, main, morphe, sha256

TRIALS = ["ADL001AR1", "ADL001DR2", "ADL001FR1", "ADL004DR2", "ADL006DR2"]
STATICS = ["ADL001_static", "ADL004_static", "ADL006_static"]
TEXT = {name: (RECORDINGS / f"{name}.csv").read_text(encoding="utf-8-sig").splitlines()
        for name in TRIALS + STATICS}


def recording(source, person, mark, step=10):
    """A shipped one as `person`'s, every `step`-th row, with a marker MARK that rests at x = `mark` mm."""
    lines = TEXT[source]
    subject = source[:6]
    columns = len(lines[4].split(","))
    names = ",".join(lines[2].replace(f"{subject}:", f"{person}:").split(",")[:columns]) + f",{person}:MARK,,"
    rows = [f"{','.join(row.split(',')[:columns])},{mark:.3f},500.000,500.000" for row in lines[5::step] if row]
    return "\n".join(lines[:2] + [names, lines[3] + ",X,Y,Z", lines[4] + ",mm,mm,mm"] + rows) + "\n"


def left(text):
    """The same seen in the mirror: the left arm reaches."""
    lines = text.splitlines()
    names = lines[2].split(",")
    for k, name in enumerate(names):
        person, _, marker = name.rpartition(":")
        if marker and marker[0] in "RL":
            names[k] = f"{person}:{'L' if marker[0] == 'R' else 'R'}{marker[1:]}"
    rows = [row.split(",") for row in lines[5:]]
    for row in rows:
        for k in range(2, len(row), 3):
            row[k] = row[k] and f"{-float(row[k]):.3f}"
    return "\n".join(lines[:2] + [",".join(names)] + lines[3:5] + [",".join(r) for r in rows]) + "\n"


class FolderCase(CommandCase):
    def setUp(self):
        super().setUp()
        self.lab = self.folder / "lab"
        self.lab.mkdir()
        self.file = self.folder / "all.h5"

    def put(self, path, text):
        (self.lab / path).parent.mkdir(parents=True, exist_ok=True)
        (self.lab / path).write_text(text)

    def imported(self, *arguments, code=0):
        """{name: (mark of the recording, mark of its static trial or None)} and what was said."""
        # Marks are told by where points stand in the file.
        result = morphe("import", self.lab, "--out", self.file, "--forward", "recorded", *arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        with h5py.File(self.file) as file:
            found = {}
            for name, group in file["demonstrations"].items():
                still = group.get("calibration/markers/position")
                found[name] = tuple(None if data is None else round(1000 * data[0, -1, 0], 3)
                                    for data in (group["markers/position"], still))
            self.attributes = {name: dict(group.attrs) for name, group in file["demonstrations"].items()}
            self.reports = {name: list(group["import_notes"].asstr()) for name, group in file["demonstrations"].items()}
        return found, result.stderr


class AsALaboratorySortsThem(FolderCase):
    """Person p's trial t has mark 100 p + t, her static trial 100 p."""

    def lay_out(self, people, trials, trial_path, static_path):
        for p in range(1, people + 1):
            for t in range(1, trials + 1):
                self.put(trial_path.format(p=p, t=t, s=(t - 1) % 2 + 1),
                         recording(TRIALS[(p + t) % 5], f"S{p:02}", 100 * p + t))
            for s in (1, 2):  # the same file where the path has no session
                self.put(static_path.format(p=p, s=s),
                         recording(STATICS[p % 3], f"S{p:02}", 100 * p))

    def expect_all(self, people, trials):
        found, said = self.imported()
        self.assertEqual(sorted(found.values()),
                         [(100 * p + t, 100 * p) for p in range(1, people + 1)
                          for t in range(1, trials + 1)])
        self.assertIn(f"{people * trials} with a static trial", said)
        return found, said

    def test_sixteen_people_with_fifteen_trials_and_a_static_trial_each(self):
        self.lay_out(16, 15, "P{p:02}/reach{t:02}.csv", "P{p:02}/static.csv")
        for name in ("README.md", "P03/notes.pdf", "P05/picture.png"):
            self.put(name, "not a recording\n")
        found, said = self.expect_all(16, 15)
        self.assertIn("found: 240 recordings of 16 people", said)
        self.assertEqual(list(found)[:2], ["P01_reach01", "P01_reach02"])
        self.assertEqual(self.attributes["P07_reach03"]["subject"], b"P07")
        for name in ("README.md", "P03/notes.pdf", "P05/picture.png"):
            self.assertIn(f"skipped: {self.lab}/{name}: not a recording", said)

    def test_other_layouts(self):
        for number, (trial, static) in enumerate([
                ("ADL{p:03}DR{t}.csv", "ADL{p:03}_static.csv"),
                ("{p}_{t}_reach.csv", "{p}_cal.csv"),
                ("P{p}/S{s}/trial{t}.csv", "P{p}/S{s}/Static 01.csv"),
                ("group/P{p}/day{s}/t{t}.csv", "group/P{p}/T-Pose.csv"),
                ("P{p}/dynamic/Trial{t}.csv", "P{p}/Static/Trial1.csv"),
                ("reach/P{p:02}/{t}.csv", "calib/P{p:02}.csv"),
                ("day{s}/P{p:02}_{t}.csv", "day{s}/P{p:02}_neutral.csv")]):
            with self.subTest(trial):
                shutil.rmtree(self.lab)
                self.lab.mkdir()
                self.lay_out(11, 3, trial, static)
                found, _ = self.expect_all(11, 3)
                self.assertEqual(len(found), 33)
                self.assertEqual(len({a["subject"] for a in self.attributes.values()}), 11)

    def test_several_folders_at_once(self):
        self.lay_out(3, 2, "P{p}/t{t}.csv", "P{p}/static.csv")
        self.succeeds("import", self.lab / "P1", self.lab / "P3", "--out", self.file, "--forward", "recorded")
        with h5py.File(self.file) as file:
            self.assertEqual(list(file["demonstrations"]), ["P1_t1", "P1_t2", "P3_t1", "P3_t2"])


class WhatElseLiesThere(FolderCase):
    def test_people_without_a_static_trial_are_named(self):
        for p in (1, 2):
            for t in (1, 2):
                self.put(f"P{p}/t{t}.csv", recording("ADL001FR1", f"P{p}", 10 * p + t))
        self.put("P1/static.csv", recording("ADL001_static", "P1", 1))
        found, said = self.imported()
        self.assertEqual(sorted(found.values(), key=str), [(11, 1), (12, 1), (21, None), (22, None)])
        self.assertIn("note: P2: 2 recordings: no static trial found", said)
        self.assertIn("no static trial found", self.reports["P2_t1"])

    def test_the_hand_is_told_from_the_motion(self):
        self.put("right.csv", recording("ADL001DR2", "A", 1))
        self.put("other.csv", left(recording("ADL001DR2", "A", 1)))
        self.imported()
        self.assertEqual({name: a["hand"] for name, a in self.attributes.items()},
                         {"right": b"right", "other": b"left"})
        self.assertTrue(any("the left hand reaches" in note for note in self.reports["other"]))
        self.imported("--hand", "right")
        self.assertEqual(self.attributes["other"]["hand"], b"right")

    def test_doubles_hidden_files_angles_and_hdf5(self):
        text = recording("ADL001FR1", "A", 1)
        for name in ("a.csv", "copy/b.csv", ".c.csv", ".git/d.csv"):
            self.put(name, text)
        self.put("other/a.csv", recording("ADL001FR1", "A", 2))
        shutil.copy(RECORDINGS / "ADL001FR1angles.csv", self.lab)
        shutil.copy(SOURCE / "datasets/pyomeca/inverse_kin.mot", self.lab)
        with h5py.File(self.lab / "old.h5", "w"):
            pass
        found, said = self.imported()
        self.assertEqual(found, {"a": (1, None), "other_a": (2, None)})
        for what in ("copy/b.csv: identical to a.csv", ".c.csv: hidden", ".git: hidden",
                     "ADL001FR1angles.csv: not a recording", "inverse_kin.mot: only joint angles",
                     "old.h5: an HDF5 file"):
            self.assertIn(f"skipped: {self.lab}/{what}", said)

    def test_called_static_but_moving(self):
        self.put("static_cup.csv", recording("ADL001DR2", "A", 1))
        found, said = self.imported()
        self.assertEqual(found, {"static_cup": (1, None)})
        self.assertIn("named as a static trial, but the person moves", said)

    def test_one_that_cannot_be_read_does_not_lose_the_rest(self):
        self.put("good.csv", recording("ADL001FR1", "A", 1))
        self.put("bad.csv", recording("ADL001FR1", "A", 2)[:-200] + "x\n")
        found, said = self.imported(code=1)
        self.assertEqual(list(found), ["good"])
        self.assertRegex(said, f"cannot be read: {self.lab}/bad.csv:\\d+: ")
        self.assertIn("morphe inspect FILE", said)

    def test_nothing_that_can_be_read(self):
        self.refuses(morphe("import", self.lab, "--out", self.file), self.lab, "no recording")
        self.put("x.txt", "text\n")
        self.refuses(morphe("import", self.lab, "--out", self.file), self.lab, "1 not a recording")
        self.put("bad.csv", "Trajectories\n100\n")
        self.refuses(morphe("import", self.lab, "--out", self.file), f"{self.lab}/bad.csv:2")
        self.assertFalse(self.file.exists())

    def test_links_that_lead_in_circles(self):
        self.put("P1/t.csv", recording("ADL001FR1", "A", 1))
        self.put("P2/t.csv", recording("ADL001FR1", "A", 2))
        os.symlink(self.lab, self.lab / "P1/again")
        os.symlink(self.lab / "nowhere", self.lab / "broken.csv")
        os.mkfifo(self.lab / "pipe.csv")
        found, said = self.imported()
        self.assertEqual(list(found), ["P1_t", "P2_t"])
        for what in ("P1/again: link to a folder", "broken.csv: cannot be read", "pipe.csv: not a regular file"):
            self.assertIn(f"skipped: {self.lab}/{what}", said)

    def test_many_with_one_reason_are_counted(self):
        self.put("good.csv", recording("ADL001FR1", "A", 1))
        for k in range(500):
            self.put(f"notes/{k}.txt", f"{k}\n")
        _, said = self.imported()
        self.assertIn("skipped: 497 more: not a recording", said)
        self.assertLess(said.count("\n"), 10)

    def test_formats_side_by_side(self):
        for name in ("pyomeca/markers.csv", "pyomeca/markers.trc", "adroit-dapg/door_demo_06.csv"):
            shutil.copy(SOURCE / "datasets" / name, self.lab)
        self.put("P1/FR1.csv", recording("ADL001FR1", "A", 1))
        # from here, since what is not installed finds configs/names in the current folder
        result = morphe("inspect", self.lab, "--axes", "y -x z", "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in ("markers", "markers_trc", "door_demo_06", "P1_FR1"):
            self.assertIn(f'"name": "{name}"', result.stdout)

    def test_a_manifest_in_the_folder_decides(self):
        entries = self.json_of("inspect", SOURCE / "datasets/ue-adl")
        self.assertEqual([d["name"] for d in entries["demonstrations"]],
                         ["ADL001DR2", "ADL004DR2", "ADL006DR2", "ADL001FR1", "ADL001AR1"])
        shutil.copytree(RECORDINGS, self.lab / "adl")
        self.put("adl/more.csv", recording("ADL001FR1", "A", 1))
        _, said = self.imported()
        self.assertIn(f"skipped: {self.lab}/adl/more.csv: not listed in adl/recordings.yaml", said)


class TheManifest(FolderCase):
    def setUp(self):
        super().setUp()
        for t, source in enumerate(("ADL001FR1", "ADL001AR1")):
            self.put(f"it's P1/t{t}.csv", recording(source, "A", t + 1))
        self.put("it's P1/static.csv", recording("ADL001_static", "A", 9))
        self.manifest = self.folder / "all.recordings.yaml"

    def test_gives_the_same_bytes(self):
        self.imported()
        again = self.folder / "elsewhere/again.h5"
        again.parent.mkdir()
        self.succeeds("import", self.manifest, "--out", again)
        self.assertEqual(sha256(self.file), sha256(again))
        self.assertEqual(os.listdir(again.parent), ["again.h5"])

    def test_an_edited_one_is_not_replaced(self):
        self.imported()
        self.imported()
        self.manifest.write_text(self.manifest.read_text().replace("hand: 'right'", "hand: 'left'"))
        before = self.manifest.read_text()
        self.refuses(morphe("import", self.lab, "--out", self.file), self.manifest, "was edited")
        self.assertEqual(self.manifest.read_text(), before)

    def test_a_run_of_a_folder_and_of_its_manifest(self):
        """And the folder of results may lie in the dataset."""
        shutil.rmtree(self.lab)
        self.lab.mkdir()
        for name in ("ADL001FR1", "ADL001AR1", "ADL001_static"):
            shutil.copy(RECORDINGS / f"{name}.csv", self.lab)
        self.put("bad.csv", "Trajectories\n100\n")
        out = self.lab / "out"
        result = morphe("run", REFERENCE, "--dataset", self.lab, "--out", out, "--jobs", "0", *QUICK)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("3 demonstrations, 2 movements", result.stdout)
        self.assertIn("1 failed", result.stdout)
        with h5py.File(out / "plans.h5") as file:
            self.assertEqual(list(file["plans"]), ["ADL001AR1", "ADL001FR1"])
        (self.lab / "bad.csv").unlink()
        before = sha256(out / "plans.h5")
        for dataset in (self.lab, out / "recordings.yaml"):
            self.assertEqual(self.json_of("run", REFERENCE, "--dataset", dataset, "--out", out,
                                          *QUICK)["reused"], 2)
            self.assertEqual(sha256(out / "plans.h5"), before)

    def test_a_run_of_single_recordings(self):
        out = self.folder / "out"
        csv, static = RECORDINGS / "ADL001FR1.csv", RECORDINGS / "ADL001_static.csv"
        self.succeeds("run", REFERENCE, "--dataset", csv, "--dataset", static, "--out", out, *QUICK)
        with h5py.File(out / "demonstrations.h5") as file:
            self.assertEqual(list(file["demonstrations"]), ["ADL001FR1"])
            self.assertIn("calibration", file["demonstrations/ADL001FR1"])
        result = self.json_of("run", REFERENCE, "--dataset", csv, "--static-trial", static, "--out",
                              self.folder / "other", *QUICK)
        self.assertEqual(result["movements"], 1)


if __name__ == "__main__":
    main()
