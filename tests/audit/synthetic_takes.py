"""Synthetic recordings, written as the files of laboratories: `morphe synthesize` gives the true joints
and fingertips; here they get marker clusters and noise, or become points of a skeleton."""
import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np

from take import FINGERS, Take, text_of, write_vicon_csv

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests/cli"))
import liberty_text  # noqa: E402

CONFIG = ROOT / "configs/synthetic/reach_to_grasp.yaml"
EVERY = 2            # of the 240 rows a second that `synthesize` gives
NOISE_MM = 0.3       # of a marker: optical systems are at 0.1 to 0.5
STILL_S = 0.5        # length of a static trial
CLUSTER_MM = 45      # spread of a cluster's four markers
SEGMENTS = ("UAR", "LAR", "HAN")  # whose frames are at shoulder, elbow and wrist


def turns(quaternions):
    """Rotations [N, 3, 3] of unit quaternions w, x, y, z."""
    w, x, y, z = quaternions.T
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def across(vectors, axes):
    """The parts of vectors [N, 3] at a right angle to axes."""
    axes = unit(axes)
    return vectors - np.sum(vectors * axes, axis=1, keepdims=True) * axes


def frames(along, aside):
    """Rotations [N, 3, 3] of segments: z along the segment, x to its side."""
    z, x = unit(along), unit(aside)
    return np.stack([x, np.cross(z, x), z], axis=2)


class TrueMotion:
    """Joints, segments and fingertips of a recording, in mm, from its truth and its calibration pose."""

    def __init__(self, group, calibration):
        sensors, rows = group["sensors"], slice(None, None, EVERY)
        time = sensors["time"][rows]
        self.rate = round((len(time) - 1) / (time[-1] - time[0]), 3)
        self.joints = 1000 * sensors["position"][rows]  # [N, 3, 3] shoulder, elbow, wrist
        hand = turns(sensors["orientation"][rows, 2])  # y towards the thumb's side, z along the hand
        self.upper_arm, self.forearm = (np.diff(self.joints, axis=1)[:, k] for k in range(2))
        self.hinge = unit(np.cross(self.upper_arm, self.forearm))  # of the elbow, outwards
        self.breadth = unit(across(hand[:, :, 1], self.forearm))   # of the wrist, to the thumb's side
        self.turns = [frames(self.upper_arm, self.hinge), frames(self.forearm, self.breadth), hand]
        self.tips = 1000 * group["hand/position"][rows]  # [N, 5, 3]
        self.knuckle = 1000 * knuckle_on_hand(calibration)

    def on_hand(self, place):
        """A point that is fixed to the hand [N, 3]."""
        return self.turns[2] @ place + self.joints[:, 2]


def knuckle_on_hand(calibration):
    """Of the index finger, in the frame of the hand at the wrist [m]."""
    sensors, marks, offsets = (calibration[key] for key in ("sensors", "markers", "offsets"))
    place = np.nanmean(sensors["position"][:, 2], axis=0)
    of_sensor = turns(np.nanmean(sensors["orientation"][:, 2], axis=0, keepdims=True))[0]
    names = [text_of(name) for name in marks.attrs["names"]]
    knuckle = np.nanmean(marks["position"][:, names.index("index_mcp")], axis=0)
    on_sensor = of_sensor.T @ (knuckle - place)
    of_segment = turns(offsets["orientation"][2:3])[0]
    return of_segment.T @ (on_sensor - offsets["position"][2])


def cluster(motion, segment, random):
    """Four markers [N, 4, 3] on a segment, about a third of the way to its end."""
    ends = motion.joints[0, segment + 1] if segment < 2 else motion.tips[0, 2]
    middle = motion.turns[segment][0].T @ (ends - motion.joints[0, segment]) / 3
    places = middle + random.uniform(-CLUSTER_MM, CLUSTER_MM, size=(4, 3))
    return np.einsum("nij,kj->nki", motion.turns[segment], places) + motion.joints[:, segment, None]


def landmarks(motion):
    """Of the static trial, in the posture of the first row."""
    (shoulder, elbow, wrist), outer, breadth = motion.joints[0], motion.hinge[0], motion.breadth[0]
    return {"RGTH": shoulder, "RLEP": elbow + 35 * outer, "RMEP": elbow - 35 * outer,
            "RSPR": wrist + 28 * breadth, "RSPU": wrist - 28 * breadth}


def trunk(motion, random):
    """Markers of both shoulders and the chest; the trunk does not turn."""
    shoulder = motion.joints[:, 0, None]
    right = shoulder + [-30, 0, 40] + random.uniform(-30, 30, size=(4, 3))
    left = right - [380, 0, 0]
    names = [f"{side}SHO{k}" for side in "RL" for k in range(1, 5)] + ["STRN"]
    return names, np.concatenate([right, left, shoulder + [-190, 90, -60]], axis=1)


def as_clusters(motion, random):
    names, points = trunk(motion, random)
    for segment, stem in enumerate(SEGMENTS):
        names = names + [f"R{stem}{k}" for k in range(1, 5)]
        points = np.concatenate([points, cluster(motion, segment, random)], axis=1)
    names += ["RTHUM", "RFTP", "RFB"]
    points = np.concatenate([points, motion.tips[:, :2], motion.on_hand(motion.knuckle)[:, None]], axis=1)
    marks = landmarks(motion)
    still = np.concatenate([points[0], np.array(list(marks.values()))])
    still = np.tile(still, (round(STILL_S * motion.rate), 1, 1))
    static = Take([*names, *marks], still + random.normal(scale=NOISE_MM, size=still.shape), motion.rate)
    return Take(names, points + random.normal(scale=NOISE_MM, size=points.shape), motion.rate, static=static)


def as_joints(motion, random):
    names = [f"right_{joint}" for joint in ("shoulder", "elbow", "wrist")] + [f"right_{f}_tip" for f in FINGERS]
    points = np.concatenate([motion.joints, motion.tips], axis=1)
    return Take(names, points + random.normal(scale=NOISE_MM, size=points.shape), motion.rate)


def write_takes(takes, folder):
    lines = ["format: vicon-csv", "hand: right", "recordings:"]
    for name, take in takes.items():
        write_vicon_csv(take, folder / f"{name}.csv")
        static = ""
        if take.static:
            write_vicon_csv(take.static, folder / f"{name}_static.csv")
            static = f", static_trial: {name}_static.csv"
        lines.append(f"  - {{file: {name}.csv, name: {name}{static}}}")
    manifest = folder / "recordings.yaml"
    manifest.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return manifest


def synthesize(morphe, count, seed, folder, config=CONFIG):
    """Returns the manifests of the same recordings as trackers with a glove, as markers and as points."""
    file = folder / "synthetic.h5"
    subprocess.run([morphe, "synthesize", config, "--out", file, "--count", str(count), "--seed", str(seed)],
                   check=True, capture_output=True)
    places = {kind: folder / kind for kind in ("trackers", "markers", "points")}
    for place in places.values():
        place.mkdir(parents=True, exist_ok=True)
    with h5py.File(file) as store, h5py.File(folder / "synthetic.truth.h5") as truth:
        manifests = [liberty_text.write_recordings(store, places["trackers"])]
        motions = {name: TrueMotion(group, store["demonstrations"][name]["calibration"])
                   for name, group in truth["demonstrations"].items()}
    for kind, make in (("markers", as_clusters), ("points", as_joints)):
        takes = {f"{name}_{kind}": make(motion, np.random.default_rng([seed, number]))
                 for number, (name, motion) in enumerate(motions.items())}
        manifests.append(write_takes(takes, places[kind]))
    return manifests
