"""The curve of a motion: what a plan certifies, at any time."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .hdf5 import Floats, Node

#: A time may be this much outside the motion, as k / rate is by rounding; it then counts as the end [s].
TIME_TOLERANCE_S = 1e-9


@dataclass(frozen=True)
class State:
    """Joints at one time [n] or at several [..., n], in the order of Motion.joints; rad, m if prismatic."""

    position: Floats
    velocity: Floats
    acceleration: Floats
    #: That of the quintic which begins at the time; at a sample the jerk jumps.
    jerk: Floats


@dataclass(frozen=True)
class Motion:
    """A trajectory, or the approach or retreat that belongs to it: samples, and the quintic between two of
    them that meets position, velocity and acceleration at both. The certificate holds for this curve."""

    name: str  #: trajectory, approach or retreat
    joints: tuple[str, ...]
    time: Floats  #: [T] s, from 0, strictly increasing
    position: Floats  #: [T, n]
    velocity: Floats  #: [T, n]
    acceleration: Floats  #: [T, n]
    demonstration_time: Floats  #: [T] s
    phase: tuple[str, ...]  #: [T]
    origin: tuple[str, ...]  #: [T] mapped, re_solved or planned
    clearance: Floats  #: [T] m, NaN: no pair

    @property
    def duration(self) -> float:
        return float(self.time[-1])

    def demonstration_time_at(self, time: npt.ArrayLike) -> Floats:
        """Returns the demonstration's time that belongs to times of the motion, linear between samples [s]."""
        return np.asarray(np.interp(np.asarray(time, dtype=np.float64), self.time, self.demonstration_time))

    def times(self, rate_hz: float) -> Floats:
        """Returns k / rate_hz for all k within the motion, and its end."""
        if not rate_hz > 0:
            raise ValueError(f"a rate must be above 0, not {rate_hz} Hz")
        steps = np.arange(int(np.ceil(self.duration * rate_hz)) + 1) / rate_hz
        return np.append(steps[(self.duration - steps) * rate_hz > 1e-6], self.duration)

    def at(self, time: npt.ArrayLike) -> State:
        """Returns the curve at one time or several [s]. A time outside the motion is a ValueError: nothing is
        certified there."""
        t = np.asarray(time, dtype=np.float64)
        begin, end = float(self.time[0]), float(self.time[-1])
        inside = (t >= begin - TIME_TOLERANCE_S) & (t <= end + TIME_TOLERANCE_S)
        if not np.all(inside):
            raise ValueError(f"{float(t[~inside].flat[0])} s is outside the {self.name}, which lasts from {begin} to {end} s")
        t = np.clip(t, begin, end)
        k = np.clip(np.searchsorted(self.time, t, side="right") - 1, 0, len(self.time) - 2)
        # Without types: mypy 1.15 takes minutes for polynomials of NumPy's.
        h: Any = (self.time[k + 1] - self.time[k])[..., None]
        x: Any = (t - self.time[k])[..., None] / h
        samples: Any = self.position, self.velocity, self.acceleration
        q0, v0, a0 = (rows[k] for rows in samples)
        q1, v1, a1 = (rows[k + 1] for rows in samples)
        d, v0, v1, a0, a1 = q1 - q0, h * v0, h * v1, h * h * a0, h * h * a1
        c2 = a0 / 2
        c3 = 10 * d - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1
        c4 = -15 * d + 8 * v0 + 7 * v1 + 1.5 * a0 - a1
        c5 = 6 * d - 3 * (v0 + v1) + 0.5 * (a1 - a0)
        curve = (q0 + x * (v0 + x * (c2 + x * (c3 + x * (c4 + x * c5)))),
                 (v0 + x * (2 * c2 + x * (3 * c3 + x * (4 * c4 + x * 5 * c5)))) / h,
                 (2 * c2 + x * (6 * c3 + x * (12 * c4 + x * 20 * c5))) / h**2)
        # At a sample it is what is stored, without rounding.
        position, velocity, acceleration = (np.where(x == 0, rows[k], np.where(x == 1, rows[k + 1], values))
                                            for rows, values in zip(samples, curve))
        return State(position, velocity, acceleration, (6 * c3 + x * (24 * c4 + x * 60 * c5)) / h**3)


def read_motion(node: Node, name: str, joints: tuple[str, ...]) -> Motion:
    group = node.group(name)
    time = group.array("time", -1)
    if len(time) < 2 or not np.all(np.diff(time) > 0):
        group.fail("time", "does not increase strictly over at least 2 samples")
    count = len(time)
    position, velocity, acceleration = (group.array(rows, count, len(joints)) for rows in ("position", "velocity", "acceleration"))
    return Motion(name=name, joints=joints, time=time, position=position, velocity=velocity, acceleration=acceleration,
                  demonstration_time=group.array("demonstration_time", count), phase=group.words("phase", count),
                  origin=group.words("origin", count), clearance=group.array("clearance", count))
