"""The robot of a plans.h5: joints with limits, frames and tips, and forward kinematics."""
from __future__ import annotations

import difflib
from dataclasses import dataclass
from typing import Sequence

import numpy as np
import numpy.typing as npt

from .hdf5 import Floats, Node


@dataclass(frozen=True)
class Joint:
    """An actuated joint and its limits; the magnitude of velocity, acceleration and jerk is limited. Near the
    ends of its range a braking curve may allow less velocity (/robot/braking_curves, not read here)."""

    name: str
    unit: str  #: rad, or m if prismatic
    lower: float
    upper: float
    velocity: float
    acceleration: float
    jerk: float


@dataclass(frozen=True)
class Frame:
    """A joint frame: pose = parent pose * transform * motion of ratio * position[joint] + offset about or
    along the axis."""

    name: str
    parent: int  #: -1: the robot's base
    transform: Floats  #: [4, 4]
    axis: Floats  #: [3]
    joint: int  #: index in Robot.joints; -1: fixed
    ratio: float
    offset: float
    prismatic: bool


@dataclass(frozen=True)
class Tip:
    """A point of the robot that has goals."""

    name: str
    frame: int
    transform: Floats  #: [4, 4], from the frame
    finger: int  #: 0 thumb … 4 little, -1 the wrist


@dataclass(frozen=True)
class Robot:
    """All poses are 4x4 matrices in the robot's base frame, in m."""

    name: str
    side: str  #: of the hand: right or left
    joints: tuple[Joint, ...]
    frames: tuple[Frame, ...]  #: parents first
    tips: tuple[Tip, ...]
    palm_frame: int
    shoulder_frame: int

    @property
    def joint_names(self) -> tuple[str, ...]:
        return tuple(joint.name for joint in self.joints)

    def joint_index(self, name: str) -> int:
        return _index(name, self.joint_names, "joint")

    def frame_index(self, name: str) -> int:
        return _index(name, [frame.name for frame in self.frames], "frame")

    def tip_index(self, name: str) -> int:
        return _index(name, [tip.name for tip in self.tips], "tip")

    def frame_poses(self, position: npt.ArrayLike) -> Floats:
        """Returns the poses [..., J, 4, 4] of all frames for joint positions [..., n]."""
        q = np.asarray(position, dtype=np.float64)
        if q.ndim == 0 or q.shape[-1] != len(self.joints):
            raise ValueError(f"{self.name} has {len(self.joints)} joints, but the positions have the shape {list(q.shape)}")
        poses = np.empty((*q.shape[:-1], len(self.frames), 4, 4))
        for i, frame in enumerate(self.frames):
            local = frame.transform
            if frame.joint >= 0:
                local = local @ _moved(frame, frame.ratio * q[..., frame.joint] + frame.offset)
            poses[..., i, :, :] = local if frame.parent < 0 else poses[..., frame.parent, :, :] @ local
        return poses

    def tip_poses(self, position: npt.ArrayLike) -> Floats:
        """Returns the poses [..., m, 4, 4] of all tips for joint positions [..., n]."""
        poses = self.frame_poses(position)
        return np.stack([poses[..., tip.frame, :, :] @ tip.transform for tip in self.tips], axis=-3)

    def palm_pose(self, position: npt.ArrayLike) -> Floats:
        """Returns the pose [..., 4, 4] of the frame that carries the hand."""
        palm: Floats = self.frame_poses(position)[..., self.palm_frame, :, :]
        return palm


def _index(name: str, names: Sequence[str], kind: str) -> int:
    if name not in names:
        near = difflib.get_close_matches(name, names, 1)
        raise KeyError(f"the robot has no {kind} '{name}'" + (f"; did you mean '{near[0]}'?" if near else ": it has " + ", ".join(names)))
    return list(names).index(name)


def _moved(frame: Frame, value: Floats) -> Floats:
    """Returns the motion [..., 4, 4] of a joint by these values [...]."""
    pose = np.zeros((*value.shape, 4, 4))
    pose[..., range(4), range(4)] = 1
    if frame.prismatic:
        pose[..., :3, 3] = value[..., None] * frame.axis
        return pose
    x, y, z = frame.axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = value[..., None, None]
    pose[..., :3, :3] += np.sin(angle) * cross + 2 * np.sin(angle / 2) ** 2 * (cross @ cross)
    return pose


def read_robot(node: Node) -> Robot:
    names = node.texts("joint_names")
    count = len(names)
    lower, upper, velocity, acceleration, jerk = (node.array(limit, count) for limit in
                                                  ("lower", "upper", "velocity", "acceleration", "jerk"))
    frames = _read_frames(node.group("frames"), count)
    slides = {frame.joint for frame in frames if frame.prismatic}
    joints = tuple(Joint(name, "m" if j in slides else "rad", float(lower[j]), float(upper[j]), float(velocity[j]),
                         float(acceleration[j]), float(jerk[j])) for j, name in enumerate(names))
    tips = node.group("tips")
    tip_names = tips.texts("name")
    transforms = tips.array("transform", len(tip_names), 4, 4)
    tip_frames, fingers = tips.integers("frame", len(tip_names)), tips.integers("finger", len(tip_names))
    read = tuple(Tip(name, tip_frames[m], transforms[m], fingers[m]) for m, name in enumerate(tip_names))
    palm, shoulder = int(node.number("palm_frame")), int(node.number("shoulder_frame"))
    for where, group, frame in (*(("frame", tips, tip.frame) for tip in read), ("@palm_frame", node, palm), ("@shoulder_frame", node, shoulder)):
        if not 0 <= frame < len(frames):
            group.fail(where, f"names the frame {frame}, but there are {len(frames)}")
    return Robot(node.text("name"), node.text("side", "right"), joints, frames, read, palm, shoulder)


def _read_frames(node: Node, joint_count: int) -> tuple[Frame, ...]:
    names = node.texts("name")
    count = len(names)
    parents, joints = node.integers("parent", count), node.integers("joint", count)
    transforms, axes = node.array("transform", count, 4, 4), node.array("axis", count, 3)
    ratios, offsets = node.array("ratio", count), node.array("offset", count)
    prismatic = node.integers("prismatic", count) if node.has("prismatic") else (0,) * count
    for i in range(count):
        if not -1 <= parents[i] < i:
            node.fail("parent", f"of frame {i} is {parents[i]}, which is not a frame before it")
        if not -1 <= joints[i] < joint_count:
            node.fail("joint", f"of frame {i} is {joints[i]}, but there are {joint_count} joints")
    return tuple(Frame(names[i], parents[i], transforms[i], axes[i], joints[i], float(ratios[i]), float(offsets[i]),
                       bool(prismatic[i])) for i in range(count))
