"""Recordings of hand trackers: what was recorded in one format is written in each of them and read."""
import copy
import json
from pathlib import Path

import h5py
import numpy as np

import tracked_hands
from support import SOURCE, CommandCase, main, morphe, temporary_folder

ADROIT = SOURCE / "datasets/adroit-dapg/recordings.yaml"
TIPS = [f"right_{finger}_tip" for finger in tracked_hands.FINGERS]


class HandTrackers(CommandCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        with temporary_folder() as folder:
            original = Path(folder) / "adroit.h5"
            assert morphe("import", ADROIT, "--forward", "recorded", "--out", original).returncode == 0
            cls.hands = tracked_hands.hands_of(original)
            inspected = json.loads(morphe("inspect", original, "--json").stdout)
        cls.phases = {entry["name"]: entry["movements"] for entry in inspected["demonstrations"]}
        assert len(cls.hands) == 5

    def read(self, write, *options):
        """Writes all five, reads each; yields its name, what was written and the group."""
        for name, hand in self.hands.items():
            with self.subTest(name):
                folder = self.folder / write.__name__ / name
                folder.mkdir(parents=True)
                file = write(hand, folder)
                read = folder / "read.h5"
                given = [option(folder) if callable(option) else option for option in options]
                self.succeeds("import", file, *given, "--forward", "recorded", "--out", read)
                with h5py.File(read) as h5:
                    (group,) = h5["demonstrations"].values()
                    yield name, hand, group, read

    def same_tips(self, hand, group, within_m, unseen=0, clock_s=0.0):
        skeleton = group["skeleton"]
        names = [name.decode() for name in skeleton.attrs["names"]]
        np.testing.assert_allclose(skeleton["time"][()] - clock_s, hand.time, atol=1e-6)
        tips = skeleton["position"][()][:, [names.index(tip) for tip in TIPS]]
        missed = np.linalg.norm(tips - hand.tips, axis=-1)
        self.assertEqual(int(np.isnan(missed).sum()), unseen)
        self.assertLess(np.nanmax(missed), within_m)
        wrist = skeleton["position"][()][:, names.index("right_wrist")]
        self.assertLess(np.nanmax(np.linalg.norm(wrist - hand.wrist, axis=-1)), within_m)

    def reports(self, group):
        return [report.decode() for report in group["import_notes"][()]]

    def test_aria(self):
        for _, hand, group, _ in self.read(tracked_hands.write_aria):
            self.same_tips(hand, group, 1e-4, unseen=5 * 20)
            self.assertIn("the left hand is never visible", self.reports(group))
            self.assertIn(f"the right hand is visible in {len(hand.time) - 20} of {len(hand.time)} "
                          "frames", self.reports(group))

    def same_phases(self, name, file):
        (entry,) = self.json_of("inspect", file)["demonstrations"]
        movements = self.phases[name]
        self.assertEqual(len(entry["movements"]), len(movements), entry["problems"])
        for movement, same in zip(entry["movements"], movements):
            self.assertEqual([p["name"] for p in movement["phases"]],
                             [p["name"] for p in same["phases"]])
            np.testing.assert_allclose([p["begin_s"] for p in movement["phases"]],
                                       [p["begin_s"] for p in same["phases"]], atol=0.0101)

    def test_optitrack(self):
        names = ("--names", lambda folder: folder / "names.yaml")
        for name, hand, group, file in self.read(tracked_hands.write_optitrack, *names):
            self.same_tips(hand, group, 1e-4, unseen=4)
            handle = group["objects/handle"]
            self.assertLess(np.abs(handle["position"][()] - hand.handle).max(), 1e-4)
            self.same_phases(name, file)

    def test_hot3d(self):
        for name, hand, group, file in self.read(tracked_hands.write_hot3d):
            self.same_tips(hand, group, 1e-4, unseen=5 * 10)
            self.assertLess(np.abs(group["objects/handle/position"][()] - hand.handle).max(), 1e-4)
            self.assertEqual(group.attrs["subject"], b"P1")
            names = [name.decode() for name in group["skeleton"].attrs["names"]]
            root = group["skeleton/position"][()][:, names.index("right_thumb_cmc")]
            self.assertLess(np.nanmax(np.abs(root - hand.joints[:, 1])), 1e-4)
            self.same_phases(name, file)

    def test_mvnx(self):
        for _, hand, group, _ in self.read(tracked_hands.write_mvnx):
            self.same_tips(hand, group, 1e-4, clock_s=-hand.time[0])
            names = [name.decode() for name in group["skeleton"].attrs["names"]]
            turn = tracked_hands.matrix_of(
                group["skeleton/orientation"][()][:, names.index("right_hand")])
            self.assertLess(np.abs(turn - hand.turn).max(), 1e-5)

    def test_manus(self):
        turn = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])  # what is read from the hand's frame
        for _, hand, group, _ in self.read(tracked_hands.write_manus):
            written = tracked_hands.in_hand(hand) @ turn.T
            self.assertLess(np.abs(group["hand/position"][()] - written).max(), 1e-4)
            self.assertIn("the glove was not tracked: only the shape of the right hand is used, not "
                          "its position", self.reports(group))

    def test_avp(self):
        for _, hand, group, _ in self.read(tracked_hands.write_avp_jsonl):
            self.same_tips(hand, group, 1e-4, unseen=5 * 10)

    def test_wrong_conventions_are_told(self):
        file = tracked_hands.write_avp_jsonl(self.hands["door_demo_06"], self.folder)
        lines = [json.loads(line) for line in file.read_text().splitlines()]
        out = self.folder / "r.h5"

        def answer(lines):
            file.write_text("".join(json.dumps(line) + "\n" for line in lines))
            return morphe("import", file, "--out", out)

        def changed(change):
            changed = copy.deepcopy(lines)
            for i, line in enumerate(changed):
                change(i, line)
            return answer(changed)

        def feet(_, line):
            for joint in line.get("rightHand", {}).values():
                joint[12:15] = [x / 0.3048 for x in joint[12:15]]

        def other_side(_, line):
            if "rightHand" in line:
                line["leftHand"] = line.pop("rightHand")

        def half(i, line):
            if i % 2:
                line.pop("rightHand", None)

        self.refuses(changed(other_side), file, "left hand: its fingers curl like those of a right")
        self.assertIn("unit: implausible: the right hand would measure", changed(feet).stderr)
        self.refuses(answer([lines[1], lines[0]]), f"{file}:2: timestamp", "must be greater")
        self.assertFalse(out.exists())
        self.assertIn("the right hand is visible in 137 of 284 frames", changed(half).stdout)

    def test_damaged_files_end_as_they_should(self):
        hand = self.hands["door_demo_13"].every(slice(0, 40))
        noise = np.random.default_rng(7)
        for write in (tracked_hands.write_aria, tracked_hands.write_optitrack,
                      tracked_hands.write_hot3d, tracked_hands.write_mvnx,
                      tracked_hands.write_manus, tracked_hands.write_avp_jsonl,
                      tracked_hands.write_avp_npz, tracked_hands.write_egodex):
            folder = self.folder / write.__name__
            folder.mkdir()
            file = write(hand, folder)
            whole = file.read_bytes()
            without_times = write in (tracked_hands.write_avp_npz, tracked_hands.write_egodex)
            options = ("--rate", "100") if without_times else ()
            for k in range(6):
                damaged = bytearray(whole)
                if k < 3:
                    damaged = damaged[:int(noise.uniform(0.2, 0.99) * len(whole))]
                else:
                    damaged[int(noise.integers(len(whole)))] ^= 1 << int(noise.integers(7))
                file.write_bytes(damaged)
                answer = morphe("import", file, *options, "--out", folder / "r.h5")
                with self.subTest(write.__name__, k=k):
                    self.assertIn(answer.returncode, (0, 2), answer.stderr)
                    if answer.returncode == 2:
                        self.assertIn(str(file), answer.stderr)
                        self.assertFalse((folder / "r.h5").exists())
                (folder / "r.h5").unlink(missing_ok=True)

    def test_avp_npz(self):
        for _, hand, group, _ in self.read(tracked_hands.write_avp_npz, "--rate", "100"):
            self.same_tips(hand, group, 1e-4, unseen=5 * 10, clock_s=-hand.time[0])
        file = self.folder / "write_avp_npz/door_demo_06/door.npz"
        asked = morphe("import", file, "--out", self.folder / "r.h5")
        self.assertEqual(asked.returncode, 2)
        self.assertIn(f"{file}: rate: not in the file", asked.stderr)

    def test_damaged_npz(self):
        file = tracked_hands.write_avp_npz(self.hands["door_demo_06"], self.folder)
        arrays = dict(np.load(file))
        for key, value, said in (
                ("stream_right_fingers", arrays["stream_right_fingers"][:, :24],
                 "must have 25 or 27 joints, not 24"),
                ("stream_right_fingers", arrays["stream_right_fingers"][1:], "frames,"),
                ("stream_right_wrist", 2 * arrays["stream_right_wrist"], "is not a rigid transform"),
                ("stream_right_wrist", arrays["stream_right_wrist"][..., :3], "4 x 4 matrices")):
            np.savez(file, **{**arrays, key: value})
            self.refuses(morphe("import", file, "--rate", "100", "--out", self.folder / "r.h5"),
                         f"{file}: {key}", said)

    def test_egodex(self):
        for _, hand, group, _ in self.read(tracked_hands.write_egodex, "--rate", "100"):
            self.same_tips(hand, group, 1e-4, unseen=5 * 10, clock_s=-hand.time[0])
            self.assertIn("llm_description: open a door", self.reports(group))


if __name__ == "__main__":
    main()
