"""A right-handed recording seen in the mirror X -> -X and declared left must give the same movements
and plans: body, calibration, sensor offsets and recorded objects go to the mirror together."""
import shutil

import h5py
import numpy as np

import formats
from support import QUICK, REFERENCE, CommandCase, main

ONE_MOVEMENT = """\
movements:
  movements_per_recording: [1, 1]
  rest_s: [0.3, 0.5]
object:
  tracked_object_share: 1
"""


def mirror(file):
    """In place. M = diag(-1, 1, 1): points M p, rotations M R M."""
    def visit(path, item):
        name = path.rsplit("/", 1)[-1]
        if name == "position":
            item[...] = item[()] * np.array([-1, 1, 1])
        elif name == "orientation":
            item[...] = item[()] * np.array([1, 1, -1, -1])

    with h5py.File(file, "r+") as h5:
        h5.visititems(visit)
        for demonstration in h5["demonstrations"].values():
            demonstration.attrs.modify("hand", np.bytes_("left"))


class LeftHand(CommandCase):
    def setUp(self):
        super().setUp()
        config = self.folder / "one.yaml"
        config.write_text(ONE_MOVEMENT)
        self.recorded = self.folder / "recorded.h5"
        self.succeeds("synthesize", config, "--out", self.recorded, "--count", 1, "--seed", 4)
        # The truth holds fingertips; thumb and index alone are planned in a second.
        self.tips = self.folder / "recorded.truth.h5"
        with h5py.File(self.tips, "r+") as h5:
            for demonstration in h5["demonstrations"].values():
                demonstration["hand/position"][:, 2:] = np.nan

    def in_the_mirror(self, file):
        left = self.folder / f"left_{file.name}"
        shutil.copy(file, left)
        mirror(left)
        return left

    def test_movements_are_the_same(self):
        for file in (self.recorded, self.tips):
            with self.subTest(file.name):
                right = self.json_of("inspect", file)["demonstrations"]
                left = self.json_of("inspect", self.in_the_mirror(file))["demonstrations"]
                self.assertEqual([d["hand"] for d in right + left], ["right", "left"])
                self.assertEqual([len(d["movements"]) for d in right], [1])
                self.assertEqual([d["movements"] for d in right], [d["movements"] for d in left])
                self.assertEqual(left[0]["problems"],
                                 right[0]["problems"] + ["a left hand: mirrored at X = 0 into a right hand"])

    def test_plans_are_the_same(self):
        plans = []
        for file in (self.tips, self.in_the_mirror(self.tips)):
            out = self.folder / f"plans_{file.stem}"
            self.succeeds("run", REFERENCE, "--dataset", file, "--out", out, *QUICK)
            h5 = h5py.File(out / "plans.h5")
            self.addCleanup(h5.close)
            [movements] = h5["plans"].values()
            [plan] = movements.values()
            plans.append(plan)
        right, left = plans
        self.assertEqual(formats.text(right.attrs["status"]), "executable")
        self.assertEqual(formats.text(right.attrs["target"]), "cup")
        self.assertEqual([formats.text(plan.attrs["hand"]) for plan in plans], ["right", "left"])
        for key in right.attrs:
            if key not in ("hand", "detail"):
                np.testing.assert_array_equal(right.attrs[key], left.attrs[key], key)
        names = []
        right.visit(names.append)
        self.assertIn("scene/cup/position", names)
        self.assertIn("trajectory/position", names)
        for name in names:
            if isinstance(right[name], h5py.Dataset):
                np.testing.assert_array_equal(right[name][()], left[name][()], name)


if __name__ == "__main__":
    main()
