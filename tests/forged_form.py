"""Lies about the form of the file, about what follows from the config, and in plans without a trajectory:
kinds of tests/forged_plans.py."""
import h5py
import numpy as np

from forger import lie, need, transfer
from verify_geometry import text

# The form of the file: what readers of Morphe ignore, and others may trust

def dataset(f, names):
    found = [name for name in names if isinstance(f.plan.get(name), h5py.Dataset) and f.plan[name].size]
    need(found)
    return str(f.rng.choice(found))

def fresh(f, name, values):
    need(name not in f.plan)
    f.plan[name] = values
    f.plan[name].attrs["unit"] = np.bytes_("rad")

def restamp(f, name, attribute, value):
    need(text(f.plan[name].attrs.get(attribute, b"")) != value)
    f.plan[name].attrs[attribute] = np.bytes_(value)

ANGLES = ("trajectory/position", "mapped/position", "path/position", "grasp/grasp_posture", "approach/position")
LENGTHS = ("goals/tip_position", "goals/wrist_position", "trajectory/clearance", "mapped/tip_error",
           "grasp/tips_in_object", "reference_frames/target")

@lie("form of the file")
def a_second_position(f):
    fresh(f, "trajectory/position_corrected", f.plan["trajectory/position"][()] * 1.01)

@lie("form of the file")
def a_second_time(f):
    fresh(f, "trajectory/time_scaled", f.plan["trajectory/time"][()] / 3)

@lie("form of the file")
def a_second_trajectory(f):
    f.file.copy(f.plan["trajectory"], f.plan, "trajectory_executable")

@lie("form of the file")
def a_torque_nobody_computed(f):
    fresh(f, "trajectory/torque", np.zeros_like(f.plan["trajectory/position"][()]))

@lie("form of the file")
def a_member_of_the_goals(f):
    fresh(f, "goals/force", np.ones(len(f.plan["goals/time"])))

@lie("form of the file")
def a_member_of_the_mapping(f):
    fresh(f, "mapped/weight", np.ones(len(f.plan["goals/time"])))

@lie("form of the file")
def a_member_of_the_path(f):
    fresh(f, "path/time", f.plan["path/demonstration_time"][()])

@lie("form of the file")
def a_member_of_the_phases(f):
    fresh(f, "phases/speed", np.ones(len(f.plan["phases/name"])))

@lie("form of the file")
def a_member_of_the_grasp(f):
    need("grasp" in f.plan)
    fresh(f, "grasp/force", np.ones(3))

@lie("form of the file")
def a_member_of_the_approach(f):
    fresh(f, transfer(f) + "/torque", np.ones(3))

@lie("form of the file")
def a_frame_of_reference_more(f):
    need("reference_frames" in f.plan)
    fresh(f, "reference_frames/camera", np.eye(4))

@lie("form of the file")
def a_member_of_an_object(f):
    body = f.object()
    need("vertices" not in body)
    body["vertices"] = np.zeros((3, 3))

@lie("form of the file")
def a_mass_of_an_object(f):
    f.object().attrs["mass"] = 0.1

@lie("form of the file")
def a_figure_more_in_the_certificate(f):
    f.plan["certificate"].attrs["max_torque_ratio"] = 0.4

@lie("form of the file")
def a_kind_of_clearance_more(f):
    fresh(f, "certificate/clearance_to_people", np.array([0.5]))

@lie("form of the file")
def a_note_on_the_plan(f):
    f.plan.attrs["certified_by"] = np.bytes_("a notified body")

@lie("form of the file")
def an_attribute_of_the_scene(f):
    f.plan["scene"].attrs["margin"] = 0.1

@lie("form of the file")
def a_factor_on_a_dataset(f):
    f.plan[dataset(f, ANGLES)].attrs["scale_factor"] = 57.29578

@lie("form of the file")
def an_offset_on_a_dataset(f):
    f.plan[dataset(f, LENGTHS)].attrs["add_offset"] = 0.1

@lie("form of the file")
def degrees_for_radians(f):
    restamp(f, dataset(f, ANGLES), "unit", "deg")

@lie("form of the file")
def degrees_a_second(f):
    restamp(f, "trajectory/velocity", "unit", "deg/s")

@lie("form of the file")
def an_acceleration_of_another_unit(f):
    restamp(f, "trajectory/acceleration", "unit", "rad/s")

@lie("form of the file")
def millimetres_for_metres(f):
    restamp(f, dataset(f, LENGTHS), "unit", "mm")

@lie("form of the file")
def milliseconds_for_seconds(f):
    restamp(f, dataset(f, ("trajectory/time", "goals/time", "phases/begin_s")), "unit", "ms")

@lie("form of the file")
def a_dataset_without_unit(f):
    del f.plan[dataset(f, ANGLES + LENGTHS)].attrs["unit"]

@lie("form of the file")
def a_frame_of_another_name(f):
    restamp(f, dataset(f, ("goals/tip_position", "goals/wrist_orientation", "reference_frames/target")), "frame", "world")

@lie("form of the file")
def a_pose_without_frame(f):
    del f.plan[dataset(f, ("goals/tip_position", "goals/elbow_position", "grasp/object_pose"))].attrs["frame"]

@lie("form of the file")
def a_frame_where_none_is(f):
    restamp(f, "trajectory/position", "frame", "palm")

@lie("form of the file")
def an_object_in_another_frame(f):
    f.object()["position"].attrs["frame"] = np.bytes_("world")

@lie("form of the file")
def phases_that_mean_others(f):
    meaning = text(f.plan["trajectory/phase"].attrs["meaning"])
    restamp(f, "trajectory/phase", "meaning", meaning.replace("3=grasp", "3=hold").replace("4=hold", "4=grasp"))

@lie("form of the file")
def origins_that_mean_others(f):
    restamp(f, "trajectory/origin", "meaning", "0=planned,1=re_solved,2=mapped")

@lie("form of the file")
def statuses_without_meaning(f):
    del f.plan["mapped/status"].attrs["meaning"]

@lie("form of the file")
def goals_reachable_the_other_way(f):
    restamp(f, "goals/reachable", "meaning", "0=yes,1=no")

@lie("form of the file")
def halves_of_numbers(f):
    name = dataset(f, ANGLES)
    f.resize(name, f.plan[name][()].astype("f4"))

@lie("form of the file")
def a_phase_of_eight_bytes(f):
    f.resize("trajectory/phase", f.plan["trajectory/phase"][()].astype("i8"))

@lie("form of the file")
def a_tolerance_in_whole_numbers(f):
    f.plan.attrs["required_clearance"] = np.int32(round(f.plan.attrs["required_clearance"]))

@lie("form of the file")
def a_unit_that_is_a_number(f):
    f.plan[dataset(f, ANGLES)].attrs["unit"] = 1.0

@lie("form of the file")
def a_contact_with_a_member_more(f):
    need("grasp/contacts" in f.plan)
    fresh(f, "grasp/contacts/stiffness", np.ones(len(f.plan["grasp/contacts/tip"])))

@lie("form of the file")
def findings_with_a_member_more(f):
    fresh(f, "findings/mended", np.ones(len(f.plan["findings/cause"])))

@lie("form of the file", True)
def a_note_on_the_file(f):
    f.file.attrs["verified"] = np.bytes_("yes")

@lie("form of the file", True)
def a_group_beside_the_plans(f):
    f.file.create_group("plans_corrected").attrs["note"] = np.bytes_("use these")

@lie("form of the file", True)
def a_copy_of_the_plans(f):
    f.file.copy("plans", "plans_of_today")

@lie("form of the file", True)
def limits_in_degrees(f):
    f.file["robot/upper"].attrs["unit"] = np.bytes_("deg")

@lie("form of the file", True)
def a_member_of_the_robot(f):
    f.file["robot/payload"] = np.ones(1)

@lie("form of the file", True)
def a_serial_number_of_the_robot(f):
    f.file["robot"].attrs["serial_number"] = np.bytes_("PA10-7C-0001")

@lie("form of the file", True)
def a_robot_of_another_name(f):
    f.file.attrs["robot"] = np.bytes_("fr3")

@lie("form of the file", True)
def a_note_on_an_input(f):
    names = []
    f.file["inputs"].visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
    f.file["inputs"][names[0]].attrs["checked"] = np.uint8(1)

@lie("form of the file", True)
def a_dataset_of_no_hash(f):
    f.file.attrs["dataset_sha256"] = np.bytes_(f.rng.choice(["none", "unknown", "0" * 63, "G" * 64]))

@lie("form of the file", True)
def a_demonstration_without_movements(f):
    f.file["plans"].create_group("ADL999")

@lie("form of the file", True)
def a_note_on_a_demonstration(f):
    f.plan.parent.attrs["quality"] = np.bytes_("approved")

@lie("form of the file", True)
def a_movement_twice(f):
    f.file.copy(f.plan, f.plan.parent, "001")

@lie("form of the file", True)
def an_assumption_less(f):
    for name in list(f.file["assumptions"]):
        values = f.file["assumptions"][name][1:]
        attributes = dict(f.file["assumptions"][name].attrs)
        del f.file["assumptions"][name]
        f.file["assumptions"][name] = values
        f.file["assumptions"][name].attrs.update(attributes)


# Placement, times and shapes that follow from the config

@lie("what the config says")
def a_motion_slowed(f):
    by = 1 + 1e-3 * f.size
    for name, power in (("time", 1), ("velocity", -1), ("acceleration", -2)):
        f.plan["trajectory"][name][...] = f.plan["trajectory"][name][()] * by**power

@lie("what the config says")
def a_human_arm_elsewhere(f):
    f.plan["goals"].attrs["common_base_offset"] = f.plan["goals"].attrs["common_base_offset"] + 1e-5 * f.size

@lie("what the config says")
def a_human_shoulder_elsewhere(f):
    f.plan["goals/shoulder_position"][...] = f.plan["goals/shoulder_position"][()] + 1e-5 * f.size

@lie("what the config says")
def a_base_moved(f):
    f.plan["goals"].attrs["base_offset"] = f.rng.normal(size=3) * 1e-3 * f.size

@lie("what the config says")
def a_world_turned(f):
    need("reference_frames" in f.plan)
    c, s = np.cos(1e-4 * f.size), np.sin(1e-4 * f.size)
    pose = f.plan["reference_frames/recording"][()]
    f.plan["reference_frames/recording"][...] = pose @ np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])

@lie("what the config says")
def a_shoulder_of_reference_elsewhere(f):
    f.add("reference_frames/shoulder", 1e-5)

@lie("what the config says")
def no_frames_of_reference(f):
    need("reference_frames" in f.plan)
    del f.plan["reference_frames"]

def inferred_target(f):
    target = f.target()
    need(text(target.attrs.get("pose_origin", b"")) == "inferred" and text(target.attrs["shape"]) == "cylinder")
    return target

@lie("what the config says")
def a_target_as_thin_as_a_needle(f):
    target = inferred_target(f)
    target.attrs["size"] = np.array([1e-3, target.attrs["size"][1]])

@lie("what the config says")
def a_thin_target_called_configured(f):
    target = inferred_target(f)
    target.attrs["size"] = np.array([1e-3, target.attrs["size"][1]])
    target.attrs["shape_origin"] = np.bytes_("configured")

@lie("what the config says")
def a_guess_called_configured(f):
    inferred_target(f).attrs["shape_origin"] = np.bytes_("configured")

@lie("what the config says")
def another_arm_thinner(f):
    name = f.rng.choice(["other upper arm", "other forearm", "other hand"])
    need(name in f.plan["scene"])
    body = f.plan["scene"][str(name)]
    body.attrs["size"] = body.attrs["size"] * [0.3, 1]

@lie("what the config says")
def an_approach_sampled_coarsely(f):
    name = transfer(f)
    rows = len(f.plan[name]["time"])
    keep = np.unique(np.r_[0:rows:2, rows - 1])
    for column in list(f.plan[name]):
        f.resize(f"{name}/{column}", f.plan[name][column][()][keep])


# Plans without a trajectory

def infeasible(f):
    f.plan.attrs["status"], f.plan.attrs["reason"] = np.bytes_("infeasible"), np.bytes_("no_path")
    kept = {name: f.plan[name] for name in ("approach", "retreat", "grasp") if name in f.plan}
    del f.plan["trajectory"]
    return kept

def without_certificate(f):
    for name, value in f.plan["certificate"].attrs.items():
        if name not in ("natural_posture_error", "repaired"):
            f.plan["certificate"].attrs[name] = np.nan
    for name in ("clearance_by_kind", "unchecked_links"):
        if name in f.plan["certificate"]:
            del f.plan["certificate"][name]

@lie("infeasible plans")
def infeasible_with_its_certificate(f):
    for name in infeasible(f):
        del f.plan[name]
    f.keep_certificate = True

@lie("infeasible plans")
def infeasible_with_one_figure(f):
    for name in infeasible(f):
        del f.plan[name]
    without_certificate(f)
    f.plan["certificate"].attrs[str(f.rng.choice(["clearance", "tip_error_max", "velocity_ratio"]))] = 0.5
    f.keep_certificate = True

@lie("infeasible plans")
def infeasible_with_an_approach(f):
    kept = infeasible(f)
    need("approach" in kept)
    for name in ("retreat", "grasp"):
        if name in kept:
            del f.plan[name]
    without_certificate(f)

@lie("infeasible plans")
def infeasible_with_a_grasp(f):
    kept = infeasible(f)
    need("grasp" in kept)
    for name in ("approach", "retreat"):
        if name in kept:
            del f.plan[name]
    without_certificate(f)

@lie("infeasible plans")
def infeasible_with_other_tolerances(f):
    for name in infeasible(f):
        del f.plan[name]
    without_certificate(f)
    f.plan.attrs["tracking_tolerance"] *= 1 + 1e-3 * f.size

@lie("infeasible plans")
def infeasible_elsewhere(f):
    for name in infeasible(f):
        del f.plan[name]
    without_certificate(f)
    f.plan["goals"].attrs["common_base_offset"] = f.plan["goals"].attrs["common_base_offset"] + 1e-5 * f.size
