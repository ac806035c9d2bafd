"""A stranger's recording: the first try may fail, but what it says to paste makes the second one work,
and the geometry is right. The truth is that of shipped recordings, written in other formats with other
names, units and axes. It takes more than 10 s: every recording is written, then imported up to two times and compared."""
import os
import subprocess

import h5py
import numpy as np

from recorded import (JOINT_COLUMNS, Recorded, c3d_bytes, joints_of, point_csv, qualisys_tsv,
                      recorded_from_csv, renamed_bvh, trc_text, vicon_csv)
from support import MORPHE, QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, main, morphe

TRIAL, STATIC = RECORDINGS / "ADL001DR2.csv", RECORDINGS / "ADL001_static.csv"

# What somebody might call the markers of ue-adl.
CALLED = {"SHO": "scapula", "UAR": "upper_arm", "LAR": "forearm", "HAN": "hand",
          "GTH": "acromion", "LEP": "elbow_lat", "MEP": "elbow_med", "SPR": "wrist_radial",
          "SPU": "wrist_ulnar", "FB": "index_knuckle", "FTP": "index_nail", "THUM": "thumb_nail"}


def called(name):
    """RUAR1 -> right_upper_arm_1; what is not on an arm keeps its name."""
    side = {"R": "right", "L": "left"}.get(name[0], "")
    stem = name[1:].rstrip("0123456789")
    if not side or stem not in CALLED:
        return f"m_{name}"
    number = name[1 + len(stem):]
    return f"{side}_{CALLED[stem]}" + (f"_{number}" if number else "")


def turned_onto(truth, points):
    """Points turned about the vertical by the one angle that lays them best on the truth: import
    turns a person to face Y."""
    seen = np.isfinite(truth).all(axis=2) & np.isfinite(points).all(axis=2)
    a, b = (rows[seen][:, 0] + 1j * rows[seen][:, 1] for rows in (points, truth))
    turn = np.vdot(a, b) / abs(np.vdot(a, b))
    flat = (points[..., 0] + 1j * points[..., 1]) * turn
    return np.stack([flat.real, flat.imag, points[..., 2]], axis=2)


class Journey(CommandCase):
    def setUp(self):
        super().setUp()
        (self.folder / "bin").mkdir()
        os.symlink(MORPHE, self.folder / "bin/morphe")
        os.symlink(SOURCE / "configs", self.folder / "configs")
        self.tries = 0

    def arrives(self, *arguments):
        """Runs it; if it is refused, pastes what is proposed into a shell. At most two tries."""
        first = morphe(*arguments, cwd=self.folder)
        self.tries, self.said = 1, first.stderr
        if first.returncode == 0:
            return first
        self.assertEqual(first.returncode, 2, first.stderr)
        self.assertIn("to paste:\n", first.stderr)
        pasted = first.stderr.split("to paste:\n", 1)[1]
        second = subprocess.run(["sh", "-e"], input=pasted, cwd=self.folder, text=True,
                                capture_output=True,
                                env={**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}"})
        self.tries = 2
        self.assertEqual(second.returncode, 0, first.stderr + second.stdout + second.stderr)
        return second

    def stream_of(self, file, stream):
        with h5py.File(file) as imported:
            (demonstration,) = imported["demonstrations"].values()
            group = demonstration[stream]
            return ([name.decode() for name in group.attrs["names"]], group["position"][:],
                    group["time"][:])

    def expect_markers(self, file, truth, tolerance=1e-6, stream="markers"):
        """Every marker of ours is where the truth has it."""
        names, position, time = self.stream_of(file, stream)
        arm = [name for name in truth.names if not called(name).startswith("m_")]
        self.assertEqual(sorted(set(names) & set(arm)), sorted(arm))
        ours = position[:, [names.index(name) for name in arm]]
        theirs = truth.position[:, [truth.names.index(name) for name in arm]]
        np.testing.assert_allclose(turned_onto(theirs, ours), theirs, rtol=0, atol=tolerance)
        if stream == "markers":
            np.testing.assert_allclose(time - time[0], truth.time - truth.time[0], atol=1e-6)


class Markers(Journey):
    """The table trials, whose static trial shows the joints."""

    def setUp(self):
        super().setUp()
        self.trial, self.still = recorded_from_csv(TRIAL), recorded_from_csv(STATIC)

    def write_both(self, suffix, write):
        """Trial and static trial, as `write` makes text or bytes of them."""
        for name, truth in (("reach", self.trial), ("static", self.still)):
            content = write(truth)
            file = self.folder / f"{name}{suffix}"
            if isinstance(content, bytes):
                file.write_bytes(content)
            else:
                file.write_text(content)

    def expect_a_movement(self):
        entry, = self.json_of("inspect", self.folder / "out.h5")["demonstrations"]
        movement, = entry["movements"]
        self.assertEqual(movement["unusable_reason"], "")
        return entry

    def test_trc_of_other_names_and_axes(self):
        self.write_both(".trc", lambda t: trc_text(t.called(called).seen_as("-y z -x"), "mm"))
        self.arrives("import", "reach.trc", "--static-trial", "static.trc", "--out", "out.h5")
        self.assertEqual(self.tries, 2)
        self.expect_markers(self.folder / "out.h5", self.trial)
        self.expect_markers(self.folder / "out.h5", self.still, 2e-3, "calibration/markers")
        self.expect_a_movement()

    def test_c3d_of_optitrack_says_neither_where_points_begin_nor_their_unit(self):
        self.write_both(".c3d", lambda t: c3d_bytes(t.called(called).seen_as("x z -y"), unit="",
                                                    rate=100, data_start=0))
        self.arrives("import", "reach.c3d", "--static-trial", "static.c3d", "--out", "out.h5")
        self.expect_markers(self.folder / "out.h5", self.trial, 1e-5)
        for asked in ("axes", "unit", "names"):
            self.assertIn(f": {asked}: ", self.said)

    def test_qualisys_tsv(self):
        self.write_both(".tsv", lambda t: qualisys_tsv(t.called(called).seen_as("y -x z")))
        self.arrives("import", "reach.tsv", "--static-trial", "static.tsv", "--out", "out.h5")
        self.expect_markers(self.folder / "out.h5", self.trial, 1e-5)

    def test_own_csv_of_markers_in_inches_with_decimal_commas(self):
        self.write_both(".csv", lambda t: point_csv(t.called(called).seen_as("z x y"), metres=0.0254,
                                                    separator=";", comma=True, axis=" {}"))
        self.arrives("import", "reach.csv", "--static-trial", "static.csv", "--rate", 100, "--out", "out.h5")
        self.expect_markers(self.folder / "out.h5", self.trial, 1e-5)

    def test_without_a_static_trial_the_doubt_is_printed(self):
        self.write_both(".trc", lambda t: trc_text(t.seen_as("x y z"), "mm"))
        printed = self.arrives("import", "reach.trc", "--out", "out.h5").stdout
        self.assertIn("no static trial: joint centres", printed)


    def test_usual_axes_that_the_body_contradicts_give_way(self):
        (self.folder / "turned.csv").write_text(vicon_csv(self.trial.seen_as("y -x z")))
        printed = self.arrives("import", "turned.csv", "--out", "out.h5").stdout
        self.assertIn("89 degrees away from the forward axis", printed)
        self.expect_markers(self.folder / "out.h5", self.trial)
        kept = self.arrives("import", "turned.csv", "--forward", "recorded", "--out", "out.h5").stdout
        self.assertIn("the posture of the body contradicts the axes", kept)
        self.assertIn("'y -x z'", kept)


class OwnPoints(Journey):
    """Joint centres that some program computed, in a CSV of its own."""

    def setUp(self):
        super().setUp()
        self.truth = joints_of(recorded_from_csv(TRIAL), recorded_from_csv(STATIC))

    def expect_joints(self, tolerance=2e-6):
        names, position, _ = self.stream_of(self.folder / "out.h5", "skeleton")
        self.assertEqual(sorted(names), sorted(self.truth.names))
        for k, name in enumerate(self.truth.names):
            np.testing.assert_allclose(position[:, names.index(name)], self.truth.position[:, k],
                                       rtol=0, atol=tolerance, err_msg=name)

    def test_names_axes_unit_and_rate_are_asked_for_at_once(self):
        words = {"shoulder": "Schulter", "elbow": "Ellbogen", "wrist": "Handgelenk",
                 "thumb_tip": "Daumen", "index_tip": "Zeigefinger"}
        text = point_csv(self.truth.called(lambda n: words[n.removeprefix("right_")]).seen_as("z x y"),
                         metres=0.001, separator=";", comma=True, time="Bild")
        (self.folder / "griff.csv").write_text(text)
        self.arrives("import", "griff.csv", "--out", "out.h5")
        for asked in ("axes", "unit", "rate", "names"):
            self.assertIn(f": {asked}: ", self.said)
        self.expect_joints()

    def test_a_header_of_two_lines_and_a_time(self):
        text = point_csv(self.truth.called(lambda n: n.replace("right_", "R ").title())
                         .seen_as("-x -y z"), metres=1, separator="\t", header_lines=2,
                         time="Time [s]")
        (self.folder / "reach.txt").write_text(text)
        self.arrives("import", "reach.txt", "--out", "out.h5")
        self.expect_joints()
        entry, = self.json_of("inspect", self.folder / "out.h5")["demonstrations"]
        self.assertEqual([p["body_part"] for p in entry["points"]],
                         [n.replace("_", " ") for n in self.truth.names])
        self.assertEqual(len(entry["movements"]), 1)

    def test_from_a_table_of_points_to_an_executable_plan(self):
        (self.folder / "reach.csv").write_text(
            point_csv(self.truth.called(lambda n: n.removeprefix("right_")).seen_as("z x y"),
                      metres=0.01, time="t"))
        printed = self.arrives("run", REFERENCE, "--dataset", "reach.csv", "--out", "out",
                               *QUICK).stdout
        self.assertEqual(self.tries, 2)
        self.assertIn("1 executable", printed)

    def test_inspect_asks_in_the_same_words(self):
        text = point_csv(self.truth.seen_as("y z x"), metres=0.01, time="t")
        (self.folder / "reach.csv").write_text(text)
        printed = self.arrives("inspect", "reach.csv").stdout
        self.assertIn("used as", printed)
        self.assertIn("1 movements", printed.replace("1 movement,", "1 movements,"))


class Skeletons(Journey):
    def test_a_shipped_name_map_is_found_and_the_unit_proposed(self):
        bvh = SOURCE / "datasets/cmu-iclone-bvh/006_15.bvh"
        printed = self.arrives("import", bvh, "--out", "out.h5").stdout
        self.assertIn("--unit cm: ", self.said)
        self.assertIn("names mapped by iclone.yaml", printed)
        self.succeeds("import", SOURCE / "datasets/cmu-iclone-bvh/recordings.yaml", "--out",
                      self.folder / "known.h5")
        with h5py.File(self.folder / "known.h5") as known:
            wanted = known["demonstrations/cmu_006_15/skeleton/position"][:]
        _, position, _ = self.stream_of(self.folder / "out.h5", "skeleton")
        np.testing.assert_allclose(position, wanted, rtol=0, atol=1e-12)

    def test_unknown_names_unit_and_axes_at_once(self):
        known = SOURCE / "datasets/pybvh/bvh_test3.bvh"
        (self.folder / "own.bvh").write_text(renamed_bvh(known.read_text(), 25.4))
        self.arrives("import", "own.bvh", "--out", "out.h5")
        for asked in ("axes", "unit", "names"):
            self.assertIn(f": {asked}: ", self.said)
        self.succeeds("import", SOURCE / "datasets/pybvh/recordings.yaml", "--out",
                      self.folder / "known.h5")
        with h5py.File(self.folder / "known.h5") as file:
            group = file["demonstrations/bvh_test3/skeleton"]
            wanted = dict(zip([n.decode() for n in group.attrs["names"]],
                              np.moveaxis(group["position"][:], 1, 0)))
        names, position, _ = self.stream_of(self.folder / "out.h5", "skeleton")
        mapped = [name for name in wanted if name.startswith(("right_", "left_"))]
        self.assertEqual(sorted(set(names) & set(mapped)), sorted(mapped))
        for name in mapped:
            np.testing.assert_allclose(position[:, names.index(name)], wanted[name], rtol=0,
                                       atol=1e-4, err_msg=name)


class Hands(Journey):
    def test_keypoints_unit_and_rate_at_once(self):
        csv = SOURCE / "datasets/dex-retargeting/human_joint_right.csv"
        self.arrives("import", csv, "--out", "out.h5")
        self.assertIn(": unit: ", self.said)
        self.assertIn(": rate: ", self.said)
        self.assertIn("--unit m: sure", self.said)
        with h5py.File(self.folder / "out.h5") as file:
            first = file["demonstrations/human_joint_right/hand/position"][0, 1]
        np.testing.assert_allclose(first, [0.009778, 0.031039, 0.019651], atol=1e-12)


    def test_a_hand_as_another_program_calls_it(self):
        csv = SOURCE / "datasets/dex-retargeting/human_joint_right.csv"
        truth = np.loadtxt(csv, delimiter=",", skiprows=1)[:, 1:].reshape(-1, 21, 3)
        truth = truth + [0.3, 0.2, 0.1]  # a point exactly at the origin would be one that is not seen
        fingers = [("THUMB", ("CMC", "MCP", "IP", "TIP"))] + [
            (f"{name}_FINGER" if name != "PINKY" else name, ("MCP", "PIP", "DIP", "TIP"))
            for name in ("INDEX", "MIDDLE", "RING", "PINKY")]
        names = ["WRIST"] + [f"{finger}_{joint}" for finger, joints in fingers for joint in joints]
        for called_so in (names, [f"lm{k}" for k in range(21)]):
            text = point_csv(Recorded(called_so, truth), metres=0.001)
            (self.folder / "hand.csv").write_text(text)
            self.arrives("import", "hand.csv", "--out", "out.h5")
            with h5py.File(self.folder / "out.h5") as file:
                hand = file["demonstrations/hand/hand"]
                self.assertEqual(hand.attrs["kind"], b"keypoints")
                position = hand["position"][:]
            shape = np.linalg.norm(position - position[:, :1], axis=2)
            np.testing.assert_allclose(shape, np.linalg.norm(truth - truth[:, :1], axis=2),
                                       atol=1e-6)


class Wrong(Journey):
    def test_a_wrong_unit_is_replaced_in_what_is_to_be_pasted(self):
        truth = joints_of(recorded_from_csv(TRIAL), recorded_from_csv(STATIC))
        (self.folder / "reach.csv").write_text(point_csv(truth, metres=0.001, time="t"))
        self.arrives("import", "reach.csv", "--unit", "m", "--axes", "x y z", "--out", "out.h5")
        self.assertIn("--unit mm", self.said)
        self.assertNotIn("--unit m ", self.said.split("to paste:")[1])

    def test_a_folder_is_asked_once_for_all_of_it(self):
        trial, still = recorded_from_csv(TRIAL), recorded_from_csv(STATIC)
        (self.folder / "lab/P1").mkdir(parents=True)
        shown = [k for k in range(len(trial.names)) if np.isfinite(trial.position[:, k]).any()]
        trial = Recorded([trial.names[k] for k in shown], trial.position[:, shown])
        for name, truth in (("reach.trc", trial), ("static.trc", still)):
            text = trc_text(truth.called(called).seen_as("z x y"), "mm")
            (self.folder / "lab/P1" / name).write_text(text)
        self.arrives("import", "lab", "--out", "out.h5")
        self.assertEqual(self.tries, 2)
        self.expect_markers(self.folder / "out.h5", trial)
        self.expect_markers(self.folder / "out.h5", still, 2e-3, "calibration/markers")

    def test_a_manifest_is_told_what_to_add(self):
        truth = joints_of(recorded_from_csv(TRIAL), recorded_from_csv(STATIC))
        (self.folder / "reach.csv").write_text(point_csv(truth.seen_as("z x y"), metres=0.001, time="t"))
        manifest = self.folder / "all.yaml"
        manifest.write_text("recordings:\n  - {file: reach.csv}\n")
        refused = morphe("import", manifest, "--out", self.folder / "out.h5")
        self.assertEqual(refused.returncode, 2)
        lines = refused.stderr.split("entry of the recording:\n")[1]
        manifest.write_text(lines + manifest.read_text())
        self.succeeds("import", manifest, "--out", self.folder / "out.h5")


if __name__ == "__main__":
    main()
