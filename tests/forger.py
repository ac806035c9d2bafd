"""What a forger of plans does with one: tests/forged_plans.py and the kinds of lies beside it."""
import h5py
import numpy as np

import verify_plans
from verify_geometry import Robot, text

KINDS = {}  # name -> (family, whether it changes the file as a whole, function)


def lie(family, whole_file=False):
    def register(function):
        KINDS[function.__name__] = (family, whole_file, function)
        return function
    return register


class Unfit(Exception):
    """The plan has nothing of what a kind would forge."""


def need(condition):
    if not condition:
        raise Unfit


class Forger:
    """One plan, and a size for the lie: 1 to 1000 times the least that must be found."""

    def __init__(self, plan, rng):
        self.plan, self.rng, self.file = plan, rng, plan.file
        self.size = 10**rng.uniform(0.1, 3)
        self.sign = rng.choice([-1, 1])

    def row(self, name, least=0):
        rows = len(self.plan[name])
        need(rows > least)
        return int(self.rng.integers(least, rows))

    def joint(self):
        return int(self.rng.integers(len(self.file["robot/joint_names"])))

    def add(self, name, by, where=None):
        need(name in self.plan and self.plan[name].size)
        values = self.plan[name][()]
        flat = values.reshape(-1)
        seen = np.flatnonzero(np.isfinite(flat))
        need(len(seen))
        where = int(self.rng.choice(seen)) if where is None else where
        flat[where] += self.sign * by * self.size
        self.plan[name][...] = values

    def phase(self, *names):
        found = [k for k, name in enumerate(self.plan["phases/name"][()]) if text(name) in names]
        need(found)
        return int(self.rng.choice(found))

    def resize(self, name, values):
        attributes = dict(self.plan[name].attrs)
        del self.plan[name]
        self.plan[name] = values
        self.plan[name].attrs.update(attributes)

    def target(self):
        name = text(self.plan.attrs["target"])
        need(name and name in self.plan["scene"])
        return self.plan["scene"][name]

    def object(self):
        need(len(self.plan["scene"]))
        return self.plan["scene"][str(self.rng.choice(list(self.plan["scene"])))]

    def scale(self, attributes, name):
        """Larger, or smaller: never by less than a thousandth."""
        value = attributes[name]
        need(np.isfinite(value))
        attributes[name] = value * (1 + self.sign * min(0.9, 1e-3 * self.size)) + (value == 0) * 1e-3 * self.size


def transfer(f):
    names = [name for name in ("approach", "retreat") if name in f.plan]
    need(names)
    return str(f.rng.choice(names))


def carried(f):
    """The target of a plan that carries it, and where it is midway: (pose in the base, demonstration time)."""
    target = f.target()
    clock = f.plan["trajectory/demonstration_time"][()]
    begin, end = target.attrs.get("attach_s", np.inf), min(target.attrs.get("release_s", np.inf), clock[-1])
    need(end - begin > 0.2)
    sample = int(np.searchsorted(clock, (begin + end) / 2))
    need(sample < len(clock))
    robot, rows = Robot(f.file["robot"]), f.plan["trajectory"]
    motion = {"demonstration_time": clock, "position": rows["position"][()]}
    into = verify_plans.into_carried(robot, target, motion, robot.frame_poses(motion["position"]), clock, 1)
    turn, place = verify_plans.rigid(into, len(clock))
    return target, -turn[sample].T @ place[sample], clock[sample]
