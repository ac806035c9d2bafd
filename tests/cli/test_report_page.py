"""The page of `morphe report` in a browser: it draws, plays, is worked by keys alone, shows the file's
numbers, and takes names from files as text. Takes half a minute of processor time: Chromium draws WebGL in
software, and reads every page anew."""
import base64
import shutil
from unittest import mock

import h5py
import numpy as np
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from support import QUICK, SOURCE, Path, estimate_arm, main, morphe, shared_run, sys, temporary_folder, unittest

sys.path.insert(0, str(SOURCE / "tests/support"))
import browser  # noqa: E402

# What Chromium itself says when it takes the canvas into a page that is put together without WebGL's library.
OF_THE_BROWSER = "GPU stall due to ReadPixels"
PIPELINES = SOURCE / "configs/pipelines"
HOSTILE = "<img src=x onerror=alert(1)></script><script>alert(2)</script>"


class Composed(browser.Options):
    """Puts the page together without WebGL's library, which halves the processor time of drawing in software."""

    def __init__(self):
        super().__init__()
        self.add_argument("--disable-gpu-compositing")


class ReportPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = temporary_folder()
        cls.folder = Path(cls.temporary.name)
        cls.post, cls.fr3 = (shared_run(PIPELINES / f"{pipeline}.yaml", *QUICK, "--report") / "out"
                             for pipeline in ("pa10_dlr_hit2_obstacle", "fr3"))
        with mock.patch.object(browser, "Options", Composed):
            cls.window = browser.open_browser(1280, 720)

    @classmethod
    def tearDownClass(cls):
        cls.window.quit()
        cls.temporary.cleanup()

    def open(self, page, address=""):
        self.window.get("about:blank")
        browser.messages(self.window), browser.requests(self.window)
        self.page = page.as_uri()
        self.window.get(self.page + address)
        self.wait("return document.querySelectorAll('.plot').length >= 5 || "
                  "!document.querySelector('#overview').hidden")

    def tearDown(self):
        said = browser.messages(self.window)
        self.assertEqual([message for message in said if OF_THE_BROWSER not in message], [])

    def wait(self, script):
        browser.wait_until(self.window, script)

    def run_script(self, script, *arguments):
        return self.window.execute_script(script, *arguments)

    def text(self, selector):
        return self.run_script("return document.querySelector(arguments[0]).textContent", selector)

    def time(self):
        """Of the robot, as the page says it."""
        return float(self.text(".instant").split()[1])

    def press(self, *keys):
        ActionChains(self.window).send_keys(*keys).perform()

    def picture(self):
        box = self.run_script("const b = document.querySelector('canvas').getBoundingClientRect();"
                              "return {x: b.x, y: b.y, width: b.width, height: b.height}")
        shot = self.window.execute_cdp_cmd("Page.captureScreenshot",
                                           {"format": "png", "clip": {**box, "scale": 0.25}})
        return browser.pixels(base64.b64decode(shot["data"])).astype(int)

    def at(self, time):
        """Draws the movement that is open at a time of its clock."""
        self.run_script("const s = document.querySelector('.timeline input'); s.value = arguments[0];"
                        "s.dispatchEvent(new Event('input'))", time)
        self.wait("return true")

    def test_asks_for_nothing_but_itself(self):
        self.open(self.post / "report.html", "#ADL001DR2/000/1")
        asked = [url.split("#")[0] for url in browser.requests(self.window)]
        self.assertEqual([url for url in asked if url.startswith(("http", "file", "ws"))], [self.page])

    def test_draws_another_picture_at_another_time(self):
        self.open(self.post / "report.html", "#ADL001DR2/000/0.1")
        early = self.picture()
        self.assertGreater(len(np.unique(early.reshape(-1, early.shape[2]), axis=0)), 50)
        self.at(1.5)
        late = self.picture()
        changed = (np.abs(early - late).max(axis=2) > 16).mean()
        self.assertGreater(changed, 0.02)
        self.at(0.1)
        self.assertLess((np.abs(early - self.picture()).max(axis=2) > 16).mean(), 0.005)

    def test_an_address_opens_a_movement_at_its_time(self):
        self.open(self.post / "report.html", "#ADL004DR2/000/0.75")
        self.assertIn("ADL004DR2/000", self.text(".movement-head h2"))
        self.assertEqual(self.time(), 0.75)
        self.press("n")
        self.wait("return document.querySelector('.movement-head h2').textContent.includes('ADL006DR2')")
        self.open(self.post / "report.html", "#nobody/000/1")
        self.assertFalse(self.run_script("return document.querySelector('#overview').hidden"))

    def test_one_clock_for_all(self):
        self.open(self.post / "report.html", "#ADL001DR2/000/0.2")
        bands = self.window.find_element(By.CSS_SELECTOR, ".bands")
        before = self.cursors()
        ActionChains(self.window).move_to_element_with_offset(bands, 100, 0).click().perform()
        box = bands.size["width"]
        end = float(self.run_script("return document.querySelector('.timeline input').max"))
        self.assertAlmostEqual(self.time(), (0.5 + 100 / box) * end, delta=2 * end / box)
        after = self.cursors()
        moved = [b - a for a, b in zip(before, after)]
        self.assertGreater(min(moved), 20)
        self.assertLess(max(moved) - min(moved), 1)
        self.run_script("document.querySelector('.plots').scrollTop = 1e6")
        self.wait("return true")
        self.assertAlmostEqual(self.cursors()[-1], after[0], delta=1)
        self.press(Keys.RIGHT)
        self.assertGreater(self.time(), 0.5 * end)

    def cursors(self):
        """Of the plots in sight."""
        return self.run_script(
            "const box = document.querySelector('.plots').getBoundingClientRect();"
            "return [...document.querySelectorAll('.plot')].map(p => [p, p.getBoundingClientRect()]).filter("
            "([, r]) => r.top >= box.top && r.bottom <= box.bottom).map("
            "([p, r]) => p.querySelector('.plot-cursor').getBoundingClientRect().x - r.x)")

    def test_a_joint_that_is_picked_is_picked_everywhere(self):
        self.open(self.post / "report.html", "#ADL001DR2/000/0.9")
        self.press("5")  # all of the robot in sight
        self.wait("return true")
        before = self.picture()
        button = self.window.find_element(By.CSS_SELECTOR, ".readings th button")
        self.run_script("arguments[0].click()", button)
        self.assertEqual(button.get_attribute("aria-pressed"), "true")
        self.wait("return true")
        self.assertGreater((np.abs(before - self.picture()).max(axis=2) > 16).mean(), 0.002)
        self.run_script("arguments[0].click()", button)
        self.assertEqual(button.get_attribute("aria-pressed"), "false")

    def test_meshes_replace_the_capsules(self):
        meshes = self.folder / "meshes"
        meshes.mkdir(exist_ok=True)
        corners = ["0 0 0", "0.1 0 0", "0 0.1 0", "0 0 0.1"]
        faces = "".join("facet normal 0 0 1\nouter loop\n" + "".join(f"vertex {corners[k]}\n" for k in face) + "endloop\nendfacet\n"
                        for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)))
        (meshes / "W2.stl").write_text(f"solid W2\n{faces}endsolid W2\n")
        page = self.folder / "meshes.html"
        done = morphe("report", self.post, "--meshes", meshes, "--plans", "ADL001DR2/000", "--out", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open(page, "#ADL001DR2/000/0.9")
        self.press("5")
        self.wait("return true")
        hidden = self.picture()
        self.press("c")
        self.wait("return true")
        self.assertGreater((np.abs(hidden - self.picture()).max(axis=2) > 16).mean(), 0.02)

    def test_keys_alone(self):
        self.open(self.post / "report.html")
        for _ in range(40):  # to the table
            self.press(Keys.TAB)
            if self.run_script("return document.activeElement.matches('table.plan-table')"):
                break
        self.press(Keys.DOWN, Keys.ENTER)
        self.wait("return document.querySelectorAll('.plot').length >= 7")
        self.assertIn("ADL004DR2/000", self.text(".movement-head h2"))
        self.run_script("document.activeElement.blur()")
        self.press(Keys.SPACE)
        self.wait("return parseFloat(document.querySelector('.instant').textContent.split(' ')[1]) > 0.1")
        self.press(Keys.SPACE)
        stopped = self.time()
        self.wait("return true")
        self.assertEqual(self.time(), stopped)
        self.press(Keys.HOME)
        self.assertEqual(self.time(), 0)
        self.press(Keys.END)
        self.assertGreater(self.time(), 1)
        for view in "123456":
            self.press(view)
        self.press("t")
        self.assertEqual(self.run_script("return document.documentElement.dataset.theme"), "dark")
        self.press("?")
        self.assertTrue(self.run_script("return document.querySelector('dialog').open"))
        self.press(Keys.ESCAPE)
        self.wait("return !document.querySelector('dialog').open")
        self.press(Keys.ESCAPE)
        self.wait("return !document.querySelector('#overview').hidden")

    def test_an_infeasible_movement_opens_at_its_worst_instant(self):
        self.open(self.fr3 / "report.html", "#ADL006DR2/000")
        reason = self.text(".reason")
        for words in ("goal_in_collision", "Worst instant", "Suggestions"):
            self.assertIn(words, reason)
        worst = self.time()
        self.at(0)
        self.run_script("[...document.querySelectorAll('.reason button')].at(-1).click()")
        self.assertEqual(self.time(), worst)

    def test_a_person_alone_is_in_sight(self):
        """Nothing was planned of wrists without fingers: the robot is not there, and takes no room."""
        run = self.folder / "wrists"
        dataset = SOURCE / "datasets/aria/hand_tracking/wrist_and_palm_poses.csv"
        done = morphe("run", PIPELINES / "pa10_dlr_hit2.yaml", "--dataset", dataset, "--out", run, "--report",
                      *QUICK)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.window.get("about:blank")
        self.window.get((run / "report.html").as_uri() + "#wrist_and_palm_poses/000")
        self.wait("return document.querySelector('.movement-head h2')?.textContent.includes('wrist_and_palm')")
        red, _, blue = np.moveaxis(self.picture()[..., :3], -1, 0)
        rows, columns = np.nonzero(red - blue > 40)
        self.assertGreater(len(rows), 0.002 * red.size)
        self.assertAlmostEqual(np.median(rows) / red.shape[0], 0.5, delta=0.15)
        self.assertAlmostEqual(np.median(columns) / red.shape[1], 0.5, delta=0.15)

    def test_the_table_shows_the_files_numbers(self):
        self.open(self.post / "report.html")
        shown = self.run_script(
            "return [...document.querySelectorAll('table.plan-table tbody:not(.spacer) tr')].map("
            "r => [r.cells[0].textContent, ...[...r.cells].map(c => c.title)])")
        self.assertEqual(len(shown), 5)
        with h5py.File(self.post / "plans.h5") as file:
            for plan, *titles in shown:
                certificate = file["plans"][plan]["certificate"].attrs
                said = dict(title.split(" = ") for title in titles if " = " in title)
                for key in ("clearance", "duration_ratio", "tip_error_max", "upper_arm_error_mean", "humanlikeness_final",
                            "forearm_error_mean", "swivel_error_mean", "palm_error_mean", "wrist_speed_correlation"):
                    self.assertEqual(float(said[key].split()[0]), certificate[key], key)

    def test_figures_against_an_estimated_arm_are_marked(self):
        file, name = self.folder / "estimated.h5", "ADL004DR2/000"
        shutil.copy(self.post / "plans.h5", file)
        with h5py.File(file, "r+") as h5:
            estimate_arm(h5["plans"][name])
        self.assertEqual(morphe("report", file, "--unverified", "--out", self.folder / "estimated.html").returncode, 0)
        self.open(self.folder / "estimated.html")
        marked = self.run_script(
            "return [...document.querySelectorAll('table.plan-table tbody:not(.spacer) tr')].map(r => [r.cells[0]."
            "textContent, [...r.cells].filter(c => c.textContent.startsWith('~')).map(c => c.title)])")
        self.assertEqual(len(marked), 5)
        for plan, titles in marked:
            self.assertEqual(sorted(title.split(" = ")[0].split(".")[-1] for title in titles),
                             ["forearm_error_mean", "humanlikeness_final", "swivel_error_mean", "upper_arm_error_mean"] if plan == name else [], plan)

    def test_filters_sort_and_search(self):
        self.open(self.fr3 / "report.html")
        rows = "[...document.querySelectorAll('table.plan-table tbody:not(.spacer) tr')].map(r => r.cells[0].textContent)"
        self.run_script("document.querySelector('.count.status-infeasible').click()")
        self.assertEqual(self.run_script(f"return {rows}"), ["ADL006DR2/000"])
        self.wait("return location.hash === '#?status=infeasible'")
        self.run_script("document.querySelector('.count.status-infeasible').click()")
        box = self.window.find_element(By.CSS_SELECTOR, "input[type=search]")
        box.send_keys("fr1")
        self.assertEqual(self.run_script(f"return {rows}"), ["ADL001FR1/000"])
        box.clear()
        self.open(self.fr3 / "report.html", "#?sort=-duration_ratio")
        with h5py.File(self.fr3 / "plans.h5") as file:
            duration_ratio = {f"{name}/000": file[f"plans/{name}/000/certificate"].attrs["duration_ratio"]
                     for name in file["plans"] if file[f"plans/{name}/000"].attrs["status"] == b"executable"}
        slowest = sorted(duration_ratio, key=duration_ratio.get, reverse=True)
        self.assertEqual(self.run_script(f"return {rows}")[:len(slowest)], slowest)

    def test_two_runs_side_by_side(self):
        both = self.folder / "both.html"
        self.assertEqual(morphe("report", self.post, self.fr3, "--out", both).returncode, 0)
        self.open(both, "#?differences=0~1")
        titles = self.run_script(
            "return [...document.querySelectorAll('table.plan-table tbody:not(.spacer) tr')].map("
            "r => [r.cells[0].textContent, [...r.cells].map(c => c.title).find(t => t.startsWith('duration_ratio:')), r.textContent])")
        self.assertEqual(len(titles), 5)
        with h5py.File(self.post / "plans.h5") as a, h5py.File(self.fr3 / "plans.h5") as b:
            for plan, duration_ratio, text in titles:
                if "infeasible" in text:
                    continue
                values = [float(word) for word in duration_ratio.replace("duration_ratio:", "").split("→")]
                self.assertEqual(values, [file["plans"][plan]["certificate"].attrs["duration_ratio"] for file in (a, b)])
        self.open(both, "#0:ADL001DR2/000/1")
        alone = self.picture()
        self.assertEqual(len(self.window.find_elements(By.CSS_SELECTOR, ".scene-legend input")), 2)
        self.run_script("document.querySelectorAll('.scene-legend input')[1].click()")
        self.wait("return true")
        self.assertGreater((np.abs(alone - self.picture()).max(axis=2) > 16).mean(), 0.01)

    def test_names_from_files_are_text(self):
        hostile = self.folder / "hostile.h5"
        hostile.write_bytes((self.post / "plans.h5").read_bytes())
        name = HOSTILE.replace("/", "\u2215")
        with h5py.File(hostile, "r+") as file:
            file.move("plans/ADL001DR2", f"plans/{name}")
            group = file[f"plans/{name}/000"]
            group.attrs["subject"] = HOSTILE.encode()
            group.attrs["task"] = 10000 * "long "
        page = self.folder / "hostile.html"
        done = morphe("report", hostile, "--unverified", "--out", page)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.open(page)
        links = self.run_script("return [...document.querySelectorAll('table.plan-table a')].map(a => a.textContent)")
        self.assertTrue(any(link.startswith("<img") for link in links))
        cells = self.run_script("return [...document.querySelectorAll('table.plan-table td')].map(c => c.textContent)")
        self.assertTrue(any(cell.startswith("<img") and "/000" not in cell for cell in cells))
        long = next(cell for cell in cells if cell.startswith("long"))
        self.assertLess(len(long), 1000)
        self.assertFalse(self.run_script("return document.body.scrollWidth > innerWidth"))
        self.run_script("[...document.querySelectorAll('table.plan-table a')].find("
                        "a => a.textContent.startsWith('<img')).click()")
        self.wait("return document.querySelectorAll('.plot').length >= 7")
        self.assertIn("<img", self.text(".movement-head h2"))
        self.assertEqual(self.run_script("return document.querySelectorAll('img').length"), 0)


if __name__ == "__main__":
    main()
