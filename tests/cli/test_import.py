"""`morphe import` and `morphe inspect`, and what `run` makes of a recording without a usable arm."""
import os

import h5py
import numpy as np

from support import QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, main, morphe, sha256

DEMONSTRATIONS = ["ADL001DR2", "ADL004DR2", "ADL006DR2", "ADL001FR1", "ADL001AR1"]

ENTRY = ["name", "duration_s", "streams", "movements", "flags", "problems", "subject", "task", "hand",
         "calibration", "objects", "rebuilt", "residuals", "estimated", "missing", "reports",
         "points"]
STREAM = ["name", "rate_hz", "valid_share", "begin_s", "duration_s", "columns", "gaps", "longest_gap_s",
          "longest_gap_column", "empty_columns"]
PHASE = ["name", "begin_s", "end_s", "confidence", "begin_confidence", "end_confidence"]


def points_of(csv):
    """[N, K, 3] in metres, read apart from the program: NaN where a cell is empty."""
    rows = csv.read_text(encoding="utf-8-sig").splitlines()[5:]
    cells = [[float(c) if c.strip() else np.nan for c in row.split(",")[2:]] for row in rows if row]
    width = min(len(row) for row in cells) // 3 * 3
    return np.array([row[:width] for row in cells]).reshape(len(cells), -1, 3) / 1000


class Import(CommandCase):
    def test_the_shipped_manifest(self):
        file = self.folder / "all.h5"
        self.assertIn("5 demonstrations",
                      self.succeeds("import", RECORDINGS / "recordings.yaml", "--out", file).stdout)
        with h5py.File(file) as imported:
            self.assertEqual(list(imported["demonstrations"]), DEMONSTRATIONS)
            group = imported["demonstrations/ADL004DR2"]
            self.assertEqual({name: group.attrs[name] for name in
                              ("subject", "task", "hand", "licence", "upper_arm", "forearm")},
                             {"subject": b"ADL004", "task": b"drink", "hand": b"right",
                              "licence": b"MIT", "upper_arm": 0.261, "forearm": 0.234})

    def test_one_recording_with_its_static_trial(self):
        file, csv, static = (self.folder / "one.h5", RECORDINGS / "ADL001DR2.csv",
                             RECORDINGS / "ADL001_static.csv")
        self.succeeds("import", csv, "--static-trial", static, "--out", file, "--forward", "recorded")
        with h5py.File(file) as imported:
            self.assertEqual(list(imported["demonstrations"]), ["ADL001DR2"])
            group = imported["demonstrations/ADL001DR2"]
            for where, source in (("markers", csv), ("calibration/markers", static)):
                np.testing.assert_allclose(group[where]["position"], points_of(source), rtol=0,
                                           atol=1e-12)
                np.testing.assert_allclose(np.diff(group[where]["time"]), 0.01, rtol=0, atol=1e-12)
            self.assertEqual(list(group["markers"].attrs["names"][:2]), [b"RSHO1", b"RSHO2"])

    def test_without_a_static_trial(self):
        file = self.folder / "one.h5"
        self.succeeds("import", RECORDINGS / "ADL001FR1.csv", "--out", file)
        with h5py.File(file) as imported:
            self.assertNotIn("calibration", imported["demonstrations/ADL001FR1"])

    def test_several_sources_into_one_file(self):
        file = self.folder / "mixed.h5"
        self.succeeds("import", RECORDINGS / "ADL001FR1.csv",
                      SOURCE / "datasets/adroit-dapg/recordings.yaml", "--out", file)
        entries = self.json_of("inspect", file)["demonstrations"]
        self.assertEqual(entries[0]["name"], "ADL001FR1")
        self.assertGreater(len(entries), 1)

    def test_twice_is_the_same_file(self):
        for name in ("a.h5", "b.h5"):
            self.succeeds("import", RECORDINGS / "recordings.yaml", "--out", self.folder / name)
        self.assertEqual(sha256(self.folder / "a.h5"), sha256(self.folder / "b.h5"))

    def test_failure_leaves_the_older_file(self):
        file, csv = self.folder / "one.h5", self.folder / "bad.csv"
        file.write_text("an older file")
        csv.write_text("Trajectories\n100\n")
        self.refuses(morphe("import", csv, "--out", file), f"{csv}:2")
        self.assertEqual(file.read_text(), "an older file")
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad.csv", "one.h5"])

    def test_the_same_name_twice(self):
        csv = RECORDINGS / "ADL001FR1.csv"
        self.refuses(morphe("import", csv, csv, "--out", self.folder / "two.h5"), csv, "ADL001FR1")
        self.assertEqual(os.listdir(self.folder), [])


class Inspect(CommandCase):
    def test_the_shipped_recordings_each_hold_a_movement(self):
        file = self.folder / "all.h5"
        self.succeeds("import", RECORDINGS / "recordings.yaml", "--out", file)
        found = self.json_of("inspect", file)
        self.assertEqual(list(found), ["demonstrations"])
        self.assertEqual([entry["name"] for entry in found["demonstrations"]], DEMONSTRATIONS)
        for entry in found["demonstrations"]:
            with self.subTest(entry["name"]):
                self.assertEqual(list(entry), ENTRY)
                # Palms lie flatter than a forearm can turn them; that is said, nothing else is.
                self.assertEqual([problem for problem in entry["problems"]
                                  if not problem.startswith("arm angles: the hand is turned")], [])
                rows = len(points_of(RECORDINGS / f"{entry['name']}.csv"))
                self.assertAlmostEqual(entry["duration_s"], (rows - 1) / 100)
                stream, = entry["streams"]
                self.assertEqual(list(stream), STREAM)
                points = points_of(RECORDINGS / f"{entry['name']}.csv")
                hidden = np.isnan(points).any(axis=2)
                self.assertAlmostEqual(stream["valid_share"], 1 - hidden.mean())
                starts = hidden & ~np.vstack([np.zeros((1, hidden.shape[1]), bool), hidden[:-1]])
                self.assertEqual(stream["gaps"], starts.sum())
                self.assertEqual(len(stream["empty_columns"]), hidden.all(axis=0).sum())
                self.assertEqual(stream["name"], "markers")
                self.assertAlmostEqual(stream["rate_hz"], 100)
                self.assertTrue(0.5 < stream["valid_share"] <= 1)
                self.assertGreaterEqual(len(entry["movements"]), 1)
                for movement in entry["movements"]:
                    self.assertEqual(list(movement), ["begin_s", "end_s", "phases", "target", "flags",
                                                      "unusable_reason"])
                    self.assertEqual(movement["unusable_reason"], "")
                    self.assertTrue(0 <= movement["begin_s"] < movement["end_s"]
                                    <= entry["duration_s"])
                    for phase in movement["phases"]:
                        self.assertEqual(list(phase), PHASE)
                        for key in PHASE[3:]:
                            self.assertTrue(0 <= phase[key] <= 1)
                    self.assertIn("reach", [phase["name"] for phase in movement["phases"]])
        printed = self.succeeds("inspect", file).stdout
        self.assertIn("ADL001DR2: ", printed)
        movements = sum(len(entry["movements"]) for entry in found["demonstrations"])
        self.assertIn(f"5 demonstrations, {movements} movements, {movements} of them usable",
                      printed)

    def test_says_what_will_not_be_usable_and_why(self):
        few, file = self.folder / "few.csv", self.folder / "few.h5"
        rows = "".join(f"{i + 1},0,{100 + i},200,300\n" for i in range(200))
        few.write_text("Trajectories\n100\n,,A:RFTP\nFrame,Sub Frame,X,Y,Z\n,,mm,mm,mm\n" + rows)
        self.succeeds("import", few, "--out", file)
        entry, = self.json_of("inspect", file)["demonstrations"]
        self.assertTrue(any("shoulder" in what for what in entry["missing"]), entry["missing"])
        self.assertEqual(entry["rebuilt"]["shoulder"], 0)

    def test_takes_the_options_of_a_config(self):
        file, config = self.folder / "one.h5", self.folder / "other.yaml"
        self.succeeds("import", RECORDINGS / "recordings.yaml", "--out", file)
        config.write_text(f"extends: {REFERENCE}\nsegment: {{min_reach_distance: 5}}\n")
        default = self.json_of("inspect", file)
        asked = self.json_of("inspect", file, "--config", config)
        self.assertTrue(all(entry["movements"] for entry in default["demonstrations"]))
        self.assertFalse(any(entry["movements"] for entry in asked["demonstrations"]))

    def test_broken_files(self):
        file = self.folder / "broken.h5"
        self.refuses(morphe("inspect", file), file)
        file.write_text("no HDF5\n")
        self.refuses(morphe("inspect", file), file)
        whole = self.folder / "whole.h5"
        self.succeeds("import", RECORDINGS / "ADL001FR1.csv", "--out", whole)
        content = whole.read_bytes()
        file.write_bytes(content[:len(content) // 2])
        self.refuses(morphe("inspect", file), file)

    def test_a_file_that_is_broken_further_on_prints_no_half_json(self):
        file = self.folder / "all.h5"
        self.succeeds("import", RECORDINGS / "recordings.yaml", "--out", file)
        with h5py.File(file, "r+") as imported:
            del imported["demonstrations/ADL001AR1/markers/time"]
        self.refuses(morphe("inspect", file, "--json"),
                     f"{file}:/demonstrations/ADL001AR1/markers/time")


class PartlySeen(CommandCase):
    """What was missing in an executable plan stands in its detail and in what `run` prints."""

    def detail_of(self, rows):
        """Plans ADL001FR1 with its rows changed, returns the plan's status and detail."""
        lines = (RECORDINGS / "ADL001FR1.csv").read_text(encoding="utf-8-sig").splitlines()
        csv, dataset, out = (self.folder / name for name in ("reach.csv", "reach.h5", "out"))
        csv.write_text("\n".join(lines[:5] + rows(lines[2].split(","), lines[5:])) + "\n")
        self.succeeds("import", csv, "--static-trial", RECORDINGS / "ADL001_static.csv", "--out", dataset)
        printed = self.succeeds("run", REFERENCE, "--dataset", dataset, "--out", out, *QUICK).stdout
        with h5py.File(out / "plans.h5") as file:
            plan = file["plans/reach/000"]
            detail = plan.attrs["detail"].decode()
            self.assertIn(detail, printed)
            return plan.attrs["status"], detail

    def test_a_hidden_tip_is_named(self):
        def hide_thumb(names, rows):
            column = names.index("ADL001:RTHUM")
            for i in range(100, 130):
                cells = rows[i].split(",")
                cells[column:column + 3] = ["", "", ""]
                rows[i] = ",".join(cells)
            return rows
        status, detail = self.detail_of(hide_thumb)
        self.assertEqual(status, b"executable")
        self.assertRegex(detail, r"thumb_tip has a goal in \d+ of \d+ frames")

    def test_a_reach_that_is_cut_off_is_not_planned(self):
        status, detail = self.detail_of(lambda names, rows: rows[:150])
        self.assertEqual(status, b"infeasible")
        self.assertIn("the recording ends while the hand moves", detail)


class WithoutAnArm(CommandCase):
    """Two markers are no arm: nothing is dropped in silence, the recording still ends as a plan."""

    def setUp(self):
        super().setUp()
        self.csv = self.folder / "few.csv"
        rows = "".join(f"{i + 1},0,{100 + i},200,300,400,{500 - i},600\n" for i in range(200))
        self.csv.write_text("Trajectories\n100\n,,A:RFTP,,,A:RHAN1,,\n"
                            "Frame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n" + rows)
        self.dataset = self.folder / "few.h5"
        self.succeeds("import", self.csv, "--out", self.dataset)
        self.out = self.folder / "out"

    def run_it(self, *arguments):
        return morphe("run", REFERENCE, "--dataset", self.dataset, "--out", self.out, *QUICK,
                      *arguments)

    def test_ends_as_an_infeasible_plan_with_its_reason(self):
        result = self.run_it()
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File(self.out / "plans.h5") as file:
            plan = file["plans/few/000"]
            self.assertEqual(plan.attrs["status"], b"infeasible")
            self.assertNotEqual(plan.attrs["reason"], b"")
            self.assertNotEqual(plan.attrs["detail"], b"")
            self.assertNotIn("trajectory", plan)
            self.assertIn(plan.attrs["reason"].decode(), result.stdout)
        self.succeeds("verify", self.out / "plans.h5")

    def test_is_counted(self):
        summary = self.json_of("run", REFERENCE, "--dataset", self.dataset, "--out", self.out)
        self.assertEqual((summary["demonstrations"], summary["infeasible"], summary["failed"]),
                         (1, 1, 0))
        self.assertEqual(sum(summary["reasons"].values()), 1)

    def test_strict_makes_it_a_failure_but_keeps_the_file(self):
        self.assertEqual(self.run_it("--strict").returncode, 1)
        self.assertTrue((self.out / "plans.h5").exists())

    def test_inspect_says_so_before(self):
        entry, = self.json_of("inspect", self.dataset)["demonstrations"]
        self.assertGreater(len(entry["problems"]), 0)
        self.assertEqual([phase["confidence"] for movement in entry["movements"]
                          for phase in movement["phases"] if phase["confidence"] > 0], [])

    def test_does_not_hinder_the_others(self):
        both = self.folder / "both.h5"
        self.succeeds("import", self.csv, RECORDINGS / "ADL001AR1.csv", "--static-trial",
                      RECORDINGS / "ADL001_static.csv", "--out", both)
        self.dataset = both
        result = self.run_it("--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File(self.out / "plans.h5") as file:
            self.assertEqual(list(file["plans"]), ["few", "ADL001AR1"])
            self.assertGreater(len(file["plans/ADL001AR1/000/mapped/position"]), 0)


if __name__ == "__main__":
    main()
