"""The page of `morphe report` shows a plan's contacts, its quality, and what became of it in physics."""
import json
import shutil

import h5py
import numpy as np

from support import SOURCE, CommandCase, main, morphe, planned_sample, sys

sys.path.insert(0, str(SOURCE / "tests/support"))
import browser  # noqa: E402
from report_page import Page  # noqa: E402

PLAN = "ADL001DR2/000"


def setUpModule():
    global PLANS, PHYSICS
    PLANS = planned_sample("--set", "grasp.close_fingers=true")
    PHYSICS = PLANS.parent / "simulated"
    done = morphe("simulate", PLANS, "--out", PHYSICS, "--rollouts", 2, "--only", PLAN)
    if "has no MuJoCo" in done.stderr:
        PHYSICS = None
    else:
        assert done.returncode == 0, done.stderr


class ReportGrasp(CommandCase):
    def page(self, *arguments):
        result = self.succeeds("report", PLANS, "--out", self.folder / "page.html", *arguments)
        return Page(self.folder / "page.html"), result.stdout

    def physics(self, folder):
        """Results of two rollouts, simulated once."""
        if PHYSICS is None:
            self.skipTest("built without MuJoCo")
        shutil.copytree(PHYSICS, folder)
        return json.loads((folder / "ADL001DR2_000.json").read_text())

    def physics_of_another_plan(self):
        other = self.folder / "other.h5"
        shutil.copy(PLANS, other)
        with h5py.File(other, "r+") as file:
            file["plans"][PLAN]["trajectory/position"][0] += 1e-6
        self.succeeds("simulate", other, "--out", self.folder / "other", "--rollouts", 1, "--only", PLAN, "--unverified")
        return self.folder / "other"

    def row(self, page):
        return next(row for row in page.rows if row["plan"] == PLAN)

    def test_contacts_and_quality_are_those_of_the_file(self):
        page, _ = self.page()
        shown = page.plan(PLAN)["grasp"]
        with h5py.File(PLANS) as file:
            grasp = file["plans"][PLAN]["grasp"]
            self.assertEqual([one["tip"] for one in shown["contacts"]],
                             list(grasp["contacts/tip"].asstr()))
            for name in ("point", "normal", "signed_distance", "normal_force"):
                np.testing.assert_array_equal([one[name] for one in shown["contacts"]],
                                              grasp["contacts"][name][()])
            self.assertEqual(shown["quality"]["available_force"], grasp["quality"].attrs["available_force"])
        self.assertIsNone(self.row(page)["physics"])

    def test_physics_is_that_of_this_plan_alone(self):
        results = self.physics(self.folder / "physics")
        page, _ = self.page("--simulation", self.folder / "none", "--simulation", self.folder / "physics")
        shown = self.row(page)["physics"]
        self.assertEqual((shown["held"], shown["rollouts"]), (results["held"], 2))
        self.assertEqual(shown["load_directions"], 6)
        self.assertEqual(shown["torque_ratio"], max(one["torque_ratio"] for one in results["rollouts"]))
        self.assertEqual(sum(shown["failures"].values()), 2 - shown["held"])
        self.assertEqual(shown["commanded_force_N"], results["rollouts"][0]["commanded_force_N"])
        file = self.folder / "physics/ADL001DR2_000.json"
        page, printed = self.page("--simulation", self.physics_of_another_plan())
        self.assertIsNone(self.row(page)["physics"])
        self.assertIn(f"{PLAN}: skipped: the simulation belongs to another plan", printed)
        for broken in ("{}", "[", json.dumps({"format": 1, "version": 1, "plan_sha256": 2}),
                       json.dumps(results | {"version": 2}), json.dumps(results | {"held": 2 - results["held"]})):
            file.write_text(broken)
            done = morphe("report", PLANS, "--out", self.folder / "none.html", "--simulation", file.parent)
            self.refuses(done, file)
            self.assertIn("is not a result of morphe simulate", done.stderr)
            self.assertFalse((self.folder / "none.html").exists())

    def test_what_lies_beside_the_plans_is_found(self):
        beside = self.folder / "run"
        beside.mkdir()
        shutil.copy(PLANS, beside)
        self.physics(beside / "physics")
        self.succeeds("report", beside, "--out", self.folder / "page.html")
        self.assertEqual(self.row(Page(self.folder / "page.html"))["physics"]["load_directions"], 6)

    def test_a_browser_shows_them(self):
        self.physics(self.folder / "physics")
        self.page("--simulation", self.folder / "physics")
        window = browser.open_browser(1280, 900)
        self.addCleanup(window.quit)
        window.get(f"{(self.folder / 'page.html').as_uri()}#{PLAN}/1.4")
        browser.wait_until(window, "return document.querySelectorAll('.plot').length >= 5")
        tips = window.execute_script("return [...document.querySelectorAll('.contacts tbody th')].map(e => e.textContent)")
        with h5py.File(PLANS) as file:
            self.assertEqual(tips, list(file["plans"][PLAN]["grasp/contacts/tip"].asstr()))
        text = window.execute_script("return document.querySelector('.grasp').innerText")
        for part in ("Physics simulation (MuJoCo", "of 2 rollouts", "required to lift, commanded", "from the plan"):
            self.assertIn(part, text)

        def picture():
            return browser.pixels(window.get_screenshot_as_png())[:, :760]
        with_pins = picture()
        window.execute_script("[...document.querySelectorAll('.bar label')].find("
                              "e => e.textContent.trim() === 'contacts').querySelector('input').click()")
        browser.wait_until(window, "return true")
        self.assertTrue((with_pins != picture()).any())
        self.assertEqual(browser.messages(window), [])


if __name__ == "__main__":
    main()
