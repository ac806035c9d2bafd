"""The page of `morphe report` by keyboard alone: ten tasks of a reader, and the first minute on a phone, a
laptop and a wide screen. Nothing is wider than the screen, and the page writes nothing to the console.
Takes half a minute: Chromium draws WebGL in software."""
import base64

import h5py
import numpy as np

from support import QUICK, SOURCE, Path, main, morphe, shared_run, sys, temporary_folder, unittest

sys.path.insert(0, str(SOURCE / "tests/support"))
import browser  # noqa: E402

OF_THE_BROWSER = "GPU stall due to ReadPixels"  # Chromium's own, when it puts a page together
PIPELINES = SOURCE / "configs/pipelines"
SCREENS = ((390, 844), (1280, 800), (2560, 1440))
KEYS = {"Tab": 9, "Enter": 13, "Escape": 27, " ": 32, "End": 35, "Home": 36, "ArrowLeft": 37, "ArrowUp": 38,
        "ArrowRight": 39, "ArrowDown": 40}
MAX_TABS, MORE_STOPS = 100, 4  # what can be scrolled is a stop, too
NAMED = ("const named = (e) => e.matches(arguments[0]) && (e.textContent + e.title).replaceAll('\\u00ad', '')"
         ".includes(arguments[1]);")
HAS_FOCUS = NAMED + "return named(document.activeElement)"
CONTROLS_BETWEEN = NAMED + """
    const all = [...document.querySelectorAll('a, button, input, select, summary, [tabindex]')].filter(
        e => (e.tabIndex >= 0 || e === document.activeElement) && e.getClientRects().length > 0);
    const to = all.findIndex(e => e.tabIndex >= 0 && named(e)), from = all.indexOf(document.activeElement);
    return to < 0 ? null : to - from"""


class ReportKeys(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = temporary_folder()
        cls.post, cls.fr3 = (shared_run(PIPELINES / f"{pipeline}.yaml", *QUICK, "--report") / "out"
                             for pipeline in ("pa10_dlr_hit2_obstacle", "fr3"))
        cls.page = Path(cls.temporary.name) / "both.html"
        done = morphe("report", cls.post, cls.fr3, "--out", cls.page)
        assert done.returncode == 0, done.stderr
        cls.window = browser.open_browser(1280, 800)

    @classmethod
    def tearDownClass(cls):
        cls.window.quit()
        cls.temporary.cleanup()

    def run_script(self, script, *arguments):
        return self.window.execute_script(script, *arguments)

    def wait(self, script):
        browser.wait_until(self.window, script, seconds=60)

    def press(self, key, shift=False):
        event = {"key": key, "code": key if len(key) > 1 else "", "modifiers": 8 if shift else 0,
                 "windowsVirtualKeyCode": KEYS.get(key, ord(key[0].upper()))}
        if len(key) == 1 or key == "Enter":
            event["text"] = "\r" if key == "Enter" else key
        self.window.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": "keyDown", **event})
        self.window.execute_cdp_cmd("Input.dispatchKeyEvent", {"type": "keyUp", **event})

    def tab_to(self, selector, text=""):
        """Presses Tab until an element of that selector with that text has the focus: as often as there are
        controls between, in the document's order."""
        count = self.run_script(CONTROLS_BETWEEN, selector, text)
        self.assertIsNotNone(count, f"no {selector} with {text!r}")
        self.assertLess(abs(count), MAX_TABS, selector)
        for _ in range(abs(count) - 1):
            self.press("Tab", shift=count < 0)
        for _ in range(MORE_STOPS):
            self.press("Tab", shift=count < 0)
            if self.run_script(HAS_FOCUS, selector, text):
                return
        self.fail(f"Tab does not lead to {selector} with {text!r}, but to " +
                  self.run_script("return document.activeElement.outerHTML.slice(0, 200)"))

    def text(self, selector):
        return self.run_script("return document.querySelector(arguments[0])?.textContent ?? ''", selector)

    def time(self):
        return float(self.text(".instant").split()[1])

    def picture(self):
        """Of the 3D view, 300 pixels wide."""
        box = self.run_script("const b = document.querySelector('.scene-host').getBoundingClientRect();"
                              "return {x: b.x, y: b.y + scrollY, width: b.width, height: b.height}")
        shot = self.window.execute_cdp_cmd("Page.captureScreenshot", {
            "format": "png", "captureBeyondViewport": True, "clip": {**box, "scale": 300 / box["width"]}})
        return browser.pixels(base64.b64decode(shot["data"])).astype(int)

    def fits(self):
        widths = self.run_script("return [document.documentElement.scrollWidth, innerWidth]")
        self.assertLessEqual(widths[0], widths[1])

    def opened(self, name):
        self.wait("return document.querySelector('.plots')?.dataset.drawn && "
                  f"document.querySelector('.movement-head h2').textContent.includes('{name}')")
        self.fits()

    def back(self):
        self.press("Escape")
        self.wait("return !document.querySelector('#overview').hidden")

    def tightest(self):
        """Of both runs the plan with the least clearance, and its two bodies."""
        found = []
        for run in (self.post, self.fr3):
            with h5py.File(run / "plans.h5") as file:
                for name in file["plans"]:
                    kinds = file[f"plans/{name}/000"].get("certificate/clearance_by_kind")
                    if kinds:
                        k = int(np.argmin(kinds["clearance"]))
                        found.append((kinds["clearance"][k], f"{name}/000", [kinds[side].asstr()[k] for side in ("first", "second")]))
        return min(found)[1:]

    def opened_page(self):
        self.window.get("about:blank")
        browser.messages(self.window)
        self.window.get(self.page.as_uri())
        self.wait("return document.querySelector('.posters')?.dataset.drawn")
        self.fits()

    def plays(self):
        """Plays and stops, with the focus where it is."""
        self.press(" ")
        self.wait("return parseFloat(document.querySelector('.instant').textContent.split(' ')[1]) > 0.05")
        self.press(" ")
        self.assertEqual(self.text(".play"), "Play")

    def says_nothing(self):
        said = browser.messages(self.window)
        self.assertEqual([message for message in said if OF_THE_BROWSER not in message], [])

    def test_ten_tasks(self):
        self.opened_page()
        plan, bodies = self.tightest()
        # 1: which plan comes closest to a collision?
        self.tab_to("th button", "Smallest distance")
        self.press("Enter")
        self.wait("return document.querySelector('.posters').dataset.drawn && "
                  f"document.querySelector('a.poster').textContent.includes('{plan}')")
        self.assertIn(plan, self.text("table.plan-table tbody:not(.spacer) tr"))
        self.tab_to("a.poster", plan)
        self.press("Enter")
        self.opened(plan)
        # 2: which two bodies are it?
        self.tab_to(".certificate summary")
        self.press("Enter")
        certified = self.text(".movement-head .groups .certified")
        self.assertTrue(all(body in certified for body in bodies), (bodies, certified))
        # 3: what has nobody looked at?
        self.assertIn("torque", self.text(".movement-head .groups .not_looked_at"))
        # 4: back to where one was
        self.back()
        self.assertIn(plan, self.run_script("return document.activeElement.textContent"))
        # 5: in what do the two runs differ?
        self.tab_to("input[type=checkbox]")
        self.press(" ")
        self.assertIn("Δ", self.text("table.plan-table thead"))
        self.press(" ")
        # 6: what could not be planned, and why?
        self.tab_to(".count.status-infeasible")
        self.press("Enter")
        self.tab_to("table.plan-table")
        self.press("Enter")
        self.opened("ADL006DR2")
        self.assertIn("goal_in_collision", self.text(".reason"))
        self.back()
        self.tab_to(".count.status-infeasible")
        self.press("Enter")
        # 7: the post that the repair avoids
        self.press("/")
        for letter in "001dr2":
            self.press(letter)
        self.tab_to("a.poster", "ADL001DR2/000")
        self.press("Enter")
        self.opened("ADL001DR2")
        self.assertIn("obstacle", self.text(".scene-legend"))
        red, green, blue = np.moveaxis(self.picture()[..., :3], -1, 0)
        self.assertGreater(np.count_nonzero((red > 110) & (red > 1.7 * green) & (red > 1.7 * blue)), 20)
        # 8: play it, stop it, step
        self.plays()
        self.press("Home")
        self.press("ArrowRight")
        self.assertTrue(0 < self.time() < 0.05, self.time())
        # 9: turn the view, go to the grasp
        before = self.picture()
        self.tab_to("canvas")
        for _ in range(4):
            self.press("ArrowLeft")
        self.wait("return true")
        self.assertGreater((np.abs(before - self.picture()).max(axis=2) > 16).mean(), 0.02)
        self.tab_to(".marks button", "grasp")
        self.press("Enter")
        self.assertGreater(self.time(), 1)
        # 10: which line is this joint's?
        self.tab_to(".plot-group button.line-name", "W2")
        self.press("Enter")
        self.assertEqual(self.run_script("return [...document.querySelectorAll('.readings [aria-pressed=true]')].map("
                                         "b => b.textContent)"), ["W2"])

        self.says_nothing()

    def test_the_first_minute_on_three_screens(self):
        for width, height in SCREENS:
            with self.subTest(width=width):
                self.window.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
                    "width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
                self.opened_page()
                self.tab_to("a.poster", "ADL001DR2/000")
                self.press("Enter")
                self.opened("ADL001DR2")
                self.plays()
                self.says_nothing()


if __name__ == "__main__":
    main()
