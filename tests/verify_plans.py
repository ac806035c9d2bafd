#!/usr/bin/python3
"""Recomputes from a plans.h5 (docs/formats.md) what it promises, apart from `morphe verify`.

usage: verify_plans.py FILE [--json]      exit 0: all holds, 1: violations, 2: unreadable

Kinematics, limits, tracking errors, clearance and rest of every executable plan, in numpy. Limits
are looked at in 33 points of each quintic, contacts at the samples and 3 points between.
"""
import argparse
import json
import sys

import h5py
import numpy as np

POINTS = np.linspace(0, 1, 33)  # of each quintic, for the limits
SUBSTEPS = 4                    # of each quintic, for the contacts
RELATIVE = 1e-6                 # of a limit
REST = 1e-9                     # rad/s, rad/s^2
DISTANCE = 1e-6                 # m
COVERAGE = 0.05                 # s of the goals' time left out at an end


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def texts(dataset):
    return [text(x) for x in dataset[()]]


class Robot:
    def __init__(self, group):
        self.joints = texts(group["joint_names"])
        for name in ("lower", "upper", "velocity", "acceleration", "jerk"):
            setattr(self, name, group[name][()])
        self.frames = {k: group["frames"][k][()] for k in
                       ("parent", "transform", "axis", "joint", "ratio", "offset")}
        self.tip_names, self.tip_frame = texts(group["tips/name"]), group["tips/frame"][()]
        self.tip_transform = group["tips/transform"][()]
        self.capsules = {k: group["capsules"][k][()] for k in
                         ("frame", "from", "to", "radius", "may_touch_target")}
        self.capsule_names = texts(group["capsules/name"])
        self.allowed = {tuple(sorted(p)) for p in group["allowed_pairs"][()].reshape(-1, 2).tolist()}

    def frame_poses(self, q):
        """base_from_frame [N, J, 4, 4] for joint positions [N, n]."""
        f = self.frames
        poses = np.zeros((len(q), len(f["parent"]), 4, 4))
        for i, parent in enumerate(f["parent"]):
            pose = poses[:, parent] @ f["transform"][i] if parent >= 0 else f["transform"][i]
            turn = np.tile(np.eye(4), (len(q), 1, 1))
            if f["joint"][i] >= 0:
                angle = (f["ratio"][i] * q[:, f["joint"][i]] + f["offset"][i])[:, None, None]
                x, y, z = f["axis"][i]
                cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                turn[:, :3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
            poses[:, i] = pose @ turn
        return poses

    def points(self, poses, frame, local):
        """Points fixed in a frame (-1: base), in the base frame [N, 3]."""
        if frame < 0:
            return np.tile(local, (len(poses), 1))
        return poses[:, frame, :3, :3] @ local + poses[:, frame, :3, 3]


class Report:
    def __init__(self, plan):
        self.plan, self.rows = plan, []

    def add(self, cause, subject, value, limit, sample=-1, time=0.0):
        self.rows.append(dict(plan=self.plan, sample=int(sample), time_s=float(time), cause=cause,
                              subject=subject, value=float(value), limit=float(limit)))

    def add_runs(self, cause, subject, bad, excess, describe):
        """One row per run of neighbours in `bad`, the worst: describe(index) -> (value, ...)."""
        edges = np.flatnonzero(np.diff(np.r_[0, bad.astype(int), 0]))
        for begin, end in zip(edges[::2], edges[1::2]):
            self.add(cause, subject, *describe(begin + int(np.argmax(excess[begin:end]))))


# q(s) = sum c_k s^k from (q0, h v0, h^2 a0, q1, h v1, h^2 a1): rows are multiples of 1/2.
ENDS = np.array([[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 2, 0, 0, 0],
                 [1, 1, 1, 1, 1, 1], [0, 1, 2, 3, 4, 5], [0, 0, 2, 6, 12, 20]])
HERMITE = np.round(2 * np.linalg.inv(ENDS)) / 2


def quintics(time, q, v, a):
    """Coefficients [6, T - 1, n] in s of q - q[k], and the steps [T - 1, 1]."""
    h = np.diff(time)[:, None]
    ends = np.stack([0 * q[:-1], h * v[:-1], h**2 * a[:-1], np.diff(q, axis=0), h * v[1:], h**2 * a[1:]])
    return np.tensordot(HERMITE, ends, 1), h


def evaluate(coefficients, order, s):
    """order-th derivative to s at points s [S] -> [T - 1, n, S]."""
    factor = np.array([np.prod(np.arange(k - order + 1, k + 1)) if k >= order else 0 for k in range(6)])
    powers = np.stack([factor[k] * s**max(k - order, 0) for k in range(6)])
    return np.tensordot(coefficients, powers, (0, 0))


def check_limits(robot, motion, report):
    time, q = motion["time"], motion["position"]
    c, h = quintics(time, q, motion["velocity"], motion["acceleration"])
    found = {}
    for order, name in enumerate(("position", "velocity", "acceleration", "jerk")):
        x = evaluate(c, order, POINTS) / h[:, :, None]**order
        if order == 0:
            x += q[:-1, :, None]
            lower, upper = robot.lower[:, None], robot.upper[:, None]
            excess = np.maximum(lower - x, x - upper)
            tolerance = RELATIVE * (robot.upper - robot.lower)
            found["position_margin"] = -excess.max()
            limit = np.where(lower - x > x - upper, lower, upper)
        else:
            x, limit = np.abs(x), np.broadcast_to(getattr(robot, name)[:, None], x.shape)
            excess, tolerance = x / limit - 1, np.full(len(robot.joints), RELATIVE)
            found[name + "_ratio"] = (x / limit).max()
        worst = excess.argmax(axis=2)

        for j, joint in enumerate(robot.joints):
            def describe(k, j=j):
                s = POINTS[worst[k, j]]
                return (x[k, j, worst[k, j]], limit[k, j, worst[k, j]], k + (s >= 0.5),
                        time[k] + s * h[k, 0])
            most = excess[:, j].max(axis=1)
            report.add_runs(name, joint, ~(most <= tolerance[j]), most, describe)
    for k in (0, len(time) - 1):
        for j, joint in enumerate(robot.joints):
            most = max(abs(motion["velocity"][k, j]), abs(motion["acceleration"][k, j]))
            if not most <= REST:
                report.add("rest", joint, most, REST, k, time[k])
    return found


def check_tracking(robot, plan, motion, phases, report):
    goals, time = plan["goals"], motion["demonstration_time"]
    poses = robot.frame_poses(motion["position"])
    grasping = np.zeros(len(time), bool)
    for name, begin, end in phases:
        if name in ("grasp", "hold"):
            grasping |= (time >= begin) & (time <= end)
    tolerance = np.where(grasping, plan.attrs["tracking_grasp"], plan.attrs["tracking"])
    largest = np.nan
    for m, tip in enumerate(robot.tip_names):
        goal = np.stack([np.interp(time, goals["time"][()], goals["tip_position"][:, m, i])
                         for i in range(3)], axis=1) if len(goals["time"]) else np.full((len(time), 3), np.nan)
        at = robot.points(poses, robot.tip_frame[m], robot.tip_transform[m, :3, 3])
        error = np.linalg.norm(at - goal, axis=1)
        seen = np.isfinite(error)
        if seen.any():
            largest = np.fmax(largest, error[seen].max())
        report.add_runs("tracking", tip, seen & (error > tolerance), np.where(seen, error - tolerance, -1),
                        lambda k: (error[k], tolerance[k], k, motion["time"][k]))
    return largest


def segment_distance(p, p_end, q, q_end):
    """Least distance of segments, [N, 3] each: best point of one, then of the other, clamped."""
    u, v, w = p_end - p, q_end - q, p - q
    dot = lambda a, b: np.einsum("ni,ni->n", a, b)
    uu, vv, uv, uw, vw = dot(u, u) + 1e-300, dot(v, v) + 1e-300, dot(u, v), dot(u, w), dot(v, w)
    area = uu * vv - uv * uv
    s = np.clip(np.where(area > 1e-12 * uu * vv, (uv * vw - vv * uw) / np.where(area > 0, area, 1), 0), 0, 1)
    t = np.clip((uv * s + vw) / vv, 0, 1)
    s = np.clip((uv * t - uw) / uu, 0, 1)
    return np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=1)


def signed_distance(shape, size, p):
    """Of points [N, 3] in the solid's frame, < 0 inside."""
    if shape == "sphere":
        return np.linalg.norm(p, axis=1) - size[0]
    if shape == "capsule":
        z = p[:, 2] - np.clip(p[:, 2], -size[1] / 2, size[1] / 2)
        return np.sqrt(p[:, 0]**2 + p[:, 1]**2 + z**2) - size[0]
    if shape == "box":
        d = np.abs(p) - np.asarray(size) / 2
    elif shape == "cylinder":
        d = np.stack([np.hypot(p[:, 0], p[:, 1]) - size[0], np.abs(p[:, 2]) - size[1] / 2], axis=1)
    else:
        raise ValueError("cannot judge the shape " + shape)
    return np.linalg.norm(np.maximum(d, 0), axis=1) + np.minimum(d.max(axis=1), 0)


def segment_solid_distance(shape, size, p, p_end):
    """Least signed distance along segments, convex in the share: ternary search."""
    at = lambda s: signed_distance(shape, size, p + s[:, None] * (p_end - p))
    low, high = np.zeros(len(p)), np.ones(len(p))
    for _ in range(50):
        third = (high - low) / 3
        left = at(low + third) < at(high - third)
        low, high = np.where(left, low, low + third), np.where(left, high - third, high)
    return np.minimum(at((low + high) / 2), np.minimum(at(low * 0), at(low * 0 + 1)))


def object_poses(group, time):
    """Rotations [N, 3, 3] and positions [N, 3] at demonstration times: linear and slerp."""
    t, p, o = group["time"][()], group["position"][()], group["orientation"][()]
    if len(p) == 1:
        a = b = np.zeros(len(time), int)
        share = np.zeros(len(time))
    else:
        a = np.clip(np.searchsorted(t, time, side="right") - 1, 0, len(t) - 2)
        b = a + 1
        share = np.clip((time - t[a]) / (t[b] - t[a]), 0, 1)
    cosine = np.einsum("ni,ni->n", o[a], o[b])
    end, angle = np.where(cosine < 0, -1, 1)[:, None] * o[b], np.arccos(np.clip(np.abs(cosine), 0, 1))
    flat = angle < 1e-9
    sine = np.where(flat, 1, np.sin(angle))
    weight_a = np.where(flat, 1 - share, np.sin((1 - share) * angle) / sine)[:, None]
    weight_b = np.where(flat, share, np.sin(share * angle) / sine)[:, None]
    w, x, y, z = (weight_a * o[a] + weight_b * end).T
    rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                         [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                         [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])
    return rotation.transpose(2, 0, 1), p[a] + share[:, None] * (p[b] - p[a])


def touch_times(phases, time):
    begins = [b for n, b, _ in phases if n == "preshape"] or [b for n, b, _ in phases if n == "grasp"]
    ends = [e for n, _, e in phases if n in ("grasp", "hold", "transport")]
    if not begins or not ends:
        return np.zeros(len(time), bool)
    return (time >= min(begins) - 1e-9) & (time <= max(ends) + 1e-9)


def check_contacts(robot, plan, motion, phases, report):
    s = np.arange(SUBSTEPS) / SUBSTEPS
    c, h = quintics(motion["time"], motion["position"], motion["velocity"], motion["acceleration"])
    inner = evaluate(c, 0, s) + motion["position"][:-1, :, None]
    q = np.concatenate([inner.transpose(0, 2, 1).reshape(-1, inner.shape[1]), motion["position"][-1:]])
    spread = lambda x: np.interp(np.arange(len(q)) / SUBSTEPS, np.arange(len(x)), x)
    clock, time = spread(motion["time"]), spread(motion["demonstration_time"])
    poses, caps = robot.frame_poses(q), robot.capsules
    ends = [(robot.points(poses, caps["frame"][i], caps["from"][i]),
             robot.points(poses, caps["frame"][i], caps["to"][i])) for i in range(len(caps["frame"]))]
    middles = [(a + b) / 2 for a, b in ends]
    halves = [np.linalg.norm(b - a, axis=1) / 2 for a, b in ends]
    window, at_sample = touch_times(phases, time), np.arange(len(q)) % SUBSTEPS == 0
    margin, depth, least = plan.attrs["margin"], plan.attrs["contact_depth"], np.inf

    def judge(cause, subject, bound, exact, touching):
        nonlocal least
        required = np.where(touching, -depth, margin)
        near = bound < np.maximum(required, least)
        distance = bound.copy()
        if near.any():
            distance[near] = exact(near)
        counted = distance[at_sample & ~touching]
        least = min(least, counted.min(initial=np.inf))
        report.add_runs(cause, subject, ~(distance >= required - DISTANCE), required - distance,
                        lambda k: (distance[k], required[k], (k + SUBSTEPS // 2) // SUBSTEPS, clock[k]))

    for i in range(len(ends)):
        for j in range(i + 1, len(ends)):
            if caps["frame"][i] == caps["frame"][j] or (i, j) in robot.allowed:
                continue
            radii = caps["radius"][i] + caps["radius"][j]
            judge("self", robot.capsule_names[i] + "/" + robot.capsule_names[j],
                  np.linalg.norm(middles[i] - middles[j], axis=1) - halves[i] - halves[j] - radii,
                  lambda near: segment_distance(*(x[near] for x in ends[i] + ends[j])) - radii,
                  np.zeros(len(q), bool))
    for name, group in plan["scene"].items():
        shape, size = text(group.attrs["shape"]), group.attrs["size"]
        rotation, position = object_poses(group, time)
        local = lambda p: np.einsum("nji,nj->ni", rotation, p - position)
        target = name == text(plan.attrs["target"])
        for i in range(len(ends)):
            a, b, radius = local(ends[i][0]), local(ends[i][1]), caps["radius"][i]
            judge("object", robot.capsule_names[i] + "/" + name,
                  signed_distance(shape, size, (a + b) / 2) - halves[i] - radius,
                  lambda near: segment_solid_distance(shape, size, a[near], b[near]) - radius,
                  window & target & bool(caps["may_touch_target"][i]))
    return least


def read_motion(robot, group, report):
    """The arrays of a trajectory, or None if they cannot be judged."""
    motion = {k: group[k][()] for k in ("time", "position", "velocity", "acceleration", "demonstration_time")}
    shape = (len(motion["time"]), len(robot.joints))
    if shape[0] < 2 or any(motion[k].shape != shape for k in ("position", "velocity", "acceleration")):
        return report.add("structure", "trajectory", shape[0], 2)
    for name, values in motion.items():
        if not np.isfinite(values).all():
            report.add("finite", name, np.nan, np.nan)
    if report.rows:
        return None
    t, d = motion["time"], motion["demonstration_time"]
    if t[0] != 0:
        report.add("time", "time", t[0], 0)
    for name, bad, x in (("time", np.diff(t) <= 0, t), ("demonstration_time", np.diff(d) < 0, d)):
        report.add_runs("time", name, bad, -np.diff(x), lambda k: (x[k + 1], x[k], k + 1, t[k + 1]))
    return None if report.rows else motion


def check_certificate(plan, found, report):
    stored = plan["certificate"].attrs
    for name, value in found.items():
        tolerance = {"position_margin": 1e-4, "position_error_max": 1e-4}.get(name, 1e-3 * abs(value) + 1e-9)
        if np.isnan(value) and np.isnan(stored[name]):
            continue
        good = stored[name] <= value + 1e-4 if name == "clearance" else abs(stored[name] - value) <= tolerance
        if not good:
            report.add("certificate", name, stored[name], value)


def check_plan(robot, path, plan):
    report = Report(path)
    executable = text(plan.attrs["status"]) == "executable"
    if executable != ("trajectory" in plan) or executable != (text(plan.attrs["reason"]) == ""):
        report.add("structure", "trajectory", "trajectory" in plan, executable)
        return report.rows
    if not executable or (motion := read_motion(robot, plan["trajectory"], report)) is None:
        return report.rows
    phases = list(zip(texts(plan["phases/name"]), plan["phases/begin_s"][()], plan["phases/end_s"][()]))
    goal_time, reached = plan["goals/time"][()], motion["demonstration_time"]
    if len(goal_time) and reached[0] > goal_time[0] + COVERAGE:
        report.add("time", "demonstration_time", reached[0], goal_time[0])
    if len(goal_time) and reached[-1] < goal_time[-1] - COVERAGE:
        report.add("time", "demonstration_time", reached[-1], goal_time[-1])
    found = check_limits(robot, motion, report)
    found["position_error_max"] = check_tracking(robot, plan, motion, phases, report)
    found["clearance"] = check_contacts(robot, plan, motion, phases, report)
    found["tempo"] = motion["time"][-1] / (plan.attrs["end_s"] - plan.attrs["start_s"])
    check_certificate(plan, found, report)
    if "approach" in plan:
        approach = Report(path + "/approach")
        if (motion := read_motion(robot, plan["approach"], approach)) is not None:
            if np.abs(motion["position"][-1] - plan["trajectory/position"][0]).max() > 1e-6:
                approach.add("structure", "approach", np.nan, 1e-6)
            check_limits(robot, motion, approach)
            check_contacts(robot, plan, motion, phases, approach)
        report.rows += approach.rows
    return report.rows


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("file")
    arguments.add_argument("--json", action="store_true")
    options = arguments.parse_args()
    result = dict(executable=0, infeasible=0, violations=[])
    try:
        with h5py.File(options.file, "r") as file:
            robot = Robot(file["robot"])
            for demonstration, movements in file["plans"].items():
                for movement, plan in movements.items():
                    result[text(plan.attrs["status"])] += 1
                    result["violations"] += check_plan(robot, f"{demonstration}/{movement}", plan)
    except (OSError, KeyError) as error:
        print(f"{options.file}: {error}", file=sys.stderr)
        return 2
    if options.json:
        print(json.dumps(result, indent=1).replace("NaN", "null"))
    else:
        for v in result["violations"]:
            print("{plan}: sample {sample} ({time_s:.4f} s): {cause} {subject}: {value:.6g}, "
                  "limit {limit:.6g}".format(**v))
        print("{} executable, {} infeasible, {} violations".format(
            result["executable"], result["infeasible"], len(result["violations"])))
    return 1 if result["violations"] else 0


if __name__ == "__main__":
    sys.exit(main())
