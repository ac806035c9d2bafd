#!/usr/bin/python3
"""Forges plans and asks `morphe verify` whether it finds them; whatever it accepts is judged by
verify_plans.py, which must accept it too.

  tests/forged_plans.py MORPHE plans.h5… [--count N] [--grasps N] [--seed S] [--each]

Every lie is one of the KINDS below, of a random size beyond what docs/formats.md tolerates. The forger
is no fool: after the lie, the certificate, the clearance of samples and the figures of mapped frames are
made to agree with it, as `morphe verify` would have them. --each: every kind once on every plan, and a
table of what is found; kinds of the family "recording" only on files with their demonstrations.h5 beside
them. Exit 1: verify accepted a plan that the judge rejects."""
import argparse
import collections
import hashlib
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

import verify_plans
from forger import KINDS, Forger, Unfit, carried, lie, need, transfer
from verify_geometry import Robot, asked_points, text

import forged_carried  # noqa: F401, registers kinds
import forged_form  # noqa: F401, registers kinds

BATCH = 100  # plans in a file


# Motion

@lie("motion")
def a_position_moved(f):
    f.add("trajectory/position", 1e-4)

@lie("motion")
def a_velocity_changed(f):
    f.add("trajectory/velocity", 1e-3)

@lie("motion")
def an_acceleration_changed(f):
    f.add("trajectory/acceleration", 1e-1)

@lie("motion")
def an_end_not_at_rest(f):
    rows, joints = f.plan["trajectory/velocity"].shape
    f.add("trajectory/velocity", 1e-6, f.joint() + f.rng.choice([0, rows - 1]) * joints)

@lie("motion")
def an_end_accelerating(f):
    rows, joints = f.plan["trajectory/acceleration"].shape
    f.add("trajectory/acceleration", 1e-6, f.joint() + f.rng.choice([0, rows - 1]) * joints)

@lie("motion")
def a_joint_shifted_throughout(f):
    f.plan["trajectory/position"][:, f.joint()] += f.sign * 1e-3 * f.size

@lie("motion")
def a_joint_beyond_its_limit(f):
    j = f.joint()
    f.plan["trajectory/position"][f.row("trajectory/time"), j] = f.file["robot/upper"][j] + 1e-4 * f.size

@lie("motion")
def a_motion_hurried(f):
    by = 1 + 0.01 * f.size
    for name, power in (("time", -1), ("velocity", 1), ("acceleration", 2)):
        f.plan["trajectory"][name][...] = f.plan["trajectory"][name][()] * by**power

@lie("motion")
def a_time_that_runs_back(f):
    k = f.row("trajectory/time", 2)
    f.plan["trajectory/time"][k] = f.plan["trajectory/time"][k - 2]

@lie("motion")
def a_clock_that_begins_late(f):
    f.plan["trajectory/time"][...] = f.plan["trajectory/time"][()] + 1e-3 * f.size

@lie("motion")
def a_sample_left_out(f):
    k = f.row("trajectory/time", 1)
    for name in f.plan["trajectory"]:
        f.resize("trajectory/" + name, np.delete(f.plan["trajectory"][name][()], k, axis=0))
    f.plan["trajectory/velocity"][-1] = f.plan["trajectory/acceleration"][-1] = 0

@lie("motion")
def three_samples_alone(f):
    rows = len(f.plan["trajectory/time"])
    keep = [0, int(f.rng.integers(1, rows - 1)), rows - 1]
    for name in f.plan["trajectory"]:
        f.resize("trajectory/" + name, f.plan["trajectory"][name][()][keep])
    if "grasp" in f.plan:
        when = f.plan["phases/begin_s"][f.phase("grasp")]
        sample = min(int(np.searchsorted(f.plan["trajectory/demonstration_time"][()], when)), 2)
        f.plan["grasp"].attrs["sample"] = np.int32(sample)

@lie("motion")
def every_nth_sample(f):
    rows = len(f.plan["trajectory/time"])
    keep = np.unique(np.r_[0:rows:int(f.rng.integers(5, 50)), rows - 1])
    for name in f.plan["trajectory"]:
        f.resize("trajectory/" + name, f.plan["trajectory"][name][()][keep])
    f.plan["trajectory/velocity"][-1] = f.plan["trajectory/acceleration"][-1] = 0

@lie("motion")
def a_number_that_is_none(f):
    f.plan["trajectory"][f.rng.choice(["position", "velocity", "acceleration"])][f.row("trajectory/time"), f.joint()] = \
        f.rng.choice([np.nan, np.inf])

@lie("motion")
def standing_still(f):
    for name in ("velocity", "acceleration"):
        f.plan["trajectory"][name][...] = 0
    f.plan["trajectory/position"][...] = f.plan["trajectory/position"][0]

@lie("motion")
def a_detour_between_samples(f):
    k = f.row("trajectory/time", 1)
    need(k + 1 < len(f.plan["trajectory/time"]))
    f.plan["trajectory/velocity"][k, f.joint()] += f.sign * 0.3 * f.size

@lie("motion")
def an_origin_of_its_own(f):
    k = f.row("trajectory/time")
    f.plan["trajectory/origin"][k] = 2 if f.plan["trajectory/origin"][k] != 2 else 0

@lie("motion")
def a_clearance_of_its_own(f):
    f.add("trajectory/clearance", 2e-4)
    f.keep_certificate = True


# Robot's table

def table(name, change):
    def forge(f):
        change(f, f.file["robot"])
    forge.__name__ = name
    lie("robot table", True)(forge)

def scaled(column):
    def change(f, robot):
        need(column in robot and robot[column].size)
        values = robot[column][()].astype(float)
        values.reshape(-1)[f.rng.integers(values.size)] *= 1 + 1e-3 * f.size
        need((values != robot[column][()]).any())
        robot[column][...] = values
    return change

for _column in ("velocity", "acceleration", "jerk"):
    table(f"a_limit_of_{_column}_raised", scaled(_column))
table("limits_times_a_million", lambda f, robot: [robot[n].write_direct(robot[n][()] * 1e6)
                                                  for n in ("velocity", "acceleration", "jerk")])
table("an_upper_limit_raised", lambda f, robot: robot["upper"].write_direct(robot["upper"][()] + 1e-3 * f.size))
table("a_lower_limit_lowered", lambda f, robot: robot["lower"].write_direct(robot["lower"][()] - 1e-3 * f.size))
table("radii_of_nothing", lambda f, robot: robot["capsules/radius"].write_direct(0 * robot["capsules/radius"][()]))
table("a_radius_less", lambda f, robot: robot["capsules/radius"].write_direct(robot["capsules/radius"][()] * 0.99))
table("every_capsule_may_touch", lambda f, robot: robot["capsules/may_touch_target"].write_direct(
    np.ones(len(robot["capsules/radius"]), np.uint8)))

def _all_allowed(f, robot):
    count = len(robot["capsules/radius"])
    pairs = np.array([(i, j) for i in range(count) for j in range(i + 1, count)], robot["allowed_collision_pairs"].dtype)
    attributes = dict(robot["allowed_collision_pairs"].attrs)
    del robot["allowed_collision_pairs"]
    robot["allowed_collision_pairs"] = pairs
    robot["allowed_collision_pairs"].attrs.update(attributes)
table("every_pair_allowed", _all_allowed)
table("a_capsule_elsewhere", lambda f, robot: robot["capsules/from"].write_direct(robot["capsules/from"][()] + 1e-3 * f.size))
table("a_frame_elsewhere", lambda f, robot: robot["frames/offset"].write_direct(robot["frames/offset"][()] + 1e-3 * f.size))

def _tip(f, robot):
    values = robot["tips/transform"][()]
    values[:, :3, 3] += 1e-3 * f.size
    robot["tips/transform"][...] = values
table("tips_elsewhere", _tip)


# Tolerances and config

for _name in ("required_clearance", "max_penetration", "max_link_penetration", "tracking_tolerance_grasp", "tracking_tolerance",
              "max_unreachable_share", "max_tip_error", "max_missing_goal_share", "max_goal_gap_s"):
    def _forge(f, name=_name):
        need(name in f.plan.attrs)
        stored, off = f.plan.attrs[name], min(0.9, 1e-3 * f.size)
        f.plan.attrs[name] = stored * (1 + f.sign * off) if stored else 1e-3 * off
    _forge.__name__ = f"{_name}_of_its_own"
    lie("tolerances and config")(_forge)

@lie("tolerances and config", True)
def a_config_that_says_otherwise(f):
    """With its own hash, but not with what came out of it."""
    config = text(f.file.attrs["config"])
    key, value = f.rng.choice([("tracking_tolerance_grasp", "0.05"), ("required_clearance", "0")])
    config = re.sub(rf"\n  {key}: [^\n]*", f"\n  {key}: {value}", config)
    f.file.attrs["config"] = np.bytes_(config)
    f.file.attrs["config_sha256"] = np.bytes_(hashlib.sha256(config.encode()).hexdigest())

@lie("tolerances and config", True)
def a_hash_of_another_config(f):
    f.file.attrs["config_sha256"] = np.bytes_(hashlib.sha256(b"another").hexdigest())


# Inputs: the hash of all of them agrees with the lie

def inputs_lie(function):
    def forge(f):
        function(f)
        f.file.attrs["inputs_sha256"] = np.bytes_(verify_plans.inputs_hash(f.file))
    forge.__name__ = function.__name__
    lie("inputs", True)(forge)

def input_names(f, *endings):
    names = []
    f.file["inputs"].visit(lambda name: names.append(name) if name.endswith(endings) else None)
    need(names)
    return names

def put_input(f, name, content):
    """An array of bytes; a text from a text."""
    del f.file["inputs"][name]
    f.file["inputs"][name] = np.frombuffer(content, np.uint8) if isinstance(content, bytes) else np.bytes_(content.encode())

def set_text(f, name, value):
    f.file.attrs[name] = np.bytes_(value.encode())

def configured_number(f):
    """A key and a number of @config, at its place in the text."""
    config = text(f.file.attrs["config"])
    found = [match for match in re.finditer(r"\n( *[a-z_]+: )([0-9.]*[1-9][0-9.]*)(?=\n)", config)]
    need(found)
    return config, found[int(f.rng.integers(len(found)))]

@inputs_lie
def a_number_of_the_config_changed(f):
    config, match = configured_number(f)
    config = config[:match.start(2)] + f"{float(match[2]) * 2:.17g}" + config[match.end(2):]
    set_text(f, "config", config)
    set_text(f, "config_sha256", hashlib.sha256(config.encode()).hexdigest())

@inputs_lie
def a_section_of_the_config_changed(f):
    """An obstacle gone, contacts a metre deep, a target of 10 g: whatever the config has of it."""
    config = text(f.file.attrs["config"])
    changes = [(r"\n  objects:\n(    .*\n)+", "\n  objects: []\n"), (r"(\n  max_penetration: ).*", r"\g<1>0.9"),
               (r"(\n  mass: ).*", r"\g<1>0.01"), (r"(\n  infer: )true", r"\g<1>false")]
    changed = [new for pattern, to in changes if (new := re.sub(pattern, to, config, count=1)) != config]
    need(changed)
    config = changed[int(f.rng.integers(len(changed)))]
    set_text(f, "config", config)
    set_text(f, "config_sha256", hashlib.sha256(config.encode()).hexdigest())

@inputs_lie
def a_setting_added(f):
    set_text(f, "settings", text(f.file.attrs["settings"]) + f"check.required_clearance={1e-5 * f.size}\n")

@inputs_lie
def the_settings_left_out(f):
    lines = text(f.file.attrs["settings"]).splitlines(True)
    need(len(lines) > 1)
    set_text(f, "settings", "".join(lines[:1]))

@inputs_lie
def another_input_as_config(f):
    names = input_names(f, ".yaml")
    own = text(f.file.attrs["settings"]).splitlines()[0].removeprefix("config=")
    set_text(f, "settings", "config=" + str(f.rng.choice([name for name in names if name != own])) + "\n")

@inputs_lie
def inputs_swapped(f):
    one, other = f.rng.choice(input_names(f, ".yaml"), 2, replace=False)
    f.file["inputs"].move(one, "kept")
    f.file["inputs"].move(other, one)
    f.file["inputs"].move("kept", other)

@inputs_lie
def an_input_too_many(f):
    f.file["inputs/notes.yaml"] = np.bytes_("of: nothing\n")

@inputs_lie
def a_key_doubled_in_an_input(f):
    name = str(f.rng.choice(input_names(f, ".yaml")))
    content = text(f.file["inputs"][name][()])
    keys = re.findall(r"^[a-z_]+:.*\n", content, re.M)
    need(keys)
    put_input(f, name, content + str(f.rng.choice(keys)))

def change_stl(f, change):
    """Changes the facets, nine numbers each, of an STL in text."""
    name = str(f.rng.choice(input_names(f, ".stl")))
    facets = np.array(re.findall(r"vertex +(\S+) +(\S+) +(\S+)", text(f.file["inputs"][name][()])), float)
    need(len(facets))
    rows = change(facets.reshape(-1, 3, 3))
    lines = ["facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*p) for p in row) +
             "endloop\nendfacet\n" for row in rows]
    put_input(f, name, "solid\n" + "".join(lines) + "endsolid\n")

@inputs_lie
def a_mesh_of_the_inputs_smaller(f):
    change_stl(f, lambda facets: 0.5 * facets)

@inputs_lie
def a_mesh_of_the_inputs_halved(f):
    change_stl(f, lambda facets: facets[:len(facets) // 2])

@inputs_lie
def a_mesh_of_the_inputs_inside_out(f):
    change_stl(f, lambda facets: facets[:, ::-1])

@lie("inputs", True)
def a_hash_of_other_inputs(f):
    set_text(f, "inputs_sha256", hashlib.sha256(b"another").hexdigest())

@lie("inputs", True)
def a_dataset_of_another_hash(f):
    set_text(f, "dataset_sha256", hashlib.sha256(b"another").hexdigest())


# Meshes of a plan, which are those of the inputs

def mesh_of(f):
    found = [item for item in f.plan["scene"].values() if text(item.attrs["shape"]) == "mesh"]
    need(found)
    return found[int(f.rng.integers(len(found)))]

@lie("scene")
def a_mesh_smaller(f):
    mesh = mesh_of(f)
    mesh["vertices"][...] = mesh["vertices"][()] * (1 - min(0.9, 1e-3 * f.size))

@lie("scene")
def a_mesh_halved(f):
    name = mesh_of(f).name.removeprefix(f.plan.name + "/") + "/triangles"
    f.resize(name, f.plan[name][()][:len(f.plan[name]) // 2])

@lie("scene")
def a_mesh_inside_out(f):
    mesh = mesh_of(f)
    mesh["triangles"][...] = mesh["triangles"][()][:, ::-1]


# Goals

def cut_goals(f, keep):
    for name in list(f.plan["goals"]):
        if len(f.plan["goals"][name]) == len(f.plan["mapped/status"]) and name not in ("auto_closed", "estimated"):
            f.resize("goals/" + name, f.plan["goals"][name][()][keep])
    for name in list(f.plan["mapped"]):
        f.resize("mapped/" + name, f.plan["mapped"][name][()][keep])

@lie("goals")
def goals_cut_short(f):
    rows = len(f.plan["goals/time"])
    keep = np.arange(rows - max(2, min(rows - 1, int(f.size))))
    need(len(keep))
    cut_goals(f, keep)

@lie("goals")
def goals_that_begin_late(f):
    rows = len(f.plan["goals/time"])
    keep = np.arange(max(2, min(rows - 1, int(f.size))), rows)
    need(len(keep))
    cut_goals(f, keep)

@lie("goals")
def no_goals_at_all(f):
    cut_goals(f, np.arange(0))

@lie("goals")
def a_frame_of_the_goals_left_out(f):
    rows = len(f.plan["goals/time"])
    cut_goals(f, np.delete(np.arange(rows), f.rng.integers(1, rows - 1)))

@lie("goals")
def goals_of_which_none_was_seen(f):
    f.plan["goals/tip_position"][...] = np.nan

@lie("goals")
def goals_unseen_while_the_hand_grasps(f):
    begin, end = (f.plan["phases"][name][k := f.phase("grasp")] for name in ("begin_s", "end_s"))
    time, kinds = f.plan["goals/time"][()], [text(n) for n in f.plan["phases/name"][()]]
    unseen = np.zeros(len(time), bool)
    for kind, b, e in zip(kinds, f.plan["phases/begin_s"][()], f.plan["phases/end_s"][()]):
        unseen |= (kind in ("grasp", "hold")) & (time >= b) & (time <= e)
    need(unseen.any())
    values = f.plan["goals/tip_position"][()]
    values[unseen] = np.nan
    f.plan["goals/tip_position"][...] = values

@lie("goals")
def a_goal_moved(f):
    f.add("goals/tip_position", 0.03)

@lie("goals")
def a_goal_seen_in_part(f):
    seen = np.flatnonzero(np.isfinite(f.plan["goals/tip_position"][()]).all(axis=2).any(axis=1))
    row = int(f.rng.choice(seen))
    tip = int(np.flatnonzero(np.isfinite(f.plan["goals/tip_position"][row]).all(axis=1))[0])
    f.plan["goals/tip_position"][row, tip, f.rng.integers(3)] = np.nan

@lie("goals")
def a_goal_turned_into_no_rotation(f):
    f.plan["goals/tip_orientation"][f.row("goals/time"), 0] = [1 + 1e-3 * f.size, 0, 0, 0]


# Phases and times

@lie("phases and times")
def a_phase_that_begins_early(f):
    k = f.phase("grasp", "hold", "transport", "return")
    need(k > 0)
    f.plan["phases/begin_s"][k] -= 1e-3 * f.size

@lie("phases and times")
def a_phase_that_ends_late(f):
    k = f.phase("reach", "grasp")
    need(k + 1 < len(f.plan["phases/name"]))
    f.plan["phases/end_s"][k] += 1e-3 * f.size

@lie("phases and times")
def a_preshape_before_the_reach(f):
    f.plan["phases/begin_s"][f.phase("preshape")] = f.plan["phases/begin_s"][0] - 1e-3 * f.size

@lie("phases and times")
def a_preshape_into_the_grasp(f):
    f.plan["phases/end_s"][f.phase("preshape")] += 1e-3 * f.size

@lie("phases and times")
def a_lift_before_the_transport(f):
    f.plan["phases/begin_s"][f.phase("lift")] -= 1e-3 * f.size

@lie("phases and times")
def a_home_after_the_return(f):
    f.plan["phases/end_s"][f.phase("home")] += 1e-3 * f.size

@lie("phases and times")
def a_phase_without_time(f):
    f.plan["phases"][f.rng.choice(["begin_s", "end_s"])][f.row("phases/name")] = np.nan

@lie("phases and times")
def a_phase_more_than_sure(f):
    f.plan["phases/confidence"][f.row("phases/name")] = 1 + 1e-3 * f.size

@lie("phases and times")
def a_reach_called_hold(f):
    k = f.phase("reach")
    names = f.plan["phases/name"][()]
    names[k] = b"hold"
    f.plan["phases/name"][...] = names

@lie("phases and times")
def a_sample_in_another_phase(f):
    k = f.row("trajectory/time", 1)
    f.plan["trajectory/phase"][k] = (f.plan["trajectory/phase"][k] + 3) % 7

@lie("phases and times")
def a_movement_that_ends_later(f):
    f.plan.attrs["end_s"] += 0.02 + 1e-3 * f.size

@lie("phases and times")
def a_movement_that_begins_earlier(f):
    f.plan.attrs["begin_s"] -= 0.02 + 1e-3 * f.size

@lie("phases and times")
def a_demonstration_that_waits(f):
    time = f.plan["trajectory/demonstration_time"][()]
    f.plan["trajectory/demonstration_time"][...] = np.minimum(time, time[-1] - 1e-3 * f.size)


# Scene

@lie("scene")
def an_object_elsewhere(f):
    body = f.object()
    body["position"][...] = body["position"][()] + f.rng.normal(size=3) * 1e-3 * f.size

@lie("scene")
def an_object_turned(f):
    body = f.object()
    need(text(body.attrs["shape"]) != "sphere")
    turn = np.r_[1, f.rng.normal(size=3) * 0.02 * f.size]
    w, v = body["orientation"][0][0], body["orientation"][0][1:]
    a, b = turn[0], turn[1:]
    turned = np.r_[a * w - b @ v, a * v + w * b + np.cross(b, v)]
    body["orientation"][0] = turned / np.linalg.norm(turned)

@lie("scene")
def an_object_of_another_size(f):
    body = f.object()
    need("size" in body.attrs)
    body.attrs["size"] = body.attrs["size"] * (1 + 0.01 * f.size)

@lie("scene")
def an_object_of_no_size(f):
    body = f.object()
    need("size" in body.attrs)
    body.attrs["size"] = body.attrs["size"] * f.rng.choice([0, -1, np.nan])

@lie("scene")
def a_target_left_out(f):
    del f.plan["scene"][f.target().name.split("/")[-1]]

@lie("scene")
def a_table_left_out(f):
    need("table" in f.plan["scene"])
    del f.plan["scene/table"]

@lie("scene")
def a_target_of_another_name(f):
    f.plan["scene"].move(f.target().name, "mug")

@lie("scene")
def no_target(f):
    f.target()
    f.plan.attrs["target"] = np.bytes_("")

@lie("scene")
def a_table_that_is_the_target(f):
    need("table" in f.plan["scene"] and text(f.plan.attrs["target"]) != "table")
    f.plan.attrs["target"] = np.bytes_("table")

@lie("scene")
def carried_by_an_unknown_frame(f):
    f.target().attrs["attached_frame"] = np.bytes_("tentacle")

@lie("scene")
def carried_by_the_palm(f):
    need("palm" not in text(f.target().attrs.get("attached_frame", b"")))
    names = [text(n) for n in f.file["robot/frames/name"][()]]
    f.target().attrs["attached_frame"] = np.bytes_(names[int(f.file["robot"].attrs["palm_frame"])])
    f.target().attrs["attach_s"] = f.plan.attrs["begin_s"]

@lie("scene")
def taken_early(f):
    need("attach_s" in f.target().attrs)
    f.target().attrs["attach_s"] -= 1e-3 * f.size

@lie("scene")
def released_late(f):
    need("release_s" in f.target().attrs)
    f.target().attrs["release_s"] += 1e-3 * f.size
    need("transport" in [text(n) for n in f.plan["phases/name"][()]])

@lie("scene")
def an_obstacle_on_the_way_of_the_target(f):
    target, place, _ = carried(f)
    need("table" in f.plan["scene"])
    f.plan["scene"].copy("table", "bead")
    bead = f.plan["scene/bead"]
    bead.attrs["shape"], bead.attrs["size"] = np.bytes_("sphere"), np.array([2e-3 * min(f.size, 20)])
    bead.attrs["pose_origin"] = bead.attrs["shape_origin"] = np.bytes_("recorded")
    bead["position"][0], bead["orientation"][0] = place, [1, 0, 0, 0]

@lie("scene")
def released_in_the_air(f):
    target, _, _ = carried(f)
    k = [text(n) for n in f.plan["phases/name"][()]]
    need("transport" in k)
    last = len(k) - 1 - k[::-1].index("transport")
    ends = f.plan["phases/end_s"][()]
    ends[last] = target.attrs["release_s"] = max(f.plan["phases/begin_s"][last], ends[last] - 0.1 * min(f.size, 10))
    f.plan["phases/end_s"][...] = ends

@lie("scene")
def another_object_carried(f):
    need("table" in f.plan["scene"] and text(f.plan.attrs["target"]) != "table")
    f.plan["scene/table"].attrs["attached_frame"] = f.file["robot/frames/name"][0]
    f.plan["scene/table"].attrs["attach_s"] = f.plan.attrs["begin_s"]

@lie("scene")
def a_world_elsewhere(f):
    need("reference_frames" in f.plan)
    name = f.rng.choice([n for n in ("table", "target") if np.isfinite(f.plan["reference_frames"][n][()]).all()] or [""])
    need(name)
    f.add(f"reference_frames/{name}", 1e-5, int(f.rng.choice([3, 7, 11])))

@lie("scene")
def an_object_without_a_place(f):
    f.object()["position"][0] = np.nan


# Grasp, mapped and path

@lie("grasp, mapped and path")
def a_grasp_left_out(f):
    need("grasp" in f.plan)
    del f.plan["grasp"]

@lie("grasp, mapped and path")
def a_grasp_at_another_sample(f):
    need("grasp" in f.plan)
    f.plan["grasp"].attrs["sample"] = np.int32(max(0, f.plan["grasp"].attrs["sample"] - int(f.size)))
    need(f.plan["grasp"].attrs["sample"] > 0)

for _name in ("object_pose", "palm_pose_in_object", "tips_in_object", "grasp_posture", "pregrasp_posture"):
    def _forge(f, name=_name):
        f.add("grasp/" + name, 1e-5)
    _forge.__name__ = f"{_name}_moved"
    lie("grasp, mapped and path")(_forge)

@lie("grasp, mapped and path")
def mapped_elsewhere(f):
    f.add("mapped/position", 1e-4)

@lie("grasp, mapped and path")
def another_branch(f):
    need("branch" in f.plan.attrs)
    f.plan.attrs["branch"] = f.plan.attrs["branch"] ^ (1 << int(f.rng.integers(3)))

@lie("grasp, mapped and path")
def a_mapped_error_less(f):
    f.add("mapped/tip_error", 1e-5)

@lie("grasp, mapped and path")
def a_mapped_turn_less(f):
    f.add("mapped/tip_orientation_error", 1e-4)

@lie("grasp, mapped and path")
def a_humanlikeness_of_its_own(f):
    rows = len(f.plan["mapped/humanlikeness"])
    need(rows and np.isfinite(f.plan["mapped/humanlikeness"][:, 0]).all())
    f.add("mapped/humanlikeness", 1e-4, 3 * int(f.rng.integers(rows)))

@lie("grasp, mapped and path")
def a_frame_called_met(f):
    k = f.row("mapped/status")
    f.plan["mapped/status"][k] = (f.plan["mapped/status"][k] + 1 + f.rng.integers(3)) % 4

@lie("grasp, mapped and path")
def nothing_mapped(f):
    for name in list(f.plan["mapped"]):
        f.resize("mapped/" + name, f.plan["mapped"][name][()][:0])

@lie("grasp, mapped and path")
def a_path_elsewhere(f):
    f.plan["path/position"][:, f.joint()] += f.sign * (0.3 + 1e-3 * f.size)

@lie("grasp, mapped and path")
def a_path_that_ends_early(f):
    f.plan["path/demonstration_time"][...] = np.minimum(f.plan["path/demonstration_time"][()],
                                                        f.plan["path/demonstration_time"][-1] - 1e-3 * f.size)


# Certificate and status

CERTIFICATE = [name for name in verify_plans.EXTREMES] + [
    "joint_limit_margin", "clearance", "tip_error_max", "tip_error_mean", "tip_error_grasp",
    "tip_orientation_error_max", "upper_arm_error_mean", "upper_arm_error_max", "forearm_error_mean",
    "forearm_error_max", "swivel_error_mean", "swivel_error_max", "palm_error_mean", "palm_error_max",
    "wrist_speed_correlation", "held_drift", "held_turn", "duration_ratio", "humanlikeness_mapped", "humanlikeness_final", "sparc_robot", "sparc_human", "log_dimensionless_jerk_robot"]
for _name in CERTIFICATE:
    def _forge(f, name=_name):
        value = f.plan["certificate"].attrs[name]
        need(np.isfinite(value))
        f.plan["certificate"].attrs[name] = value + f.sign * 2e-4 * f.size
        f.keep_certificate = True
    _forge.__name__ = f"{_name}_in_the_certificate"
    lie("certificate and status")(_forge)

@lie("certificate and status")
def called_approximate(f):
    need(text(f.plan.attrs["status"]) == "executable")
    f.plan.attrs["status"] = np.bytes_("approximate")

@lie("certificate and status")
def goals_called_out_of_reach(f):
    need(text(f.plan.attrs["status"]) == "executable")
    f.plan["goals/reachable"][...] = 0

@lie("certificate and status")
def called_repaired(f):
    f.plan["certificate"].attrs["repaired"] = np.uint8(1 - f.plan["certificate"].attrs["repaired"])
    f.keep_certificate = True


# Approach and retreat

@lie("approach and retreat")
def an_approach_left_out(f):
    del f.plan[transfer(f)]

@lie("approach and retreat")
def an_approach_that_begins_elsewhere(f):
    name = transfer(f)
    rows = len(f.plan[name]["time"])
    keep = np.arange(rows // 2, rows) if name == "approach" else np.arange(rows // 2)
    for column in list(f.plan[name]):
        f.resize(f"{name}/{column}", f.plan[name][column][()][keep])
    end = 0 if name == "approach" else -1
    f.plan[name]["velocity"][end] = f.plan[name]["acceleration"][end] = 0
    f.plan[name]["time"][...] = f.plan[name]["time"][()] - f.plan[name]["time"][0]

@lie("approach and retreat")
def an_approach_off_the_plan(f):
    f.plan[transfer(f)]["position"][..., f.joint()] += f.sign * 1e-6 * f.size

@lie("approach and retreat")
def a_clock_inside_of_the_grasp(f):
    f.plan[transfer(f)]["demonstration_time"][...] = f.plan["phases/begin_s"][f.phase("grasp")] + 1e-6

@lie("approach and retreat")
def a_clock_that_runs_meanwhile(f):
    name = transfer(f)
    time = f.plan[name]["demonstration_time"][()]
    f.plan[name]["demonstration_time"][...] = time + np.linspace(0, 1e-6 * f.size, len(time))

@lie("approach and retreat")
def an_approach_in_a_phase(f):
    f.plan[transfer(f)]["phase"][0] = 3

@lie("approach and retreat")
def an_approach_hurried(f):
    name, by = transfer(f), 1 + 0.01 * f.size
    for column, power in (("time", -1), ("velocity", 1), ("acceleration", 2)):
        f.plan[name][column][...] = f.plan[name][column][()] * by**power

@lie("approach and retreat")
def an_approach_not_at_rest(f):
    f.add(transfer(f) + "/velocity", 1e-6, f.joint())

@lie("approach and retreat")
def a_clearance_of_the_approach(f):
    f.add(transfer(f) + "/clearance", 2e-4)
    f.keep_certificate = True

@lie("approach and retreat")
def an_approach_nobody_asked_for(f):
    need("approach" not in f.plan)
    f.file.copy(f.plan["trajectory"], f.plan, "approach")
    way = f.plan["approach"]
    way["position"][...] = way["position"][0]
    way["velocity"][...] = way["acceleration"][...] = 0
    way["demonstration_time"][...] = way["demonstration_time"][0]
    way["phase"][...] = 0
    way["clearance"][...] = way["clearance"][0]


# Contacts and forces of a grasp: `--grasps`

def demonstrated_coordinate(f):
    """An index into the values of contacts that the person made: those of closed fingers are known to a finger's length."""
    rows = [k for k, origin in enumerate(f.plan["grasp/contacts/origin"][()]) if text(origin) == "demonstrated"]
    need(rows)
    return 3 * int(f.rng.choice(rows)) + int(f.rng.integers(3))

def contact(name, least, vector=False):
    def forge(f):
        need("grasp/contacts" in f.plan)
        f.add("grasp/contacts/" + name, least, demonstrated_coordinate(f) if name == "desired_point" else None)
    forge.__name__ = f"a_contact_of_another_{name}"
    lie("contacts")(forge)

for _name, _least in (("desired_point", 1e-3), ("point", 1e-3), ("normal", 3e-3), ("signed_distance", 2e-5), ("pad_angle", 1e-5)):
    contact(_name, _least)

@lie("contacts")
def a_normal_flipped(f):
    need("grasp/contacts" in f.plan)
    k = f.row("grasp/contacts/tip")
    f.plan["grasp/contacts/normal"][k] = -f.plan["grasp/contacts/normal"][k]

@lie("contacts")
def a_contact_off_the_surface(f):
    need("grasp/contacts" in f.plan)
    k = f.row("grasp/contacts/tip")
    f.plan["grasp/contacts/point"][k] += f.sign * 2e-5 * f.size * f.plan["grasp/contacts/normal"][k]

@lie("contacts")
def a_contact_left_out(f):
    need("grasp/contacts" in f.plan)
    k = f.row("grasp/contacts/tip")
    for name in list(f.plan["grasp/contacts"]):
        f.resize("grasp/contacts/" + name, np.delete(f.plan["grasp/contacts"][name][()], k, axis=0))

@lie("contacts")
def all_contacts_left_out(f):
    need("grasp/contacts" in f.plan)
    for name in ("contacts", "quality", "grasp_force"):
        if name in f.plan["grasp"]:
            del f.plan["grasp"][name]

@lie("contacts")
def a_contact_more_than_sure(f):
    need("grasp/contacts" in f.plan)
    f.plan["grasp/contacts/confidence"][f.row("grasp/contacts/tip")] = 1 + 1e-3 * f.size

@lie("contacts")
def a_contact_on_another_link(f):
    need("grasp/contacts" in f.plan)
    k, names = f.row("grasp/contacts/tip"), f.plan["grasp/contacts/link"][()]
    names[k] = f.file["robot/capsules/name"][0]
    f.plan["grasp/contacts/link"][...] = names

for _name, _least in (("friction_coefficient", 0.02), ("torsional_friction", 0.02), ("mass", 0.02),
                       ("characteristic_length", 0.02), ("available_force", 0.01)):
    def _forge(f, name=_name, least=_least):
        need("grasp/quality" in f.plan and np.isfinite(f.plan["grasp/quality"].attrs[name]))
        f.plan["grasp/quality"].attrs[name] *= 1 + least * f.size
    _forge.__name__ = f"{_name}_raised_in_the_result"
    lie("contacts")(_forge)

@lie("contacts")
def an_epsilon_raised(f):
    need("grasp/quality" in f.plan and f.plan["grasp/quality"].attrs.get("epsilon_lower", np.nan) > 0.01)
    for name in ("epsilon_lower", "epsilon_upper"):
        f.plan["grasp/quality"].attrs[name] *= 1.06 + 1e-2 * f.size

@lie("contacts")
def newtons_needed_fewer(f):
    need("grasp/quality" in f.plan)
    name = f.rng.choice(["required_force_gravity", "required_force_worst"])
    need(np.isfinite(f.plan["grasp/quality"].attrs[name]))
    f.plan["grasp/quality"].attrs[name] *= 0.9 / f.size**0.3

@lie("contacts")
def a_force_changed(f):
    need("grasp/grasp_force" in f.plan)
    f.add("grasp/contacts/normal_force", 0.1)

@lie("contacts")
def a_force_out_of_its_cone(f):
    need("grasp/grasp_force" in f.plan)
    f.add("grasp/contacts/friction_force", 0.1)

@lie("contacts")
def a_torque_changed(f):
    f.add("grasp/grasp_force/torque", 1e-4)

@lie("contacts")
def a_servo_sent_elsewhere(f):
    f.add("grasp/grasp_force/servo_target", 1e-4)

@lie("contacts")
def a_squeeze_left_out(f):
    need("grasp/grasp_force" in f.plan)
    del f.plan["grasp/grasp_force"]

@lie("contacts")
def a_squeeze_run_as_a_motion(f):
    need("grasp/grasp_force" in f.plan)
    sample, rows = f.plan["grasp"].attrs["sample"], len(f.plan["trajectory/time"])
    need(sample + 1 < rows)
    f.plan["trajectory/position"][int(f.rng.integers(sample + 1, rows))] = f.plan["grasp/grasp_force/servo_target"][()]

@lie("contacts")
def a_pad_that_is_not_asked(f):
    need("tip_to_pad_share" in f.plan["goals"])
    f.plan["goals/tip_to_pad_share"][...] = 0

@lie("contacts")
def a_penetration_deeper(f):
    need("grasp/contacts" in f.plan)
    gap = f.plan["grasp/contacts/signed_distance"][()].min()
    need(gap < -1e-5)
    f.plan.attrs["max_penetration"] = -gap * 0.5


def agree_with_the_lie(robot, plan):
    """What a forger makes of mapped frames; what verify alone knows to the last digit, repaired() does."""
    mapped, goals = plan["mapped"], plan["goals"]
    q, time = mapped["position"][()], goals["time"][()]
    if not len(q) or len(q) != len(time) or not np.isfinite(q).all():
        return
    poses = robot.frame_poses(q)
    for m in range(len(robot.tip_names)):
        away = asked_points(robot, goals, m, time, poses) - goals["tip_position"][:, m]
        mapped["tip_error"][:, m] = np.linalg.norm(away, axis=1)


def clearances(robot, plan, name):
    """Of the samples, as they are."""
    motion = verify_plans.read_motion(robot, plan[name], report := verify_plans.Report(""))
    if not motion:
        return None
    phases = list(zip(plan["phases/name"].asstr(), plan["phases/begin_s"], plan["phases/end_s"]))
    told = np.full(len(motion["time"]), np.nan)
    return verify_plans.check_contacts(robot, plan, motion, phases, told, report, substeps=1)[1]


def restate_kinds(robot, plan):
    """Writes the clearances by kind as they are."""
    group = plan["certificate/clearance_by_kind"]
    motion = verify_plans.read_motion(robot, plan["trajectory"], report := verify_plans.Report(""))
    phases = list(zip(plan["phases/name"].asstr(), plan["phases/begin_s"], plan["phases/end_s"]))
    kinds, _, closest = verify_plans.check_contacts(robot, plan, motion, phases, plan["trajectory/clearance"][()], report)
    names = [kind for kind in ("self", "table", "objects", "target") if kind in kinds]
    pairs = [closest[kind][0].split("/", 1) for kind in names]
    for name, values in (("kind", names), ("clearance", [kinds[kind] for kind in names]),
                         ("first", [pair[0] for pair in pairs]), ("second", [pair[1] for pair in pairs]),
                         ("time", [closest[kind][1] for kind in names])):
        attributes = dict(group[name].attrs)
        del group[name]
        group.create_dataset(name, data=values).attrs.update(attributes)


def keep(file):
    """A file that must not be lost with its folder."""
    copy = Path(tempfile.gettempdir()) / f"forged_{os.getpid()}.h5"
    copy.write_bytes(Path(file).read_bytes())
    return copy


def verified(morphe, file):
    result = subprocess.run([morphe, "verify", file, "--json"], capture_output=True, text=True)
    if result.returncode == 2:
        return None, result.stderr
    if result.returncode not in (0, 1):
        raise RuntimeError(f"{morphe} verify ended with {result.returncode} on a copy of {file}: {keep(file)}")
    found = collections.defaultdict(list)
    for row in json.loads(result.stdout)["violations"]:
        found["/".join(row["plan"].split("/")[:2])].append(row)
    return found, ""


def rows_of(found, plan):
    """Those of a plan and of others of its demonstration, of which a forger may have made one."""
    demonstration = plan.split("/")[0]
    return [row for path, rows in found.items() if path.split("/")[0] == demonstration for row in rows]


def beyond_repair(rows):
    return bool({row["cause"] for row in rows} - {"certificate", "clearance"})


def repair(file, found):
    """Gives each plan the certificate that verify computed, and the clearance of samples."""
    changed = False
    robot = Robot(file["robot"])
    restated = set()
    for path, rows in found.items():
        plan = file["plans"][path]
        for row in rows:
            changed = True
            if row["subject"].startswith("clearance_by_kind") and row["cause"] == "certificate":
                restated.add(path)
            elif row["cause"] == "certificate" and row["subject"] in plan["certificate"].attrs:
                value = np.nan if row["limit"] is None else row["limit"]
                kind = plan["certificate"].attrs[row["subject"]].dtype.type
                plan["certificate"].attrs[row["subject"]] = kind(value)
            elif row["cause"] == "clearance":
                name = (row["plan"].split("/") + ["trajectory"])[2]
                if (own := clearances(robot, plan, name)) is not None:
                    plan[name]["clearance"][...] = own
    for path in restated:
        restate_kinds(robot, file["plans"][path])
    return changed


class Tally:
    def __init__(self):
        self.made, self.found, self.missed = (collections.Counter() for _ in range(3))
        self.wrong = []


def skip(path, plans):
    with h5py.File(path, "r+") as file:
        for plan in plans:
            del file["plans"][plan.split("/")[0]]


def judge_batch(morphe, path, kinds, honest, tally):
    """One file of forged plans: verified, repaired where that may help, verified again, at most three
    times; what is found for good is left out, as is what cannot even be read. What is accepted goes to
    the judge: nothing else can break the claim."""
    left, rounds = dict(kinds), 0
    while left and rounds < 3:
        found, refusal = verified(morphe, path)
        if found is None:
            place = re.search(r":/plans/([^/]+/[^/:]+)", refusal)
            gone = [place[1]] if place and place[1] in left else list(left)
        else:
            rounds += 1
            if any(row["subject"] != "plans" for row in found.get("", [])):  # of the file
                gone = list(left)
            else:
                gone = [plan for plan in left if (rows := rows_of(found, plan)) and (
                    rounds == 3 or plan in honest or beyond_repair(rows))]
        tally.found.update(left.pop(plan) for plan in gone)
        if not left:
            return
        skip(path, gone)
        if found is None:
            continue
        with h5py.File(path, "r+") as file:
            if not repair(file, {plan: found[plan] for plan in left if found.get(plan)}):
                break
    with h5py.File(path) as file:
        robot = Robot(file["robot"])
        for plan, kind in left.items():
            if rows_of(found, plan):
                tally.found[kind] += 1
                continue
            tally.missed[kind] += 1
            if rows := verify_plans.check_plan(robot, plan, file["plans"][plan]):
                tally.wrong.append((kind, rows[0]))


def forge_batch(sources, kinds_wanted, rng, folder, morphe, tally):
    """Plans of one source, each with a lie, in one file."""
    source = sources[int(rng.integers(len(sources)))]
    path, kinds, honest = folder / "forged.h5", {}, set()
    path.unlink(missing_ok=True)
    with h5py.File(source) as whole, h5py.File(path, "w", track_order=True) as file:
        for key, value in whole.attrs.items():
            file.attrs[key] = value
        for name in (name for name in whole if name != "plans"):
            whole.copy(name, file)
        plans = file.create_group("plans", track_order=True)
        paths = [f"{d}/{m}" for d in whole["plans"] for m in whole["plans"][d]
                 if "trajectory" in whole["plans"][d][m]]
        robot = Robot(file["robot"])
        for number, kind in enumerate(kinds_wanted):
            group = plans.create_group(f"F{number:04}", track_order=True)
            for _ in range(20):
                whole.copy(whole["plans"][str(rng.choice(paths))], group, "000")
                forger = Forger(group["000"], rng)
                forger.keep_certificate = False
                try:
                    KINDS[kind][2](forger)
                    if not forger.keep_certificate and KINDS[kind][0] in ("goals", "motion", "scene", "carried"):
                        agree_with_the_lie(robot, group["000"])
                except Unfit:
                    del group["000"]
                    continue
                tally.made[kind] += 1
                kinds[f"F{number:04}/000"] = kind
                if forger.keep_certificate:
                    honest.add(f"F{number:04}/000")
                break
            else:
                del plans[f"F{number:04}"]
    if kinds:
        judge_batch(morphe, path, kinds, honest, tally)


def forge_with_recordings(source, kind, rng, folder, morphe, tally):
    """One plan of a whole file, with the recordings beside it. Only what verify says of these counts."""
    path, dataset = folder / "forged.h5", Path(source).with_name("demonstrations.h5")
    if not dataset.exists():
        return
    for _ in range(20):
        path.write_bytes(Path(source).read_bytes())
        with h5py.File(path, "r+") as file:
            plans = [f"{d}/{m}" for d in file["plans"] for m in file["plans"][d] if "trajectory" in file["plans"][d][m]]
            forger = Forger(file["plans"][str(rng.choice(plans))], rng)
            try:
                KINDS[kind][2](forger)
            except Unfit:
                continue
        tally.made[kind] += 1
        result = subprocess.run([morphe, "verify", path, "--dataset", dataset, "--json"], capture_output=True, text=True)
        rows = json.loads(result.stdout)["violations"] if result.returncode < 2 else []
        told = result.returncode == 2 or any(row["cause"] == "recording" for row in rows)
        (tally.found if told else tally.missed)[kind] += 1
        return


def run(morphe, sources, count, families, seed, batch=BATCH, log=lambda text: None):
    rng, tally = np.random.default_rng(seed), Tally()
    names = [name for name, (family, _, _) in KINDS.items() if family in families - {"recording"}]
    with tempfile.TemporaryDirectory(prefix="morphe_forged_") as folder:
        while (left := count - sum(tally.made.values())) > 0:
            wanted = [str(name) for name in rng.choice(names, min(batch, left))]
            together = [name for name in wanted if not KINDS[name][1]]
            before = sum(tally.made.values())
            if together:
                forge_batch(sources, together, rng, Path(folder), morphe, tally)
            for name in (name for name in wanted if KINDS[name][1]):
                forge_batch(sources, [name], rng, Path(folder), morphe, tally)
            log(f"{sum(tally.made.values())} made, {sum(tally.missed.values())} not found, "
                f"{len(tally.wrong)} of them rejected by the judge")
            if sum(tally.made.values()) == before:
                break
    return tally


def each(morphe, sources, seed, families=None):
    """Every kind of these families, or of all, once on every file."""
    tally, rng = Tally(), np.random.default_rng(seed)
    kinds = {name: kind for name, kind in KINDS.items() if families is None or kind[0] in families}
    with tempfile.TemporaryDirectory(prefix="morphe_forged_") as folder:
        for source in sources:
            together = []
            for name, (family, whole_file, _) in kinds.items():
                if family == "recording":
                    forge_with_recordings(source, name, rng, Path(folder), morphe, tally)
                elif whole_file:
                    forge_batch([source], [name], rng, Path(folder), morphe, tally)
                else:
                    together.append(name)
            if together:
                forge_batch([source], together, rng, Path(folder), morphe, tally)
    return tally


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("morphe")
    parser.add_argument("plans", nargs="+")
    parser.add_argument("--count", type=int, default=200, help="forged plans")
    parser.add_argument("--grasps", type=int, default=0, help="of which only grasps are forged, beside those")
    parser.add_argument("--each", action="store_true", help="every kind on every file instead")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    log = lambda line: print(line, file=sys.stderr)
    morphe, wrong = Path(options.morphe).resolve(), 0
    plans = [Path(plan).resolve() for plan in options.plans]
    families = {family for family, _, _ in KINDS.values()}
    if options.each:
        tallies = [each(morphe, plans, options.seed)]
    else:
        tallies = [run(morphe, plans, options.count, families - {"contacts"}, options.seed, log=log)]
        if options.grasps:
            tallies.append(run(morphe, plans, options.grasps, {"contacts"}, options.seed, log=log))
    for tally in tallies:
        for name, (family, _, _) in KINDS.items():
            if tally.made[name]:
                print(f"{family:24} {name:42} {tally.found[name]:6} of {tally.made[name]:6} found")
        print(f"{sum(tally.found.values())} of {sum(tally.made.values())} found, "
              f"{len(tally.wrong)} accepted that the judge rejects")
        for kind, row in tally.wrong[:20]:
            print("  accepted:", kind, row)
        wrong += len(tally.wrong)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
