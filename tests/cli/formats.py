"""docs/formats.md as a table: dataset -> (shape, unit, frame or None). A letter of a shape stands for
the same number everywhere in its group of the table; a number for itself."""
import h5py

PLANS_ROOT = "format version config config_sha256 dataset_sha256 settings inputs_sha256 software built_with robot".split()
ROBOT_ATTRIBUTES = "name shoulder_frame palm_frame side".split()
ROBOT = {
    "joint_names": ("n", "", None),
    "lower": ("n", "rad", None), "upper": ("n", "rad", None), "velocity": ("n", "rad/s", None),
    "acceleration": ("n", "rad/s^2", None), "jerk": ("n", "rad/s^3", None),
    "frames/name": ("J", "", None), "frames/parent": ("J", "1", None),
    "frames/transform": ("J44", "m", "parent"), "frames/axis": ("J3", "1", "joint"),
    "frames/joint": ("J", "1", None), "frames/ratio": ("J", "1", None),
    "frames/offset": ("J", "rad", None),
    "tips/name": ("m", "", None), "tips/frame": ("m", "1", None),
    "tips/transform": ("m44", "m", "joint"), "tips/finger": ("m", "1", None),
    "joint_centres/frame": ("k", "1", None), "joint_centres/chain": ("k", "", None),
    "capsules/name": ("c", "", None), "capsules/frame": ("c", "1", None),
    "capsules/from": ("c3", "m", "joint"), "capsules/to": ("c3", "m", "joint"),
    "capsules/radius": ("c", "m", None), "capsules/may_touch_target": ("c", "1", None),
    "allowed_collision_pairs": ("a2", "1", None),
}

PLAN_ATTRIBUTES = ("status reason detail subject task source licence hand begin_s end_s target required_clearance max_penetration "
                   "tracking_tolerance_grasp tracking_tolerance").split()
CERTIFICATE = ("joint_limit_margin velocity_ratio acceleration_ratio jerk_ratio clearance "
               "tip_error_max tip_error_mean tip_error_grasp tip_orientation_error_max "
               "upper_arm_error_mean upper_arm_error_max forearm_error_mean forearm_error_max "
               "swivel_error_mean swivel_error_max palm_error_mean palm_error_max "
               "wrist_speed_correlation held_drift held_turn duration_ratio humanlikeness_mapped "
               "humanlikeness_final sparc_robot sparc_human log_dimensionless_jerk_robot "
               "log_dimensionless_jerk_human repaired").split()
PLAN = {
    "goals/time": ("F", "s", None),
    "goals/tip_position": ("Fm3", "m", "base"), "goals/tip_orientation": ("Fm4", "1", "base"),
    "goals/reachable": ("Fm", "1", None),
    "goals/shoulder_position": ("F3", "m", "base"), "goals/elbow_position": ("F3", "m", "base"),
    "goals/wrist_position": ("F3", "m", "base"), "goals/wrist_orientation": ("F4", "1", "base"),
    "goals/finger_joint_position": ("F53", "m", "base"), "goals/estimated": ("E", "", None),
    "phases/name": ("P", "", None), "phases/begin_s": ("P", "s", None),
    "phases/end_s": ("P", "s", None), "phases/confidence": ("P", "1", None),
    "mapped/position": ("Fn", "rad", None), "mapped/tip_error": ("Fm", "m", None),
    "mapped/tip_orientation_error": ("Fm", "rad", None), "mapped/objective": ("F", "1", None),
    "mapped/humanlikeness": ("F3", "m^2,m^2,m^3", None), "mapped/status": ("F", "1", None),
    "findings/begin_s": ("D", "s", None), "findings/end_s": ("D", "s", None),
    "findings/cause": ("D", "", None), "findings/subject": ("D", "", None),
    "findings/other_body": ("D", "", None), "findings/excess": ("D", "m or rad", None),
    "findings/unit": ("D", "", None), "findings/limit": ("D", "m or rad", None),
    "path/position": ("Wn", "rad", None), "path/origin": ("W", "1", None),
    "path/demonstration_time": ("W", "s", None),
}
TRAJECTORY = {
    "time": ("T", "s", None), "position": ("Tn", "rad", None), "velocity": ("Tn", "rad/s", None),
    "acceleration": ("Tn", "rad/s^2", None), "demonstration_time": ("T", "s", None),
    "phase": ("T", "1", None), "origin": ("T", "1", None), "clearance": ("T", "m", None),
}
GRASP = {
    "object_pose": ("44", "m", "base"), "palm_pose_in_object": ("44", "m", "object"),
    "tips_in_object": ("m3", "m", "object"), "grasp_posture": ("n", "rad", None),
    "pregrasp_posture": ("n", "rad", None),
}
OBJECT = {"time": ("K", "s", None), "position": ("K3", "m", "base"),
          "orientation": ("K4", "1", "base")}

DEMONSTRATION_ATTRIBUTES = "subject task hand source licence upper_arm forearm".split()
MARKERS = {"markers/time": ("N", "s", None), "markers/position": ("NM3", "m", "world"),
           "calibration/markers/time": ("C", "s", None),
           "calibration/markers/position": ("CQ3", "m", "world")}

MEANINGS = {
    "mapped/status": "0=met,1=compromise,2=out_of_reach,3=no_goal",
    "trajectory/phase": "0=rest,1=reach,2=preshape,3=grasp,4=hold,5=transport,6=return,"
                        "7=approach,8=lift,9=place,10=release,11=retreat,12=home",
    "trajectory/origin": "0=mapped,1=re_solved,2=planned",
}


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def faults(group, table, sizes):
    """What differs from the table; `sizes` binds letters to numbers and grows."""
    found = []
    for name, (shape, unit, frame) in table.items():
        data = group.get(name)
        if not isinstance(data, h5py.Dataset):
            found.append(f"{group.name}/{name} is not there")
            continue
        wanted = tuple(int(s) if s.isdigit() else sizes.setdefault(s, actual)
                       for s, actual in zip(shape, data.shape))
        if len(shape) != data.ndim or data.shape != wanted:
            found.append(f"{data.name}: {data.shape} is not {shape} with {sizes}")
        if text(data.attrs.get("unit", "none")) != unit:
            found.append(f"{data.name}: unit is not {unit!r}")
        if text(data.attrs.get("frame", "none")) != (frame or "none"):
            found.append(f"{data.name}: frame is not {frame!r}")
        if data.dtype.kind == "f" and data.dtype != "f8":
            found.append(f"{data.name}: {data.dtype} is not float64")
    return found


def strings(file):
    """(where, string) of every name, attribute and string dataset of a file."""
    def of(where, value):
        for item in value.reshape(-1) if hasattr(value, "reshape") else [value]:
            if isinstance(item, (bytes, str)):
                yield where, text(item)

    items = [file]
    file.visititems(lambda name, item: items.append(item))
    for item in items:
        yield "a name", item.name
        for name, value in item.attrs.items():
            yield from of(f"{item.name}@{name}", value)
        if isinstance(item, h5py.Dataset) and item.dtype.kind in "SO":
            yield from of(item.name, item[()])
