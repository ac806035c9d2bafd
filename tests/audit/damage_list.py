"""The damages of the study, with the flags, questions and messages that name each of them."""
import itertools
from dataclasses import dataclass
from typing import Callable

import numpy as np

from damages import (call_rate, call_unit, cycle_cluster, decimate, every, exchange, exchange_clusters,
                     exchange_in_gap, exchange_in_static, exchange_roles, exchange_sides,
                     frozen, hide, jitter, keep_rows, lose_random_rows, lose_rows, many_spikes,
                     own_static, Patient, repeat_rows, replace_static, scale, scale_static,
                     spike, step, tilted, turn)


@dataclass
class Damage:
    name: str
    apply: Callable[[Patient], object]
    fits: tuple = ()     # codes of flags that name it
    asks: tuple = ()     # keys of questions that name it
    told: str = ""       # pattern of the import notes, the plan's detail or the error that name it
    exact: bool = False  # mended means that all points are as they were
    undecidable: str = ""  # why the file cannot tell this damage from an undamaged recording, if it does not


MIDDLE = "reach"
LABELS = ("exchanged_markers", "exchanged_digits")
SIDES = (*LABELS, "mirrored")
FRAME = dict(fits=("mirrored", "vertical"), asks=("axes", "hand"), told="implausible_arm")
SIZE = dict(fits=("scale", "static_trial"), asks=("unit",))
TIME = dict(fits=("time_base", "lost_rows", "repeated_rows", "frozen_rows"), asks=("rate",))
LOST = ("lost_rows",)
GAPS = dict(fits=("missing_goals", "incomplete_movement"), told=r"not seen|hidden|missing|never visible|without .*goal|no_goal|no_shoulder")
CUT = dict(fits=("incomplete_movement",), told=r"no_movement|in motion|incomplete")
GONE = dict(fits=("missing_goals", "no_grasp", "static_trial"),
            told=r"never visible|not recorded|three are needed|_tip has goals|no_shoulder|no_goal|no_movement")
TEMPO = ("a slower or quicker person: rms frequencies of unchanged recordings reach from 0.44 to 1.0 Hz, "
         "a factor of 2.3")
TILT = "people lean, and hold their arms, up to 24 degrees from upright in unchanged recordings"
STATURE = "people's sizes, as markers give them, reach from 0.76 to 1.1 of an adult's in unchanged recordings"
STATIC = dict(fits=("static_trial", "exchanged_markers"), asks=("static_trial", "unit"))


def label_damages():
    pairs = {"digits": ("thumb", "index"), "hand": (("hand", 0), ("hand", 1)),
             "hand_far": (("hand", 0), ("hand", 2)),
             "forearm": (("forearm", 0), ("forearm", 2)), "upper": (("upper", 0), ("upper", 1)),
             "hand_forearm": (("hand", 0), ("forearm", 1)), "index_hand": ("index", ("hand", 2)),
             "thumb_forearm": ("thumb", ("forearm", 0)), "upper_hand": (("upper", 2), ("hand", 2)),
             "wrist_elbow": ("wrist", "elbow")}
    for name, (a, b) in pairs.items():
        for when, place, seconds in (("whole", None, None), ("from", MIDDLE, None), ("while", "grasp", 0.3)):
            yield Damage(f"exchange_{name}_{when}", lambda p, a=a, b=b, place=place, seconds=seconds:
                         exchange_roles(p, a, b, place, seconds), LABELS, exact=True)
    yield Damage("exchange_hand_in_gap", lambda p: exchange_in_gap(p, ("hand", 0), ("hand", 1)), LABELS)
    yield Damage("exchange_digits_in_gap", lambda p: exchange_in_gap(p, ("thumb",), ("index",)), LABELS)
    yield Damage("cycle_hand", lambda p: cycle_cluster(p, "hand"), LABELS, exact=True)
    yield Damage("cycle_forearm", lambda p: cycle_cluster(p, "forearm"), LABELS, exact=True)
    yield Damage("exchange_clusters", lambda p: exchange_clusters(p, "hand", "forearm"), LABELS, exact=True)
    yield Damage("exchange_sides", exchange_sides, SIDES, ("hand", "axes", "static_trial"))


def point_damages():
    spikes = dict(fits=("spike",))
    for part, size, rows, place in (
            ("index", 5, 1, MIDDLE), ("index", 20, 1, MIDDLE), ("index", 50, 1, "grasp"), ("index", 200, 1, MIDDLE),
            ("index", 1000, 1, MIDDLE), ("thumb", 100, 3, MIDDLE), ("thumb", 300, 5, "grasp"),
            ("hand", 100, 1, MIDDLE), ("forearm", 50, 2, MIDDLE), ("upper", 300, 1, MIDDLE), ("wrist", 100, 1, MIDDLE),
            ("elbow", 50, 2, MIDDLE)):
        yield Damage(f"spike_{part}_{size}mm_{rows}_{place}", lambda p, part=part, size=size, rows=rows, place=place:
                     spike(p, part, size, rows, place), **spikes)
    yield Damage("spike_both_digits", lambda p: [spike(p, part, 150) for part in ("thumb", "index")], **spikes)
    yield Damage("spikes_index", lambda p: many_spikes(p, [p.point("index")], 0.01, 100), **spikes)
    yield Damage("spikes_all", lambda p: many_spikes(p, every(p), 0.01, 100), ("spike", "jitter", "step", "lost_rows"))
    steps = dict(fits=("step", "static_trial"))  # the cluster has another shape than in the static trial
    for part, size in (("index", 20), ("index", 50), ("index", 100), ("thumb", 30), ("hand", 30), ("upper", 40),
                       ("wrist", 50)):
        yield Damage(f"step_{part}_{size}mm", lambda p, part=part, size=size:
                     step(p, [p.marker(part)], size), **steps)
    yield Damage("step_all_100mm", lambda p: step(p, every(p), 100), ("step", "lost_rows"))
    yield Damage("jitter_all_0.02mm", lambda p: jitter(p, every(p), 0.02))  # of a good laboratory: harmless
    for size in (2, 5):
        yield Damage(f"jitter_all_{size}mm", lambda p, size=size: jitter(p, every(p), size), ("jitter",))
        yield Damage(f"jitter_index_{size}mm", lambda p, size=size: jitter(p, [p.point("index")], size), ("jitter",))
    yield Damage("jitter_hand_5mm", lambda p: jitter(p, p.cluster("hand"), 5), ("jitter",))


def gap_damages():
    for part, seconds, place in (("index", 0.1, MIDDLE), ("index", 0.5, MIDDLE), ("index", 0.3, "grasp"),
                                 ("thumb", 1, "grasp"), ("index", 2, "grasp")):
        yield Damage(f"gap_{part}_{seconds}s_{place}", lambda p, part=part, seconds=seconds, place=place:
                     hide(p, [p.point(part)], seconds, place), **GAPS)
    yield Damage("gap_hand_0.5s", lambda p: hide(p, p.cluster("hand"), 0.5), **GAPS)
    yield Damage("gap_wrist_0.2s", lambda p: hide(p, [p.point("wrist")], 0.2), **GAPS)
    for seconds in (0.1, 0.5, 1, 2):
        yield Damage(f"gap_all_{seconds}s", lambda p, seconds=seconds: hide(p, every(p), seconds), **GAPS)
    zero = dict(fits=("spike", "missing_goals"), told=GAPS["told"] + r"|0, 0, 0")
    yield Damage("zeros_index_0.3s", lambda p: hide(p, [p.point("index")], 0.3, value=0), **zero)
    yield Damage("zeros_all_0.3s", lambda p: hide(p, every(p), 0.3, value=0), **zero)
    for part in ("hand", "forearm", "upper", "shoulder"):
        yield Damage(f"missing_{part}_cluster", lambda p, part=part: p.take.drop(p.cluster(part)), **GONE)
    yield Damage("missing_hand_marker", lambda p: p.take.drop([p.marker("hand")]), **GONE)
    for part in ("thumb", "index", "elbow"):
        yield Damage(f"missing_{part}", lambda p, part=part: p.take.drop([p.point(part)]), **GONE)


def frame_damages():
    for name, matrix in {"mirrored_x": np.diag([-1, 1, 1]), "mirrored_y": np.diag([1, -1, 1]),
                         "mirrored_z": np.diag([1, 1, -1]), "swapped_xy": np.eye(3)[[1, 0, 2]],
                         "swapped_yz": np.eye(3)[[0, 2, 1]], "y_up": [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
                         "x_up": tilted(90, 1), "upside_down": np.diag([1, -1, -1]), "about_vertical_90": tilted(90, 2),
                         "tilted_10": tilted(10), "tilted_20": tilted(20),
                         "tilted_45": tilted(45, 1)}.items():
        undecidable = TILT if name in ("tilted_10", "tilted_20") else ""
        yield Damage(f"axes_{name}", lambda p, matrix=matrix: turn(p, matrix), **FRAME, undecidable=undecidable)
    for name, factor in {"cm": 0.1, "m": 1e-3, "inch": 1 / 25.4, "tenfold": 10, "thousandfold": 1000,
                         "30_percent": 1.3}.items():
        undecidable = STATURE if name == "30_percent" else ""
        yield Damage(f"unit_{name}_called_mm", lambda p, factor=factor: scale(p, factor), **SIZE,
                     undecidable=undecidable)
    yield Damage("unit_mm_called_m", lambda p: call_unit(p, "m"), **SIZE)


def row_damages():
    yield Damage("rate_third_of_header", lambda p: decimate(p, 3), **TIME)
    for factor in (0.3, 0.5, 2, 3.3):
        yield Damage(f"rate_header_times_{factor}", lambda p, factor=factor: call_rate(p, factor), **TIME,
                     undecidable=TEMPO if factor <= 2 else "")
    for seconds in (0.1, 0.3, 1):
        yield Damage(f"frozen_all_{seconds}s", lambda p, seconds=seconds: frozen(p, every(p), seconds), ("frozen_rows",))
    yield Damage("frozen_index_0.3s", lambda p: frozen(p, [p.point("index")], 0.3), ("frozen_rows", "step"))
    yield Damage("doubled_tenth", lambda p: repeat_rows(
        p, 1 + (np.arange(len(p.take.position)) % 10 == 0), True), ("repeated_rows", "frozen_rows"))
    yield Damage("doubled_all", lambda p: repeat_rows(p, 2, True), ("repeated_rows", "frozen_rows", "time_base"))
    yield Damage("doubled_all_numbers_too", lambda p: repeat_rows(p, 2, False),
                 ("repeated_rows", "frozen_rows"), told="twice|repeated|number")
    for count, renumbered in ((5, True), (20, True), (40, True), (100, True), (40, False)):
        yield Damage(f"lost_{count}{'' if renumbered else '_numbers_too'}", lambda p, count=count, renumbered=renumbered:
                     lose_rows(p, count, renumbered), LOST + (() if renumbered else ("missing_goals",)), told=GAPS["told"])
    yield Damage("lost_random", lambda p: lose_random_rows(p, 0.05), LOST + ("jitter", "time_base"))
    yield Damage("cut_in_reach", lambda p: keep_rows(p, 0, p.moments.reach), **CUT)
    yield Damage("cut_before_grasp", lambda p: keep_rows(p, 0, p.moments.grasp - p.rows(0.15)), **CUT)
    yield Damage("begins_in_reach", lambda p: keep_rows(p, p.moments.reach, len(p.take.position)), **CUT)
    yield Damage("begins_late", lambda p: keep_rows(p, p.moments.begin + p.rows(0.15), len(p.take.position)), **CUT)


def static_damages():
    yield Damage("static_of_another", lambda p: replace_static(p, p.other_static), **STATIC)
    yield Damage("static_in_cm", lambda p: scale_static(p, 0.1), **STATIC)
    yield Damage("static_mirrored", lambda p: [own_static(p), setattr(
        p.take.static, "position", p.take.static.position * [-1, 1, 1])], **STATIC)
    yield Damage("static_exchanged", lambda p: exchange_in_static(p, ("hand", 0), ("hand", 1)), **STATIC)
    yield Damage("static_absent", lambda p: [own_static(p), setattr(p.take, "static", None)],
                 ("static_trial",), told="static trial")


def all_damages():
    return list(itertools.chain(label_damages(), point_damages(), gap_damages(), frame_damages(),
                                row_damages(), static_damages()))


def every_exchange(roles):
    """Each two markers of arm and hand, for the whole trial and from the middle of the reach on."""
    for a, b in itertools.combinations(roles.arm_points(), 2):
        for when, place in (("whole", None), ("from", MIDDLE)):
            yield Damage(f"exchange_{a}_{b}_{when}", lambda p, a=a, b=b, place=place:
                         exchange(p, a, b, slice(None) if place is None else slice(getattr(p.moments, place), None)),
                         LABELS, exact=True)


def undecidable_table():
    """The rows of docs/audit.md about damages that no file can tell from another person."""
    reasons = {}
    for damage in all_damages():
        if damage.undecidable:
            reasons.setdefault(damage.undecidable, []).append(f"`{damage.name}`")
    rows = [f"| {', '.join(names)} | {reason} |" for reason, names in reasons.items()]
    return "\n".join(["| damage | reason |", "|---|---|", *rows]) + "\n"
