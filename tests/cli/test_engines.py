"""`check.engine: fcl` runs every check through FCL alone: on all shipped demonstrations that can be
planned it must say what the closed forms say. More than 10 s: every pipeline is planned with both, and FCL
alone takes four times as long where a path is repaired."""
import unittest

import h5py

from formats import text
from support import QUICK, SOURCE, CommandCase, main

# Below this a closed form speaks of what it could not prove within its band, FCL of nothing.
UNDECIDED = 1.01e-4


def verdicts(file):
    """By plan: its reason, and the collisions found in its mapped path, by cause and pair."""
    found = {}
    with h5py.File(file) as plans:
        for name, movements in plans["plans"].items():
            for movement, plan in movements.items():
                rows = plan["findings"] if "findings" in plan else {}
                pairs = {}
                if "cause" in rows:
                    columns = (rows[k][()] for k in ("cause", "subject", "other_body", "excess"))
                    for cause, one, other, depth in zip(*columns):
                        key = (text(cause), text(one), text(other))
                        if key[0] in ("self_collision", "object_collision", "table"):
                            pairs[key] = max(depth, pairs.get(key, 0))
                found[name, movement] = text(plan.attrs["reason"]), pairs
    return found


class Engines(CommandCase):
    def check(self, pipeline):
        both = []
        for engine in ("analytic", "fcl"):
            out = self.folder / engine
            self.succeeds("run", SOURCE / "configs/pipelines" / pipeline, *QUICK, "--out", out, "--jobs", 2,
                          "--set", f"check.engine={engine}", "--set", "repair.max_iterations=1")
            both.append(verdicts(out / "plans.h5"))
        analytic, fcl = both
        self.assertEqual(analytic.keys(), fcl.keys())
        collisions = 0
        for plan, (reason, pairs) in analytic.items():
            sure = {pair for pair, depth in pairs.items() if depth > UNDECIDED}
            self.assertLessEqual(sure, fcl[plan][1].keys(), plan)
            self.assertLessEqual(fcl[plan][1].keys(), pairs.keys(), plan)
            collisions += len(sure)
            if not pairs:
                self.assertEqual(reason, fcl[plan][0], plan)
        return collisions

    def test_reference(self):
        self.check("pa10_dlr_hit2.yaml")

    def test_with_an_obstacle(self):
        self.assertGreater(self.check("pa10_dlr_hit2_obstacle.yaml"), 0)

    def test_with_a_mesh(self):
        self.assertGreater(self.check("pa10_dlr_hit2_shelf.yaml"), 0)

    def test_adroit(self):
        self.check("pa10_dlr_hit2_adroit.yaml")

    def test_a_hand_alone(self):
        self.check("dlr_hit2_keypoints.yaml")

    def test_with_the_target_elsewhere(self):
        self.check("pa10_dlr_hit2_moved.yaml")


if __name__ == "__main__":
    main()
