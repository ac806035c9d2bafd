"""Where a laboratory laid its axes changes nothing: a person faces where the body says."""
import math

import h5py
import numpy as np

from formats import text
from support import QUICK, RECORDINGS, REFERENCE, CommandCase, main, morphe

FIRST_ROW = 5  # of a Vicon export


class Facing(CommandCase):
    def turned(self, name, degrees):
        """A shipped recording with its points turned about the vertical."""
        cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        lines = (RECORDINGS / name).read_text(encoding="utf-8-sig").splitlines()
        for number in range(FIRST_ROW, len(lines)):
            cells = lines[number].split(",")
            for x in range(2, len(cells) - 2, 3):
                if cells[x]:
                    east, north = float(cells[x]), float(cells[x + 1])
                    cells[x] = repr(cosine * east - sine * north)
                    cells[x + 1] = repr(sine * east + cosine * north)
            lines[number] = ",".join(cells)
        file = self.folder / f"{degrees}" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text("\n".join(lines) + "\n")
        return file

    def plan(self, recording, static, *arguments):
        out = self.folder / f"out_{recording.parent.name}_{len(arguments)}"
        run = self.succeeds("run", REFERENCE, "--dataset", recording, "--static-trial", static, "--out", out,
                            *arguments, *QUICK)
        with h5py.File(out / "plans.h5") as file:
            plan, = next(iter(file["plans"].values())).values()
            position = plan["trajectory/position"][()] if "trajectory" in plan else None
            return run.stdout + run.stderr, text(plan.attrs["status"]), text(plan.attrs["reason"]), position

    def test_the_same_plans_from_any_axes(self):
        _, status, _, straight = self.plan(self.turned("ADL001FR1.csv", 0), self.turned("ADL001_static.csv", 0))
        self.assertEqual(status, "executable")
        for degrees in (180, 137.3):
            said, status, _, position = self.plan(self.turned("ADL001FR1.csv", degrees),
                                                  self.turned("ADL001_static.csv", degrees))
            self.assertEqual(status, "executable")
            self.assertIn("away from the forward axis", said)
            self.assertLess(np.abs(position - straight).max(), 1e-3)

    def test_by_the_axes_a_person_who_sat_the_other_way_is_no_human(self):
        recording, static = self.turned("ADL001FR1.csv", 180), self.turned("ADL001_static.csv", 180)
        said, status, reason, _ = self.plan(recording, static, "--forward", "recorded")
        self.assertEqual((status, reason), ("infeasible", "implausible_arm"))
        self.assertIn("beyond human joint limits", said)
        self.assertIn("the posture of the body contradicts the axes", said)
        self.assertIn("implausible_arm", self.succeeds("inspect", recording, "--static-trial", static,
                                                 "--forward", "recorded").stdout)
        refused = morphe("inspect", recording, "--forward", "north")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("--forward", refused.stderr)


if __name__ == "__main__":
    main()
