"""Reads a plans.h5 of one full and one infeasible plan with h5py alone; fails on any difference."""
import sys

import h5py
import numpy as np

from contract import assumptions, attributes, flags, shapes, text

PHASES = ("0=rest,1=reach,2=preshape,3=grasp,4=hold,5=transport,6=return,"
          "7=approach,8=lift,9=place,10=release,11=retreat,12=home")
ORIGINS = "0=mapped,1=re_solved,2=planned"


def trajectory(name, samples):
    return {f"{name}/{data}": (shape, kind, unit, None) for data, shape, kind, unit in [
        ("time", (samples,), "f", "s"), ("position", (samples, 3), "f", "rad or m"),
        ("velocity", (samples, 3), "f", "rad or m/s"), ("acceleration", (samples, 3), "f", "rad or m/s^2"),
        ("demonstration_time", (samples,), "f", "s"), ("phase", (samples,), "u", "1"),
        ("origin", (samples,), "u", "1"), ("clearance", (samples,), "f", "m")]}


def frames(f, m, n):
    """goals, mapped: f frames, m tips, n joints."""
    return {
        "goals/time": ((f,), "f", "s", None),
        "goals/tip_position": ((f, m, 3), "f", "m", "base"),
        "goals/tip_orientation": ((f, m, 4), "f", "1", "base"),
        "goals/reachable": ((f, m), "u", "1", None),
        "goals/shoulder_position": ((f, 3), "f", "m", "base"),
        "goals/elbow_position": ((f, 3), "f", "m", "base"),
        "goals/wrist_position": ((f, 3), "f", "m", "base"),
        "goals/wrist_orientation": ((f, 4), "f", "1", "base"),
        "goals/finger_joint_position": ((f, 5 if f else 0, 3), "f", "m", "base"),
        "mapped/position": ((f, n), "f", "rad or m", None),
        "mapped/tip_error": ((f, m), "f", "m", None),
        "mapped/tip_orientation_error": ((f, m), "f", "rad", None),
        "mapped/objective": ((f,), "f", "1", None),
        "mapped/humanlikeness": ((f, 3 if f else 0), "f", "m^2,m^2,m^3", None),
        "mapped/status": ((f,), "u", "1", None),
    }


def findings_of(group, count):
    return {**{f"{group}/{d}": ((count,), "f", "s", None) for d in ("begin_s", "end_s")},
            **{f"{group}/{d}": ((count,), "S", "", None) for d in ("cause", "subject", "other_body", "unit")},
            **{f"{group}/{d}": ((count,), "f", "m or rad", None) for d in ("excess", "limit")}}


def repair(steps):
    return {f"repair/{name}": ((steps,), kind, unit, None) for name, kind, unit in [
        ("level", "i", "1"), ("name", "S", ""), ("begin_s", "f", "s"), ("end_s", "f", "s"),
        ("max_joint_change", "f", "rad or m"), ("finding_count", "i", "1"), ("collision_depth_sum", "f", "m"),
        ("other_depth_sum", "f", "m"), ("worst_finding", "S", ""), ("accepted", "u", "1"),
        ("stop_reason", "S", "")]}


def rows(phases, findings, waypoints, joints, estimated):
    return {
        "goals/estimated": ((estimated,), "S", "", None),
        "phases/name": ((phases,), "S", "", None),
        **{f"phases/{d}": ((phases,), "f", "s", None) for d in ("begin_s", "end_s")},
        "phases/confidence": ((phases,), "f", "1", None),
        **findings_of("findings", findings),
        "path/position": ((waypoints, joints), "f", "rad or m", None),
        "path/origin": ((waypoints,), "u", "1", None),
        "path/demonstration_time": ((waypoints,), "f", "s", None),
    }


PLAN_ATTRIBUTES = ["status", "reason", "detail", "subject", "task", "hand", "begin_s", "end_s",
                   "target", "required_clearance", "max_penetration", "tracking_tolerance_grasp", "tracking_tolerance",
                   "max_unreachable_share", "max_tip_error", "max_missing_goal_share", "max_goal_gap_s",
                   "source", "licence"]
QUALITY = ["friction_coefficient", "torsional_friction", "mass", "centre_of_mass", "characteristic_length",
           "epsilon_lower", "epsilon_upper", "required_force_worst", "required_force_gravity", "available_force"]
CERTIFICATE = ["joint_limit_margin", "velocity_ratio", "acceleration_ratio", "jerk_ratio", "clearance",
               "tip_error_max", "tip_error_mean", "tip_error_grasp",
               "tip_orientation_error_max", "upper_arm_error_mean", "upper_arm_error_max",
               "forearm_error_mean", "forearm_error_max", "swivel_error_mean", "swivel_error_max", "palm_error_mean",
               "palm_error_max", "wrist_speed_correlation", "held_drift", "held_turn", "natural_posture_error", "duration_ratio",
               "humanlikeness_mapped", "humanlikeness_final", "sparc_robot", "sparc_human",
               "log_dimensionless_jerk_robot", "log_dimensionless_jerk_human", "repaired"]

with h5py.File(sys.argv[1]) as file:
    attributes(file, ["format", "version", "config", "config_sha256", "dataset_sha256", "settings", "inputs_sha256", "software",
                      "built_with",
                      "robot"])
    assert text(file.attrs["format"]) == "morphe-plans" and file.attrs["version"] == 3
    assert text(file.attrs["config"]) == "seed: 7\n" + "#" * 100000 + "\n"
    assert file["inputs/../robots/dlr.yaml"].asstr()[()] == "name: dlr_hit2 °\n"

    robot = file["robot"]
    attributes(robot, ["name", "shoulder_frame", "palm_frame", "side"])
    assert file.attrs["robot"] == robot.attrs["name"] == b"three"
    shapes(robot, {
        "joint_names": ((3,), "S", "", None),
        "lower": ((3,), "f", "rad or m", None), "upper": ((3,), "f", "rad or m", None),
        "velocity": ((3,), "f", "rad or m/s", None), "acceleration": ((3,), "f", "rad or m/s^2", None),
        "jerk": ((3,), "f", "rad or m/s^3", None),
        "frames/name": ((4,), "S", "", None), "frames/parent": ((4,), "i", "1", None),
        "frames/transform": ((4, 4, 4), "f", "m", "parent"),
        "frames/axis": ((4, 3), "f", "1", "joint"), "frames/joint": ((4,), "i", "1", None),
        "frames/ratio": ((4,), "f", "1", None), "frames/offset": ((4,), "f", "rad or m", None),
        "frames/prismatic": ((4,), "u", "1", None),
        "coupled_limits/frame": ((1,), "i", "1", None),
        "coupled_limits/lower": ((1,), "f", "rad or m", None),
        "coupled_limits/upper": ((1,), "f", "rad or m", None),
        "coupled_limits/velocity": ((1,), "f", "rad or m/s", None),
        "coupled_limits/acceleration": ((1,), "f", "rad or m/s^2", None),
        "coupled_limits/jerk": ((1,), "f", "rad or m/s^3", None),
        "braking_curves/joint": ((1,), "i", "1", None),
        "braking_curves/twice_deceleration": ((1,), "f", "rad or m/s^2", None),
        "braking_curves/velocity_offset": ((1,), "f", "rad or m/s", None),
        "braking_curves/lower_end": ((1,), "f", "rad or m", None),
        "braking_curves/upper_end": ((1,), "f", "rad or m", None),
        "unchecked_links": ((2,), "S", "", None),
        "tips/name": ((2,), "S", "", None), "tips/frame": ((2,), "i", "1", None),
        "tips/transform": ((2, 4, 4), "f", "m", "joint"), "tips/finger": ((2,), "i", "1", None),
        "tips/finger_curve_share": ((2,), "f", "1", None),
        "joint_centres/frame": ((2,), "i", "1", None), "joint_centres/chain": ((2,), "S", "", None),
        "capsules/name": ((3,), "S", "", None), "capsules/frame": ((3,), "i", "1", None),
        "capsules/from": ((3, 3), "f", "m", "joint"), "capsules/to": ((3, 3), "f", "m", "joint"),
        "capsules/radius": ((3,), "f", "m", None),
        "capsules/may_touch_target": ((3,), "u", "1", None),
        "allowed_collision_pairs": ((2, 2), "i", "1", None),
    })
    assert list(robot["joint_names"].asstr()) == ["S1", "E1", "index_distal"]
    transform = robot["frames/transform"][0]
    assert np.array_equal(transform[3], [0, 0, 0, 1]) and np.array_equal(transform[1:3, 3], [2, 3])
    assert np.allclose(transform[:3, :3], [[np.cos(.3), 0, np.sin(.3)], [0, 1, 0],
                                           [-np.sin(.3), 0, np.cos(.3)]], rtol=0, atol=1e-15)

    assert list(file["plans"]) == ["zz"] and list(file["plans/zz"]) == ["000", "001"]
    full, bare = file["plans/zz/000"], file["plans/zz/001"]
    for plan in (full, bare):
        attributes(plan, PLAN_ATTRIBUTES + (["max_link_penetration", "branch"] if plan is full else []))
        attributes(plan["certificate"], CERTIFICATE)
        attributes(plan["goals"], ["common_base_offset"])
        assert text(plan["mapped/status"].attrs["meaning"]) == \
            "0=met,1=compromise,2=out_of_reach,3=no_goal"
        assert text(plan["path/origin"].attrs["meaning"]) == ORIGINS
    scene = ["zebra", "cup", "bottle", "pen", "apple"]
    assert list(full["scene"]) == scene
    shapes(full, {
        **frames(4, 2, 3), **rows(2, 2, 5, 3, 2), **trajectory("trajectory", 6),
        **trajectory("approach", 2), **trajectory("retreat", 3),
        **flags(3), **assumptions(2), **repair(2), **findings_of("remaining_findings", 1),
        **{f"scene/{name}/{data}": what for k, name in enumerate(scene)
           for data, what in {"time": ((k + 1,), "f", "s", None),
                              "position": ((k + 1, 3), "f", "m", "base"),
                              "orientation": ((k + 1, 4), "f", "1", "base")}.items()},
        "scene/apple/vertices": ((4, 3), "f", "m", "object"),
        "scene/apple/triangles": ((2, 3), "i", "1", None),
        **{f"reference_frames/{name}": ((4, 4), "f", "m", "base") for name in ("recording", "table", "target")},
        "reference_frames/shoulder": ((3,), "f", "m", "base"),
        "grasp/object_pose": ((4, 4), "f", "m", "base"),
        "grasp/palm_pose_in_object": ((4, 4), "f", "m", "object"),
        "grasp/tips_in_object": ((2, 3), "f", "m", "object"),
        "certificate/unchecked_links": ((1,), "S", "", None),
        **{f"certificate/clearance_by_kind/{name}": ((2,), kind, unit, None) for name, kind, unit in [
            ("kind", "S", ""), ("clearance", "f", "m"), ("first", "S", ""), ("second", "S", ""), ("time", "f", "s")]},
        "branch_words": ((2,), "S", "", None), "branch_changes": ((1,), "S", "", None),
        "grasp/grasp_posture": ((3,), "f", "rad or m", None),
        "grasp/pregrasp_posture": ((3,), "f", "rad or m", None),
        "goals/tip_to_pad_share": ((4, 2), "f", "1", None),
        "goals/auto_closed": ((2,), "u", "1", None),
        **{f"grasp/contacts/{name}": ((2,), "S", "", None) for name in ("tip", "link", "origin", "state")},
        **{f"grasp/contacts/{name}": ((2, 3), "f", unit, "object")
           for name, unit in {"demonstrated_point": "m", "desired_point": "m", "point": "m", "normal": "1",
                              "friction_force": "N"}.items()},
        **{f"grasp/contacts/{name}": ((2,), "f", unit, None)
           for name, unit in {"signed_distance": "m", "pad_angle": "rad", "confidence": "1", "normal_force": "N"}.items()},
        "grasp/grasp_force/torque": ((3,), "f", "N m", None),
        "grasp/grasp_force/servo_target": ((3,), "f", "rad or m", None),
    })
    attributes(full["grasp/quality"], QUALITY)
    assert text(full.attrs["status"]) == "executable" and text(full.attrs["reason"]) == ""
    assert (full.attrs["begin_s"], full.attrs["end_s"], text(full.attrs["target"])) == (0.5, 2.75, "cup")
    assert [full.attrs[name] for name in PLAN_ATTRIBUTES[9:15]] == [0.002, 0.004, 0.006, 0.03, 0.25, 0.04]
    assert full["grasp"].attrs["sample"] == 2
    assert full["certificate"].attrs["repaired"] == 1
    assert np.isnan(full["certificate"].attrs["tip_orientation_error_max"])
    assert text(full["trajectory/phase"].attrs["meaning"]) == PHASES
    assert list(full["trajectory/phase"]) == [1, 2, 3, 4, 5, 6]
    assert full.attrs["branch"] == 3
    assert list(full["branch_words"].asstr()) == ["shoulder left", "elbow negative"]
    assert list(full["path/origin"]) == [2, 1, 0, 0, 2]
    assert list(full["findings/cause"].asstr()) == ["object_collision", "joint_limit"]
    assert list(full["repair/name"].asstr()) == ["detour", "attempt 1"] and list(full["repair/accepted"]) == [1, 0]
    assert list(full["remaining_findings/subject"].asstr()) == ["index_tip"]
    assert text(full["scene/cup"].attrs["attached_frame"]) == "palm"
    assert full["scene/cup"].attrs["attach_s"] == 1.25
    assert [text(full["scene/cup"].attrs[f"{of}_origin"]) for of in ("pose", "shape")] == ["inferred", "configured"]
    assert "pose_origin" not in full["scene/zebra"].attrs
    assert list(full["certificate/clearance_by_kind/kind"].asstr()) == ["self", "target"]
    assert list(file["assumptions/kind"].asstr()) == ["set_by_hand", "inferred"]
    assert full["goals"].attrs["common_base_offset"].shape == (3,)

    shapes(bare, {**frames(0, 0, 0), **rows(0, 0, 0, 0, 0)})
    assert text(bare.attrs["status"]) == "infeasible"
    assert text(bare.attrs["reason"]) == "no_goal"
