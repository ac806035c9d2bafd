"""morphe place: what it prints, writes and refuses. It takes more than 10 s: two searches for a place,
one for people and one as JSON, and a run from there."""
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from support import REFERENCE, SOURCE, CommandCase, main, morphe, write_two_recordings

# So small a search takes seconds; what it finds is no good measure of it.
SMALL = ("--candidates", 8, "--refine", 2, "--plan", 1, "--set", "map.coarse_step_s=0.1")


def rotation(turns):
    """Elementary turns, multiplied from left to right (Rodrigues)."""
    m = np.eye(3)
    for turn in turns:
        x, y, z = np.eye(3)["xyz".index(turn["axis"])]
        k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        m = m @ (np.eye(3) + np.sin(turn["angle"]) * k + (1 - np.cos(turn["angle"])) * k @ k)
    return m


class Place(CommandCase):
    def test_a_config_that_runs_and_a_map(self):
        recordings = write_two_recordings(self.folder)
        config, picture = self.folder / "placed.yaml", self.folder / "map.svg"
        done = self.succeeds("place", REFERENCE, "--dataset", recordings, *SMALL, "--mount", "side",
                             "--tilt", 20, "--fix", "y", "--out", config, "--reach-map", picture)
        self.assertIn("place: refined roughly 2 of 2", done.stderr)
        section, _, note = done.stdout[done.stdout.index("placement:"):].partition("note: ")
        self.assertIn(f"{config} does not contain --set and --dataset", note)
        self.assertTrue(config.read_text().endswith(section))
        self.assertEqual(ElementTree.parse(picture).getroot().get("width"), "700")
        rows = done.stdout.splitlines()
        self.assertRegex(rows[2], r"^configured +2 of 2 ")
        self.assertRegex(rows[3], r"^1 +\d of 2 ")
        found = self.json_of("place", REFERENCE, "--dataset", recordings, *SMALL, "--mount", "side",
                             "--tilt", 20, "--fix", "y", "--jobs", 1)
        best, configured = found["placements"][0], found["configured"]
        self.assertEqual(configured["shoulder_offset"], [0.1, -0.3, 0.3])
        self.assertEqual(best["shoulder_offset"][1], -0.3)
        self.assertGreater(abs(rotation(best["rotation"])[0, 2]), np.cos(np.radians(20.3)))
        offset = re.search(r"shoulder_offset: \[(.*)\]", section)[1]
        np.testing.assert_allclose([float(v) for v in offset.split(",")], best["shoulder_offset"])
        # A run from there says the same.
        out = self.folder / "run"
        ran = self.json_of("run", config, "--dataset", recordings, "--out", out, "--set",
                           "map.coarse_step_s=0.1")
        self.assertEqual(ran["executable"], best["executable"])
        self.assertEqual(ran["movements"], best["movements"])

    def test_what_cannot_be_placed(self):
        recordings = write_two_recordings(self.folder)
        place = ("place", REFERENCE, "--dataset", recordings)
        self.refuses(morphe(*place, "--fix", "x,w"), "--fix x,w", "rotation")
        self.refuses(morphe(*place, "--tilt", 100), "place", "tilt")
        self.refuses(morphe(*place, "--refine", 2), "place", "--plan: must be 1 to 2")
        self.assertEqual(morphe(*place, "--mount", "roof").returncode, 2)
        hand = self.folder / "hand.yaml"
        hand.write_text(f"robot: {{file: {SOURCE}/configs/robots/dlr_hit2.yaml}}\n")
        self.refuses(morphe("place", hand), hand, "dataset")
        self.refuses(morphe("place", hand, "--dataset", recordings), "dlr_hit2", "hand without an arm")


if __name__ == "__main__":
    main()
