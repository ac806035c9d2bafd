"""A picture of a plan, with matplotlib."""
from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np

from .motion import Motion
from .plan import Plan

POINTS_PER_SECOND = 100


def plot(plan: Plan, joints: Optional[Sequence[str]] = None) -> Any:
    """Returns a matplotlib Figure of the trajectory over time: positions of the joints (all, or those named), the
    largest share of the limits of velocity, acceleration and jerk, and the clearance; phases in the background.
    Save it with `figure.savefig("plan.png")`. Raises ImportError without matplotlib."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise ImportError("morphe.plot needs matplotlib: apt install python3-matplotlib, or pip install matplotlib") from None
    motion = plan.motion()
    shown = [plan.robot.joint_index(name) for name in (plan.robot.joint_names if joints is None else joints)]
    time = np.union1d(motion.times(POINTS_PER_SECOND), motion.time)
    state = motion.at(time)
    figure = Figure(figsize=(9, 7), layout="constrained")
    positions, shares, clearance = figure.subplots(3, 1, sharex=True)
    legend = {"fontsize": "small", "loc": "center left", "bbox_to_anchor": (1, 0.5)}
    for j in shown:
        positions.plot(time, state.position[:, j], label=plan.robot.joint_names[j])
    units = sorted({plan.robot.joints[j].unit for j in shown})
    positions.set_ylabel(f"position [{', '.join(units)}]")
    if len(shown) <= 10:
        positions.legend(**legend)
    for name in ("velocity", "acceleration", "jerk"):
        limits = np.array([getattr(joint, name) for joint in plan.robot.joints])
        shares.plot(time, np.max(np.abs(getattr(state, name)) / limits, axis=1), label=name)
    shares.axhline(1, color="black", linewidth=0.5)
    shares.set_ylabel("largest share of a limit")
    shares.legend(**legend)
    clearance.plot(motion.time, 1e3 * motion.clearance)
    clearance.axhline(1e3 * plan.required_clearance, color="black", linewidth=0.5)
    clearance.set_ylabel("clearance [mm]")
    clearance.set_xlabel("time [s]")
    for axes in (positions, shares, clearance):
        _shade(axes, motion, axes is positions)
    positions.set_title(f"{plan.name}: {plan.status}", loc="left")
    return figure


def _shade(axes: Any, motion: Motion, named: bool) -> None:
    """Puts phases behind a plot, every other one grey."""
    begins = [0, *(k for k in range(1, len(motion.phase)) if motion.phase[k] != motion.phase[k - 1])]
    for number, (begin, end) in enumerate(zip(begins, [*begins[1:], len(motion.phase) - 1])):
        left, right = motion.time[begin], motion.time[end]
        axes.axvspan(left, right, color="0.92" if number % 2 else "0.97", zorder=-1)
        if named:
            axes.annotate(motion.phase[begin], (left, 0), xycoords=("data", "axes fraction"), fontsize="x-small", va="bottom", rotation=90)
