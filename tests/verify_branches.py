"""The branch of an arm's inverse kinematics along a path, computed from the robot's table in plans.h5
and independently of Morphe: shoulder, elbow and wrist by the signs of the factors whose zeros are the
arm's singular postures (docs/formats.md), and joints that are wound up by whole turns."""
from dataclasses import dataclass, field

import numpy as np

LEAST_SINE = 0.0175     # of two axes that count as not parallel: one degree
LEAST_LEVER_M = 0.01    # of an elbow: distances of shoulder and wrist from its axis
UNCERTAIN_SINE = 0.05   # a factor that is smaller does not decide
WORDS = {"shoulder": ("right", "left"), "elbow": ("positive", "negative"), "wrist": ("unflipped", "flipped")}
HEIGHTS = ("up", "down")  # of the elbow of an arm whose upper arm turns in a plane through the first axis
DECIDED_MEAN = 0.1      # of a factor on a path whose sign is beyond doubt
WOUND_RAD = 1.0         # a joint is wound up if whole turns bring the path nearer to zero by more


@dataclass
class Branch:
    signs: dict = field(default_factory=dict)    # part -> 1, -1, or 0: undecided
    wound: dict = field(default_factory=dict)    # joint -> whole turns
    changes: list = field(default_factory=list)  # part, time [s]
    height: int = 0  # sign of shoulder times elbow at which the elbow is up; 0 if up makes no sense

    @property
    def number(self):
        if not self.signs:
            return -1
        return sum(1 << bit for bit, part in enumerate(WORDS) if self.signs.get(part, 1) < 0)

    def word(self, part):
        sign = self.signs[part]
        if part == "elbow" and self.height:
            up = sign * self.height * self.signs["shoulder"]
            return HEIGHTS[up < 0] if up else "undecided"
        return WORDS[part][sign < 0] if sign else "undecided"

    def words(self):
        said = [f"{part} {self.word(part)}" for part in self.signs]
        return said + [f"{joint} wound up by {turns:+d} turn{'s' if abs(turns) > 1 else ''}"
                       for joint, turns in self.wound.items()]


def arm_hinges(robot):
    """The frames of the hinges from the base to the palm."""
    frame, found = robot.palm, []
    while frame >= 0:
        if robot.frames["joint"][frame] >= 0 and not robot.slides[frame]:
            found.append(frame)
        frame = robot.frames["parent"][frame]
    return found[::-1]


class Axes:
    """Axes [N, 3] of the arm's hinges, and points on them, at N postures."""

    def __init__(self, robot, q):
        poses = robot.frame_poses(q)
        hinges = arm_hinges(robot)
        self.count = len(hinges)
        self.axis = [poses[:, f, :3, :3] @ robot.frames["axis"][f] for f in hinges]
        self.origin = [poses[:, f, :3, 3] for f in hinges]
        self.palm = poses[:, robot.palm, :3, 3]

    def sine(self, i, k):
        return np.linalg.norm(np.cross(self.axis[i][0], self.axis[k][0]))

    def foot(self, i, *others):
        """The point of axis i nearest to the first of the other axes that is not parallel, else its origin."""
        a, p = self.axis[i], self.origin[i]
        for k in others:
            if 0 <= k < self.count and k != i and self.sine(i, k) > LEAST_SINE:
                b, between = self.axis[k], self.origin[k] - p
                dot = np.sum(a * b, axis=1)
                along = (np.sum(between * a, axis=1) - dot * np.sum(between * b, axis=1)) / (1 - dot * dot)
                return p + along[:, None] * a
        if max(others) >= self.count:  # the last axis: nearest to the palm
            return p + np.sum((self.palm - p) * a, axis=1)[:, None] * a
        return p

    def lever(self, i, point):
        """From axis i to a point, at a right angle to the axis."""
        away = point - self.origin[i]
        return away - np.sum(away * self.axis[i], axis=1)[:, None] * self.axis[i]


def levers(axes, i):
    shoulder = axes.lever(i, axes.foot(i - 1, i - 2, i))
    wrist = axes.lever(i, axes.palm if i + 1 == axes.count else axes.foot(i + 1, i + 2, i))
    return shoulder, wrist


def elbow_of(axes):
    """The hinge that changes the distance of shoulder and wrist most; None without one."""
    def reach(i):
        return [np.linalg.norm(side[0]) for side in levers(axes, i)]
    best = max(range(1, axes.count), key=lambda i: np.prod(reach(i)), default=None)
    return None if best is None or min(reach(best)) < LEAST_LEVER_M else best


def triple(axes, middle):
    """Sine of the middle one of three joints from the position at which their axes are in one plane."""
    if not 0 < middle < axes.count - 1:
        return None
    size = axes.sine(middle - 1, middle) * axes.sine(middle, middle + 1)
    if min(axes.sine(middle - 1, middle), axes.sine(middle, middle + 1)) < LEAST_SINE:
        return None
    a, b, c = (axes.axis[k] for k in (middle - 1, middle, middle + 1))
    return np.sum(a * np.cross(b, c), axis=1) / size


def side_of_wrist(axes, elbow):
    """Side of the wrist with regard to the plane of the first two axes."""
    near = min(elbow + 2, axes.count - 2)
    aside = np.cross(axes.axis[0], axes.axis[1]) / axes.sine(0, 1)
    away = axes.foot(near, near + 1) - axes.foot(0, 1)
    return np.sum(away * aside, axis=1) / np.linalg.norm(away, axis=1)


def factors(robot, q):
    """({part: [N]} in -1 … 1, sign by which shoulder times elbow is up, 0 if up makes no sense)"""
    axes = Axes(robot, q)
    elbow = elbow_of(axes) if axes.count > 2 else None
    if elbow is None:
        return {}, 0
    shoulder, wrist = levers(axes, elbow)
    size = np.linalg.norm(shoulder, axis=1) * np.linalg.norm(wrist, axis=1)
    bend = np.sum(axes.axis[elbow] * np.cross(wrist, shoulder), axis=1) / size
    first, height = triple(axes, 1) if elbow > 2 else None, 0
    if first is None and elbow > 1 and axes.sine(0, 1) > LEAST_SINE:
        first = side_of_wrist(axes, elbow)
        if elbow == 2 and axes.sine(1, 2) < LEAST_SINE:
            height = -int(np.sign(axes.axis[1][0] @ axes.axis[2][0]))
    found = {"shoulder": first, "elbow": bend, "wrist": triple(axes, elbow + 2)}
    return {part: values for part, values in found.items() if values is not None}, height


def changes_of(part, values, time):
    found, last = [], 0
    for value, t in zip(values, time):
        if abs(value) < UNCERTAIN_SINE:
            continue
        if last and np.sign(value) != last:
            found.append((part, float(t)))
        last = np.sign(value)
    return found


def turns_of(q, lower, upper):
    """Whole turns by which a joint's path is farther from zero than it must be."""
    middle = (q.min() + q.max()) / 2
    turns = int(np.round(middle / (2 * np.pi)))
    while turns:
        moved = q - 2 * np.pi * turns
        if moved.min() >= lower and moved.max() <= upper:
            break
        turns -= int(np.sign(turns))
    return turns if abs(middle) - abs(middle - 2 * np.pi * turns) > WOUND_RAD else 0


def branch_of(robot, q, time):
    branch = Branch()
    found, branch.height = factors(robot, q)
    for part, values in found.items():
        decided = np.abs(values) >= UNCERTAIN_SINE
        branch.signs[part] = int(np.sign(values[decided].sum())) if decided.any() else 0
        branch.changes += changes_of(part, values, time)
    for joint in dict.fromkeys(int(robot.frames["joint"][f]) for f in arm_hinges(robot)):
        turns = turns_of(q[:, joint], robot.limits["lower"][joint], robot.limits["upper"][joint])
        if turns:
            branch.wound[text(robot.joints[joint])] = turns
    return branch


def check_branch(robot, plan, motion, report):
    """The stored branch against that of the trajectory's postures."""
    if "branch" not in plan.attrs:
        return
    time, q = motion["demonstration_time"], motion["position"]
    own, means = branch_of(robot, q, time), {part: values.mean() for part, values in factors(robot, q)[0].items()}
    if not own.signs:
        report.add("branch", "number", plan.attrs["branch"], np.nan)
    if any(abs(mean) < DECIDED_MEAN for mean in means.values()):
        return
    if own.number != plan.attrs["branch"]:
        report.add("branch", "number", plan.attrs["branch"], own.number)
    if own.words() != [text(word) for word in plan["branch_words"][()]]:
        report.add("branch", "branch_words", np.nan, own.number)


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)
