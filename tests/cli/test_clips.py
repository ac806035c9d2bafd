"""Clips (.npz): what labs write, what Morphe writes, and what is wrong with some of them. It takes more
than 10 s: eight orders of five hands, and all that is shipped written and read again."""
import json
import re
from pathlib import Path

import h5py
import numpy as np

import tracked_hands
from support import QUICK, RECORDINGS, REFERENCE, SOURCE, CommandCase, main, morphe, temporary_folder

ADROIT = SOURCE / "datasets/adroit-dapg/recordings.yaml"
FINGERS = tracked_hands.FINGERS
TIPS = [f"right_{finger}_tip" for finger in FINGERS]
PINKY = ("thumb", "index", "middle", "ring", "pinky")
# Where a keypoint stands in each order's list, from the documents of their makers, finger by finger.
ORDERS = {
    "openpose": (21, [0, *range(1, 21)]),
    "mano": (21, [0, 13, 14, 15, 16, 1, 2, 3, 17, 4, 5, 6, 18, 10, 11, 12, 19, 7, 8, 9, 20]),
    "aria": (21, [5, None, 6, 7, 0, 8, 9, 10, 1, 11, 12, 13, 2, 14, 15, 16, 3, 17, 18, 19, 4]),
    "flashdex": (20, [None, 18, 17, 16, 19, 2, 1, 0, 3, 6, 5, 4, 7, 14, 13, 12, 15, 10, 9, 8, 11]),
    "openxr": (26, [1, 2, 3, 4, 5, *range(7, 11), *range(12, 16), *range(17, 21), *range(22, 26)]),
    "webxr": (25, [0, 1, 2, 3, 4, *range(6, 10), *range(11, 15), *range(16, 20), *range(21, 25)]),
    "arkit": (27, [0, 1, 2, 3, 4, *range(6, 10), *range(11, 15), *range(16, 20), *range(21, 25)]),
    "ovr": (24, [0, 3, 4, 5, 19, 6, 7, 8, 20, 9, 10, 11, 21, 12, 13, 14, 22, 16, 17, 18, 23]),
}


def in_order(joints, order):
    """[T, 21, 3] keypoints as a tool lists them; what it has beside (palm, metacarpals) lies between
    wrist and middle knuckle."""
    count, places = ORDERS[order]
    listed = np.repeat((0.6 * joints[:, 0] + 0.4 * joints[:, 9])[:, None], count, axis=1)
    for keypoint, place in enumerate(places):
        if place is not None:
            listed[:, place] = joints[:, keypoint]
    return listed


def pose_of(hand):
    pose = np.tile(np.eye(4), (len(hand.time), 1, 1))
    pose[:, :3, 3] = hand.handle
    return pose


BALL = ("object_handle_shape", "sphere"), ("object_handle_size", [0.02])


class Clips(CommandCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with temporary_folder() as folder:
            original = Path(folder) / "adroit.h5"
            assert morphe("import", ADROIT, "--out", original).returncode == 0
            cls.hands = tracked_hands.hands_of(original)
            inspected = json.loads(morphe("inspect", original, "--json").stdout)
        cls.phases = {entry["name"]: entry["movements"] for entry in inspected["demonstrations"]}

    def write(self, name="clip", **arrays):
        file = self.folder / f"{name}.npz"
        file.parent.mkdir(parents=True, exist_ok=True)
        np.savez(file, **arrays)
        return file

    def arrays_of(self, hand, order="openpose"):
        return {"times": hand.time, "mano_right_joints": in_order(hand.joints, order),
                "mano_right_wrist_pos": hand.wrist, "object_handle_pose": pose_of(hand), "axes": "x y z",
                **dict(BALL)}

    def read(self, file, *options):
        read = self.folder / "read.h5"
        self.succeeds("import", file, "--forward", "recorded", *options, "--out", read)
        with h5py.File(read) as h5:
            (group,) = h5["demonstrations"].values()
            names = [name.decode() for name in group["skeleton"].attrs["names"]]
            points = dict(zip(names, np.moveaxis(group["skeleton/position"][()], 1, 0)))
            return points, [report.decode() for report in group["import_notes"][()]], read

    def same_tips(self, points, hand):
        for finger, tip in enumerate(TIPS):
            missed = np.linalg.norm(points[tip] - hand.tips[:, finger], axis=-1)
            self.assertLess(missed.max(), 1e-4, tip)

    def same_phases(self, name, file):
        (entry,) = self.json_of("inspect", file)["demonstrations"]
        self.assertEqual(len(entry["movements"]), len(self.phases[name]), entry["problems"])
        for movement, same in zip(entry["movements"], self.phases[name]):
            self.assertEqual([p["name"] for p in movement["phases"]],
                             [p["name"] for p in same["phases"]])
            np.testing.assert_allclose([p["begin_s"] for p in movement["phases"]],
                                       [p["begin_s"] for p in same["phases"]], atol=0.0101)

    def test_flashdex(self):
        (self.folder / "objects/handle").mkdir(parents=True)
        corners = 0.02 * np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]])
        faces = [(1, 3, 5), (3, 2, 5), (2, 4, 5), (4, 1, 5), (3, 1, 6), (2, 3, 6), (4, 2, 6), (1, 4, 6)]
        (self.folder / "objects/handle/visual.obj").write_text(
            "".join("v {} {} {}\n".format(*corner) for corner in corners)
            + "".join("f {} {} {}\n".format(*face) for face in faces))
        for name, hand in self.hands.items():
            with self.subTest(name):
                file = self.write(
                    f"human_demo/{name}", fps=np.float32(100), mano_right_wrist_pos=hand.wrist,
                    mano_right_wrist_rot=np.tile(np.eye(3), (len(hand.time), 1, 1)),
                    mano_right_joints=in_order(hand.joints, "flashdex").astype(np.float32),
                    obj_right_pose=pose_of(hand), obj_right_id="handle", obj_right_scale=1.0)
                points, reports, read = self.read(file)
                self.same_tips(points, hand)
                self.assertIn("flashdex", " ".join(reports))
                self.same_phases(name, read)
                with h5py.File(read) as h5:
                    self.assertEqual(len(h5[f"demonstrations/{name}/objects/handle/triangles"]), 8)

    def test_every_order_is_told_by_count_and_anatomy(self):
        for order in ORDERS:
            for name, hand in self.hands.items():
                with self.subTest(order=order, name=name):
                    points, reports, read = self.read(self.write(name, **self.arrays_of(hand, order)))
                    self.same_tips(points, hand)
                    self.assertIn(f"mano_right_joints: joint order {order},", " ".join(reports))
            self.same_phases(name, read)

    def test_names_decide_whatever_the_order(self):
        hand = self.hands["door_demo_06"]
        names = ["wrist"] + [f"{finger}_{part}" for finger in PINKY for part in
                             (("metacarpal", "proximal", "distal", "tip") if finger == "thumb" else
                              ("proximal", "intermediate", "distal", "tip"))] + ["elbow_pad"]
        shuffled = np.random.default_rng(1).permutation(len(names))
        joints = np.concatenate([hand.joints, hand.joints[:, :1]], axis=1)
        arrays = self.arrays_of(hand)
        arrays["mano_right_joints"] = joints[:, shuffled]
        arrays["mano_right_joint_names"] = np.array(names)[shuffled]
        points, reports, _ = self.read(self.write(**arrays))
        self.same_tips(points, hand)
        np.testing.assert_allclose(points["right_thumb_ip"], hand.joints[:, 3], atol=1e-9)
        self.assertIn("elbow_pad", " ".join(reports))

    def test_an_order_that_nothing_tells_is_asked_for(self):
        hand = self.hands["door_demo_06"]
        arrays = self.arrays_of(hand)
        said = "mano_right_joints: the 21 joints do not look like a hand in any known order"
        arrays["mano_right_joints"] = hand.joints[:, np.random.default_rng(2).permutation(21)]
        file = self.write(**arrays)
        self.refuses(morphe("import", file, "--out", self.folder / "no.h5"), f"{file}", said)
        odd, stretched = hand.joints.copy(), [2, 3, 6, 7, 10, 11]  # as no tracker would see them
        odd[:, stretched] += 2 * (odd[:, stretched] - hand.wrist[:, None])
        arrays["mano_right_joints"] = odd
        file = self.write(**arrays)
        asked = morphe("import", file, "--out", self.folder / "read.h5")
        self.assertEqual(asked.returncode, 2)
        self.assertIn(f"{file}: {said}", asked.stderr)
        self.assertIn("--joint-order openpose", asked.stderr.split("to paste:")[1])
        points, _, _ = self.read(file, "--joint-order", "openpose")
        self.assertIn("right_index_tip", points)
        self.refuses(morphe("import", file, "--joint-order", "openxr", "--out", self.folder / "no.h5"),
                     file, "21 joints", "26")

    def test_units_axes_and_what_is_not_seen(self):
        hand = self.hands["door_demo_06"]
        arrays = self.arrays_of(hand)
        y_up = tracked_hands.Y_UP
        joints = 100 * arrays["mano_right_joints"] @ y_up.T
        joints[5:9] = np.nan
        pose = pose_of(hand)
        pose[:, :3] = y_up @ pose[:, :3]
        pose[:, :3, 3] *= 100
        arrays.update(mano_right_joints=joints.astype(">f4"), object_handle_pose=np.asfortranarray(pose),
                      object_handle_size=[2.0], unit="cm", axes="x -z y")
        del arrays["mano_right_wrist_pos"]
        points, reports, read = self.read(self.write(**arrays))
        missed = np.linalg.norm(points["right_index_tip"] - hand.tips[:, 1], axis=-1)
        self.assertEqual(list(np.flatnonzero(np.isnan(missed))), [5, 6, 7, 8])
        self.assertLess(np.nanmax(missed), 1e-4)
        self.assertIn(f"the right hand is visible in {len(missed) - 4} of {len(missed)} frames", reports)
        with h5py.File(read) as h5:
            np.testing.assert_allclose(h5["demonstrations/clip/objects/handle/position"][()],
                                       hand.handle, atol=1e-9)

    def test_axes_that_the_clip_does_not_state_are_asked_for(self):
        hand = self.hands["door_demo_06"]
        arrays = self.arrays_of(hand)
        del arrays["axes"]
        high = [0.0, 0.0, 2.0]  # a floor far below
        for turn, likely in ((np.eye(3), "x y z"), (tracked_hands.Y_UP, "x -z y")):
            with self.subTest(likely):
                for key, values in (("mano_right_joints", hand.joints), ("mano_right_wrist_pos", hand.wrist)):
                    arrays[key] = (values + high) @ turn.T
                asked = morphe("import", self.write(**arrays), "--out", self.folder / "no.h5")
                self.assertEqual(asked.returncode, 2, asked.stdout)
                self.assertIn(": axes: the file does not state", asked.stderr)
                self.assertIn(f"--axes '{likely}'", asked.stderr.split("to paste:")[1])
        points, _, _ = self.read(self.write(**arrays), "--axes", "x -z y")
        np.testing.assert_allclose(points["right_index_tip"], hand.tips[:, 1] + high, atol=1e-9)

    def test_hands_that_were_not_seen_are_zeros(self):
        hand = self.hands["door_demo_06"]
        for nothing in (0, -1):
            arrays = self.arrays_of(hand)
            arrays["mano_right_joints"] = hand.joints.copy()
            arrays["mano_right_joints"][20:26] = nothing
            arrays["mano_right_wrist_pos"] = arrays["mano_right_joints"][:, 0]
            arrays["object_handle_pose"] = pose_of(hand)
            arrays["object_handle_pose"][30:33] = 0
            points, reports, read = self.read(self.write(**arrays))
            missed = np.linalg.norm(points["right_index_tip"] - hand.tips[:, 1], axis=-1)
            self.assertEqual(list(np.flatnonzero(np.isnan(missed))), list(range(20, 26)))
            self.assertIn("all joints of the right hand are at one point in 6 frames; treated as not visible",
                          reports)
            with h5py.File(read) as h5:
                self.assertEqual(len(h5["demonstrations/clip/objects/handle/time"]), len(hand.time) - 3)

    def test_times_in_other_units(self):
        hand = self.hands["door_demo_06"]
        plain, _, _ = self.read(self.write(**self.arrays_of(hand)))
        for factor, unit in ((1e3, "ms"), (1e6, "us"), (1e9, "ns")):
            with self.subTest(unit):
                arrays = self.arrays_of(hand)
                arrays.update(times=hand.time * factor, label_phases=["reach"],
                              label_times=[[0.5 * factor, 1.0 * factor]])
                points, reports, read = self.read(self.write(**arrays))
                self.assertIn(f"unit of 'times' not in the file; assumed {unit}, ", "; ".join(reports))
                with h5py.File(read) as h5:
                    np.testing.assert_allclose(h5["demonstrations/clip/skeleton/time"], hand.time, atol=1e-9)
        frames = self.arrays_of(hand)
        frames["times"] = np.arange(len(hand.time))
        asked = morphe("import", self.write(**frames), "--out", self.folder / "no.h5")
        self.assertEqual(asked.returncode, 2)
        self.assertIn(": rate: 'times' has whole numbers with the step 1", asked.stderr)
        self.read(self.write(**frames), "--rate", "100")
        with h5py.File(self.folder / "read.h5") as h5:
            np.testing.assert_allclose(h5["demonstrations/clip/skeleton/time"], np.arange(len(hand.time)) / 100)

    def test_an_order_that_the_bones_contradict_is_asked_for(self):
        for name, hand in self.hands.items():
            for order, stated in (("mano", "openpose"), ("openpose", "mano"), ("aria", "openpose")):
                with self.subTest(name, order=order, stated=stated):
                    file = self.write(name, **{**self.arrays_of(hand, order), "joint_order": stated})
                    asked = morphe("import", file, "--out", self.folder / "no.h5")
                    self.assertEqual(asked.returncode, 2, asked.stdout)
                    self.assertIn("the bones contradict the joint order of the file", asked.stderr)
                    self.assertIn(f"--joint-order {order}", asked.stderr.split("to paste:")[1])
                    points, _, _ = self.read(file, "--joint-order", order)
                    self.same_tips(points, hand)

    def test_joints_in_the_frame_of_the_wrist_have_no_place(self):
        hand = self.hands["door_demo_06"]
        local = hand.joints - hand.joints[:, :1]
        file = self.write(times=hand.time, axes="x y z", joint_order="openpose", mano_right_joints=local)
        said = self.succeeds("import", file, "--out", self.folder / "read.h5").stdout
        self.assertIn("the wrist is the origin in every frame: the points are in the frame of the hand", said)

    def test_spider(self):
        hand = self.hands["door_demo_06"]
        rows = len(hand.time)
        fingers = np.zeros((rows, 5, 7))
        fingers[..., 3] = 1
        fingers[..., :3] = hand.tips
        nothing = np.tile([0, 0, 0, 1, 0, 0, 0.0], (rows, 1))
        (self.folder / "task_info.json").write_text(json.dumps({"task": "door", "ref_dt": 0.01}))
        file = self.write(
            "0/trajectory_keypoints", qpos_finger_right=fingers, qpos_finger_left=0 * fingers,
            qpos_wrist_right=np.hstack([hand.wrist, tracked_hands.quaternions_of(hand.turn)]),
            qpos_wrist_left=nothing, qpos_obj_left=nothing,
            qpos_obj_right=np.hstack([hand.handle, nothing[:, 3:]]))
        points, reports, read = self.read(file)
        self.same_tips(points, hand)
        self.assertEqual(sorted(points), sorted([*TIPS, "right_wrist"]))
        self.assertIn("frame period 0.01 s, from task_info.json", reports)
        with h5py.File(read) as h5:
            (group,) = h5["demonstrations"].values()
            self.assertEqual(list(group["objects"]), ["right_object"])
            self.assertEqual(group.attrs["task"], b"door")

    def test_what_is_wrong_is_said(self):
        hand = self.hands["door_demo_06"]
        good = self.arrays_of(hand)
        backwards = hand.time.copy()
        backwards[7] = backwards[5]
        mirrored = {**good, "mano_right_joints": hand.joints * [-1, 1, 1]}
        feet = {key: value / 0.3048 if key.startswith("mano") else value for key, value in good.items()}
        no_rate = {key: value for key, value in good.items() if key != "times"}
        for arrays, key, *words in (
                ({**good, "times": backwards}, "times", "value 7 must be greater"),
                ({**good, "object_handle_pose": 2 * pose_of(hand)}, "object_handle_pose", "not a rotation"),
                ({**good, "object_handle_shape": "ring"}, "object_handle_shape", "ring"),
                ({**good, "object_handle_size": [1.0, 2.0]}, "object_handle_size", "(2,)", "(1,)"),
                ({**good, "mano_right_wrist_pos": hand.wrist[1:]}, "mano_right_wrist_pos", "shape"),
                ({**good, "joint_order": "opnpose"}, "joint_order", "opnpose", "openpose"),
                ({**good, "note": np.array([{}])}, "note", "Python objects"),
                (mirrored, "right hand", "curl like those of a left hand"),
                ({"fps": 30}, "is not a clip", "mano_right_joints", "fps")):
            with self.subTest(key):
                file = self.write(**arrays)
                self.refuses(morphe("import", file, "--out", self.folder / "no.h5"), f"{file}: {key}",
                             *words)
                self.assertFalse((self.folder / "no.h5").exists())
        period = {**no_rate, "fps": 0.01}
        for arrays, asked in ((feet, "unit"), (no_rate, "rate"), (period, "rate")):
            with self.subTest(asked):
                result = morphe("inspect", self.write(**arrays))
                self.assertEqual(result.returncode, 2)
                self.assertIn(f": {'fps' if arrays is period else asked}: ", result.stderr)
                self.assertIn(f"--{asked} ", result.stderr.split("to paste:")[1])

    def test_damaged_files_are_refused(self):
        hand = self.hands["door_demo_06"].every(slice(0, 20))
        np.savez_compressed(self.folder / "whole.npz", **self.arrays_of(hand))
        whole = (self.folder / "whole.npz").read_bytes()
        file = self.folder / "damaged.npz"
        random = np.random.default_rng(3)
        for at in random.integers(0, len(whole), 12):
            file.write_bytes(whole[:at])
            result = morphe("inspect", "--format", "clip-npz", file)
            self.refuses(result, file)
        for at in random.integers(0, len(whole), 12):
            flipped = bytearray(whole)
            flipped[at] ^= 0xFF
            file.write_bytes(flipped)
            self.assertIn(morphe("inspect", "--format", "clip-npz", file).returncode, (0, 2))

    def test_the_page_shows_how(self):
        page = (SOURCE / "docs/clips.md").read_text()
        (code,) = re.findall(r"^```python\n(.*?)^```$", page, re.M | re.S)
        hand = self.hands["door_demo_06"]
        seen_by_camera = hand.joints @ np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
        seen_by_camera[3] = 0
        code = code.replace('"mug.npz", 30', f'"{self.folder / "mug.npz"}", 100')
        exec(code, {"camera_joints": seen_by_camera})
        points, _, read = self.read(self.folder / "mug.npz")
        missed = np.linalg.norm(points["right_index_tip"] - hand.tips[:, 1], axis=-1)
        self.assertEqual(list(np.flatnonzero(np.isnan(missed))), [3])
        self.assertLess(np.nanmax(missed), 1e-9)
        with h5py.File(read) as h5:
            self.assertEqual(h5["demonstrations/mug"].attrs["task"], b"lift the mug")


class Beside(CommandCase):
    """What lies beside clips, and what a manifest says of them."""

    def setUp(self):
        super().setUp()
        self.data = self.folder / "data"
        self.data.mkdir()
        joints = np.zeros((40, 21, 3))
        for finger in range(5):
            for joint in range(4):
                across = 0.02 * (2 - finger)
                joints[:, 1 + 4 * finger + joint] = (across, 0.09 - 0.01 * abs(finger - 2) + 0.03 * joint,
                                                     -0.012 * joint)
        joints[:, 1:5] += (0.02, -0.06, -0.01)
        joints += np.stack([0 * np.arange(40), 0.01 * np.arange(40), 0 * np.arange(40)], -1)[:, None]
        self.right, self.left = -joints * [1, -1, -1], joints

    def clip(self, name="clip", **more):
        np.savez(self.data / f"{name}.npz", fps=30, joint_order="openpose", axes="x y z",
                 mano_left_joints=self.left, mano_right_joints=self.right + [0.4, 0, 0], **more)
        return self.data / f"{name}.npz"

    def manifest(self, *lines):
        file = self.data / "some.yaml"
        file.write_text("recordings:\n  - {" + ", ".join(lines) + "}\n")
        return file

    def hand_of(self, *arguments):
        out = self.folder / "hand.h5"
        self.succeeds("import", *arguments, "--out", out)
        with h5py.File(out) as h5:
            return {name: (group.attrs["hand"].decode(), [r.decode() for r in group["import_notes"][()]])
                    for name, group in h5["demonstrations"].items()}

    def test_other_arrays_are_passed_over(self):
        self.clip()
        np.savez(self.data / "forces.npz", forces=np.zeros((5, 3)), fps=100)
        np.savez_compressed(self.data / "model.npz", weights=np.array([{}], object))
        damaged = self.clip("damaged")
        damaged.write_bytes(damaged.read_bytes()[:-400])
        half = self.clip("half")
        half.write_bytes(half.read_bytes().replace(b"<f8", b"<q8"))
        result = morphe("import", self.data, "--out", self.folder / "read.h5")
        self.assertEqual(result.returncode, 1, result.stderr)
        said = result.stdout + result.stderr
        for name in ("forces", "model"):
            self.assertIn(f"skipped: {self.data / name}.npz: not a recording: a .npz file without a key of a "
                          "clip, such as mano_right_joints", said)
        for name in ("damaged", "half"):
            self.assertIn(f"cannot be read: {self.data / name}.npz: ", said)
        with h5py.File(self.folder / "read.h5") as h5:
            self.assertEqual(list(h5["demonstrations"]), ["clip"])
        for name in ("forces", "model"):
            self.refuses(morphe("inspect", self.data / f"{name}.npz"), self.data / f"{name}.npz",
                         "is not a clip", "mano_right_joints", "body_joints", "qpos_wrist_left")

    def test_the_clip_says_which_hand(self):
        self.clip(hand="left")
        said = "the clip states that the left hand reaches; the right one was requested and used"
        for manifest, options, hand, contradicts in (
                (("file: clip.npz",), (), "left", False),
                (("file: clip.npz", "hand: left"), (), "left", False),
                (("file: clip.npz", "hand: right"), (), "right", True),
                (("file: clip.npz", "hand: right"), ("--hand", "left"), "left", False),
                (("file: clip.npz",), ("--hand", "right"), "right", True)):
            with self.subTest(manifest=manifest, options=options):
                ((taken, reports),) = self.hand_of(self.manifest(*manifest), *options).values()
                self.assertEqual(taken, hand)
                self.assertEqual(said in reports, contradicts, reports)
        both = self.hand_of(self.manifest("file: clip.npz", "hand: both"))
        self.assertEqual({name: hand for name, (hand, _) in both.items()},
                         {"clip_right": "right", "clip_left": "left"})
        one = self.hand_of(self.manifest("file: clip.npz", "hand: both"), "--hand", "left")
        self.assertEqual(list(one), ["clip_left"])

    def test_the_command_line_wins_over_a_manifest(self):
        self.clip()
        for key, value, option, given in (("joint_order", "openxr", "--joint-order", "openpose"),
                                          ("axes", "x -z y", "--axes", "x y z"),
                                          ("unit", "mm", "--unit", "m"),):
            with self.subTest(key):
                plain = self.hand_of(self.data / "clip.npz", option, given)
                told = self.hand_of(self.manifest("file: clip.npz", "hand: right", f"{key}: {value}"),
                                    option, given)
                with h5py.File(self.folder / "hand.h5") as h5:
                    points = h5["demonstrations/clip/skeleton/position"][()]
                self.hand_of(self.data / "clip.npz", option, given, "--hand", "right")
                with h5py.File(self.folder / "hand.h5") as h5:
                    np.testing.assert_array_equal(h5["demonstrations/clip/skeleton/position"][()], points)
                self.assertEqual(set(told["clip"][1]) - set(plain["clip"][1]), set())


class Written(CommandCase):
    # Bodies and angles alone, and recordings that Morphe reads alike.
    NONE, TWICE = {"box_angles", "rofunc_take", "cmu_take"}, {"hands_v2", "wrists_v2"}

    def test_all_that_is_shipped_comes_back(self):
        manifests = sorted((SOURCE / "datasets").glob("*/recordings.yaml"))
        first, clips = self.folder / "first.h5", self.folder / "clips"
        said = self.succeeds("import", *manifests, "--out", first, "--clip", clips).stdout
        for name in self.NONE:
            self.assertIn(f"{name}: no clip", said)
        again = self.folder / "again.h5"
        self.succeeds("import", clips, "--out", again)
        with h5py.File(first) as a, h5py.File(again) as b:
            names = set(a["demonstrations"]) - self.NONE - self.TWICE
            self.assertEqual(set(b["demonstrations"]), names)
            for name in names:
                with self.subTest(name):
                    self.same(a["demonstrations"][name], b["demonstrations"][name],
                              np.load(clips / f"{name}.npz", allow_pickle=False))
        self.same_movements(first, again)
        second = self.folder / "clips_again"
        self.succeeds("import", *manifests, "--clip", second)
        for file in sorted(clips.iterdir()):
            self.assertEqual(file.read_bytes(), (second / file.name).read_bytes(), file.name)

    def same_movements(self, first, again):
        before = {e["name"]: e for e in self.json_of("inspect", first)["demonstrations"]}
        for entry in self.json_of("inspect", again)["demonstrations"]:
            with self.subTest(entry["name"]):
                was = before[entry["name"]]
                self.assertEqual(len(entry["movements"]), len(was["movements"]))
                for movement, same in zip(entry["movements"], was["movements"]):
                    self.assertEqual([p["name"] for p in movement["phases"]],
                                     [p["name"] for p in same["phases"]])
                    for key in ("begin_s", "end_s"):
                        np.testing.assert_allclose([p[key] for p in movement["phases"]],
                                                   [p[key] for p in same["phases"]], atol=1e-6)
                self.assertEqual(set(entry["estimated"]) & {"shoulder", "elbow", "fingertips"},
                                 set(was["estimated"]) & {"shoulder", "elbow", "fingertips"})

    def same(self, a, b, clip):
        for key in ("task", "hand", "source", "licence", "subject"):
            self.assertEqual(a.attrs.get(key, b""), b.attrs.get(key, b""), key)
        for name in a.get("objects", ()):
            for key in ("time", "position", "orientation"):
                np.testing.assert_allclose(b["objects"][name][key], a["objects"][name][key], atol=1e-9)
        if "rebuilt" in clip:
            self.assertEqual(b["skeleton"].attrs["reconstructed"], 1)
            np.testing.assert_array_equal(b["skeleton/time"], clip["times"])
        elif "in_hand" in clip:
            np.testing.assert_allclose(b["hand/position"], a["hand/position"], atol=1e-9)
        else:
            names = list(b["skeleton"].attrs["names"])
            order = [names.index(name) for name in a["skeleton"].attrs["names"]]
            for key in ("position", "orientation"):
                np.testing.assert_allclose(b["skeleton"][key][()][:, order], a["skeleton"][key],
                                           atol=1e-9)

    def test_a_left_hand_stays_one(self):
        clips = self.folder / "clips"
        self.succeeds("import", RECORDINGS / "ADL001DR2.csv", "--static-trial",
                      RECORDINGS / "ADL001_static.csv", "--hand", "left", "--clip", clips)
        clip = np.load(clips / "ADL001DR2.npz")
        self.assertEqual(str(clip["hand"]), "left")
        self.assertIn("left_shoulder", clip["body_joint_names"])
        (entry,) = self.json_of("inspect", clips / "ADL001DR2.npz")["demonstrations"]
        self.assertEqual(entry["hand"], "left")

    def test_a_clip_is_planned_as_the_recording_is(self):
        clips, plans = self.folder / "clips", {}
        recording = (RECORDINGS / "ADL001FR1.csv", "--static-trial", RECORDINGS / "ADL001_static.csv")
        self.succeeds("import", *recording, "--clip", clips)
        for what, dataset in (("markers", recording), ("clip", [clips / "ADL001FR1.npz"])):
            self.succeeds("run", REFERENCE, *QUICK, "--dataset", *dataset, "--quiet", "--out",
                          self.folder / what)
            with h5py.File(self.folder / what / "plans.h5") as h5:
                plans[what] = {key: h5[f"plans/ADL001FR1/000/trajectory/{key}"][()]
                               for key in ("time", "position")}
        for key, values in plans["markers"].items():
            np.testing.assert_allclose(plans["clip"][key], values, rtol=0, atol=1e-9)

    def test_what_was_estimated_is_said_again(self):
        clips = self.folder / "clips"
        self.succeeds("import", ADROIT, "--clip", clips)
        written = self.json_of("inspect", ADROIT)["demonstrations"][0]
        (read,) = self.json_of("inspect", clips / f"{written['name']}.npz")["demonstrations"]
        self.assertEqual(read["estimated"], ["shoulder", "elbow"])
        self.assertIn("estimated during reconstruction, not recorded: shoulder, elbow; humanlikeness of the arm is relative to an estimate", read["problems"])
        (said,) = [s for s in written["problems"] if s.startswith("the shoulder was not recorded")]
        self.assertIn(said, read["reports"])
        self.succeeds("run", REFERENCE, *QUICK, "--dataset", clips / f"{written['name']}.npz",
                      "--quiet", "--out", self.folder / "plans")
        with h5py.File(self.folder / "plans/plans.h5") as h5:
            (plan,) = h5[f"plans/{written['name']}"].values()
            self.assertIn("estimated during reconstruction, not recorded: shoulder, elbow", str(plan.attrs["detail"]))

    def test_neither_file_nor_folder_is_refused(self):
        result = morphe("import", RECORDINGS / "ADL001FR1.csv")
        self.refuses(result, "import", "--out", "--clip")


if __name__ == "__main__":
    main()
