"""What damages a recording: a function per kind. damage_list.py names the damages of the study.

A damage changes a copy of a take in place. It finds its points by their roles and its place by the
moments of the undamaged movement, so that it applies to any recording; it raises NotApplicable if
the recording lacks what it changes. Random numbers come from the names of damage and recording."""
from dataclasses import dataclass

import numpy as np


class NotApplicable(Exception):
    pass


@dataclass
class Moments:
    """Rows of the undamaged take."""
    begin: int
    reach: int  # half of the way between begin and grasp
    grasp: int
    end: int


@dataclass
class Patient:
    """What a damage changes, and what it may know."""
    take: object
    roles: object
    moments: Moments
    random: np.random.Generator
    other_static: object = None  # of another person

    def point(self, role):
        if role not in self.roles.points:
            raise NotApplicable(f"no {role}")
        return self.roles.points[role]

    def cluster(self, part):
        if part not in self.roles.clusters:
            raise NotApplicable(f"no cluster on the {part}")
        return self.roles.clusters[part]

    def marker(self, part, number=0):
        """A point by its role, or a marker of a cluster."""
        return self.point(part) if part in self.roles.points else self.cluster(part)[number]

    def rows(self, seconds):
        return max(1, round(seconds * self.take.rate))

    def span(self, place, seconds):
        """Rows around a moment."""
        first = max(1, getattr(self.moments, place) - self.rows(seconds) // 2)
        return slice(first, min(first + self.rows(seconds), len(self.take.position) - 1))

    def both(self):
        return [take for take in (self.take, self.take.static) if take]

    def direction(self):
        vector = self.random.normal(size=3)
        return vector / np.linalg.norm(vector)

    def damaged(self, rows):
        self.take.damaged = rows.start or 0, (rows.stop or len(self.take.position)) - 1


# Labels

def exchange(p, a, b, rows=slice(None)):
    i, j = p.take.names.index(a), p.take.names.index(b)
    p.take.position[rows, [i, j]] = p.take.position[rows, [j, i]]
    p.damaged(rows)


def exchange_roles(p, a, b, place=None, seconds=None):
    """Two points (role or (cluster, number)), for the whole trial, from a moment on, or for a while."""
    rows = slice(None) if place is None else slice(getattr(p.moments, place), None)
    if seconds:
        rows = p.span(place, seconds)
    a, b = (p.marker(*(one if isinstance(one, tuple) else (one,))) for one in (a, b))
    if np.isnan(p.take.at(a)[rows]).all() and np.isnan(p.take.at(b)[rows]).all():
        raise NotApplicable("not seen")
    exchange(p, a, b, rows)


def cycle_cluster(p, part):
    a, b, c = p.cluster(part)[:3]
    exchange(p, a, b)
    exchange(p, b, c)


def exchange_in_gap(p, a, b):
    """Both are hidden for 0.2 s and come back with each other's names."""
    rows = p.span("reach", 0.2)
    a, b = p.marker(*a), p.marker(*b)
    for name in (a, b):
        p.take.at(name)[rows] = np.nan
    exchange(p, a, b, slice(rows.stop, None))


def exchange_clusters(p, a, b):
    for one, other in zip(p.cluster(a), p.cluster(b)):
        exchange(p, one, other)


def exchange_sides(p):
    side = {"R": "right_", "L": "left_"}
    def twin(name):
        if name.startswith(tuple(side.values())):
            here, there = side.values() if name.startswith("right_") else reversed(side.values())
            return there + name[len(here):]
        return {"R": "L", "L": "R"}.get(name[0], name[0]) + name[1:]
    pairs = [(n, twin(n)) for n in p.take.names if n < twin(n) and twin(n) in p.take.names]
    if len(pairs) < 5:
        raise NotApplicable("one side")
    for a, b in pairs:
        exchange(p, a, b)


# Spikes, steps, noise

def spike(p, part, millimetres, rows=1, place="reach", number=0):
    first = getattr(p.moments, place)
    p.take.at(p.marker(part, number))[first:first + rows] += millimetres * p.direction()
    p.damaged(slice(first, first + rows))


def many_spikes(p, names, share, millimetres):
    for name in names:
        for row in np.flatnonzero(p.random.random(len(p.take.position)) < share):
            p.take.at(name)[row] += millimetres * p.direction()
    p.damaged(slice(None))


def step(p, names, millimetres, place="reach"):
    rows = slice(getattr(p.moments, place), None)
    offset = millimetres * p.direction()
    for name in names:
        p.take.at(name)[rows] += offset
    p.damaged(rows)


def jitter(p, names, millimetres):
    for name in names:
        p.take.at(name)[:] += p.random.normal(scale=millimetres, size=p.take.at(name).shape)
    p.damaged(slice(None))


# Gaps

def hide(p, names, seconds, place="reach", value=np.nan):
    rows = p.span(place, seconds)
    for name in names:
        p.take.at(name)[rows] = value
    p.damaged(rows)


# The frame and the unit

def turn(p, matrix):
    for take in p.both():
        take.position = take.position @ np.array(matrix, float).T


def tilted(degrees, axis=0):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    a, b = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[[a, a, b, b], [a, b, a, b]] = c, -s, s, c
    return matrix


def scale(p, factor, takes=None):
    for take in takes or p.both():
        take.position = take.position * factor


def call_unit(p, unit):
    for take in p.both():
        take.unit = unit


# Rows and the time base

def decimate(p, every):
    p.take.take_rows(np.arange(0, len(p.take.position), every), True)


def call_rate(p, factor):
    """A person may move as slowly as a rate that is too low says: then the plan is the same, but slower."""
    p.take.rate *= factor
    if factor < 1:
        p.take.clock = factor, 0


def frozen(p, names, seconds, place="reach"):
    rows = p.span(place, seconds)
    for name in names:
        p.take.at(name)[rows] = p.take.at(name)[rows.start - 1]
    p.damaged(rows)


def repeat_rows(p, repeats, renumbered):
    """Writes row i repeats[i] times."""
    p.take.take_rows(np.repeat(np.arange(len(p.take.position)), repeats), renumbered)


def lose_rows(p, count, renumbered, place="reach"):
    first = getattr(p.moments, place)
    rows = np.arange(len(p.take.position))
    p.take.take_rows(np.delete(rows, slice(first, first + count)), renumbered)
    p.damaged(slice(first - 1, first + (1 if renumbered else count)))


def lose_random_rows(p, share):
    kept = p.random.random(len(p.take.position)) >= share
    p.take.take_rows(np.flatnonzero(kept), True)


def keep_rows(p, first, last):
    p.take.take_rows(np.arange(first, last), True)
    p.take.clock = 1, first / p.take.rate


# Static trial and markers

def own_static(p):
    if not p.take.static:
        raise NotApplicable("no static trial")
    return p.take.static


def replace_static(p, static):
    own_static(p)
    if not static:
        raise NotApplicable("no other person")
    p.take.static = static.copy()


def exchange_in_static(p, a, b):
    still = own_static(p)
    i, j = (still.names.index(p.marker(*one)) for one in (a, b))
    still.position[:, [i, j]] = still.position[:, [j, i]]


def scale_static(p, factor):
    scale(p, factor, [own_static(p)])


def every(p):
    return list(p.take.names)
