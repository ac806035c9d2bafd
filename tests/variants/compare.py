"""The difference of two plans of the same motion."""
from dataclasses import asdict, dataclass, field

import numpy as np

SAME_JOINTS_RAD = 0.05


@dataclass
class Difference:
    recording: str
    movement: int
    robot: str
    variant: str
    status: str
    original_status: str
    branch: str = ""
    original_branch: str = ""
    same_status: bool = False
    same_branch: bool = False
    joints_rad: float = np.nan        # largest, of the mapped paths
    arm_rad: float = np.nan           # the same of the joints that move the palm
    driven_rad: float = np.nan        # of the trajectories, at equal times of the demonstration
    palm_deg: float = np.nan          # largest, of the mapped paths
    elbow_mm: float = np.nan
    objective_ratio: float = np.nan   # of the variant's mean to the original's
    duration_ratio: float = np.nan
    original_duration_ratio: float = np.nan
    wound: list = field(default_factory=list)

    def same_joints(self):
        return self.joints_rad <= SAME_JOINTS_RAD

    def as_json(self):
        return {key: None if isinstance(value, float) and np.isnan(value) else value
                for key, value in asdict(self).items()}


def at_times(path, wanted):
    time, joints = path
    return np.stack([np.interp(wanted, time, column) for column in joints.T], axis=1)


def both_paths(one, other):
    """Joints of two paths at the times of the first that both have; None without such times."""
    if not len(one[0]) or not len(other[0]):
        return None
    wanted = one[0][(one[0] >= other[0][0]) & (one[0] <= other[0][-1])]
    return (at_times(one, wanted), at_times(other, wanted)) if len(wanted) else None


def largest_joint_difference(one, other, joints=slice(None)):
    paths = both_paths(one, other)
    return float(np.abs(paths[0] - paths[1])[:, joints].max()) if paths else np.nan


def arm_joints(robot):
    frame, found = robot.palm, set()
    while frame >= 0:
        found.add(int(robot.frames["joint"][frame]))
        frame = robot.frames["parent"][frame]
    return sorted(found - {-1})


def palm_and_elbow(robot, one, other):
    """(angle of the palm [deg], distance of the elbow [mm]), both the largest."""
    paths = both_paths(one, other)
    if not paths:
        return np.nan, np.nan
    a, b = (robot.frame_poses(path) for path in paths)
    turn = np.einsum("nji,njk->nik", a[:, robot.palm, :3, :3], b[:, robot.palm, :3, :3])
    cosine = (np.trace(turn, axis1=1, axis2=2) - 1) / 2
    elbows = [frame for frame, chain in zip(robot.centres, robot.chains) if chain == "arm"]
    elbow = np.nan
    if elbows:
        elbow = 1000 * np.linalg.norm(a[:, elbows[0], :3, 3] - b[:, elbows[0], :3, 3], axis=1).max()
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max()), float(elbow)


def compare(one, other, **names):
    """The difference of a variant's plan from the original's."""
    found = Difference(**names, status=one.status, original_status=other.status)
    found.same_status = one.status == other.status
    if one.branch is None or other.branch is None:
        found.same_branch = one.branch is other.branch
        return found
    found.branch, found.original_branch = (", ".join(plan.branch.words()) for plan in (one, other))
    found.same_branch = found.branch == found.original_branch
    found.joints_rad = largest_joint_difference(one.mapped, other.mapped)
    found.arm_rad = largest_joint_difference(one.mapped, other.mapped, arm_joints(one.robot))
    found.driven_rad = largest_joint_difference(one.driven, other.driven)
    found.palm_deg, found.elbow_mm = palm_and_elbow(one.robot, one.mapped, other.mapped)
    found.objective_ratio = one.objective / other.objective if other.objective > 0 else np.nan
    found.duration_ratio, found.original_duration_ratio = one.duration_ratio, other.duration_ratio
    found.wound = [f"{joint} {turns:+d}" for joint, turns in one.branch.wound.items()]
    return found
