"""What `verify` rejects is not handed on: refused, or shown as not verified. A file that was accepted is
not judged twice, and nobody else can say that it was."""
import json
import os
import shutil
import stat

import h5py

import formats
from support import MORPHE, CommandCase, main, morphe, planned_sample, sha256

FIRST, SECOND = "ADL001DR2/000", "ADL001AR1/000"


def setUpModule():
    global HONEST, FORGED
    HONEST = planned_sample("--set", "grasp.close_fingers=true")
    FORGED = HONEST.parent / "forged.h5"
    shutil.copy(HONEST, FORGED)
    with h5py.File(FORGED, "r+") as file:
        file["plans"][FIRST]["certificate"].attrs["clearance"] = 0.5


class Unverified(CommandCase):
    def setUp(self):
        super().setUp()
        self.cache = self.folder / "cache"
        before = os.environ["XDG_CACHE_HOME"]
        self.addCleanup(os.environ.__setitem__, "XDG_CACHE_HOME", before)
        os.environ["XDG_CACHE_HOME"] = str(self.cache)

    def notes(self):
        return sorted(file.name for file in self.cache.rglob("*") if file.is_file())

    def test_what_hands_on_refuses(self):
        out = self.folder / "new"
        for command in (("export", FORGED, "--format", "csv", "--out", out),
                        ("export", FORGED, "--format", "robomimic", "--out", out),
                        ("report", FORGED, "--out", self.folder / "page.html"),
                        ("report", FORGED, "--svg", out),
                        ("simulate", FORGED, "--out", out)):
            with self.subTest(command[0], how=command[-2]):
                result = morphe(*command)
                if "has no MuJoCo" in result.stderr:
                    continue
                self.refuses(result, FORGED, "is rejected by verify: ", "the first: " + FIRST, "--unverified")
                self.assertEqual(os.listdir(self.folder), [])

    def test_what_is_handed_on_unverified_says_so(self):
        out = self.folder / "out"
        said = "was not verified (--unverified)"
        self.succeeds("export", FORGED, "--format", "csv", "--out", out, "--unverified")
        index = json.loads((out / "index_csv.json").read_text())
        self.assertEqual((index["verified"], index["not_verified"]), (False, said))
        self.succeeds("export", HONEST, "--format", "csv", "--out", self.folder / "honest")
        index = json.loads((self.folder / "honest/index_csv.json").read_text())
        self.assertEqual((index["verified"], "not_verified" in index), (True, False))
        self.succeeds("export", FORGED, "--format", "robomimic", "--out", out, "--unverified")
        with h5py.File(out / "robomimic.hdf5") as file:
            self.assertEqual(formats.text(file["data"].attrs["not_verified"]), said)
        page = self.folder / "page.html"
        self.succeeds("report", FORGED, "--out", page, "--svg", out, "--unverified")
        self.assertIn(f'"not_verified":"{said}"', page.read_text())
        for picture in out.glob("*.svg"):
            self.assertIn(", not verified<", picture.read_text())
        self.succeeds("report", HONEST, "--out", page)
        self.assertIn('"not_verified":""', page.read_text())

    def test_figures_of_a_forged_plan_are_not_shown(self):
        listed = self.succeeds("list", FORGED).stdout
        self.assertIn("is rejected by verify: 1 violation, the first: " + FIRST, listed)
        row = next(line for line in listed.splitlines() if line.startswith(FIRST))
        self.assertRegex(row, rf"^{FIRST} +not verified( +-)+$")
        self.assertNotIn("500.0", listed)
        plans = {plan["plan"]: plan for plan in self.json_of("list", FORGED)["plans"]}
        self.assertEqual(plans[FIRST]["status"], "not verified")
        self.assertEqual(set(plans[FIRST]["figures"].values()), {None})
        self.assertEqual(plans[FIRST]["clearances"], [])
        self.assertIsNotNone(plans[SECOND]["figures"]["clearance"])
        self.assertEqual(len(self.json_of("list", FORGED, "--only", "not verified")["plans"]), 1)
        trusting = self.succeeds("list", FORGED, "--unverified").stdout
        self.assertIn("500.0", trusting)
        self.assertIn(f"{FORGED}: was not verified (--unverified)\n", trusting)

    def test_diff_and_explain(self):
        result = morphe("diff", HONEST, FORGED)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"  {FIRST}: executable -> not verified\n", result.stdout)
        self.assertIn("B: is rejected by verify: ", result.stdout)
        self.assertIn("500", morphe("diff", HONEST, FORGED, "--all").stdout)  # what differs is told
        self.assertNotIn("-> not verified", morphe("diff", HONEST, FORGED, "--unverified").stdout)
        explained = self.succeeds("explain", FORGED, FIRST).stdout
        self.assertRegex(explained, rf"^{FIRST}\n  not verified  rejected by verify: {FIRST}: .*\n$")
        (plan,) = self.json_of("explain", FORGED, FIRST)["plans"]
        self.assertEqual((plan["plan"], plan["status"]), (FIRST, "not verified"))
        self.assertIn("certified", self.succeeds("explain", FORGED, FIRST, "--unverified").stdout)

    def test_a_simulation_that_was_edited(self):
        out = self.folder / "physics"
        command = ("simulate", HONEST, "--out", out, "--only", FIRST, "--rollouts", 1, "--quiet",
                   "--load-directions", "none", "--time-step", 0.004)
        result = morphe(*command)
        if "has no MuJoCo" in result.stderr:
            self.skipTest("built without MuJoCo")
        self.assertEqual(result.returncode, 0, result.stderr)
        file = out / (FIRST.replace("/", "_") + ".json")
        made = file.read_bytes()
        edited = json.loads(made)
        edited["rollouts"][0]["arm_error"] = 0.0
        file.write_text(json.dumps(edited))
        page = ("report", HONEST, "--out", self.folder / "page.html", "--simulation", out)
        self.refuses(morphe(*page), file, "was changed since")
        self.succeeds(*command)  # is not believed
        self.assertEqual(file.read_bytes(), made)
        self.succeeds(*page)

    def test_a_file_that_was_accepted_is_not_judged_again(self):
        self.succeeds("list", HONEST)
        self.assertEqual(len(self.notes()), 1)
        self.succeeds("verify", HONEST)
        self.assertEqual(len(self.notes()), 1)
        self.assertEqual(morphe("list", FORGED).stdout.count("not verified"), 1)
        self.assertEqual(len(self.notes()), 1)  # what is rejected is judged every time
        for where in (self.cache, self.cache / "morphe", self.cache / "morphe/accepted"):
            self.assertEqual(stat.S_IMODE(where.stat().st_mode) & 0o022, 0)

    def test_a_note_of_others_is_not_believed(self):
        """A note in the user's own cache is the user's word; one in a folder that others may write is not."""
        import hashlib
        program = sha256(MORPHE)
        name = hashlib.sha256((sha256(FORGED) + program).encode()).hexdigest()
        accepted = self.cache / "morphe/accepted"
        accepted.mkdir(parents=True, mode=0o700)
        (accepted / name).touch(mode=0o600)
        self.assertNotIn("not verified", self.succeeds("list", FORGED).stdout)
        for loose in (accepted, accepted.parent, accepted / name):
            mode = loose.stat().st_mode
            loose.chmod(0o777)
            self.assertIn("not verified", self.succeeds("list", FORGED).stdout, loose)
            loose.chmod(mode)
        os.symlink(accepted / name, accepted / "link")
        os.rename(accepted / "link", accepted / name)
        self.assertIn("not verified", self.succeeds("list", FORGED).stdout)
        beside = FORGED.parent / ".cache/morphe/accepted"
        beside.mkdir(parents=True)
        (beside / name).touch()
        self.assertIn("not verified", self.succeeds("list", FORGED).stdout)

    def test_a_cache_that_cannot_be_used_is_left(self):
        self.cache.write_text("no folder")
        self.assertNotIn("not verified", self.succeeds("list", HONEST).stdout)
        del os.environ["XDG_CACHE_HOME"]
        home = os.environ.pop("HOME", None)
        if home is not None:
            self.addCleanup(os.environ.__setitem__, "HOME", home)
        os.environ["XDG_CACHE_HOME"] = "relative"
        self.assertNotIn("not verified", self.succeeds("list", HONEST, cwd=self.folder).stdout)
        self.assertFalse((self.folder / "relative").exists())


if __name__ == "__main__":
    main()
