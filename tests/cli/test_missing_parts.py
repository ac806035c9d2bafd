"""Shipped recordings of which a part is missing: markers hidden for a while, rows cut off at either end.
What `run` says of them is what `verify` says of its plans."""
import h5py

from support import QUICK, RECORDINGS, REFERENCE, CommandCase, main
from verify_geometry import text

WRIST = ("RHAN1", "RHAN2", "RHAN3", "RHAN4", "RSPR", "RSPU")
TIPS = ("RFTP", "RTHUM")
HEADER_LINES = 5


def damaged(trial, target, hidden=(), from_s=0, to_s=0, begin_s=0, end_s=99):
    """A copy with rows from begin_s to end_s, in which `hidden` markers have no numbers from from_s to to_s.
    Rows are 10 ms apart, and numbered from 1."""
    lines = (RECORDINGS / f"{trial}.csv").read_text(encoding="utf-8-sig").splitlines()
    names = lines[2].split(",")
    columns = [3 * k + 2 + axis for k, name in enumerate(names[2::3]) for axis in range(3) if name.partition(":")[2] in hidden]
    assert len(columns) == 3 * len(hidden)
    rows = []
    for row in lines[HEADER_LINES:]:
        cells = row.split(",")
        if not cells[0].isdigit() or not begin_s <= (time_s := (int(cells[0]) - 1) / 100) < end_s:
            continue
        for column in columns if from_s <= time_s < to_s else ():
            cells[column] = ""
        rows.append(",".join([str(len(rows) + 1), *cells[1:]]))
    target.write_text("\n".join([*lines[:HEADER_LINES], *rows]) + "\n")
    return target


class MissingParts(CommandCase):
    def planned(self, trial="ADL001DR2", settings=(), **damage):
        """The attributes of the one plan, which `verify` accepts."""
        file, out = damaged(trial, self.folder / f"{trial}.csv", **damage), self.folder / "out"
        self.succeeds("run", REFERENCE, "--dataset", file, "--static-trial", RECORDINGS / f"{trial[:6]}_static.csv",
                      "--out", out, "--fresh", *QUICK, *settings)
        self.succeeds("verify", out)
        with h5py.File(out / "plans.h5") as plans:
            return {name: text(value) for name, value in plans[f"plans/{trial}/000"].attrs.items()}

    def infeasible(self, word, **damage):
        plan = self.planned(**damage)
        self.assertEqual((plan["status"], plan["reason"]), ("infeasible", "doubtful_recording"), plan["detail"])
        self.assertIn(word, plan["detail"])
        return plan

    def test_a_wrist_hidden_for_200_ms(self):
        plan = self.planned(hidden=WRIST, from_s=1.3, to_s=1.5)
        self.assertEqual(plan["status"], "executable", plan["detail"])

    def test_a_forearm_hidden_for_300_ms(self):
        self.planned(hidden=("RLAR1", "RLAR2", "RLAR3", "RLAR4"), from_s=1.0, to_s=1.3)

    def test_a_shoulder_hidden_for_150_ms(self):
        self.planned(hidden=("RSHO1", "RSHO2", "RSHO3", "RSHO4"), from_s=0.9, to_s=1.05)

    def test_the_fingertips_hidden_in_the_grasp(self):
        # the grasp is labelled from 1.72 s to 2.05 s
        self.infeasible("of the fingertip goals in grasp and hold were not recorded", hidden=TIPS, from_s=1.8, to_s=2.0)

    def test_the_fingertips_hidden_in_the_reach(self):
        # the reach is labelled from 0.66 s to 1.72 s
        plan = self.planned(hidden=TIPS, from_s=1.2, to_s=1.4)
        self.assertEqual(plan["status"], "approximate", plan["detail"])
        self.assertIn("there is no fingertip goal for 0.2", plan["detail"])
        lenient = self.planned(hidden=TIPS, from_s=1.2, to_s=1.4, settings=("--set", "check.max_goal_gap_s=1"))
        self.assertEqual(lenient["status"], "executable", lenient["detail"])
        self.infeasible("no fingertip was recorded for 0.5", hidden=TIPS, from_s=1.0, to_s=1.5)

    def test_a_recording_that_ends_in_the_reach(self):
        plan = self.infeasible("the recording ends while the hand moves", end_s=1.3)
        self.assertIn("no complete reach", plan["detail"])
        overruled = self.planned(end_s=1.3, settings=("--set", "audit.refuse=[spike]"))
        self.assertNotEqual(overruled["reason"], "doubtful_recording")

    def test_a_recording_that_begins_in_the_reach(self):
        self.infeasible("the recording begins while the hand moves", begin_s=1.05)


if __name__ == "__main__":
    main()
