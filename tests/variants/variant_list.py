"""The variants of a recording: the same motion, seen otherwise. Each is a function of a Take (points in
mm, X to the right, Z up) and a random generator that returns another Take."""
import re

import numpy as np

TURN_DEG, SHIFT_MM = 30.0, (412.0, -273.0, 0.0)  # about the vertical, and along the floor
NOISE_MM = 1e-3
DIGIT_MM = 1e-6   # the last one of a file that states nanometres
RATE_HZ = 120.0
MIRRORED_NAMES = (re.compile(r"([RL])([A-Z]{2,}\d*)"), re.compile(r"(right|left)(_\w+)"))
OTHER_SIDE = {"R": "L", "L": "R", "right": "left", "left": "right"}


def renamed(take, random):
    return take.copy()


def last_digit(take, random):
    changed = take.copy()
    changed.position += DIGIT_MM * random.choice([-1, 1], size=take.position.shape)
    return changed


def noisy(take, random):
    changed = take.copy()
    changed.position += random.uniform(-NOISE_MM, NOISE_MM, size=take.position.shape)
    return changed


def moved(take, random):
    changed, angle = take.copy(), np.radians(TURN_DEG)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    changed.position = take.position @ turn.T + SHIFT_MM
    return changed


def cubic(values, at):
    """Values [N, …] between their rows, by the cubic through the four nearest ones; linear beside rows
    that are missing (NaN), and missing between a missing row and another."""
    below = np.clip(np.floor(at).astype(int), 0, len(values) - 2)
    share = (at - below).reshape(-1, *[1] * (values.ndim - 1))
    one, two = values[below], values[below + 1]
    before, after = values[np.maximum(below - 1, 0)], values[np.minimum(below + 2, len(values) - 1)]
    line = one + share * (two - one)
    curve = (-before * share * (share - 1) * (share - 2) / 6 + one * (share + 1) * (share - 1) * (share - 2) / 2
             - two * (share + 1) * share * (share - 2) / 2 + after * (share + 1) * share * (share - 1) / 6)
    inner = ((below > 0) & (below + 2 < len(values))).reshape(share.shape)
    return np.where(inner & np.isfinite(curve), curve, np.where(share == 0, one, line))


def resampled(take, random):
    changed = take.copy()
    count = int((len(take.position) - 1) * RATE_HZ / take.rate + 1e-9) + 1
    changed.position = cubic(take.position, np.arange(count) * take.rate / RATE_HZ)
    changed.frame, changed.rate = np.arange(1, count + 1), RATE_HZ
    return changed


def mirrored_name(name):
    for pattern in MIRRORED_NAMES:
        if found := pattern.fullmatch(name):
            return OTHER_SIDE[found[1]] + found[2]
    return name


def mirrored(take, random):
    """X to -X, with the labels of right and left exchanged; the file is given as one of the other hand,
    which Morphe mirrors again: the plans must be those of the recording itself."""
    changed = take.copy()
    changed.position = take.position * [-1, 1, 1]
    changed.names = [mirrored_name(name) for name in take.names]
    return changed


VARIANTS = {"renamed": renamed, "last_digit": last_digit, "noisy": noisy, "moved": moved,
            "resampled": resampled, "mirrored": mirrored}


def variant_of(take, name, seed):
    """The variant of a recording and of its static trial."""
    random = np.random.default_rng([seed, list(VARIANTS).index(name)])
    changed = VARIANTS[name](take, random)
    if take.static:
        changed.static = VARIANTS[name](take.static, random)
    return changed
