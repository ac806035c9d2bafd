"""`morphe synthesize`: what the files hold, that seed and index alone decide, and bad configs."""
import h5py
import numpy as np

from support import SOURCE, CommandCase, line_of, main, morphe, sha256

CONFIGS = sorted((SOURCE / "configs/synthetic").glob("*.yaml"))
SHORT = """\
movements:
  movements_per_recording: [1, 1]
  rest_s: [0.3, 0.4]
sensors:
  calibration_s: 0.2
  rate_hz: 120
"""


class Synthesize(CommandCase):
    def config(self, text=SHORT):
        file = self.folder / "short.yaml"
        file.write_text(text)
        return file

    def make(self, name, *options, config=None):
        file = self.folder / f"{name}.h5"
        self.succeeds("synthesize", config or self.config(), "--out", file, *options)
        return file, self.folder / f"{name}.truth.h5"

    def test_the_shipped_configs(self):
        self.assertTrue(CONFIGS)
        for config in CONFIGS:
            with self.subTest(config.name):
                recorded, truth = self.make(config.stem, "--count", 2, config=config)
                with h5py.File(recorded) as a, h5py.File(truth) as b:
                    self.assertEqual(list(a["demonstrations"]),
                                     ["synthetic_000000", "synthetic_000001"])
                    self.assertEqual(list(a["demonstrations"]), list(b["demonstrations"]))
                    for name in a["demonstrations"]:
                        self.check_magnitudes(a["demonstrations"][name], b["demonstrations"][name])

    def check_magnitudes(self, recorded, truth):
        for column in ("begin_s", "end_s", "phase"):
            np.testing.assert_array_equal(recorded["labels"][column], truth["labels"][column])
        self.assertEqual(recorded["hand"].attrs["kind"], b"glove")
        self.assertEqual(recorded["hand/angles"].shape[1], 22)
        self.assertEqual(list(recorded["sensors"].attrs["names"]), [b"shoulder", b"elbow", b"wrist"])
        time = recorded["sensors/time"][:]
        np.testing.assert_allclose(np.diff(time), 1 / 240, rtol=0, atol=1e-9)
        np.testing.assert_allclose(np.diff(recorded["hand/time"]), 1 / 90, rtol=0, atol=1e-9)
        # Through the offsets, the sensors are near the truth: noise, and that of the calibration.
        offsets = recorded["calibration/offsets/position"][:]
        q = recorded["sensors/orientation"][:]
        w, v = q[..., :1], q[..., 1:]
        turned = offsets + 2 * np.cross(v, np.cross(v, offsets) + w * offsets)
        error = recorded["sensors/position"][:] + turned - truth["sensors/position"][:]
        self.assertLess(np.sqrt(np.nanmean(error**2)), 0.002)
        joints = truth["sensors/position"][:]
        upper_arm = np.linalg.norm(joints[:, 1] - joints[:, 0], axis=1)
        np.testing.assert_allclose(upper_arm, truth.attrs["upper_arm"], rtol=0, atol=1e-9)

    def test_seed_and_index_alone_decide(self):
        one, truth_of_one = self.make("one", "--count", 6, "--jobs", 1)
        two, truth_of_two = self.make("two", "--count", 6, "--jobs", 3)
        self.assertEqual(sha256(one), sha256(two))
        self.assertEqual(sha256(truth_of_one), sha256(truth_of_two))
        self.assertNotEqual(sha256(one), sha256(self.make("other", "--count", 6, "--seed", 2)[0]))
        fewer, _ = self.make("fewer", "--count", 2)
        with h5py.File(one) as all_of_them, h5py.File(fewer) as first_two:
            for name in first_two["demonstrations"]:
                np.testing.assert_array_equal(
                    all_of_them["demonstrations"][name]["sensors/position"],
                    first_two["demonstrations"][name]["sensors/position"])

    def test_many(self):
        recorded, _ = self.make("many", "--count", 200)
        with h5py.File(recorded) as file:
            names = list(file["demonstrations"])
            self.assertEqual(len(names), 200)
            onsets = [file["demonstrations"][name]["labels/begin_s"][0] for name in names]
        self.assertEqual(len(set(onsets)), 200)

    def test_bad_configs_name_their_place(self):
        out = self.folder / "out.h5"
        for text, needle, key in (
                ("glove:\n  noise: -1\n", "noise", "glove.noise"),
                ("movements:\n  rest_s: 1\n", "rest_s", "movements.rest_s"),
                ("movements:\n  kinds:\n    straight: 1\n", "straight", "movements.kinds.straight"),
                ("hand: 3\n", "hand", "hand")):
            with self.subTest(text):
                config = self.config(text)
                result = morphe("synthesize", config, "--out", out)
                self.refuses(result, f"{config}:{line_of(config, needle)}: {key}")
                self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["short.yaml"])

    def test_bad_usage(self):
        config = self.config()
        missing = morphe("synthesize", self.folder / "none.yaml", "--out", self.folder / "out.h5")
        self.refuses(missing, self.folder / "none.yaml")
        self.assertEqual(
            morphe("synthesize", config, "--out", self.folder / "out.h5", "--count", 0).returncode, 2)
        self.assertEqual(morphe("synthesize", config).returncode, 2)


if __name__ == "__main__":
    main()
