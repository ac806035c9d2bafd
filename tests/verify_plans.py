#!/usr/bin/python3
"""Recomputes from a plans.h5 (docs/formats.md) what it promises, apart from `morphe verify`:
limits in 33 points of each quintic, contacts and tips at the samples and 3 points between, and
what else a plan says of itself (verify_promises.py, verify_branches.py, verify_grasps.py). Exit 0: all holds, 1: violations, 2: unreadable."""
import argparse
import functools
import hashlib
import itertools
import json
import sys
import h5py
import numpy as np

from verify_geometry import (Mesh, Robot, asked_points, columns, goals_at, in_base, segment_distance,
                             radius_about_centre, segment_solid_distance, signed_distance, solids_distance, text)
from verify_branches import check_branch
from verify_grasps import check_grasp, held_figures
from verify_promises import REFINING, check_promises, check_transfer

POINTS, SUBSTEPS = np.linspace(0, 1, 33), 4  # of each quintic: for the limits, for contacts and tips
FINE_SUBSTEPS = 64  # where a clearance is said to be less than was seen
RELATIVE, REST, DISTANCE = 1e-6, 1e-9, 1e-6  # of a limit; rad/s and rad/s^2; m
TRANSFER_END = 1e-6  # rad or m that an approach or a retreat may be off the trajectory where they meet
COVERAGE = 1e-6  # s of the goals' time that may be left out at an end
BETWEEN = 1e-4  # m that a tip may be farther from its goal between samples; of a sample's clearance
SUPPORT_NOISE = 2e-3  # m of overlap, or of height, of what stands on something when it is taken or put down
RELEASE_HEIGHT = 1e-2  # m above everything at which it may be released
DERIVATIVES = ("position", "velocity", "acceleration")
EXTREMES = ("velocity_ratio", "acceleration_ratio", "jerk_ratio")
SMOOTHNESS = ("sparc_robot", "log_dimensionless_jerk_robot", "sparc_human", "log_dimensionless_jerk_human")

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

def quintics(motion):
    """Coefficients [6, T - 1, n] in s of q - q[k], and the steps [T - 1, 1]."""
    h, (q, v, a) = np.diff(motion["time"])[:, None], (motion[name] for name in DERIVATIVES)
    d, v0, v1, a0, a1 = np.diff(q, axis=0), h * v[:-1], h * v[1:], h**2 * a[:-1], h**2 * a[1:]
    return np.stack([0 * d, v0, a0 / 2, 10 * d - 6 * v0 - 4 * v1 - 1.5 * a0 + 0.5 * a1,
                     -15 * d + 8 * v0 + 7 * v1 + 1.5 * a0 - a1,
                     6 * d - 3 * (v0 + v1) + 0.5 * (a1 - a0)]), h

def evaluate(coefficients, order, s):
    """order-th derivative to s at points s [S] -> [T - 1, n, S]."""
    for _ in range(order):
        coefficients = coefficients[1:] * np.arange(1, len(coefficients))[:, None, None]
    return np.tensordot(coefficients, s ** np.arange(len(coefficients))[:, None], (0, 0))

def check_limits(robot, motion, report):
    time, (c, h) = motion["time"], quintics(motion)
    found, low, high = {}, robot.limits["lower"][:, None], robot.limits["upper"][:, None]
    for order, name in enumerate(DERIVATIVES + ("jerk",)):
        x = evaluate(c, order, POINTS) / h[:, :, None]**order
        if order == 0:
            x += motion["position"][:-1, :, None]
            excess, limit = np.maximum(low - x, x - high), np.where(low - x > x - high, low, high)
            tolerance, found["joint_limit_margin"] = RELATIVE * (high - low)[:, 0], -excess.max()
        else:
            x, limit = np.abs(x), np.broadcast_to(robot.limits[name][:, None], x.shape)
            excess, tolerance = x / limit - 1, np.full(len(robot.joints), RELATIVE)
            found[name + "_ratio"] = (x / limit).max()
        worst = excess.argmax(axis=2)
        for j, joint in enumerate(robot.joints):
            def describe(k):
                s = POINTS[w := worst[k, j]]
                return x[k, j, w], limit[k, j, w], k + (s >= 0.5), time[k] + s * h[k, 0]
            most = excess[:, j].max(axis=1)
            report.add_runs(name, joint, ~(most <= tolerance[j]), most, describe)
    braking = robot.braking
    for b, j in enumerate(braking.get("joint", ())):
        x, v = (evaluate(c, order, POINTS)[:, j] / h**order for order in (0, 1))
        x = x + motion["position"][:-1, j, None]
        for sign, end in ((1, braking["upper_end"][b]), (-1, braking["lower_end"][b])):
            left = np.sqrt(np.maximum(braking["twice_deceleration"][b] * sign * (end - x), 0)) - braking["velocity_offset"][b]
            ratio = np.where(sign * v > 0, sign * v / np.maximum(left, 1e-99), 0).max(axis=1)
            found["velocity_ratio"] = max(found["velocity_ratio"], ratio.max())
            report.add_runs("velocity", robot.joints[j], ~(ratio <= 1 + RELATIVE), ratio,
                            lambda k: (ratio[k], 1, k, time[k]))
    moving = np.maximum(np.abs(motion["velocity"]), np.abs(motion["acceleration"]))
    for k in (0, len(time) - 1):
        for j in np.flatnonzero(moving[k] > REST):
            report.add("rest", robot.joints[j], moving[k, j], REST, k, time[k])
    return found

def is_grasping(phases, time):
    put_down = [end for name, _, end in phases if name == "transport"][-1:] or [np.inf]
    return sum(((time >= begin) & (time <= end) for name, begin, end in phases
                if name == "grasp" or name == "hold" and begin < put_down[0]), np.zeros(len(time), bool))

def dense(robot, motion, substeps=SUBSTEPS):
    """The samples, and substeps - 1 points between: positions, poses, clock, demonstration time."""
    inner = evaluate(quintics(motion)[0], 0, np.arange(substeps) / substeps)
    inner += motion["position"][:-1, :, None]
    q = np.concatenate([inner.transpose(0, 2, 1).reshape(-1, inner.shape[1]), motion["position"][-1:]])
    spread = lambda x: np.interp(np.arange(len(q)) / substeps, np.arange(len(x)), x)
    return robot.frame_poses(q), spread(motion["time"]), spread(motion["demonstration_time"])

def check_tracking(robot, plan, motion, phases, report):
    goals = plan["goals"]
    (poses, clock, time), errors, turned = dense(robot, motion), [], []
    grasping, sampled = is_grasping(phases, time), np.arange(len(time)) % SUBSTEPS == 0
    allowed = np.where(grasping, plan.attrs["tracking_tolerance_grasp"], plan.attrs["tracking_tolerance"])
    tolerance = np.where(sampled, allowed, allowed + BETWEEN)
    here = poses[sampled]
    for m, tip in enumerate(robot.tip_names if len(goals["time"]) else ()):
        error = np.linalg.norm(asked_points(robot, goals, m, time, poses)
                               - goals_at(goals, "tip_position", m, time), axis=1)
        errors.append(error[sampled])  # NaN: no goal there
        report.add_runs("tracking", tip, error > tolerance, error - tolerance,
                        lambda k: (error[k], allowed[k], (k + SUBSTEPS // 2) // SUBSTEPS, clock[k]))
        turn = here[:, robot.tips["frame"][m], :3, :3] @ robot.tips["transform"][m, :3, :3]
        goal = rotations_at(goals["time"][()], goals["tip_orientation"][:, m], time[sampled])
        # |A - B|² = 8 sin²(angle / 2) of two rotation matrices.
        turned.append(2 * np.arcsin(np.minimum(np.linalg.norm(turn - goal, axis=(1, 2)) / 8**0.5, 1)))
    errors, turned = np.array(errors), np.array(turned)
    found = dict(zip(("tip_error_max", "tip_error_mean"), largest_and_mean(errors)))
    found["tip_error_grasp"] = largest_and_mean(errors[:, grasping[sampled]] if len(errors) else errors)[0]
    found["tip_orientation_error_max"] = largest_and_mean(turned)[0]
    found.update(arm_figures(robot, goals, time[sampled], here))
    found.update(posture_figures(robot, goals, time[sampled], here))
    return found

def largest_and_mean(values):
    seen = values[np.isfinite(values)]
    return (seen.max(), seen.mean()) if len(seen) else (np.nan, np.nan)

def rotations_at(times, quaternions, time):
    """Matrices [N, 3, 3] at times, slerp between frames, NaN beside one that has none."""
    if not len(quaternions):
        return np.full((len(time), 3, 3), np.nan)
    last = len(times) - 1
    b = np.clip(np.searchsorted(times, time), 0, last)
    a = np.where((times[b] == time) | (time < times[0]) | (time > times[-1]), b, b - 1)
    share = np.where(a == b, 0, (time - times[a]) / np.where(a == b, 1, times[b] - times[a]))
    p, q = quaternions[a], quaternions[b]
    cosine = np.einsum("ni,ni->n", p, q)
    q, angle = np.where(cosine < 0, -1, 1)[:, None] * q, np.arccos(np.minimum(np.abs(cosine), 1))
    slerp = lambda u: (u * np.sinc(u * angle / np.pi) / np.sinc(angle / np.pi))[:, None]
    w, x, y, z = ((r := slerp(1 - share) * p + slerp(share) * q) / np.linalg.norm(r, axis=1)[:, None]).T
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)

def arm_figures(robot, goals, time, poses):
    """Metric A and the angle between the upper arms' directions, over the samples."""
    names = ("upper_arm_error_max", "upper_arm_error_mean", "humanlikeness_final")
    centres = [frame for frame, chain in zip(robot.centres, robot.chains) if chain == "arm"]
    if not len(goals["time"]) or not centres:
        return dict.fromkeys(names, np.nan)
    at = lambda key: np.stack([np.interp(time, goals["time"][()], goals[key][:, i]) for i in range(3)], axis=1)
    elbow, shoulder = at("elbow_position"), at("shoulder_position")
    own = np.stack([poses[:, frame, :3, 3] for frame in centres])
    sums = ((own - elbow)**2).sum(axis=(0, 2))
    unit = lambda x: x / np.linalg.norm(x, axis=1)[:, None]
    apart = np.linalg.norm(unit(elbow - shoulder) - unit(own[0] - poses[:, robot.shoulder, :3, 3]), axis=1)
    return dict(zip(names, largest_and_mean(2 * np.arcsin(apart / 2)) + largest_and_mean(sums)[1:]))

def arms_of(robot, poses):
    """The robot's shoulder, elbow and wrist, [N, 3] each, NaN: the arm does not have it."""
    centres = [poses[:, frame, :3, 3] for frame, chain in zip(robot.centres, robot.chains) if chain == "arm"]
    none = np.full((len(poses), 3), np.nan)
    if not centres:
        return none, none, none
    chain = [poses[:, robot.shoulder, :3, 3], *centres]
    chain += [in_base(poses, frame, transform[:3, 3]) for frame, transform, finger in
              zip(robot.tips["frame"], robot.tips["transform"], robot.fingers) if finger < 0]
    chain += [poses[:, robot.palm, :3, 3]] if len(chain) == 2 else []
    return chain[0], chain[1] if len(chain) == 3 else none, chain[-1]

def angle_between(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(axis=1))

def swivels(human, own):
    """The angle by which the elbows are turned about the lines from shoulder to wrist, after the
    shortest rotation that lays one line on the other; NaN if an elbow is too near to its line."""
    unit = lambda x: x / np.linalg.norm(x, axis=1)[:, None]
    along = lambda x, line: (x * line).sum(axis=1)[:, None]
    lines, offsets, bent = [], [], []
    for shoulder, elbow, wrist in (human, own):
        lines.append(line := unit(wrist - shoulder))
        offsets.append((elbow - shoulder) - along(elbow - shoulder, line) * line)
        length = np.linalg.norm(elbow - shoulder, axis=1) + np.linalg.norm(wrist - elbow, axis=1)
        bent.append(np.linalg.norm(offsets[-1], axis=1) >= 0.1 * length)
    # Two reflections make the shortest rotation: across the bisector's plane and the target's.
    middle = unit(lines[0] + lines[1])
    mirrored = offsets[0] - 2 * along(offsets[0], middle) * middle
    turned = mirrored - 2 * along(mirrored, lines[1]) * lines[1]
    good = bent[0] & bent[1] & (along(*lines)[:, 0] > 0)
    return np.where(good, angle_between(turned, offsets[1]), np.nan)

def posture_figures(robot, goals, time, poses):
    """Errors of the forearm's direction, the swivel angle and the palm's rotation."""
    names = ("forearm_error", "swivel_error", "palm_error")
    if not len(goals["time"]):
        return {name + end: np.nan for name in names for end in ("_max", "_mean")}
    at = lambda key: np.stack([np.interp(time, goals["time"][()], goals[key][:, i]) for i in range(3)], axis=1)
    human, own = [at(key + "_position") for key in ("shoulder", "elbow", "wrist")], arms_of(robot, poses)
    hand = rotations_at(goals["time"][()], goals["wrist_orientation"][()], time)
    turn = np.einsum("nji,njk->nik", poses[:, robot.palm, :3, :3], hand)
    sine = np.linalg.norm([turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0],
                           turn[:, 1, 0] - turn[:, 0, 1]], axis=0) / 2
    rows = (angle_between(human[2] - human[1], own[2] - own[1]), swivels(human, own),
            np.arctan2(sine, (np.trace(turn, axis1=1, axis2=2) - 1) / 2))
    return {name + end: value for name, row in zip(names, rows)
            for end, value in zip(("_max", "_mean"), largest_and_mean(row))}

def wrist_correlation(robot, goals, motion):
    """Pearson's correlation of the wrists' speeds at the goals' frames, by central differences."""
    clock, wrist = goals["time"][()], goals["wrist_position"][()]
    if len(wrist) != len(clock) or len(motion["time"]) < 2:
        return np.nan
    reached, first = np.unique(motion["demonstration_time"], return_index=True)
    last = np.append(first[1:] - 1, len(motion["time"]) - 1)  # of those with the same demonstration time
    k = np.clip(np.searchsorted(reached, clock), 0, len(reached) - 1)
    b = np.maximum(k - 1, 0)
    share = (clock - reached[b]) / np.where(k == b, 1, reached[k] - reached[b])
    begin = motion["time"][last[b]]
    at = np.where(k == b, motion["time"][0], begin + share * (motion["time"][first[k]] - begin))
    at = np.where(clock > reached[-1], motion["time"][-1], at)
    own = arms_of(robot, robot.frame_poses(positions_at(motion, at)))[2]
    speed = lambda x, t: np.linalg.norm(x[2:] - x[:-2], axis=1) / (t[2:] - t[:-2])
    human, robots = speed(wrist, clock), speed(own, at)
    good = np.isfinite(human) & np.isfinite(robots)
    if good.sum() < 2 or not min(human[good].max(), robots[good].max()) > 1e-3:
        return np.nan
    return np.corrcoef(human[good], robots[good])[0, 1]

def positions_at(motion, at):
    """The joints [N, n] on the quintics at times."""
    piece = np.clip(np.searchsorted(motion["time"], at, side="right") - 1, 0, len(motion["time"]) - 2)
    c, h = quintics(motion)
    share = (at - motion["time"][piece]) / h[piece, 0]
    return motion["position"][piece] + sum(c[k][piece] * share[:, None]**k for k in range(6))

def smoothness(speed, step):
    """SPARC (up to 10 Hz, threshold 0.05, padded 16 times) and log dimensionless jerk."""
    if len(speed) < 3 or not speed.max() > 0:
        return np.nan, np.nan
    padded = 2**(int(np.ceil(np.log2(len(speed)))) + 4)
    size = np.abs(np.fft.rfft(speed, padded))
    size = size[np.arange(len(size)) / (padded * step) <= 10 * (1 + 1e-12)] / size.max()
    size = size[:np.flatnonzero(size >= 0.05)[-1] + 1]
    arc = -np.hypot(1 / (len(size) - 1), np.diff(size)).sum() if len(size) > 1 else np.nan
    jerk, duration = np.diff(speed, 2) / step**2, step * (len(speed) - 1)
    return arc, -np.log(duration**3 / speed.max()**2 * (jerk**2).sum() * step)

def smoothness_of(robot, goals, motion):
    """Both figures of the robot and of the human: mean speed of the tips that always have goals."""
    time, tips = goals["time"][()], goals["tip_position"][()]
    always = np.flatnonzero(np.isfinite(tips).all(axis=(0, 2))) if len(time) > 1 else []
    if not len(always):
        return dict.fromkeys(SMOOTHNESS, np.nan)
    step = (time[-1] - time[0]) / (len(time) - 1)
    at = np.arange(int(motion["time"][-1] / step * (1 + 1e-12) + 1e-9) + 1) * step
    poses = robot.frame_poses(positions_at(motion, at))
    robots = np.stack([in_base(poses, robot.tips["frame"][m], robot.tips["transform"][m, :3, 3])
                       for m in always], axis=1)
    speed = lambda x: np.linalg.norm(x[2:] - x[:-2], axis=2).mean(axis=1) / (2 * step)
    figures = smoothness(speed(robots), step) + smoothness(speed(tips[:, always]), step)
    return dict(zip(SMOOTHNESS, figures))

def into_object(group, time):
    """Takes points [N, 3] into an object's frame at demonstration times: linear and slerp."""
    t, p, o = group["time"][()], group["position"][()], group["orientation"][()]
    if len(p) == 1:
        t, p, o = np.array([0, 1]), np.repeat(p, 2, axis=0), np.repeat(o, 2, axis=0)
    a = (b := np.clip(np.searchsorted(t, time, side="right"), 1, len(t) - 1)) - 1
    share = np.clip((time - t[a]) / (t[b] - t[a]), 0, 1)
    cosine = np.einsum("ni,ni->n", o[a], o[b])
    end, angle = np.where(cosine < 0, -1, 1)[:, None] * o[b], np.arccos(np.minimum(np.abs(cosine), 1))
    slerp = lambda u: (u * np.sinc(u * angle / np.pi) / np.sinc(angle / np.pi))[:, None]
    turn, place = slerp(1 - share) * o[a] + slerp(share) * end, p[a] + share[:, None] * (p[b] - p[a])
    def into(points):
        back = np.cross(points - place, turn[:, 1:])
        return points - place + 2 * turn[:, :1] * back + 2 * np.cross(back, turn[:, 1:])
    return into

def into_carried(robot, group, motion, poses, time, substeps):
    """As into_object, but from attach_s to release_s the object moves with its attached frame, and
    then stays; both at the first sample from then on."""
    recorded, held = into_object(group, time), group.attrs
    samples = motion["demonstration_time"]
    taken = np.searchsorted(samples, held.get("attach_s", np.inf))
    if "attached_frame" not in held or taken == len(samples) or samples[taken] >= samples[-1]:
        return recorded
    hand = poses[:, [text(name) for name in robot.frame_names].index(text(held["attached_frame"]))]
    at = lambda point: recorded(np.tile(point, (len(time), 1)))[taken * substeps]
    object_from_base = np.eye(4)
    object_from_base[:3] = np.c_[np.transpose([at(e) - at(np.zeros(3)) for e in np.eye(3)]), at(np.zeros(3))]
    hand_from_object = np.linalg.inv(object_from_base @ hand[taken * substeps])
    base_from_object = hand @ hand_from_object
    released = np.searchsorted(samples, held.get("release_s", np.inf))
    if released < len(samples):
        base_from_object[time > samples[released]] = hand[released * substeps] @ hand_from_object
    carried = np.linalg.inv(base_from_object)
    def into(points):
        moved = np.einsum("nij,nj->ni", carried[:, :3, :3], points) + carried[:, :3, 3]
        return np.where((time < samples[taken])[:, None], recorded(points), moved)
    return into

def into_target(robot, plan, group, motion, poses, time, substeps):
    """As into_carried; of an approach or retreat, whose clock stands still, as at that end of the plan's motion."""
    own = columns(plan["trajectory"], "demonstration_time", "position")
    if np.array_equal(own["demonstration_time"], motion["demonstration_time"]):
        return into_carried(robot, group, motion, poses, time, substeps)
    at_samples = into_carried(robot, group, own, robot.frame_poses(own["position"]), own["demonstration_time"], 1)
    turn, place = rigid(at_samples, len(own["position"]))
    end = 0 if time[0] <= own["demonstration_time"][0] else -1
    return lambda points: points @ turn[end].T + place[end]

def rigid(into, count):
    """Rotation [N, 3, 3] and translation [N, 3] of a function that takes points into an object's frame."""
    place = into(np.zeros((count, 3)))
    return np.stack([into(np.tile(axis, (count, 1))) - place for axis in np.eye(3)], axis=2), place

def carried_pairs(robot, plan, motion, poses, time, substeps, report):
    """The target and each other object, as judge() takes them, from when the target is taken on. Meshes are not judged."""
    target, scene = text(plan.attrs["target"]), plan["scene"]
    samples = plan["trajectory/demonstration_time"][()]
    held = scene[target].attrs if target in scene else {}
    taken = np.searchsorted(samples, held.get("attach_s", np.inf))
    if taken == len(samples) or samples[taken] >= samples[-1] or text(held["shape"]) == "mesh":
        return
    released = min(len(samples) - 1, np.searchsorted(samples, held.get("release_s", np.inf)))
    solid = lambda name: (text(scene[name].attrs["shape"]), scene[name].attrs.get("size"))
    own = columns(plan["trajectory"], "demonstration_time", "position")
    ways = [(into_target(robot, plan, scene[target], own, robot.frame_poses(own["position"]), samples, 1), samples),
            (into_target(robot, plan, scene[target], motion, poses, time, substeps), time)]
    clear, heights, stood = max(SUPPORT_NOISE, plan.attrs["required_clearance"]), [np.inf], False
    for name in scene:
        if name == target or solid(name)[0] == "mesh":
            continue
        def relative(way, times):
            """The object in the frame of the target, and a lower bound of the distance."""
            (turn, place), (other, at) = rigid(way, len(times)), rigid(into_object(scene[name], times), len(times))
            back = np.einsum("nij,nkj->nik", turn, other)
            centre = at - np.einsum("nij,nkj,nk->ni", other, turn, place)
            bound = signed_distance(*solid(name), centre) - radius_about_centre(*solid(target))
            return back, place - np.einsum("nij,nj->ni", back, at), bound
        (turn, place, at_samples), (turns, places, bound) = (relative(*way) for way in ways)
        close = at_samples < 2 * RELEASE_HEIGHT
        at_samples[close] = solids_distance(solid(target), solid(name), turn[close], place[close])
        until, since = support_times(at_samples, taken, released, samples, clear)
        stood |= until > -np.inf
        heights.append(at_samples[released])
        begun = time >= samples[taken]
        yield (name, np.where(begun, bound, np.inf),
               lambda near: solids_distance(solid(target), solid(name), turns[near], places[near]),
               (time <= until + 1e-9) | (time >= since - 1e-9) | ~begun)
    names = list(plan["phases/name"].asstr())
    in_flight = "transport" in names and held.get("release_s", np.inf) <= samples[-1] and len(motion["time"]) == len(samples)
    if stood and in_flight and min(heights) > RELEASE_HEIGHT:
        report.add("release", target, min(heights), RELEASE_HEIGHT)

def support_times(distance, taken, released, samples, clear):
    """Until when and from when the target may touch an object, from its distances at the samples."""
    until, since = -np.inf, np.inf
    is_clear = np.flatnonzero(distance[taken:released + 1] >= clear) + taken
    if distance[taken] <= SUPPORT_NOISE:
        until = samples[is_clear[0]] if len(is_clear) else np.inf
    if distance[released] <= SUPPORT_NOISE:
        since = samples[is_clear[-1]] if len(is_clear) else -np.inf
    return until, since

def touch_times(phases, time):
    named = lambda name: [(begin, end) for n, begin, end in phases if n == name]
    begins = named("preshape") or named("grasp") or [(np.inf, 0)]
    ends = named("grasp") + named("hold") + named("transport") or [(0, -np.inf)]
    return (time >= min(begins)[0] - 1e-9) & (time <= max(end for _, end in ends) + 1e-9)

def check_contacts(robot, plan, motion, phases, stored, report, substeps=SUBSTEPS):
    """The least clearance of each kind of pair, that of each sample, of which `stored` is what is said, and the closest
    pair of each kind with its time."""
    (poses, clock, time), caps = dense(robot, motion, substeps), robot.capsules
    ends = [(in_base(poses, frame, a), in_base(poses, frame, b))
            for frame, a, b in zip(caps["frame"], caps["from"], caps["to"])]
    middles = [(a + b) / 2 for a, b in ends]
    halves = [np.linalg.norm(b - a, axis=1) / 2 for a, b in ends]
    window = touch_times(phases, time)
    margin, depth, least = plan.attrs["required_clearance"], plan.attrs["max_penetration"], {}
    closest = {}
    pads, of_links = {capsule for capsule, _ in robot.pads()}, plan.attrs.get("max_link_penetration", depth)
    sampled = np.arange(len(time)) % substeps == 0
    own = np.full(len(time), np.inf)  # clearance of each instant; exact up to what is stored at samples
    told = np.where(np.isfinite(stored), stored + BETWEEN, np.inf)
    def judge(kind, subject, bound, exact, touching, depth=0):
        cause = "self_collision" if kind == "self" else "object_collision"
        required = np.where(touching, -depth, margin)
        wanted = np.maximum(required, least.setdefault(kind, np.inf))
        wanted[sampled] = np.where(touching[sampled], required[sampled],
                                   np.maximum(wanted[sampled], np.minimum(told, own[sampled])))
        near = bound < wanted
        distance = bound.copy()
        distance[near] = exact(near)
        apart = np.where(touching, np.inf, distance)
        if (nearest := apart.min()) < least[kind]:
            least[kind], closest[kind] = nearest, (subject, clock[apart.argmin()])
        own[~touching] = np.minimum(own, distance)[~touching]
        report.add_runs(cause, subject, ~(distance >= required - DISTANCE), required - distance,
                        lambda k: (distance[k], required[k], (k + substeps // 2) // substeps, clock[k]))

    for i, j in itertools.combinations(range(len(ends)), 2):
        if caps["frame"][i] == caps["frame"][j] or (i, j) in robot.allowed:
            continue
        radii = caps["radius"][i] + caps["radius"][j]
        judge("self", robot.capsule_names[i] + "/" + robot.capsule_names[j],
              np.linalg.norm(middles[i] - middles[j], axis=1) - halves[i] - halves[j] - radii,
              lambda near: segment_distance(*(x[near] for x in ends[i] + ends[j])) - radii,
              np.zeros(len(time), bool))
    for name, group in plan["scene"].items():
        shape, size = text(group.attrs["shape"]), group.attrs.get("size")
        mesh = Mesh(group["vertices"][()], group["triangles"][()]) if shape == "mesh" else None
        outside = (lambda p: np.linalg.norm(p, axis=1) - mesh.radius) if mesh else (
            lambda p: signed_distance(shape, size, p))
        exact = mesh.segment_distance if mesh else functools.partial(segment_solid_distance, shape, size)
        target = name == text(plan.attrs["target"])
        into = into_target(robot, plan, group, motion, poses, time, substeps) if target else into_object(group, time)
        for i in range(len(ends)):
            a, b, radius = into(ends[i][0]), into(ends[i][1]), caps["radius"][i]
            judge("target" if target else "table" if name == "table" else "objects", robot.capsule_names[i] + "/" + name,
                  outside((a + b) / 2) - halves[i] - radius,
                  lambda near: exact(a[near], b[near]) - radius,
                  window & target & bool(caps["may_touch_target"][i]), depth if i in pads else of_links)
    for name, bound, exact, touching in carried_pairs(robot, plan, motion, poses, time, substeps, report):
        judge("table" if name == "table" else "objects", text(plan.attrs["target"]) + "/" + name, bound, exact, touching, SUPPORT_NOISE)
    here = np.where(np.isinf(own[sampled]), np.nan, own[sampled])
    good = (np.abs(stored - here) <= BETWEEN) | (np.isnan(stored) & np.isnan(here))
    report.add_runs("clearance", "trajectory", ~good, np.abs(stored - here),
                    lambda k: (stored[k], here[k], k, motion["time"][k]))
    return {kind: value for kind, value in least.items() if np.isfinite(value)}, here, closest

def kinds_of(plan):
    """The clearances by kind of the certificate; none in files of earlier versions."""
    group = plan["certificate"].get("clearance_by_kind")
    return dict(zip(group["kind"].asstr(), group["clearance"])) if group else {}

def read_motion(robot, group, report):
    """The arrays of a trajectory, or None if they cannot be judged."""
    motion = columns(group, "time", "demonstration_time", *DERIVATIVES)
    shape = (len(motion["time"]), len(robot.joints))
    if shape[0] < 2 or any(motion[k].shape != shape for k in DERIVATIVES):
        return report.add("structure", "trajectory", shape[0], 2)
    for name in (name for name, values in motion.items() if not np.isfinite(values).all()):
        report.add("finite", name, np.nan, np.nan)
    t = motion["time"]
    if t[0] != 0:
        report.add("time", "time", t[0], 0, 0)
    for name, least in (("time", 1e-300), ("demonstration_time", 0)):
        x, step = motion[name], np.diff(motion[name])
        report.add_runs("time", name, step < least, -step, lambda k: (x[k + 1], x[k], k + 1, t[k + 1]))
    return None if report.rows else motion

def check_certificate(plan, found, report):
    attributes = plan["certificate"].attrs
    stored = {name: attributes.get(name, np.nan) for name in found}  # earlier versions lack some
    for name, value in found.items():
        # The extremes are looked for at points, the others recomputed.
        tolerance = 1e-3 * abs(value) + 1e-9 if name in EXTREMES else 1e-8 * max(1, abs(value))
        tolerance = 1e-4 if name in ("joint_limit_margin", "clearance") else tolerance
        unbounded = name == "clearance" and np.isinf(value)  # nothing could touch
        good = unbounded or abs(stored[name] - value) <= tolerance
        if not good and not (np.isnan(value) and np.isnan(stored[name])):
            report.add("certificate", name, stored[name], value)

def goal_gaps(plan, asked, phases):
    """The largest share of missing goals in a phase, and the longest time without any goal."""
    time, followed = plan["goals/time"][()], asked[:, asked.any(axis=0)]
    names = {"preshape": "reach"}
    grasping = is_grasping(phases, time)

    def phase_at(t):
        around = [(end - begin, name) for name, begin, end in phases if begin <= t <= end and name not in REFINING]
        shortest = min(around, key=lambda row: row[0])[1] if around else ""
        return names.get(shortest, shortest)

    of_frame = np.array(["grasp" if holds else phase_at(t) for t, holds in zip(time, grasping)])
    shares = [1 - followed[of_frame == name].mean() for name in set(of_frame)] if followed.size else [0]
    seen = asked.any(axis=1)
    longest = 0
    for k in np.flatnonzero(~seen) if seen.any() else ():
        before, after = np.flatnonzero(seen[:k]), np.flatnonzero(seen[k:])
        begin = time[before[-1]] if len(before) else time[0]
        longest = max(longest, (time[k + after[0]] if len(after) else time[-1]) - begin)
    return max(shares), longest

def check_status(plan, status, farthest, phases, report):
    """What is called executable reaches what it allows; files of earlier versions do not say what that is."""
    if "max_unreachable_share" not in plan.attrs:
        return
    asked = np.isfinite(plan["goals/tip_position"][()]).all(axis=2)
    if "auto_closed" in plan["goals"]:
        asked &= plan["goals/auto_closed"][()] == 0
    out = plan["goals/reachable"][()] == 0
    share = (asked & out).sum() / asked.sum() if asked.any() else 0
    most, tip = plan.attrs["max_unreachable_share"], plan.attrs["max_tip_error"]
    missing, gap = goal_gaps(plan, asked, phases)
    kinds = [("max_unreachable_share", share, most, share > most or share == 1), ("max_tip_error", farthest, tip, farthest > tip)]
    for name, value in (("max_missing_goal_share", missing), ("max_goal_gap_s", gap)):
        limit = plan.attrs.get(name, np.inf)
        kinds.append((name, value, limit, value > limit))
    exceeded = [kind for kind in kinds if kind[3]]
    if status == "approximate":
        if not exceeded:
            report.add("status", "approximate", share, most)
        return
    for name, value, limit, _ in exceeded:
        report.add("status", name, value, limit)

def check_plan(robot, path, plan):
    report = Report(path)
    status, moves = text(plan.attrs["status"]), "trajectory" in plan
    should = status in ("executable", "approximate", "partial")
    if should != moves or (status in ("executable", "approximate")) != (text(plan.attrs["reason"]) == ""):
        report.add("structure", "trajectory", moves, should)
    for name, value in plan["certificate"].attrs.items() if not moves else ():
        if name not in ("repaired", "natural_posture_error", "unchecked_links") and not np.isnan(value):
            report.add("certificate", name, value, np.nan)
    for name, body in plan["scene"].items() if moves else ():
        corners = (body["vertices"], body["triangles"]) if text(body.attrs["shape"]) == "mesh" else ()
        if any(len(rows) == 0 or not np.isfinite(rows[()]).all() for rows in corners):
            report.add("structure", name, np.nan, np.nan)
    if moves and "remaining_findings" in plan:
        report.add("structure", "remaining_findings", len(plan["remaining_findings/excess"]), 0)
    if report.rows or not moves or not (motion := read_motion(robot, plan["trajectory"], report)):
        return report.rows
    phases = list(zip(plan["phases/name"].asstr(), plan["phases/begin_s"], plan["phases/end_s"]))
    goal_time, reached = plan["goals/time"][()], motion["demonstration_time"]
    for end in (0, -1) if len(goal_time) else ():
        if abs(reached[end] - goal_time[end]) > COVERAGE:
            report.add("time", "demonstration_time", reached[end], goal_time[end])
    found = check_limits(robot, motion, report)
    found.update(check_tracking(robot, plan, motion, phases, report))
    found.update(smoothness_of(robot, plan["goals"], motion))
    found["wrist_speed_correlation"] = wrist_correlation(robot, plan["goals"], motion)
    check_status(plan, status, found["tip_error_max"], phases, report)
    mapped = plan["mapped/humanlikeness"][()]
    found["humanlikeness_mapped"] = largest_and_mean(mapped[:, :1])[1]
    clearance = plan["trajectory/clearance"][()]
    kinds, *_ = check_contacts(robot, plan, motion, phases, clearance, report)
    told = kinds_of(plan)
    if any(told.get(kind, np.inf) < least - BETWEEN for kind, least in kinds.items()):  # nearer between the points
        kinds, *_ = check_contacts(robot, plan, motion, phases, clearance, Report(path), FINE_SUBSTEPS)
    for kind in sorted({*kinds, *told}) if told else ():
        if not abs((value := told.get(kind, np.nan)) - (least := kinds.get(kind, np.nan))) <= BETWEEN:
            report.add("certificate", f"clearance_by_kind/{kind}", value, least)
    found["clearance"] = min(kinds.values(), default=np.inf)
    human = np.ptp(motion["demonstration_time"])
    found["duration_ratio"] = motion["time"][-1] / human if human > 0 else np.nan
    poses = robot.frame_poses(motion["position"])
    found.update(held_figures(robot, plan, motion, phases, poses))
    check_certificate(plan, found, report)
    check_promises(robot, plan, motion, phases, report)
    check_branch(robot, plan, motion, report)
    check_grasp(robot, plan, motion, phases, poses, report)
    for name, end, meets in (("approach", -1, motion["position"][0]), ("retreat", 0, motion["position"][-1])):
        transfer = Report(path + "/" + name)
        if name in plan and (way := read_motion(robot, plan[name], transfer)):
            if not (gap := np.abs(way["position"][end] - meets).max()) <= TRANSFER_END:
                transfer.add("structure", name, gap, TRANSFER_END)
            check_limits(robot, way, transfer)
            check_contacts(robot, plan, way, phases, plan[name]["clearance"][()], transfer)
            check_transfer(plan, name, transfer)
        report.rows += transfer.rows
    return report.rows

def inputs_hash(file):
    """docs/formats.md at @inputs_sha256: the lines that sha256sum prints."""
    hashes = {}
    def add(name, item):
        if isinstance(item, h5py.Dataset):
            content = item[()]
            hashes[name.encode()] = sha256(content.tobytes() if isinstance(content, np.ndarray) else bytes(content))
    file["inputs"].visititems(add)
    lines = sha256(text(file.attrs["settings"]).encode()).encode() + b"  settings\n"
    lines += b"".join(hashes[name].encode() + b"  inputs/" + name + b"\n" for name in sorted(hashes))
    return sha256(lines + text(file.attrs["dataset_sha256"]).encode() + b"  dataset\n")

def sha256(content):
    return hashlib.sha256(content).hexdigest()

def check_header(file, report):
    if text(file.attrs["config_sha256"]) != sha256(text(file.attrs["config"]).encode()):
        report.add("config", "config_sha256", np.nan, np.nan)
    if text(file.attrs["inputs_sha256"]) != inputs_hash(file):
        report.add("config", "inputs_sha256", np.nan, np.nan)

def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    result = dict(executable=0, approximate=0, partial=0, infeasible=0, violations=[])
    try:
        with h5py.File(options.file, "r") as file:
            robot = Robot(file["robot"])
            plans, header = file["plans"], Report("")
            check_header(file, header)
            result["violations"] += header.rows
            paths = [f"{name}/{number}" for name in plans for number in plans[name]]
            if not paths:
                result["violations"] += [dict(plan="", sample=-1, time_s=0.0, cause="structure",
                                              subject="plans", value=0.0, limit=1.0)]
            for path in paths:
                result[text(plans[path].attrs["status"])] += 1
                result["violations"] += check_plan(robot, path, plans[path])
    except (OSError, KeyError) as error:
        print(f"{options.file}: {error}", file=sys.stderr)
        return 2
    if options.json:
        print(json.dumps(result, indent=1).replace("NaN", "null"))
    else:
        for row in result["violations"]:
            print("{plan}: sample {sample} ({time_s:.4f} s): {cause} {subject}: {value:.6g}, "
                  "limit {limit:.6g}".format(**row))
        print("{executable} executable, {approximate} approximate, {partial} partial, {infeasible} infeasible".format(**result))
    return 1 if result["violations"] else 0

if __name__ == "__main__":
    sys.exit(main())
