"""What plans rest on is in the file, and every command that shows plans says it: docs/certificate.md."""
import shutil

import h5py
import numpy as np

import formats
from support import (QUICK, REFERENCE, SOURCE, CommandCase, json, main, morphe, python_verify, shared_run)
from verify_geometry import text

PLAN = "ADL001DR2/000"
ASSUMPTIONS = {name: ("a", "", None) for name in ("kind", "subject", "value")}
CLEARANCES = {"kind": ("k", "", None), "clearance": ("k", "m", None), "first": ("k", "", None),
              "second": ("k", "", None), "time": ("k", "s", None)}
NOT_LOOKED_AT = {"torque", "payload", "tracking", "calibration", "surroundings", "grasp"}


def setUpModule():
    global SHARED, PLANS
    SHARED = shared_run(REFERENCE, *QUICK, dataset="one recording")
    PLANS = SHARED / "out/plans.h5"


def rows(group):
    return list(zip(*(map(text, group[name][()]) for name in ("kind", "subject", "value"))))


class Stored(CommandCase):
    def test_origins_assumptions_and_clearances(self):
        with h5py.File(PLANS) as file:
            plan = file["plans"][PLAN]
            for name, object in plan["scene"].items():
                self.assertEqual([text(object.attrs[f"{of}_origin"]) for of in ("pose", "shape")],
                                 ["inferred", "inferred"], name)
            self.assertEqual(formats.faults(file["assumptions"], ASSUMPTIONS, {}), [])
            self.assertEqual(formats.faults(plan["certificate/clearance_by_kind"], CLEARANCES, {}), [])
            of_file = rows(file["assumptions"])
            self.assertEqual({subject for kind, subject, _ in of_file if kind == "not_looked_at"}, NOT_LOOKED_AT)
            self.assertEqual({(subject, value) for kind, subject, value in of_file if kind == "set_by_hand"},
                             {tuple(setting.split("=")) for setting in QUICK[1::2]})
            assumed = [(subject, value.split(":")[0]) for kind, subject, value in of_file if kind == "assumed"]
            self.assertEqual(assumed, [("limits", "pa10"), ("limits", "dlr_hit2"), ("mount", "pa10_dlr_hit2")])
            self.assertIn(("inferred", "heading"), [row[:2] for row in rows(plan["assumptions"])])

    def test_clearances_by_kind_are_the_certificates(self):
        with h5py.File(PLANS) as file:
            certificate = file["plans"][PLAN]["certificate"]
            kinds = dict(zip(certificate["clearance_by_kind/kind"].asstr(), certificate["clearance_by_kind/clearance"]))
            self.assertEqual(min(kinds.values()), certificate.attrs["clearance"])
        self.assertEqual(set(kinds), {"self", "table", "target"})
        self.assertEqual(json.loads(python_verify(PLANS).stdout)["violations"], [])  # computes each of them


class Shown(CommandCase):
    def expect_box(self, printed):
        for start, words in (("certified", ["limits, collisions"]), ("inferred", ["target", "table", "heading"]),
                             ("assumed", ["limits", "mount"]), ("set by hand", ["map.starts=4"]),
                             ("not looked at", ["torque", "payload", "tracking", "calibration"])):
            line = next((line for line in printed.splitlines() if line.strip().startswith(start)), None)
            self.assertIsNotNone(line, printed)
            for word in words:
                self.assertIn(word, line)

    def test_at_the_end_of_run_in_list_and_in_verify(self):
        self.expect_box((SHARED / "stdout.txt").read_text())
        self.expect_box(self.succeeds("list", PLANS).stdout)
        self.expect_box(self.succeeds("verify", PLANS).stdout)

    def test_in_explain_with_the_values(self):
        printed = self.succeeds("explain", PLANS, PLAN).stdout
        for words in ("target: cup: place from thumb and index at the grasp, cylinder of", "table: height from the",
                      "limits: pa10: ", "mount: pa10_dlr_hit2: the adapter", "map.starts=4", "torque: ",
                      "self ", "table ", "target "):
            self.assertIn(words, printed)
        [plan] = self.json_of("explain", PLANS, PLAN)["plans"]
        self.assertEqual({row["kind"] for row in plan["clearances"]}, {"self", "table", "target"})
        self.assertLessEqual(NOT_LOOKED_AT, {row["subject"] for row in plan["assumptions"]})

    def test_in_json_of_list_and_verify(self):
        listed = self.json_of("list", PLANS)
        [plan] = listed["plans"]
        self.assertEqual(plan["plan"], PLAN)
        self.assertEqual({row["subject"] for row in plan["assumptions"] if row["kind"] == "inferred"},
                         {"target", "table", "heading"})
        with h5py.File(PLANS) as file:
            stored = file["plans"][PLAN]["certificate/clearance_by_kind"]
            self.assertEqual([row["clearance"] for row in plan["clearances"]], list(stored["clearance"]))
            self.assertEqual([row["first"] for row in plan["clearances"]], list(stored["first"].asstr()))
        verified = self.json_of("verify", PLANS)["assumptions"]
        self.assertIn(1, [row["plans"] for row in verified if row["subject"] == "target"])

    def test_in_the_head_of_every_export_and_on_the_page(self):
        for format in ("csv", "ros", "ros-json", "robomimic"):
            out = self.folder / format
            self.succeeds("export", PLANS, "--format", format, "--out", out)
            index = json.loads((out / f"index_{format}.json").read_text())
            self.assertLessEqual(NOT_LOOKED_AT, {row["subject"] for row in index["assumptions"]})
            self.assertIn("target", {row["subject"] for row in index["plans"][0]["assumptions"]})
        page = self.folder / "page.html"
        self.succeeds("report", PLANS, "--out", page)
        for words in ("mount: pa10_dlr_hit2: the adapter", "target: cup: place from thumb and index"):
            self.assertIn(words, page.read_text())

    def test_by_robot_as_its_controller_page_says(self):
        file = SOURCE / "configs/robots/pa10_dlr_hit2.yaml"
        printed = self.succeeds("robot", file).stdout
        self.assertIn("assumed: limits: pa10: ", printed)
        self.assertIn("assumed: mount: pa10_dlr_hit2: the adapter", printed)
        self.assertEqual([row["subject"] for row in self.json_of("robot", file)["assumed"]],
                         ["limits", "limits", "mount"])
        for robot in sorted((SOURCE / "configs/robots").glob("*.yaml")):
            self.assertNotIn("does not say where", self.succeeds("robot", robot).stdout, robot.name)


class MustBeKnown(CommandCase):
    def planned(self, subjects, *more):
        return morphe("run", REFERENCE, "--dataset", SHARED / "recordings.yaml", "--out", self.folder / "out",
                      "--set", f"must_be_known=[{subjects}]", *QUICK, *more)

    def test_an_inferred_target_is_refused(self):
        result = self.planned("target")
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File(self.folder / "out/plans.h5") as file:
            plan = file["plans"][PLAN].attrs
            self.assertEqual((text(plan["status"]), text(plan["reason"])), ("infeasible", "not_known"))
            self.assertIn("scene.target.body", text(plan["detail"]))
        self.succeeds("verify", self.folder / "out")

    def test_an_inferred_table_is_not_once_its_height_is_given(self):
        result = self.planned("table", "--set", "scene.table.height=-0.02")
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File(self.folder / "out/plans.h5") as file:
            plan = file["plans"][PLAN]
            self.assertNotEqual(text(plan.attrs["reason"]), "not_known")
            self.assertEqual(text(plan["scene/table"].attrs["pose_origin"]), "configured")

    def test_assumed_limits_are_an_error_of_the_config(self):
        result = self.planned("limits")
        self.assertEqual(result.returncode, 2, result.stdout)
        self.assertIn("must_be_known", result.stderr)
        self.assertIn("pa10", result.stderr)


class Forged(CommandCase):
    """Each changes one thing; `verify` names it."""

    def forged(self, change):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            change(file, file["plans"][PLAN])
        result = morphe("verify", copy, "--json")
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        return {(row["cause"], row["subject"]) for row in json.loads(result.stdout)["violations"]}

    def test_origins(self):
        def unknown(_, plan):
            del plan["scene/cup"].attrs["pose_origin"]
        self.assertIn(("config", "cup/origin"), self.forged(unknown))

        def thin(_, plan):
            plan["scene/cup"].attrs["size"] = np.array([0.001, plan["scene/cup"].attrs["size"][1]])
        self.assertIn(("scene", "cup/size"), self.forged(thin))

    def test_assumptions(self):
        def dropped(file, _):
            kept = rows(file["assumptions"])[1:]
            attributes = dict(file["assumptions/kind"].attrs)
            for k, name in enumerate(("kind", "subject", "value")):
                del file["assumptions"][name]
                file["assumptions"].create_dataset(name, data=[row[k] for row in kept]).attrs.update(attributes)
        self.assertEqual({cause for cause, _ in self.forged(dropped)}, {"assumption"})

        def all_dropped(file, _):
            del file["assumptions"]
        self.assertEqual({cause for cause, _ in self.forged(all_dropped)}, {"assumption"})

    def test_clearances_by_kind(self):
        with h5py.File(PLANS) as file:
            kinds = list(file["plans"][PLAN]["certificate/clearance_by_kind/kind"].asstr())
        for k, kind in enumerate(kinds):
            def larger(_, plan):
                plan["certificate/clearance_by_kind/clearance"][k] += 0.01
            self.assertIn(("certificate", f"clearance_by_kind/{kind}"), self.forged(larger))

            def later(_, plan):
                times = plan["certificate/clearance_by_kind/time"]
                times[k] = 0 if times[k] > 0.5 else plan["trajectory/time"][-1]
            self.assertEqual(self.forged(later), {("certificate", f"clearance_by_kind/{kind}/pair")})

        def dropped(_, plan):
            del plan["certificate/clearance_by_kind"]
        self.assertEqual(self.forged(dropped), {("config", "clearance_by_kind")})


class EarlierFiles(CommandCase):
    def test_are_read_and_say_that_they_do_not_know(self):
        copy = self.folder / "plans.h5"
        shutil.copy(PLANS, copy)
        with h5py.File(copy, "r+") as file:
            plan = file["plans"][PLAN]
            for object in plan["scene"].values():
                for origin in ("pose_origin", "shape_origin"):
                    del object.attrs[origin]
            del file["assumptions"], plan["assumptions"], plan["certificate/clearance_by_kind"]
        self.assertIn("the file does not say whether it was recorded", self.succeeds("explain", copy, PLAN, "--unverified").stdout)
        self.succeeds("list", copy)
        self.succeeds("report", copy, "--unverified", "--out", self.folder / "page.html")
        self.succeeds("export", copy, "--unverified", "--format", "csv", "--out", self.folder / "csv")


if __name__ == "__main__":
    main()
