"""Morphe's answer to a recording: its flags, questions and messages, the points that it read and the
plans that it made; and the comparison of two answers."""
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

import h5py
import numpy as np

from take import text_of, write_vicon_csv

sys.path.append(str(Path(__file__).resolve().parents[1]))
from verify_geometry import Robot, in_base  # noqa: E402

# Without clearance only the goals decide where the fingers without goals are: with it each of them has
# postures that are about as good, and noise of 0.02 mm decides between them.
ALIKE = ("map.clearance.weight=0", "map.avoid_target=false")
QUICK = ("map.starts=4", "map.candidates=1", "map.coarse_step_s=0.1")
BRANCHES = tuple((f"seed={seed}", *QUICK[:2], *ALIKE) for seed in range(1, 6))  # searches that find several branches
KEYS = "axes|unit|rate|hand|static[-_]trial|names"
TIP_M, JOINT_RAD = 0.001, 0.05  # harmless: no plan differs by more
LIMITS_S = 0.1                  # nor begins or ends otherwise, unless the hand rests meanwhile:
REST_M = 0.005                  # its tips move less
POINT_M = 1e-6                  # a point that was mended is where it was


@dataclass
class Flag:
    code: str
    response: str
    begin_s: float
    end_s: float
    subject: str
    text: str

    def overlaps(self, begin_s, end_s):
        return not self.end_s < begin_s and not self.begin_s > end_s

    def resembles(self, other):
        same = self.code == other.code and self.response == other.response and self.subject == other.subject
        return same and (np.isnan(self.begin_s) or np.isnan(other.begin_s)
                         or self.overlaps(other.begin_s - 0.1, other.end_s + 0.1))


@dataclass
class PlannedMovement:
    status: str
    detail: str
    phases: list
    grasp_s: float         # begin of the first grasp, or end of the reach
    limits: tuple          # begin, end [s]
    time: np.ndarray       # [F] of the demonstration
    joints: np.ndarray     # [F, n] of the arm and of the fingers that have goals
    tips: np.ndarray       # [F, m, 3] in the recording's world, of the mapped path [m]
    tip_has_goal: np.ndarray  # [m]


@dataclass
class Answer:
    exit_code: int = 0
    error: str = ""
    asked: set = field(default_factory=set)
    flags: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    names: list = field(default_factory=list)
    time: np.ndarray = None
    points: np.ndarray = None  # [N, K, 3] [m]
    movements: list = field(default_factory=list)

    def set_clock(self, factor, offset_s):
        """Changes the times of points and movements to those of another file of the same motion."""
        if self.time is not None:
            self.time = factor * self.time + offset_s
        for movement in self.movements:
            movement.time = factor * movement.time + offset_s
            movement.limits = tuple(factor * t + offset_s for t in movement.limits)

    def messages(self):
        details = [f"{movement.status} {movement.detail}" for movement in self.movements]
        return [line for line in [*self.notes, *details, *self.error.splitlines()] if line]


def flags_of(group):
    if "flags" not in group:
        return []
    columns = [group["flags"][key][()] for key in ("code", "response", "begin_s", "end_s", "subject", "text")]
    return [Flag(text_of(code), text_of(response), float(begin), float(end), text_of(subject), text_of(text))
            for code, response, begin, end, subject, text in zip(*columns)]


def joints_towards(robot, tips):
    """The joints that move any of the tips."""
    found, frames = set(), robot.frames
    for frame in robot.tips["frame"][tips]:
        while frame >= 0:
            found.add(int(frames["joint"][frame]))
            frame = frames["parent"][frame]
    return sorted(found - {-1})


def movement_of(plan, robot):
    mapped, goals, phases = plan["mapped/position"][()], plan["goals"], plan["phases"]
    names = [text_of(name) for name in phases["name"][()]]
    grasp = next((b for name, b in zip(names, phases["begin_s"][()]) if name == "grasp"),
                 next((e for name, e in zip(names, phases["end_s"][()]) if name == "reach"), np.nan))
    status = text_of(plan.attrs["status"])
    if status == "infeasible":
        status = text_of(plan.attrs["reason"])
    base_from_world = np.eye(4)
    if "reference_frames" in plan:
        base_from_world = plan["reference_frames/recording"][()]
    tips = np.empty((0, 0, 3))
    if len(mapped):
        poses = robot.frame_poses(mapped)
        tips = np.stack([in_base(poses, frame, transform[:3, 3]) for frame, transform
                         in zip(robot.tips["frame"], robot.tips["transform"])], axis=1)
        tips = (tips - base_from_world[:3, 3]) @ base_from_world[:3, :3]
    aimed = np.isfinite(goals["tip_position"][()]).all(axis=2).any(axis=0)
    joints = mapped[:, joints_towards(robot, aimed)]
    return PlannedMovement(status, text_of(plan.attrs["detail"]), names, float(grasp),
                           (float(plan.attrs["begin_s"]), float(plan.attrs["end_s"])), goals["time"][()],
                           joints, tips, aimed)


def read_demonstration(file, answer):
    with h5py.File(file) as store:
        for group in store["demonstrations"].values():
            answer.notes += [text_of(note) for note in group["import_notes"][()]] if "import_notes" in group else []
            answer.flags += flags_of(group)
            stream = group.get("markers", group.get("skeleton"))
            if stream is not None:
                answer.names = [text_of(name) for name in stream.attrs["names"]]
                answer.time, answer.points = stream["time"][()], stream["position"][()]


def read_plans(file, answer):
    with h5py.File(file) as store:
        robot = Robot(store["robot"])
        for plans in store["plans"].values():
            for plan in plans.values():
                answer.movements.append(movement_of(plan, robot))
                answer.flags += [flag for flag in flags_of(plan)
                                 if not any(flag.resembles(known) for known in answer.flags)]


def ask(morphe, config, files, folder, settings, planned):
    """Runs or only imports a file that is given alone, as a user does at first."""
    folder.mkdir(parents=True, exist_ok=True)
    demonstrations, plans = folder / "demonstrations.h5", folder / "plans.h5"
    if planned:
        command = [morphe, "run", config, "--dataset", files[0], "--out", folder, "--jobs", "1", "--quiet"]
        command += [word for setting in settings for word in ("--set", setting)]
    else:
        command = [morphe, "import", files[0], "--out", demonstrations]
    command += ["--static-trial", files[1]] if files[1] else []
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    answer = Answer(result.returncode, result.stderr)
    if demonstrations.exists():
        read_demonstration(demonstrations, answer)
    if plans.exists():
        read_plans(plans, answer)
    if (plans if planned else demonstrations).exists():
        answer.error = ""
    else:
        found = re.findall(rf"(?m)^  --({KEYS})\b|: ({KEYS}): ", result.stderr)
        answer.asked = {(option or key).replace("-", "_") for option, key in found}
    return answer


def ask_take(morphe, config, take, folder, settings=QUICK, planned=True):
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / "trial.csv", folder / "still.csv" if take.static else None]
    write_vicon_csv(take, files[0])
    if take.static:
        write_vicon_csv(take.static, files[1])
    answer = ask(morphe, config, files, folder / ("out" if planned else "read"), settings, planned)
    answer.set_clock(*take.clock)
    return answer


def at_times(time, rows, wanted):
    flat = rows.reshape(len(rows), -1)
    return np.stack([np.interp(wanted, time, column) for column in flat.T], axis=1).reshape(-1, *rows.shape[1:])


def motion_apart(one, other, edge):
    """The time between the begins (edge 0) or ends (1) of two movements [s]; 0 if the tips rest meanwhile."""
    apart = abs(one.limits[edge] - other.limits[edge])
    if any(abs(movement.time[-edge] - movement.limits[edge]) > LIMITS_S for movement in (one, other)):
        return apart  # the tips are not planned there
    first, last = sorted((one.time[-edge], other.time[-edge]))
    for movement in (one, other):
        tips = movement.tips[(movement.time >= first) & (movement.time <= last)]
        if len(tips) and np.nanmax(np.linalg.norm(tips - tips[0], axis=2)) > REST_M:
            return apart
    return 0.0


def compare_movements(one, other):
    """(words, tips [m], joints [rad]): the words say a difference that no number states."""
    if not len(one.joints) or not len(other.joints):
        same = len(one.joints) == len(other.joints)
        return ("" if same else f"{one.status} instead of {other.status}: {one.detail}"), 0.0, 0.0
    if one.phases != other.phases:
        return f"phases {' '.join(one.phases)} instead of {' '.join(other.phases)}", 0.0, 0.0
    apart = max(motion_apart(one, other, edge) for edge in (0, 1))
    if apart > LIMITS_S:
        return f"begins or ends {apart:.2f} s apart", 0.0, 0.0
    if (one.tip_has_goal != other.tip_has_goal).any():
        return "other tips have goals", 0.0, 0.0
    time = other.time[(other.time >= one.time[0]) & (other.time <= one.time[-1])]
    tips = at_times(one.time, one.tips, time) - at_times(other.time, other.tips, time)
    joints = at_times(one.time, one.joints, time) - at_times(other.time, other.joints, time)
    return "", float(np.linalg.norm(tips[:, other.tip_has_goal], axis=2).max()), float(np.abs(joints).max())


def compare_plans(one, other):
    """The same of two answers: their largest differences."""
    if len(one.movements) != len(other.movements):
        return f"{len(one.movements)} movements instead of {len(other.movements)}", 0.0, 0.0
    differences = [compare_movements(a, b) for a, b in zip(one.movements, other.movements)]
    words, tips, joints = zip(*differences) if differences else (("",), (0.0,), (0.0,))
    return next(filter(None, words), ""), max(tips), max(joints)


def points_apart(one, other):
    """Largest distance of a point that both saw at the same time [m]; inf if they share no moment."""
    if one.points is None or other.points is None:
        return np.inf
    rows = np.searchsorted(other.time, one.time - 1e-4)
    kept = rows < len(other.time)
    kept[kept] = np.abs(other.time[rows[kept]] - one.time[kept]) < 1e-4
    common = [name for name in one.names if name in other.names]
    if not kept.any() or not common:
        return np.inf
    a = one.points[kept][:, [one.names.index(name) for name in common]]
    b = other.points[rows[kept]][:, [other.names.index(name) for name in common]]
    apart = np.linalg.norm(a - b, axis=2)
    return float(np.nanmax(apart)) if np.isfinite(apart).any() else 0.0
