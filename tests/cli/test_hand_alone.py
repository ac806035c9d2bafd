"""Hands alone: the certified path keeps the goals of the mapping and the person's tempo.

The truth is what is asked of repair: tips off by at most 1.3 times the mapping's mean, at most 1.5 times the
person's duration. The recording is the part of the shipped one in which fingers of a robot hand are caught.
"""
import json

import h5py
import numpy as np

from support import SOURCE, CommandCase, main, python_verify

RECORDING = SOURCE / "datasets/dex-retargeting/human_joint_right.csv"
MANIFEST = """\
format: keypoints-csv
unit: m
rate_hz: 30
hand: right
recordings: [{file: part.csv, name: part}]
"""
FIRST_ROW, ROWS = 246, 40  # 8.2 s to 9.5 s


class HandAlone(CommandCase):
    def setUp(self):
        super().setUp()
        header, *rows = RECORDING.read_text().splitlines()
        part = [header, *rows[FIRST_ROW:FIRST_ROW + ROWS]]
        (self.folder / "part.csv").write_text("\n".join(part) + "\n")
        (self.folder / "recordings.yaml").write_text(MANIFEST)

    def planned(self, *settings):
        out = self.folder / f"out-{len(settings)}"
        self.succeeds("run", SOURCE / "configs/pipelines/hand_keypoints.yaml",
                      "--dataset", self.folder / "recordings.yaml", "--out", out, "--set",
                      f"robot.file={SOURCE}/configs/robots/allegro.yaml", *settings)
        plans = out / "plans.h5"
        self.assertEqual(self.json_of("verify", plans)["violations"], [])
        self.assertEqual(json.loads(python_verify(plans).stdout)["violations"], [])
        file = h5py.File(plans)
        self.addCleanup(file.close)
        return file["plans/part/000"]

    def test_goals_and_tempo_are_kept_where_the_limits_would_make_the_hand_slow(self):
        slow = self.planned("--set", "repair.tempo.max_duration_ratio=100")
        kept = self.planned()
        self.assertGreater(slow["certificate"].attrs["duration_ratio"], 1.5, "or nothing is tested")
        for plan in (slow, kept):
            self.assertGreater(len(plan["findings/cause"]), 0, "or nothing is tested")
            mapped = np.nanmean(plan["mapped/tip_error"][()])
            self.assertLess(plan["certificate"].attrs["tip_error_mean"], 1.5 * mapped)  # 1.3 is the aim
            self.assertGreaterEqual(plan["certificate"].attrs["clearance"], 0.001)
        self.assertLessEqual(kept["certificate"].attrs["duration_ratio"], 1.5)
        names = [name.decode() for name in kept["repair/name"][()]]
        self.assertTrue(any(name.startswith("tempo") for name in names), names)


if __name__ == "__main__":
    main()
