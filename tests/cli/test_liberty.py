"""Liberty and CyberGlove text files, from the calibration pose to movements: what they are written
from, a synthetic dataset, is known."""
import h5py
import numpy as np

import liberty_text
from support import SOURCE, CommandCase, main

CONFIG = SOURCE / "configs/synthetic/reach_to_grasp.yaml"


class Liberty(CommandCase):
    def test_text_is_the_same_recording(self):
        made, read = self.folder / "made.h5", self.folder / "read.h5"
        self.succeeds("synthesize", CONFIG, "--out", made, "--count", "2")
        with h5py.File(made) as file:
            manifest = liberty_text.write_recordings(file, self.folder)
            self.succeeds("import", manifest, "--out", read)
            with h5py.File(read) as again:
                self.assertEqual(list(file["demonstrations"]), list(again["demonstrations"]))
                for name, one in file["demonstrations"].items():
                    self.same(one, again["demonstrations"][name])
        made, read = (self.json_of("inspect", file)["demonstrations"] for file in (made, read))
        for one, other in zip(made, read):
            self.assertTrue(one["movements"])
            for movement, same in zip(one["movements"], other["movements"], strict=True):
                self.assertEqual([p["name"] for p in movement["phases"]],
                                 [p["name"] for p in same["phases"]])
                np.testing.assert_allclose([p["begin_s"] for p in movement["phases"]],
                                           [p["begin_s"] for p in same["phases"]], atol=0.01)

    def same(self, one, other):
        """Ten digits were written; which of q and -q stands for a turn is nobody's business."""
        for place in ("sensors", "calibration/sensors"):
            for what in ("time", "position"):
                np.testing.assert_allclose(one[place][what], other[place][what], atol=1e-8)
            match = np.abs(np.sum(one[place]["orientation"][()] * other[place]["orientation"][()],
                                  axis=-1))
            np.testing.assert_allclose(match[~np.isnan(match)], 1, atol=1e-8)
            self.assertEqual(np.isnan(one[place]["position"]).sum(),
                             np.isnan(other[place]["position"]).sum())
        for place in ("hand", "calibration/hand"):
            np.testing.assert_allclose(one[place]["time"], other[place]["time"], atol=1e-8)
            np.testing.assert_allclose(one[place]["angles"], other[place]["angles"], atol=1e-8)
        np.testing.assert_allclose(one["calibration/offsets/position"],
                                   other["calibration/offsets/position"], atol=1e-6)
        match = np.abs(np.sum(one["calibration/offsets/orientation"][()] *
                              other["calibration/offsets/orientation"][()], axis=-1))
        np.testing.assert_allclose(match, 1, atol=1e-8)


if __name__ == "__main__":
    main()
