"""A movement whose later part cannot be planned is delivered up to a phase after which the object rests."""
import shutil
from pathlib import Path

import h5py
import numpy as np

from formats import text
from support import (ONE_RECORDING, QUICK, REFERENCE, CommandCase, json, main, morphe, python_verify,
                     temporary_folder, write_recordings)

PLAN = "ADL001DR2/000"
IN_AIR, RETURN = ("--set", "segment.partial=in_air"), ("--set", "segment.plan_until=return")
COARSE = ("--set", "retime.sample_rate_hz=50")  # plans of six seconds are judged in less time
MOTION = ("time", "position", "velocity", "acceleration", "phase", "clearance")


class Partial(CommandCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.root = Path(holder.name).resolve()
        cls.manifest = write_recordings(cls.root, ONE_RECORDING)
        cls.free = cls.run_plans("free", cls.manifest, *RETURN)
        with h5py.File(cls.free) as file:
            phases = file["plans"][PLAN]["phases"]
            ends = dict(zip(phases["name"].asstr(), phases["end_s"][()]))
            cls.end = ends
        cls.home = cls.run_plans("home", cls.with_block("home", cls.end["release"]), *RETURN)

    @classmethod
    def run_plans(cls, name, dataset, *settings):
        out = cls.root / name
        done = morphe("run", REFERENCE, "--dataset", dataset, "--out", out, *QUICK, *COARSE, *settings)
        assert done.returncode == 0, done.stdout + done.stderr
        return out / "plans.h5"

    @classmethod
    def with_block(cls, name, from_s):
        """The recording with a block that somebody else puts where the hand is, from a time on."""
        dataset = cls.root / f"{name}.h5"
        morphe("import", cls.manifest, "--out", dataset)
        with h5py.File(dataset, "r+") as file, h5py.File(cls.free) as free:
            plan = free["plans"][PLAN]
            base_from_world = plan["reference_frames/recording"][()]
            names = list(free["robot/tips/name"].asstr())
            index = plan["goals/tip_position"][:, names.index("index_tip")]
            after = plan["goals/time"][()] > from_s + 0.4
            hand = np.linalg.inv(base_from_world) @ np.append(index[np.flatnonzero(after)[0]], 1)
            block = file["demonstrations"]["ADL001DR2"].require_group("objects").create_group("block")
            block.attrs["shape"], block.attrs["size"] = np.bytes_("box"), np.array([0.3, 0.3, 0.3])  # no hand takes it
            for key, rows, attributes in (
                    ("time", [0.0, from_s, from_s + 0.1], dict(unit="s")),
                    ("position", [hand[:3] + [0, 1.5, 0]] * 2 + [hand[:3]], dict(unit="m", frame="world")),
                    ("orientation", [[1.0, 0, 0, 0]] * 3, dict(unit="1", frame="world"))):
                block[key] = np.array(rows, dtype=float)
                block[key].attrs.update({k: np.bytes_(v) for k, v in attributes.items()})
        return dataset

    def found(self, run):
        return {(row["cause"], row["subject"]) for row in json.loads(run.stdout)["violations"]}

    def own_violations(self, file):
        return self.found(morphe("verify", file, "--json"))

    def violations(self, file):
        return [self.own_violations(file), self.found(python_verify(file))]

    def forged(self, change):
        copy = self.folder / "forged.h5"
        shutil.copy(self.home, copy)
        with h5py.File(copy, "r+") as file:
            change(file["plans"][PLAN])
        return copy

    def test_it_is_the_plan_until_then_and_says_why(self):
        short = self.run_plans("short", self.with_block("short", self.end["release"]),
                               "--set", "segment.plan_until=release")
        with h5py.File(self.home) as file, h5py.File(short) as until:
            plan, own = file["plans"][PLAN], until["plans"][PLAN]
            self.assertEqual(text(own.attrs["status"]), "executable", own.attrs["detail"])
            said = {key: text(plan.attrs[key]) for key in ("status", "reason", "detail", "delivered_until")}
            self.assertEqual((said["status"], said["delivered_until"]), ("partial", "release"), said)
            self.assertEqual(said["reason"], "goal_in_collision")
            self.assertRegex(said["detail"], f"^delivered until the end of release, {self.end['release']:.2f} s "
                                             f"of .* to {self.end['return']:.2f} s: .*block")
            self.assertAlmostEqual(plan.attrs["end_s"], self.end["release"])
            self.assertAlmostEqual(plan.attrs["requested_end_s"], self.end["return"])
            for key in MOTION:
                np.testing.assert_array_equal(plan["trajectory"][key], own["trajectory"][key])
        self.assertEqual(self.violations(self.home), [set(), set()])

    def test_the_commands_tell_it_from_whole_plans(self):
        for words, count in (((), 1), (("partial",), 1), (("goal_in_collision",), 1), (("executable",), 0)):
            found = self.succeeds("list", self.home.parent, *(x for word in words for x in ("--only", word)))
            self.assertEqual(found.stdout.count(f"{PLAN}  partial"), count, found.stdout)
        counts = json.loads(morphe("verify", self.home, "--json").stdout)
        self.assertEqual([counts[key] for key in ("executable", "partial", "infeasible")], [0, 1, 0])
        change = json.loads(morphe("diff", self.free, self.home, "--json").stdout)["status_changes"]
        self.assertEqual([change[0][key]["status"] for key in ("first", "second")][1], "partial")
        explained = morphe("explain", self.home.parent).stdout
        self.assertIn("partial, goal_in_collision", explained)
        out = self.folder / "exported"
        self.succeeds("export", self.home, "--format", "csv", "--out", out)
        index = json.loads((out / "index_csv.json").read_text())
        self.assertEqual([plan["status"] for plan in index["plans"]], ["partial"])
        strict = morphe("run", REFERENCE, "--dataset", self.root / "home.h5", "--out", self.home.parent,
                        *QUICK, *COARSE, *RETURN, "--strict")
        self.assertEqual(strict.returncode, 1, strict.stderr)
        self.assertIn("0 executable (0 repaired), 1 partial, 0 infeasible", strict.stdout + strict.stderr)

    def test_never(self):
        plans = self.run_plans("never", self.root / "home.h5", *RETURN, "--set", "segment.partial=never")
        with h5py.File(plans) as file:
            plan = file["plans"][PLAN]
            self.assertEqual(text(plan.attrs["status"]), "infeasible")
            self.assertNotIn("delivered_until", plan.attrs)
        self.assertEqual(self.violations(plans), [set(), set()])

    def test_a_block_in_the_cups_way(self):
        """It is cut before the cup is taken, unless it may remain in the air."""
        dataset = self.with_block("carried", self.end["lift"] + 0.2)
        place = ("--set", "segment.plan_until=place")
        rest = self.run_plans("rest", dataset, *place)
        air = self.run_plans("air", dataset, *place, *IN_AIR)
        for plans, until in ((rest, "grasp"), (air, "lift")):
            with h5py.File(plans) as file:
                self.assertEqual(text(file["plans"][PLAN].attrs["delivered_until"]), until)
            self.assertEqual(self.violations(plans), [set(), set()])
        with h5py.File(rest, "r+") as file, h5py.File(air) as other:
            del file["plans"][PLAN]
            other.copy(other["plans"][PLAN], file["plans"]["ADL001DR2"], "000")
        self.assertIn(("status", "delivered_until"), self.own_violations(rest))

    def test_forged(self):
        def named(**attributes):
            def change(plan):
                plan.attrs.update({key: np.bytes_(value) for key, value in attributes.items()})
            return change
        refused = morphe("verify", self.forged(named(status="executable")))
        self.assertEqual(refused.returncode, 2, refused.stdout)
        self.assertIn("@status is 'executable' with the @reason 'goal_in_collision'", refused.stderr)
        self.assertEqual(morphe("verify", self.forged(named(reason=""))).returncode, 2)
        whole = self.forged(named(status="executable", reason=""))
        self.assertIn(("config", "end_s"), self.own_violations(whole))
        for until in ("place", "lift", "hold", "reach", "home"):
            found = self.own_violations(self.forged(named(delivered_until=until)))
            self.assertIn(("status", "delivered_until"), found, until)
        def sooner(plan):
            plan.attrs["requested_end_s"] = plan.attrs["end_s"] - 0.1
        for found in self.violations(self.forged(sooner)):
            self.assertIn(("status", "requested_end_s"), found)
        def later(plan):
            plan.attrs["requested_end_s"] += 0.1
        self.assertIn(("config", "requested_end_s"), self.own_violations(self.forged(later)))


if __name__ == "__main__":
    main()
