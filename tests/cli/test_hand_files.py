"""Files of hands with one peculiarity each (tests/data/recordings)."""
import shlex

import h5py
import numpy as np

from support import SOURCE, CommandCase, main, morphe

DATA = SOURCE / "tests/data/recordings"


class HandFiles(CommandCase):
    def skeleton(self, file):
        with h5py.File(file) as h5:
            (group,) = h5["demonstrations"].values()
            names = [name.decode() for name in group["skeleton"].attrs["names"]]
            return group["skeleton/time"][()], dict(zip(names, np.moveaxis(group["skeleton/position"][()], 1, 0)))

    def test_zeros_are_no_hand(self):
        out = self.folder / "read.h5"
        self.succeeds("import", DATA / "clip_zeros_are_no_hand.npz", "--out", out)
        _, points = self.skeleton(out)
        for name, path in points.items():
            self.assertEqual(list(np.flatnonzero(np.isnan(path).any(axis=1))), list(range(20, 26)), name)

    def test_times_in_milliseconds(self):
        out = self.folder / "read.h5"
        said = self.succeeds("import", DATA / "clip_times_in_ms.npz", "--out", out).stdout
        self.assertIn("unit of 'times' not in the file; assumed ms, 25 rows per second", said)
        time, _ = self.skeleton(out)
        np.testing.assert_allclose(time, np.arange(71) / 25, atol=1e-12)

    def test_a_hand_alone_in_bvh(self):
        asked = morphe("import", DATA / "bvh_hand_alone_in_cm.bvh", "--out", "read.h5", cwd=self.folder)
        self.assertEqual(asked.returncode, 2, asked.stdout)
        lines = asked.stderr.split("to paste:\n")[1].splitlines()
        (self.folder / "bvh_hand_alone_in_cm_names.yaml").write_text("\n".join(lines[1:lines.index("END")]))
        words = shlex.split(lines[-1])
        self.assertEqual(words[words.index("--unit") + 1], "cm")
        self.succeeds(*words[1:], cwd=self.folder)
        _, points = self.skeleton(self.folder / "read.h5")
        finger = np.linalg.norm(points["right_index_tip"] - points["right_index_mcp"], axis=-1)
        self.assertTrue((0.07 < finger).all() and (finger < 0.11).all(), finger)


if __name__ == "__main__":
    main()
