"""Lies about a target that is carried, and about what a plan took from its recording: kinds of
tests/forged_plans.py."""
import hashlib

import numpy as np

from forger import carried, lie, need
from verify_geometry import text

# A target that is carried in the hand

def attached(f):
    target = carried(f)[0]
    need("attached_frame" in target.attrs)
    return target

def bump(f, joint, begin, end, by):
    """Adds a smooth detour of a joint between two demonstration times, with its derivatives."""
    clock, time = f.plan["trajectory/demonstration_time"][()], f.plan["trajectory/time"][()]
    rows = np.flatnonzero((clock > begin) & (clock < end))
    need(len(rows) > 10)
    span = time[rows[-1]] - time[rows[0]]
    u = (time[rows] - time[rows[0]]) / span
    powers = by * 64 * (u**3 * (1 - u)**3), by * 192 * (u * (1 - u))**2 * (1 - 2 * u), \
        by * 384 * u * (1 - u) * (1 - 5 * u + 5 * u**2)
    for name, order in (("position", 0), ("velocity", 1), ("acceleration", 2)):
        values = f.plan["trajectory"][name][()]
        values[rows, joint] += powers[order] / span**order
        f.plan["trajectory"][name][...] = values

@lie("carried")
def held_by_another_frame(f):
    target = attached(f)
    names = [name for name in f.file["robot/frames/name"][()] if text(name) != text(target.attrs["attached_frame"])]
    target.attrs["attached_frame"] = np.bytes_(f.rng.choice(names))

@lie("carried")
def held_by_nothing(f):
    del attached(f).attrs["attached_frame"]

@lie("carried")
def never_taken(f):
    target = carried(f)[0]
    for name in ("attached_frame", "attach_s", "release_s"):
        target.attrs.pop(name, None)

@lie("carried")
def never_released(f):
    target = attached(f)
    need("transport" in [text(n) for n in f.plan["phases/name"][()]])
    del target.attrs["release_s"]

@lie("carried")
def a_finger_that_opens_on_the_way(f):
    target = attached(f)
    need("grasp/contacts" in f.plan)
    states = [text(state) for state in f.plan["grasp/contacts/state"][()]]
    need("touching" in states)
    tip = text(f.plan["grasp/contacts/tip"][states.index("touching")])
    robot = f.file["robot"]
    frame = int(robot["tips/frame"][[text(n) for n in robot["tips/name"][()]].index(tip)])
    while robot["frames/joint"][frame] < 0:
        frame = int(robot["frames/parent"][frame])
    end = min(target.attrs.get("release_s", np.inf), f.plan["trajectory/demonstration_time"][-1])
    bump(f, int(robot["frames/joint"][frame]), target.attrs["attach_s"], end, -0.03 * min(f.size, 10))

@lie("carried")
def a_wrist_that_leaves_the_target(f):
    """The arm makes a detour while the target is carried as before: its recorded way stays."""
    target = carried(f)[0]
    end = min(target.attrs.get("release_s", np.inf), f.plan["trajectory/demonstration_time"][-1])
    bump(f, 3, target.attrs["attach_s"], end, 0.02 * min(f.size, 10))

@lie("carried")
def a_contact_called_near(f):
    attached(f)
    need("grasp/contacts" in f.plan)
    states = f.plan["grasp/contacts/state"][()]
    need(any(text(state) == "touching" for state in states))
    f.resize("grasp/contacts/state", np.array([b"near"] * len(states)))

@lie("carried")
def touched_before_its_phase(f):
    """Fingers at the target already when the hand sets out: the preshape, in which they may touch it, begins there."""
    target = carried(f)[0]
    clock = f.plan["trajectory/demonstration_time"][()]
    k = int(np.searchsorted(clock, target.attrs["attach_s"]))
    kinds = [text(n) for n in f.plan["phases/name"][()]]
    need("preshape" in kinds and k + 1 < len(clock))
    p = kinds.index("preshape")
    f.plan["phases/begin_s"][p] = f.plan["phases/end_s"][p] = target.attrs["attach_s"]

@lie("carried")
def a_table_that_rises_into_the_target(f):
    target, place, _ = carried(f)
    need("table" in f.plan["scene"])
    f.plan["scene/table/position"][0] = place

@lie("carried")
def a_target_larger_on_the_way(f):
    target = attached(f)
    need("size" in target.attrs)
    target.attrs["size"] = target.attrs["size"] * (1 + 0.05 * min(f.size, 10))

@lie("carried")
def let_go_early(f):
    target = attached(f)
    kinds = [text(n) for n in f.plan["phases/name"][()]]
    need("transport" in kinds)
    last = len(kinds) - 1 - kinds[::-1].index("transport")
    need(f.plan["phases/end_s"][last] < f.plan["trajectory/demonstration_time"][-1])
    target.attrs["release_s"] -= 1e-3 * f.size


# What a plan took from its recording: found with the dataset beside it

@lie("recording")
def a_copy_of_another_name(f):
    f.file.copy(f.plan.parent, f.file["plans"], "P99_reach")

@lie("recording")
def an_arm_that_was_there(f):
    names = [name for name in ("other upper arm", "other forearm", "other hand") if name in f.plan["scene"]]
    need(names)
    for name in names:
        del f.plan["scene"][name]

@lie("recording")
def an_arm_elsewhere(f):
    need("other forearm" in f.plan["scene"])
    f.plan["scene/other forearm/position"][...] = f.plan["scene/other forearm/position"][()] + 1e-3 * f.size

@lie("recording")
def an_arm_too_late(f):
    need("other forearm" in f.plan["scene"])
    f.plan["scene/other forearm/time"][...] = f.plan["scene/other forearm/time"][()] + 1e-3 * f.size

@lie("recording")
def a_table_lower(f):
    need("table" in f.plan["scene"] and np.isfinite(f.plan["reference_frames/table"][()]).all())
    down = 1e-3 * f.size
    f.plan["scene/table/position"][...] = f.plan["scene/table/position"][()] - [0, 0, down]
    f.plan["reference_frames/table"][2, 3] -= down

@lie("recording")
def another_person(f):
    f.plan.attrs["subject"] = np.bytes_("P99")

@lie("recording")
def another_task(f):
    f.plan.attrs["task"] = np.bytes_("pouring of another kind")

@lie("recording")
def another_hand(f):
    f.plan.attrs["hand"] = np.bytes_("left" if text(f.plan.attrs["hand"]) == "right" else "right")

@lie("recording")
def a_doubt_left_out(f):
    need("flags" in f.plan)
    del f.plan["flags"]

@lie("recording")
def a_recording_without_assumptions(f):
    need("assumptions" in f.plan)
    del f.plan["assumptions"]

@lie("recording")
def an_elbow_elsewhere(f):
    f.add("goals/elbow_position", 1e-5)

@lie("recording")
def a_wrist_elsewhere(f):
    f.add("goals/wrist_position", 1e-5)

@lie("recording")
def a_finger_joint_elsewhere(f):
    f.add("goals/finger_joint_position", 1e-5)

@lie("recording")
def a_tip_that_was_not_seen(f):
    values = f.plan["goals/tip_position"][()]
    values[0, 1] = np.nan
    f.plan["goals/tip_position"][...] = values

@lie("recording")
def a_shoulder_that_was_estimated(f):
    need(not len(f.plan["goals/estimated"]))
    f.resize("goals/estimated", np.array([b"shoulder"]))

@lie("recording")
def a_preshape_from_the_begin_on(f):
    f.plan["phases/begin_s"][f.phase("preshape")] = f.plan["phases/begin_s"][0]

@lie("recording")
def a_phase_surer(f):
    f.plan["phases/confidence"][f.row("phases/name")] *= 0.5

@lie("recording")
def an_object_called_recorded(f):
    body = f.object()
    need(text(body.attrs.get("pose_origin", b"")) == "inferred")
    body.attrs["pose_origin"] = body.attrs["shape_origin"] = np.bytes_("recorded")

@lie("recording")
def an_object_more(f):
    need("table" in f.plan["scene"])
    f.plan["scene"].copy("table", "shelf")
    shelf = f.plan["scene/shelf"]
    shelf.attrs["pose_origin"] = shelf.attrs["shape_origin"] = np.bytes_("recorded")
    shelf["position"][0] = [9, 9, 9]

@lie("recording")
def a_dataset_of_another_hash(f):
    f.file.attrs["dataset_sha256"] = np.bytes_(hashlib.sha256(b"another").hexdigest())
