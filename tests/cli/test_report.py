"""`morphe report`: a page holds what the file holds, and is there whole or not at all."""
import xml.etree.ElementTree

import h5py
import numpy as np

from support import SOURCE, Path, main, morphe, sha256, shared_run, sys, temporary_folder, unittest

sys.path[:0] = [str(SOURCE / "tests/support"), str(SOURCE / "tests")]
import pictures  # noqa: E402
from docs_test import SHOWN_BY, same_line  # noqa: E402
from report_page import Page  # noqa: E402

PIPELINES = SOURCE / "configs/pipelines"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = temporary_folder()
        cls.runs = Path(cls.temporary.name)
        for pipeline, out in (("pa10_dlr_hit2_obstacle", "post"), ("fr3", "fr3")):
            done = morphe("run", PIPELINES / f"{pipeline}.yaml", "--out", cls.runs / out, "--jobs", 1, "--report")
            assert done.returncode == 0, done.stderr
        cls.post, cls.fr3 = cls.runs / "post/plans.h5", cls.runs / "fr3/plans.h5"

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def setUp(self):
        folder = temporary_folder()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.page = self.folder / "page.html"

    def refused(self, *arguments):
        done = morphe("report", *arguments, "--out", self.page)
        self.assertEqual((done.returncode, done.stdout, list(self.folder.glob("page*"))), (2, "", []))
        return done.stderr

    def made(self, *arguments):
        done = morphe("report", *arguments, "--out", self.page)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return Page(self.page)

    def test_the_page_holds_the_files_numbers(self):
        page = self.made(self.post)
        run = page.report["runs"][0]
        with h5py.File(self.post) as file:
            plans = [f"{name}/{k}" for name in file["plans"] for k in file["plans"][name]]
            self.assertEqual([row["plan"] for row in page.rows], plans)
            self.assertEqual(run["sha256"], sha256(self.post))
            self.assertEqual(run["config_sha256"], file.attrs["config_sha256"].decode())
            for row in page.rows:
                self.holds(page, row, file["plans"][row["plan"]])

    def holds(self, page, row, group):
        certificate = group["certificate"].attrs
        kinds = group["certificate/clearance_by_kind"]
        self.assertEqual([each["kind"] for each in row["certificate"].pop("clearance_by_kind")],
                         list(kinds["kind"].asstr()))
        for key, value in row["certificate"].items():
            stored = certificate[key]
            if value is None:
                self.assertTrue(np.isnan(stored), key)
            else:
                self.assertEqual(value, stored.decode() if isinstance(stored, bytes) else stored, key)
        self.assertEqual(set(row["certificate"]), set(certificate))
        plan = page.plan(row["plan"])
        motion = next(motion for motion in plan["motions"] if motion["name"] == "trajectory")
        sample = motion["sample"][:, 0].astype(int)
        trajectory = group["trajectory"]
        away = np.abs(motion["position"] - trajectory["position"][()][sample])
        self.assertLessEqual(away.max(), page.report["angle_error"] * 1.0001)
        self.assertLessEqual(np.abs(motion["time"][:, 0] - trajectory["time"][()][sample]).max(), 5.1e-5)
        self.assertLessEqual(np.abs(motion["clearance"][:, 0] - trajectory["clearance"][()][sample]).max(), 5.1e-6)
        goals, shown = group["goals/tip_position"][()], plan["human"]["tips"]
        np.testing.assert_allclose(shown, goals.reshape(len(goals), -1), atol=1.1e-5)
        # The least clearance is among what is shown, and so is every joint's greatest speed.
        self.assertIn(trajectory["clearance"][()].argmin(), sample)
        for fastest in np.abs(trajectory["velocity"][()]).argmax(axis=0):
            self.assertIn(fastest, sample)

    def test_same_bytes_from_run_and_report_and_any_number_of_threads(self):
        again = self.folder / "again"
        done = morphe("run", PIPELINES / "fr3.yaml", "--out", again, "--jobs", 2, "--report")
        self.assertEqual(done.returncode, 0)
        self.assertIn("report.html: open it in a browser", done.stdout)
        self.assertEqual(sha256(again / "report.html"), sha256(self.runs / "fr3/report.html"))
        self.made(self.post)
        first = sha256(self.page)
        self.made(self.post)
        self.assertEqual(sha256(self.page), first)

    def test_nothing_is_loaded_from_elsewhere(self):
        self.made(self.post)
        text = self.page.read_text(encoding="utf-8")
        head = text[:text.index("<title>")]
        self.assertIn("default-src 'none'", head)
        self.assertNotRegex(text, r"<(?:script|img|link|iframe)[^>]*(?:src|href)=")

    def test_selection_says_what_it_leaves_out(self):
        page = self.made(self.fr3, "--infeasible")
        self.assertEqual([(row["plan"], row["reason"]) for row in page.rows],
                         [("ADL006DR2/000", "goal_in_collision")])
        self.assertIn("4 of 5 plans", page.report["runs"][0]["left_out"])
        page = self.made(self.post, "--plans", "ADL001*")
        self.assertEqual([row["plan"] for row in page.rows], ["ADL001DR2/000", "ADL001FR1/000", "ADL001AR1/000"])
        page = self.made(self.post, "--worst", 2, "duration_ratio")
        with h5py.File(self.post) as file:
            duration_ratio = {f"{name}/000": file[f"plans/{name}/000/certificate"].attrs["duration_ratio"] for name in file["plans"]}
        worst = sorted(duration_ratio, key=duration_ratio.get)[-2:]
        self.assertEqual({row["plan"] for row in page.rows}, set(worst))

    def test_an_infeasible_plan_has_its_worst_instant_and_advice(self):
        plan = self.made(self.fr3).plan("ADL006DR2/000")
        with h5py.File(self.fr3) as file:
            time = file["plans/ADL006DR2/000/goals/time"][()]
        self.assertTrue(time[0] <= plan["worst"]["demonstration_s"] <= time[-1])
        self.assertIn("fr3_", plan["worst"]["sentence"])
        self.assertGreaterEqual(len(plan["advice"]), 1)

    def test_several_runs_on_one_page(self):
        page = self.made(self.post, self.runs / "fr3")
        self.assertEqual([(run["name"], run["shown"]) for run in page.report["runs"]], [("post", 5), ("fr3", 5)])
        self.assertEqual(len(page.rows), 10)
        self.assertEqual(page.report["runs"][1]["robot"]["name"], page.report["runs"][1]["robot_name"])

    def test_pictures(self):
        done = morphe("report", self.fr3, "--svg", self.folder / "films")
        self.assertEqual(done.returncode, 0, done.stderr)
        films = sorted((self.folder / "films").iterdir())
        self.assertEqual([film.name for film in films],
                         [f"{name}_000.svg" for name in
                          ("ADL001AR1", "ADL001DR2", "ADL001FR1", "ADL004DR2", "ADL006DR2")])
        for film in films:
            text = film.read_text()
            xml.etree.ElementTree.fromstring(text)
            self.assertEqual(text.count("<clipPath"), 5)
            self.assertNotIn("nan", text)
        self.assertIn("worst", films[-1].read_text())

    def test_the_pictures_of_the_documents_are_of_todays_plans(self):
        """To the letter where the build is the one that drew them, else within the documents' tolerance."""
        runs = {"pa10_dlr_hit2_obstacle": self.post.parent, "fr3": self.fr3.parent}
        with h5py.File(self.post) as file:
            exact = all(part in file.attrs["built_with"].decode() for part in SHOWN_BY)
        for picture, (pipeline, plans, _) in pictures.PICTURES.items():
            with self.subTest(picture=picture):
                run = runs.get(pipeline) or shared_run(PIPELINES / f"{pipeline}.yaml", dataset="one recording") / "out"
                today = pictures.rows_of_list(morphe("list", run, "--only", plans).stdout).splitlines()
                drawn = pictures.text_of((SOURCE / f"docs/pictures/{picture}.png").read_bytes()).splitlines()
                alike = drawn == today if exact else len(drawn) == len(today) and all(map(same_line, drawn, today))
                self.assertTrue(alike, f"docs/pictures/draw.py draws {picture} anew; it shows\n" + "\n".join(drawn) +
                                "\nand today's plans are\n" + "\n".join(today))

    def test_what_cannot_be_read_is_said_and_nothing_is_left_behind(self):
        self.assertIn("nothing.h5", self.refused(self.folder / "nothing.h5"))
        text = self.folder / "text.h5"
        text.write_text("no HDF5")
        self.assertIn("text.h5", self.refused(text))
        self.assertIn("demonstrations.h5", self.refused(self.runs / "fr3/demonstrations.h5"))
        broken = self.folder / "broken.h5"
        broken.write_bytes(self.fr3.read_bytes()[:100000])
        self.assertIn("broken.h5", self.refused(broken))
        self.assertIn("--worst", self.refused(self.fr3, "--worst", "x", "tip_error_max"))
        self.assertIn("beauty", self.refused(self.fr3, "--worst", "1", "beauty"))
        self.assertIn("contains no plans.h5", self.refused(self.folder))
        self.assertIn("no plan has the name", self.refused(self.fr3, "--plans", "nobody*"))
        self.assertIn("--out", morphe("report", self.fr3).stderr)

    def test_a_folder_that_is_not_there(self):
        done = morphe("report", self.fr3, "--out", self.folder / "no/such/page.html")
        self.assertEqual(done.returncode, 2)
        self.assertIn("page.html", done.stderr)

    def test_a_damaged_plan_leaves_the_page_before(self):
        self.made(self.fr3)
        before = sha256(self.page)
        damaged = self.folder / "damaged.h5"
        damaged.write_bytes(self.fr3.read_bytes())
        with h5py.File(damaged, "r+") as file:
            del file["plans/ADL001AR1/000/trajectory/velocity"]
        done = morphe("report", damaged, "--out", self.page)
        self.assertEqual(done.returncode, 2)
        self.assertIn("ADL001AR1", done.stderr)
        self.assertEqual(sha256(self.page), before)


if __name__ == "__main__":
    main()
