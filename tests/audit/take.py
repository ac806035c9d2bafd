"""Recorded points in memory, read from demonstrations.h5 and written as Vicon CSV."""
import copy
import re
from dataclasses import dataclass

import numpy as np

FINGERS = ("thumb", "index", "middle", "ring", "little")
JOINTS = {"thumb": ("cmc", "mcp", "ip", "tip")}
HAND_JOINTS = ["wrist"] + [f"{finger}_{joint}" for finger in FINGERS
                           for joint in JOINTS.get(finger, ("mcp", "pip", "dip", "tip"))]
SIDES = {"R": "right", "L": "left"}
CLUSTERS = {"shoulder": "SHO", "upper": "UAR", "forearm": "LAR", "hand": "HAN"}


@dataclass
class Take:
    """Points [N, K, 3] in mm, NaN if not seen, and the header of their file."""
    names: list
    position: np.ndarray
    rate: float = 100.0      # of the header [Hz]
    unit: str = "mm"         # of the header
    frame: np.ndarray = None  # first column of the rows
    static: "Take" = None    # the static trial
    damaged: tuple = None    # first and last row that a damage changed; None: all
    clock: tuple = (1, 0)    # a, b: the true time is a times the file's, plus b [s]

    def __post_init__(self):
        if self.frame is None:
            self.frame = np.arange(1, len(self.position) + 1)

    def copy(self):
        return copy.deepcopy(self)

    def at(self, name):
        """[N, 3] of a point, a view."""
        return self.position[:, self.names.index(name)]

    def drop(self, names):
        kept = [i for i, name in enumerate(self.names) if name not in names]
        self.names, self.position = [self.names[i] for i in kept], self.position[:, kept]

    def take_rows(self, rows, renumbered):
        self.position = self.position[rows]
        self.frame = np.arange(1, len(rows) + 1) if renumbered else self.frame[rows]


def write_vicon_csv(take, file):
    count = len(take.names)
    lines = ["Trajectories", f"{take.rate:g}", ",," + ",".join(f"P:{name},," for name in take.names),
             "Frame,Sub Frame" + ",X,Y,Z" * count, "," + f",{take.unit}" * 3 * count]
    for frame, points in zip(take.frame, take.position.reshape(len(take.position), -1)):
        cells = ["" if np.isnan(value) else f"{value:.6f}" for value in points]
        lines.append(",".join([str(frame), "0", *cells]))
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def joint_columns(group, side):
    """(names, time, position [N, K, 3] in m) of the joints that a demonstration contains."""
    if "skeleton" in group:
        stream = group["skeleton"]
        names = [text_of(name) for name in stream.attrs["names"]]
        kept = [i for i, name in enumerate(names) if re.match("(right|left)_", name)]
        return [names[i] for i in kept], stream["time"][()], stream["position"][:, kept]
    if "hand" in group and text_of(group["hand"].attrs["kind"]) == "keypoints":
        hand = group["hand"]
        return [f"{side}_{joint}" for joint in HAND_JOINTS], hand["time"][()], hand["position"][()]
    return None


def columns_of(group, side):
    if "markers" in group:
        stream = group["markers"]
        return [text_of(name) for name in stream.attrs["names"]], stream["time"][()], stream["position"][()]
    return joint_columns(group, side)


def take_of(columns, static=None):
    """The points that are seen at all; None if there are none."""
    if not columns or len(columns[1]) < 2 or not np.isfinite(columns[2]).any():
        return None
    names, time, position = columns
    seen = np.isfinite(position).any(axis=(0, 2))
    return Take([name for name, one in zip(names, seen) if one], 1000 * position[:, seen],
                round((len(time) - 1) / (time[-1] - time[0]), 3), static=static)


def take_of_demonstration(group):
    """The markers or joints of a demonstration with its static trial; None if it has only other streams."""
    static = None
    if "calibration/markers" in group:
        static = take_of(columns_of(group["calibration"], ""))
    return take_of(columns_of(group, text_of(group.attrs["hand"])), static)


class Roles:
    """The points of the arm that moves farther, by what they are on: `thumb`, `index`, `wrist`, …,
    and its marker clusters."""

    def __init__(self, take):
        letters = sorted("RL", key=lambda letter: -self.travel(take, letter))
        self.letter, self.other = letters
        side, names = SIDES[self.letter], set(take.names)
        known = {"thumb": (f"{self.letter}THUM", f"{side}_thumb_tip"),
                 "index": (f"{self.letter}FTP", f"{side}_index_tip"),
                 **{joint: (f"{side}_{joint}",) for joint in ("wrist", "elbow", "shoulder")}}
        self.points = {role: next(name for name in choices if name in names)
                       for role, choices in known.items() if names & set(choices)}
        self.clusters = {}
        for part, stem in CLUSTERS.items():
            pattern = f"{self.letter}{stem}\\d"
            markers = [n for n in take.names if re.fullmatch(pattern, n)
                       and np.isfinite(take.at(n)).all(axis=1).mean() > 0.5]
            if len(markers) >= 3:
                self.clusters[part] = markers

    @staticmethod
    def travel(take, letter):
        moved = [np.nansum(np.linalg.norm(np.diff(take.at(name)[::10], axis=0), axis=1))
                 for name in take.names
                 if re.match(f"{letter}[A-Z]|{SIDES[letter]}_", name)]
        return max(moved, default=0)

    def arm_points(self):
        """Of the arm and hand: all that an exchange may concern."""
        parts = [m for part in ("upper", "forearm", "hand") for m in self.clusters.get(part, [])]
        return parts + [name for role, name in self.points.items() if role in ("thumb", "index")]
