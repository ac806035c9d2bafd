"""What may be wrong with recordings of hands, in the file of every reader: each fault is a line that
says it, or what is read is right all the same."""
import json
import re
from pathlib import Path

import h5py
import numpy as np

import tracked_hands
from support import SOURCE, CommandCase, main, morphe, temporary_folder

ADROIT = SOURCE / "datasets/adroit-dapg/recordings.yaml"
FOOT = 0.3048


def write_clip(hand, folder):
    folder.mkdir(parents=True, exist_ok=True)
    np.savez(folder / "door.npz", times=hand.time, mano_right_joints=hand.joints, joint_order="openpose", axes="x y z",
             object_handle_pose=tracked_hands.matrices(np.eye(3), hand.handle),
             object_handle_shape="sphere", object_handle_size=[0.02])
    return folder / "door.npz"


WRITERS = {"clip-npz": write_clip, "optitrack-csv": tracked_hands.write_optitrack,
           "aria-csv": tracked_hands.write_aria, "hot3d": tracked_hands.write_hot3d,
           "mvnx": tracked_hands.write_mvnx, "manus-csv": tracked_hands.write_manus,
           "avp-jsonl": tracked_hands.write_avp_jsonl, "avp-npz": tracked_hands.write_avp_npz,
           "egodex-hdf5": tracked_hands.write_egodex}


def edited(file, change):
    """The file, its text or its arrays changed."""
    if file.suffix == ".npz":
        np.savez(file, **change(dict(np.load(file))))
    elif file.suffix == ".hdf5":
        with h5py.File(file, "r+") as h5:
            change(h5)
    else:
        file.write_text(change(file.read_text()))
    return file


def other_side(text):
    """Right and left exchanged."""
    sides = {"right": "left", "left": "right", "Right": "Left", "Left": "Right"}
    return re.sub("right|left|Right|Left", lambda side: sides[side[0]], text)


def exchanged(reader, file):
    """A right hand that is called a left one."""
    if reader == "manus-csv":
        return file.rename(file.with_name("door_L.csv"))
    if reader == "optitrack-csv":
        (file.parent / "names.yaml").write_text("Hand: left_wrist\n")

    def change(content):
        if isinstance(content, str):
            return other_side(content)
        if isinstance(content, dict):
            return {other_side(key): value for key, value in content.items()}
        for group in content.values():
            for name in list(group):
                if name.startswith("right"):
                    group.move(name, other_side(name))
        return None
    return edited(file, change)


def scaled(hand, factor):
    hand = hand.every(slice(None))
    for name in ("joints", "wrist", "handle", "in_palm", "tips"):
        setattr(hand, name, getattr(hand, name) * factor)
    return hand


def moved(hand, turn, shift=0.0):
    """As another frame sees it; [3, 3] or [N, 3, 3], and [N, 3]."""
    hand, turn = hand.every(slice(None)), np.broadcast_to(turn, hand.turn.shape)
    hand.joints = np.einsum("nij,nkj->nki", turn, hand.joints) + np.reshape(shift, (-1, 1, 3) if np.ndim(
        shift) else ())
    hand.wrist = np.einsum("nij,nj->ni", turn, hand.wrist) + shift
    hand.handle = np.einsum("nij,nj->ni", turn, hand.handle) + shift
    hand.turn, hand.palm, hand.tips = turn @ hand.turn, turn @ hand.palm, hand.joints[:, 4::4]
    return hand


def in_a_moving_frame(hand):
    t = hand.time
    turn = (tracked_hands.rotation((0, 0, 1), 0.5 * np.sin(2 * t))
            @ tracked_hands.rotation((1, 0, 0), 0.3 * np.cos(3 * t)))
    return moved(hand, turn, np.stack([0.2 * np.sin(2 * t), 0.1 * np.cos(t), 0.05 * np.sin(3 * t)], -1))


class WrongRecordings(CommandCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with temporary_folder() as folder:
            original = Path(folder) / "adroit.h5"
            assert morphe("import", ADROIT, "--forward", "recorded", "--out", original).returncode == 0
            cls.hand = tracked_hands.hands_of(original)["door_demo_06"]

    def answer(self, reader, file):
        options = {"optitrack-csv": ("--names", file.parent / "names.yaml")}.get(reader, ())
        if reader in ("avp-npz", "egodex-hdf5"):
            options = ("--rate", "100")
        return morphe("import", file, *options, "--out", self.folder / "read.h5")

    def each(self, change, *without):
        """Every reader's file of the hand, changed first."""
        for reader, write in WRITERS.items():
            if reader in without:
                continue
            folder = self.folder / reader
            folder.mkdir(exist_ok=True)
            with self.subTest(reader):
                yield reader, write(change(self.hand), folder)

    def test_the_other_hand(self):
        # UmeTrack's joints are computed for the side that is said: they are one's of that side.
        for reader, file in self.each(lambda hand: hand, "hot3d"):
            file = exchanged(reader, file)
            self.refuses(self.answer(reader, file), file, "left hand: its fingers curl like those of a right")

    def test_feet_for_metres(self):
        for reader, file in self.each(lambda hand: scaled(hand, 1 / FOOT), "hot3d"):
            asked = self.answer(reader, file)
            self.assertEqual(asked.returncode, 2, asked.stdout)
            self.assertIn("unit: implausible: the right hand would measure 0.327 m", asked.stderr)
            if reader in ("optitrack-csv", "manus-csv"):  # in mm and cm: nobody writes 0.3 mm and 3 mm
                self.assertNotIn("--unit", asked.stderr)
                self.assertIn("mm, cm, m, in and ft do not make it plausible", asked.stderr)
            else:
                self.assertIn("--unit ft", asked.stderr.split("to paste:")[1])

    def test_feet_for_metres_of_a_world_alone(self):
        """HOT3D's hand is the profile's, in millimetres: only where it is may be in feet."""
        file = tracked_hands.write_hot3d(self.hand, self.folder / "hot3d")
        lines = [json.loads(line) for line in file.read_text().splitlines()]
        for line in lines:
            for pose in line["hand_poses"].values():
                pose["wrist_xform"]["t_xyz"] = [x / FOOT for x in pose["wrist_xform"]["t_xyz"]]
        file.write_text("".join(json.dumps(line) + "\n" for line in lines))
        (read,) = self.json_of("inspect", file)["demonstrations"]
        self.assertTrue(any(s.startswith("no fixed shoulder position has all wrist positions within")
                            for s in read["problems"]), read["problems"])

    def test_another_axis_is_up(self):
        """Where a head was recorded, the hands are above it."""
        file = tracked_hands.write_avp_jsonl(moved(self.hand, tracked_hands.Y_UP.T), self.folder)

        def with_head(text):
            lines = [json.loads(line) for line in text.splitlines()]
            for line in lines:  # eyes 0.45 m above the table and 0.2 m behind the hand's beginning
                head = np.eye(4)
                head[:3, 3] = [0, -0.45, 0.45]
                line["headMatrix"] = list(head.T.ravel())
            return "".join(json.dumps(line) + "\n" for line in lines)
        said = self.answer("avp-jsonl", edited(file, with_head))
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertRegex(said.stdout, r"the median height of the hands above the head is 0\.\d\d m; another axis may")

    def test_a_frame_that_moves(self):
        """Objects that nobody touches move with it."""
        said_of = {}
        for reader, file in self.each(in_a_moving_frame):
            said = self.answer(reader, file)
            self.assertEqual(said.returncode, 0, said.stderr)
            said_of[reader] = re.findall(r"object handle moves by 0\.\d\d m before a hand comes near", said.stdout)
        with_objects = {"clip-npz", "optitrack-csv", "hot3d"}
        self.assertEqual({reader for reader, said in said_of.items() if said}, with_objects)
        for reader, file in self.each(lambda hand: hand):
            self.assertNotIn("before a hand comes near", self.answer(reader, file).stdout)

    def test_half_of_the_frames_missing(self):
        hidden = np.arange(len(self.hand.time)) % 2 == 1

        def hide_array(key, nothing):
            def change(arrays):
                arrays[key][hidden] = nothing
                return arrays
            return change

        def hide_confidence(h5):
            for confidence in h5["confidences"].values():
                confidence[hidden] = 0

        def hide_lines(change, first=0, each=1):
            """Of a text, every line of a hidden frame; a frame has `each` lines."""
            def change_text(text):
                lines = text.splitlines()
                for k in range(first, len(lines)):
                    if hidden[(k - first) // each]:
                        lines[k] = change(lines[k])
                return "\n".join(lines) + "\n"
            return change_text

        def hide_landmarks(text):
            at = text.splitlines()[0].split(",").index("right_tracking_confidence")
            return hide_lines(lambda line: ",".join(
                "-1" if k == at else cell for k, cell in enumerate(line.split(","))), first=1)(text)

        hide = {"clip-npz": hide_array("mano_right_joints", np.nan),
                "optitrack-csv": hide_lines(lambda line: re.sub(r",[^,]*", ",", line), first=7),
                "aria-csv": hide_landmarks,
                "hot3d": hide_lines(lambda line: json.dumps({**json.loads(line), "hand_poses": {}}), each=2),
                "avp-jsonl": hide_lines(lambda line: line.replace("rightHand", "nobody")),
                "avp-npz": hide_array("stream_right_wrist", 0),
                "egodex-hdf5": hide_confidence}

        # Suits and gloves know their joints always.
        for reader, file in self.each(lambda hand: hand, "mvnx", "manus-csv"):
            said = self.answer(reader, edited(file, hide[reader]))
            self.assertEqual(said.returncode, 0, said.stderr)
            seen = int(re.search(r"the right hand is visible in (\d+) of 284 frames", said.stdout)[1])
            self.assertTrue(130 <= seen <= 142, seen)

    def test_times_that_run_back(self):
        def back(hand):
            hand = hand.every(slice(None))
            hand.time = hand.time.copy()
            hand.time[[100, 101]] = hand.time[[101, 100]]
            return hand

        # Frames of the last two have no times, those of a suit an index.
        for reader, file in self.each(back, "mvnx", "avp-npz", "egodex-hdf5"):
            refused = self.answer(reader, file)
            self.assertEqual(refused.returncode, 2, refused.stdout)
            self.assertRegex(refused.stderr, rf"^{re.escape(str(file))}(:\d+)?: .*must be greater than ")
            self.assertEqual(refused.stderr.count("\n"), 1)
        file = edited(tracked_hands.write_mvnx(self.hand, self.folder),
                      lambda text: text.replace('index="100"', 'index="98"'))
        self.refuses(self.answer("mvnx", file), f"{file}:{line_with(file, 'index=' + chr(34) + '98' + chr(34), 2)}",
                     "frame.index", "must be greater")

    def test_two_people(self):
        file = tracked_hands.write_mvnx(self.hand, self.folder)
        text = file.read_text()
        subject = text[text.index("<subject"):text.index("</subject>") + len("</subject>")]
        file.write_text(text.replace(subject, subject + subject.replace('"P1"', '"P2"')))
        said = self.answer("mvnx", file)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn("the file has 2 people; the first, P1, is used", said.stdout)


def line_with(file, needle, count):
    lines = [i for i, line in enumerate(file.read_text().splitlines(), 1) if needle in line]
    return lines[count - 1]


if __name__ == "__main__":
    main()
