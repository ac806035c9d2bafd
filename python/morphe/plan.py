"""What a plan says, as plain data. Names, units and meanings are those of docs/formats.md (plans.h5)."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

import numpy.typing as npt

from .errors import NoTrajectoryError
from .hdf5 import Floats
from .motion import Motion, State
from .robot import Robot

STATUSES = ("executable", "approximate", "partial", "infeasible")
ASSUMPTION_KINDS = ("inferred", "assumed", "set_by_hand", "not_looked_at")


@dataclass(frozen=True)
class Assumption:
    """A value on which a plan rests and which nobody measured, or a thing that no step looked at."""

    kind: str  #: one of ASSUMPTION_KINDS
    subject: str
    value: str


@dataclass(frozen=True)
class Phase:
    name: str
    begin_s: float  #: in the demonstration
    end_s: float
    confidence: float


@dataclass(frozen=True)
class Finding:
    """A fault of the mapped path, before it was repaired."""

    begin_s: float
    end_s: float
    cause: str
    subject: str
    other_body: str
    excess: float
    unit: str
    limit: float


@dataclass(frozen=True)
class Goals:
    """The person's points that the robot follows, in its base frame; NaN: no goal."""

    time: Floats  #: [F] s of the demonstration
    tip_position: Floats  #: [F, m, 3]
    tip_orientation: Floats  #: [F, m, 4] w, x, y, z
    reachable: Floats  #: [F, m] 1: the robot can be there
    shoulder_position: Floats  #: [F, 3]
    elbow_position: Floats  #: [F, 3]
    wrist_position: Floats  #: [F, 3]
    wrist_orientation: Floats  #: [F, 4]


@dataclass(frozen=True)
class SceneObject:
    """An object and its recorded poses in the robot's base frame (one row: it stands still). From attach_s to
    release_s (of the demonstration) the target moves with the frame `attached_frame` instead."""

    name: str
    shape: str
    size: Floats
    time: Floats  #: [K]
    position: Floats  #: [K, 3]
    orientation: Floats  #: [K, 4]
    vertices: Optional[Floats]  #: [V, 3] of a mesh
    triangles: Optional[Floats]  #: [W, 3]
    attached_frame: str  #: "": it does not move with the hand
    attach_s: float  #: NaN: never
    release_s: float
    pose_origin: str  #: configured, recorded, inferred; "": not known
    shape_origin: str


@dataclass(frozen=True)
class Contact:
    """A planned contact of a pad with the target, in the target's frame."""

    tip: str
    link: str
    origin: str
    state: str  #: touching, or near
    demonstrated_point: Floats  #: [3] NaN: the person touched nothing with it
    desired_point: Floats
    point: Floats
    normal: Floats  #: inwards
    signed_distance: float  #: below 0: penetration
    pad_angle: float
    confidence: float
    normal_force: float  #: NaN: near
    friction_force: Floats


@dataclass(frozen=True)
class Quality:
    """Bounds of a grasp's quality for the friction and the mass that are assumed."""

    friction_coefficient: float
    torsional_friction: float
    mass: float
    centre_of_mass: Floats
    characteristic_length: float
    epsilon_lower: float
    epsilon_upper: float
    required_force_worst: float
    required_force_gravity: float
    available_force: float


@dataclass(frozen=True)
class Grasp:
    sample: int  #: of the trajectory; of the path in a plan without one
    object_pose: Floats  #: [4, 4] in the base frame
    palm_pose_in_object: Floats  #: [4, 4]
    tips_in_object: Floats  #: [m, 3]
    grasp_posture: Floats  #: [n]
    pregrasp_posture: Floats  #: [n]
    approach_direction: Floats  #: [3] in the target's frame; NaN: the palm hardly moved
    contacts: tuple[Contact, ...]  #: empty without the config's section `grasp`
    quality: Optional[Quality]


@dataclass(frozen=True)
class KindClearance:
    """The least distance of a kind of pair that may not touch."""

    kind: str  #: self, table, objects, target
    clearance: float
    first: str
    second: str
    time: float  #: of the trajectory


@dataclass(frozen=True)
class Certificate:
    """What the planner certified of the curve. Reading it proves nothing: morphe.verify does. NaN: does not
    apply, or the file is of a version that did not compute it."""

    joint_limit_margin: float
    velocity_ratio: float
    acceleration_ratio: float
    jerk_ratio: float
    clearance: float
    tip_error_max: float
    tip_error_mean: float
    tip_error_grasp: float
    tip_orientation_error_max: float
    upper_arm_error_mean: float
    upper_arm_error_max: float
    forearm_error_mean: float
    forearm_error_max: float
    swivel_error_mean: float
    swivel_error_max: float
    palm_error_mean: float
    palm_error_max: float
    wrist_speed_correlation: float
    held_drift: float
    held_turn: float
    duration_ratio: float
    natural_posture_error: float
    humanlikeness_mapped: float
    humanlikeness_final: float
    repaired: float
    sparc_robot: float
    sparc_human: float
    log_dimensionless_jerk_robot: float
    log_dimensionless_jerk_human: float
    clearance_by_kind: tuple[KindClearance, ...]
    unchecked_links: tuple[str, ...]  #: links with a body whose contacts nobody checked


@dataclass(frozen=True)
class Plan:
    """A plan; it stays valid after its file is closed. Only status `executable` does the person's whole task."""

    name: str  #: demonstration/movement, as the program prints it
    demonstration: str
    movement: str
    status: str  #: one of STATUSES
    reason: str  #: "" unless infeasible or partial
    detail: str
    delivered_until: str  #: the last phase of a partial plan, otherwise ""
    requested_end_s: float  #: of a partial plan, otherwise NaN
    subject: str
    task: str
    hand: str
    target: str  #: "": nothing is grasped
    source: str
    licence: str
    begin_s: float
    end_s: float
    required_clearance: float
    tracking_tolerance_grasp: float
    tracking_tolerance: float
    branch: tuple[str, ...]  #: words: shoulder, elbow, wrist
    robot: Robot
    goals: Goals
    phases: tuple[Phase, ...]
    scene: tuple[SceneObject, ...]
    findings: tuple[Finding, ...]
    grasp: Optional[Grasp]
    trajectory: Optional[Motion]
    approach: Optional[Motion]
    retreat: Optional[Motion]
    certificate: Certificate
    assumptions: tuple[Assumption, ...]  #: of the recording, of the objects, and of the whole file; by kind

    def motion(self) -> Motion:
        """Returns the trajectory, or raises NoTrajectoryError with the plan's reason."""
        if self.trajectory is None:
            raise NoTrajectoryError(f"{self.name} has no trajectory: {self.status}, {self.reason}: {self.detail}")
        return self.trajectory

    @property
    def duration(self) -> float:
        return self.motion().duration

    def at(self, time: npt.ArrayLike) -> State:
        """Returns the trajectory's curve at one time or several [s]; see Motion.at."""
        return self.motion().at(time)

    def frame_poses(self, time: npt.ArrayLike) -> Floats:
        """Returns the poses [..., J, 4, 4] of all frames of the robot."""
        return self.robot.frame_poses(self.at(time).position)

    def tip_poses(self, time: npt.ArrayLike) -> Floats:
        """Returns the poses [..., m, 4, 4] of the tips."""
        return self.robot.tip_poses(self.at(time).position)

    def palm_pose(self, time: npt.ArrayLike) -> Floats:
        """Returns the pose [..., 4, 4] of the palm."""
        return self.robot.palm_pose(self.at(time).position)

    def assumptions_of(self, kind: str) -> tuple[Assumption, ...]:
        """Returns the assumptions of a kind: inferred, assumed, set_by_hand or not_looked_at."""
        if kind not in ASSUMPTION_KINDS:
            raise ValueError(f"unknown kind '{kind}'; the kinds are {', '.join(ASSUMPTION_KINDS)}")
        return tuple(each for each in self.assumptions if each.kind == kind)
