"""Reads one plan of a plans.h5."""
from __future__ import annotations

import math
from typing import Optional

from .hdf5 import Node
from .motion import Motion, read_motion
from .plan import (ASSUMPTION_KINDS, STATUSES, Assumption, Certificate, Contact, Finding, Goals, Grasp, KindClearance,
                   Phase, Plan, Quality, SceneObject)
from .robot import Robot

TABLE = "table"  # the name of the object that scene.table of a config makes


def read_assumptions(node: Node) -> tuple[Assumption, ...]:
    """Returns those that a group has; none if it has no list."""
    if not node.has("assumptions"):
        return ()
    group = node.group("assumptions")
    found = group.rows(Assumption)
    for each in found:
        if each.kind not in ASSUMPTION_KINDS:
            group.fail("kind", f"has the unknown value '{each.kind}'")
    return found


def read_status(node: Node) -> str:
    status = node.text("status")
    if status not in STATUSES:
        node.fail("@status", f"is '{status}', not {', '.join(STATUSES)}")
    return status


def read_plan(node: Node, name: str, robot: Robot, of_file: tuple[Assumption, ...]) -> Plan:
    demonstration, movement = name.split("/")
    status, target = read_status(node), node.text("target")
    scene = _read_scene(node.group("scene"))
    motions = {motion: _read_motion_of(node, motion, robot) for motion in ("trajectory", "approach", "retreat")}
    if (motions["trajectory"] is None) != (status == "infeasible"):
        node.fail("trajectory", f"is {'missing' if motions['trajectory'] is None else 'there'}, but the plan is {status}")
    assumptions = (*read_assumptions(node), *_of_objects(scene, target), *of_file)
    return Plan(
        name=name, demonstration=demonstration, movement=movement, status=status, reason=node.text("reason"),
        detail=node.text("detail"), delivered_until=node.text("delivered_until", ""),
        requested_end_s=node.number("requested_end_s", math.nan), subject=node.text("subject"), task=node.text("task"),
        hand=node.text("hand"), target=target, source=node.text("source", ""), licence=node.text("licence", ""),
        begin_s=node.number("begin_s"), end_s=node.number("end_s"), required_clearance=node.number("required_clearance"),
        tracking_tolerance_grasp=node.number("tracking_tolerance_grasp"), tracking_tolerance=node.number("tracking_tolerance"),
        branch=node.texts("branch_words") if node.has("branch_words") else (), robot=robot,
        goals=_read_goals(node.group("goals"), len(robot.tips)), phases=node.group("phases").rows(Phase), scene=scene,
        findings=node.group("findings").rows(Finding), grasp=_read_grasp(node, robot, motions["trajectory"]), **motions,
        certificate=_read_certificate(node.group("certificate")),
        assumptions=tuple(sorted(assumptions, key=lambda each: ASSUMPTION_KINDS.index(each.kind))))


def _read_motion_of(node: Node, name: str, robot: Robot) -> Optional[Motion]:
    return read_motion(node, name, robot.joint_names) if node.has(name) else None


def _read_goals(node: Node, tips: int) -> Goals:
    time = node.array("time", -1)
    count = len(time)
    points = {name: node.array(name, count, 3) for name in ("shoulder_position", "elbow_position", "wrist_position")}
    return Goals(time=time, tip_position=node.array("tip_position", count, tips, 3),
                 tip_orientation=node.array("tip_orientation", count, tips, 4), reachable=node.array("reachable", count, tips),
                 wrist_orientation=node.array("wrist_orientation", count, 4), **points)


def _read_scene(node: Node) -> tuple[SceneObject, ...]:
    return tuple(_read_object(node.group(name), name) for name in node.names())


def _read_object(node: Node, name: str) -> SceneObject:
    shape = node.text("shape")
    time = node.array("time", -1)
    mesh = shape == "mesh"
    return SceneObject(
        name=name, shape=shape, size=node.vector("size", ()), time=time, position=node.array("position", len(time), 3),
        orientation=node.array("orientation", len(time), 4), vertices=node.array("vertices", -1, 3) if mesh else None,
        triangles=node.array("triangles", -1, 3) if mesh else None, attached_frame=node.text("attached_frame", ""),
        attach_s=node.number("attach_s", math.nan), release_s=node.number("release_s", math.nan),
        pose_origin=node.text("pose_origin", ""), shape_origin=node.text("shape_origin", ""))


def _of_objects(scene: tuple[SceneObject, ...], target: str) -> tuple[Assumption, ...]:
    """Says of objects what their origins say (docs/certificate.md)."""
    found = []
    for each in scene:
        subject = "table" if each.name == TABLE else "target" if each.name == target else "object"
        inferred = [what for what, origin in (("pose", each.pose_origin), ("shape", each.shape_origin)) if origin == "inferred"]
        if each.name == TABLE:  # the pose of a table is its height; its shape is of no matter
            inferred = [what for what in inferred if what == "pose"]
        if inferred:
            found.append(Assumption("inferred", subject, f"{each.name}: {' and '.join(inferred)}, from the recording"))
        elif not each.pose_origin and subject != "object":
            found.append(Assumption("assumed", subject, f"{each.name}: the file does not say whether it was recorded, "
                                                        "configured or inferred"))
    return tuple(found)


def _read_grasp(node: Node, robot: Robot, trajectory: Optional[Motion]) -> Optional[Grasp]:
    if not node.has("grasp"):
        return None
    group, joints = node.group("grasp"), len(robot.joints)
    sample = int(group.number("sample"))
    if sample < 0 or (trajectory is not None and sample >= len(trajectory.time)):
        group.fail("@sample", f"is {sample}, which is no sample of the trajectory")
    return Grasp(
        sample=sample, object_pose=group.array("object_pose", 4, 4),
        palm_pose_in_object=group.array("palm_pose_in_object", 4, 4), tips_in_object=group.array("tips_in_object", len(robot.tips), 3),
        grasp_posture=group.array("grasp_posture", joints), pregrasp_posture=group.array("pregrasp_posture", joints),
        approach_direction=group.vector("approach_direction"),
        contacts=group.group("contacts").rows(Contact) if group.has("contacts") else (),
        quality=group.group("quality").figures(Quality) if group.has("quality") else None)


def _read_certificate(node: Node) -> Certificate:
    return node.figures(
        Certificate, math.nan,
        clearance_by_kind=node.group("clearance_by_kind").rows(KindClearance) if node.has("clearance_by_kind") else (),
        unchecked_links=node.texts("unchecked_links") if node.has("unchecked_links") else ())
