"""`morphe study`, the small version of the shipped study: the files that it writes, that its figures
are within what is wanted, that they hang on config and inputs alone, and bad configs. Takes 30 s of
processor time: six kinds of study, each with figures of its own."""
import csv
import re
import xml.etree.ElementTree as ElementTree

import h5py
import numpy as np

from support import (QUICK, SOURCE, CommandCase, Path, json, line_of, main, morphe, replace, sha256,
                     temporary_folder)

RECORDINGS = SOURCE / "configs/studies/recordings.yaml"
SMALL = """\
study: recordings
synthetic:
  - name: one
    config: one.yaml
    quick_count: 1
    max_median_error_s: 0.1
"""


def with_whole_paths(study):
    """The text of a shipped study that can stand anywhere."""
    text = (SOURCE / f"configs/studies/{study}.yaml").read_text()
    return text.replace("../../datasets", f"{SOURCE}/datasets").replace(" ../", f" {SOURCE}/configs/").replace(
        "[../", f"[{SOURCE}/configs/")


class ShippedStudy(CommandCase):
    """One run for all that is asked of it: it takes seconds."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.out = Path(holder.name) / "out"
        cls.result = morphe("study", RECORDINGS, "--quick", "--out", cls.out)
        assert cls.result.returncode == 0, cls.result.stderr
        cls.rows = json.loads((cls.out / "results.json").read_text())["rows"]

    def test_every_figure_is_within_what_is_wanted(self):
        wanted = [row for row in self.rows if "requirement" in row]
        self.assertGreater(len(wanted), 20)
        for row in wanted:
            relation, limit = row["requirement"].split()
            with self.subTest(f"{row['case']} {row['metric']}"):
                self.assertIsNotNone(row["ours"])
                difference = row["ours"] - float(limit)
                self.assertGreaterEqual(-difference if relation == "<=" else difference, 0)
                self.assertTrue(row["requirement_met"])

    def test_json_csv_and_hdf5_say_the_same(self):
        with open(self.out / "results.csv", newline="") as file:
            table = list(csv.DictReader(file))
        with h5py.File(self.out / "results.h5") as h5:
            self.assertEqual(h5.attrs["format"], b"morphe-study")
            columns = {name: h5[name][()] for name in ("case", "metric", "units", "ours", "count")}
        self.assertEqual(len(table), len(self.rows))
        for name, column in columns.items():
            self.assertEqual(len(column), len(self.rows), name)
        for k, row in enumerate(self.rows):
            case = "; ".join(row["case"].values())
            self.assertEqual((table[k]["case"], table[k]["metric"], table[k]["unit"]),
                             (case, row["metric"], row["unit"]))
            self.assertEqual((columns["case"][k].decode(), columns["metric"][k].decode(),
                              columns["units"][k].decode()), (case, row["metric"], row["unit"]))
            ours = np.nan if row["ours"] is None else row["ours"]
            np.testing.assert_array_equal(columns["ours"][k], ours)
            np.testing.assert_array_equal(float(table[k]["ours"] or "nan"), ours)
            self.assertEqual(int(table[k]["count"]), row["count"])
            self.assertEqual(columns["count"][k], row["count"])

    def test_speeds_are_printed_and_not_written(self):
        self.assertRegex(self.result.stdout, r"reconstruction, times real time +\d")
        self.assertNotIn("times real time", (self.out / "results.json").read_text())

    def test_every_printed_row_that_misses_says_so(self):
        self.assertNotIn("not met", self.result.stdout)

    def test_the_number_of_threads_changes_no_byte(self):
        """Of the same sets, with three recordings each of those that are made."""
        config = self.folder / "recordings.yaml"
        text = with_whole_paths("recordings").replace("    quick_count: 10\n", "")
        config.write_text(re.sub("( +)config: .*", r"\g<0>\n\1quick_count: 3", text))
        two, one = (self.folder / str(jobs) for jobs in (2, 1))
        for out in (two, one):
            self.succeeds("study", config, "--quick", "--out", out, "--jobs", out.name)
        names = sorted(path.name for path in two.iterdir())
        self.assertEqual(names, sorted(path.name for path in one.iterdir()))
        for name in names:
            self.assertEqual(sha256(two / name), sha256(one / name), name)

    def test_plots_can_be_read(self):
        plots = sorted(self.out.glob("*.svg"))
        self.assertIn("ADL001DR2.svg", [plot.name for plot in plots])
        for plot in plots:
            with self.subTest(plot.name):
                root = ElementTree.parse(plot).getroot()
                width, height = (float(root.get(side)) for side in ("width", "height"))
                texts, ticks = [], []
                for element in root.iter():
                    if not element.tag.endswith("text") or element.get("transform"):
                        continue
                    self.assertTrue(element.text, "a text without words")
                    x, y = float(element.get("x")), float(element.get("y"))
                    self.assertTrue(0 <= x < width and 0 < y < height, element.text)
                    texts.append((x, y))
                    if re.fullmatch(r"-?[\d.e-]+", element.text):
                        ticks.append((x, y))
                self.assertEqual(len(texts), len(set(texts)), "texts on top of each other")
                self.assertGreater(len(ticks), 4)


class SmallStudy(CommandCase):
    def setUp(self):
        super().setUp()
        self.config = self.folder / "small.yaml"
        self.config.write_text(SMALL)
        (self.folder / "one.yaml").write_text("movements:\n  movements_per_recording: [1, 1]\n")

    def run_study(self):
        return morphe("study", self.config, "--quick", "--out", self.folder / "out")

    def test_paths_start_at_the_config(self):
        self.assertEqual(self.run_study().returncode, 0)
        rows = json.loads((self.folder / "out/results.json").read_text())["rows"]
        self.assertEqual({row["case"]["set"] for row in rows}, {"one"})

    def test_bad_configs_name_their_line(self):
        for old, new, key in (("quick_count: 1", "quick_count: many", "quick_count"),
                              ("max_median_error_s: 0.1", "max_median: 0.1", "max_median"),
                              ("study: recordings", "study: nothing", "study")):
            with self.subTest(new):
                self.config.write_text(SMALL)
                replace(self.config, old, new)
                self.refuses(self.run_study(), f"{self.config}:{line_of(self.config, new)}", key)
                self.assertFalse((self.folder / "out").exists())

    def test_what_a_study_names_must_be_there(self):
        (self.folder / "one.yaml").unlink()
        result = self.run_study()
        self.assertEqual(result.returncode, 2)
        self.assertIn("one.yaml", result.stderr)
        self.assertFalse((self.folder / "out").exists())
        missing = morphe("study", self.folder / "none.yaml", "--out", self.folder / "out")
        self.assertEqual(missing.returncode, 2)
        self.assertIn("none.yaml", missing.stderr)


class MappingStudies(CommandCase):
    """The paper's results and whole movements, on few frames."""

    def rows_of(self, text, *options):
        config = self.folder / "study.yaml"
        config.write_text(text)
        out = self.folder / f"out{len(options)}"
        self.succeeds("study", config, "--quick", "--out", out, *options)
        for row in json.loads((out / "results.json").read_text())["rows"]:
            if "requirement" in row:
                self.assertTrue(row["requirement_met"], row)
        return out

    def test_the_paper(self):
        text = (SOURCE / "configs/studies/paper.yaml").read_text()
        text = text.replace("../../datasets", f"{SOURCE}/datasets")
        text = text.replace("../robots", f"{SOURCE}/configs/robots")
        out = self.rows_of(text + "cases: [fingers, mappings, reference]\n"
                           "quick_step_s: 0.5\nstarts: 8\n")
        rows = json.loads((out / "results.json").read_text())["rows"]
        self.assertEqual({row["case"]["fingers"] for row in rows if "fingers" in row["case"]},
                         set("3456"))
        published = [row["published"] for row in rows if row["published"] is not None]
        self.assertIn(0.06665, published)
        ElementTree.parse(out / "figure_3.svg")

    def test_whole_movements(self):
        study = SOURCE / "configs/studies"
        text = f"""\
study: mapping
reference_variant: ours
ik_variant: plain
sets:
  - {{name: real, pipeline: {study}/../pipelines/pa10_dlr_hit2.yaml,
     manifest: {SOURCE}/datasets/ue-adl/recordings.yaml}}
variants:
  - {{name: ours}}
  - {{name: plain, set: [map.humanlike_arm=0, map.humanlike_fingers=0]}}
"""
        out = self.rows_of(text)
        alone = self.rows_of(text, "--jobs", "1")
        self.assertEqual(sha256(out / "results.json"), sha256(alone / "results.json"))
        rows = json.loads((out / "results.json").read_text())["rows"]
        ratio, = [row["ours"] for row in rows if row["metric"] == "A, ratio"]
        self.assertLess(ratio, 1)

    def test_obstacles_in_the_way(self):
        study = SOURCE / "configs/studies"
        text = (study / "repair.yaml").read_text().replace("repair_pipeline.yaml", f"{study}/repair_pipeline.yaml")
        out = self.rows_of(text.replace("../synthetic", f"{study}/../synthetic"))
        rows = json.loads((out / "results.json").read_text())["rows"]
        ours = {row["metric"]: row["ours"] for row in rows
                if row["case"] == {"obstacle": "all", "variant": "ours"}}
        self.assertEqual(ours["executable"], 1)
        self.assertEqual(ours["states in collision"], 0)


class HandsStudy(CommandCase):
    """Hands alone: the shipped study's small version has a row for every method and metric."""

    def test_every_method_is_measured_and_pinches_close(self):
        config = SOURCE / "configs/studies/hands.yaml"
        result = morphe("study", config, "--quick", "--out", self.folder / "hands")
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = json.loads((self.folder / "hands/results.json").read_text())["rows"]
        figures = {(row["case"]["method"], row["metric"]): row for row in rows}
        for method in ("Morphe", "vector", "DexPilot"):
            for metric in ("tip error, mean", "largest step in 10 ms",
                           "thumb-index distance, correlation with the human's"):
                self.assertIsNotNone(figures[method, metric]["ours"])
        ours = figures["Morphe", "thumb-index error in pinches, median"]
        self.assertTrue(ours["requirement_met"])
        self.assertTrue(figures["Morphe", "tip acceleration over goal acceleration"]["requirement_met"])
        # 30 frames a second for 20.67 s, rebuilt at 100.
        self.assertEqual(figures["Morphe", "largest step in 10 ms"]["count"], 2067)


class TradeOffStudy(CommandCase):
    """The shipped study's small version, and a config that cannot be meant."""

    def test_rows_table_and_picture_agree(self):
        out = self.folder / "out"
        self.succeeds("study", SOURCE / "configs/studies/trade_off.yaml", "--quick", "--out", out)
        rows = json.loads((out / "results.json").read_text())["rows"]
        figures = {(row["case"].get("recordings"), row["case"]["weight"], row["metric"]): row["ours"] for row in rows}
        knee = figures[None, "map.palm_direction", "knee"]
        self.assertIn(knee, (0, 1.6))
        self.assertGreater(figures["choose", "map.palm_direction=0", "executable"], 0)
        palm = {value: figures["choose", f"map.palm_direction={value}", "palm angle to the human's, median"]
                for value in ("0", "1.6")}
        self.assertLess(palm["1.6"], palm["0"])
        table = (out / "palm_direction.md").read_text()
        for value, angle in palm.items():
            shown = f"**{value}**" if float(value) == knee else value
            self.assertRegex(table, rf"\| {re.escape(shown)} \|.*\| {np.degrees(angle):.1f} \|")
        root = ElementTree.parse(out / "palm_direction.svg").getroot()
        self.assertIn("palm [deg]", [element.text for element in root.iter()])

    def test_values_must_ascend(self):
        config = self.folder / "trade_off.yaml"
        config.write_text(with_whole_paths("trade_off").replace("[0, 0.1,", "[0.1, 0,"))
        result = morphe("study", config, "--quick", "--out", self.folder / "out")
        self.assertEqual(result.returncode, 2)
        self.assertIn("values: must ascend", result.stderr)


class GraspStudy(CommandCase):
    """The shipped study's small version with a small search: objects of known contacts in a hand, planned
    both ways."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.base = Path(holder.name)
        search = ", ".join(setting for setting in QUICK if "=" in setting)
        text = with_whole_paths("grasp").replace("set: [grasp.touch_distance=0.010]", f"set: [grasp.touch_distance=0.010, {search}]")
        cls.text = text.replace("{name: fingertips}", f"{{name: fingertips, set: [{search}]}}")
        cls.out = cls.run_study("all", cls.text)
        rows = json.loads((cls.out / "results.json").read_text())["rows"]
        cls.rows = {(row["case"]["set"], row["case"]["variant"], row["metric"]): row
                    for row in rows}

    @classmethod
    def run_study(cls, name, text, *options):
        config = cls.base / f"{name}.yaml"
        config.write_text(text)
        result = morphe("study", config, "--quick", "--out", cls.base / name, *options)
        assert result.returncode == 0, result.stderr
        return cls.base / name

    def test_contacts_are_nearer_to_the_known_ones_than_fingertips_are(self):
        metric = "contact point error, median"
        contacts = self.rows["synthetic", "contacts", metric]
        self.assertEqual(contacts["count"], 6)  # thumb, index and middle finger of two grasps
        self.assertLess(contacts["ours"], self.rows["synthetic", "fingertips", metric]["ours"])
        self.assertTrue(contacts["requirement_met"])

    def test_pads_sink_in_by_no_more_than_a_millimetre(self):
        for name in ("synthetic", "drinking"):
            row = self.rows[name, "contacts", "penetration of pads, largest"]
            self.assertGreater(row["count"], 0)
            self.assertTrue(row["requirement_met"], row)

    def test_contacts_of_an_inferred_cup_count_for_nothing(self):
        metrics = {metric for name, _, metric in self.rows if name == "drinking"}
        self.assertIn("contacts touching", metrics)
        self.assertNotIn("contact point error, median", metrics)

    def test_a_contact_is_kept_or_given_up(self):
        for name in ("synthetic", "drinking"):
            asked, given_up, touch = (self.rows[name, "contacts", metric]["ours"] for metric in
                                      ("contacts demonstrated", "contacts dropped", "contacts touching"))
            self.assertGreater(asked, 0)
            self.assertLessEqual(given_up + touch, asked)

    def test_the_plans_can_be_verified(self):
        names = sorted(path.name for path in (self.out / "plans").iterdir())
        self.assertEqual(names, sorted(f"{name}-pa10_dlr_hit2-{variant}.h5"
                                       for name in ("synthetic", "adroit", "drinking")
                                       for variant in ("contacts", "fingertips")))
        for name in names:
            with self.subTest(name):
                printed = self.succeeds("verify", self.out / "plans" / name).stdout
                self.assertRegex(printed, " 0 violations")

    def test_the_number_of_threads_changes_no_byte(self):
        """Of the set whose contacts are known."""
        synthetic = self.text.partition("  - name: adroit")[0]
        two, one = (self.run_study(f"jobs_{jobs}", synthetic, "--jobs", jobs) for jobs in (2, 1))
        for name in ("results.json", "results.csv", "results.h5",
                     "plans/synthetic-pa10_dlr_hit2-contacts.h5"):
            self.assertEqual(sha256(two / name), sha256(one / name), name)

    def test_a_baseline_with_contacts_is_none(self):
        config = self.folder / "grasp.yaml"
        config.write_text(with_whole_paths("grasp").replace(
            "{name: fingertips}", "{name: fingertips, set: [grasp.touch_distance=0.020]}"))
        result = morphe("study", config, "--quick", "--out", self.folder / "out")
        self.assertEqual(result.returncode, 2)
        self.assertIn("`fingertips` must not", result.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    main()
