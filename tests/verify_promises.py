"""What a plan says of the person, the scene and itself beside its motion, judged from the file alone
(docs/formats.md): phases, goals, scene, mapped frames, path, approach and retreat. Part of
verify_plans.py; causes and subjects are those of `morphe verify`."""
import numpy as np

from verify_geometry import asked_points, in_base, text

BORDER, POSE, STEP = 1e-9, 1e-6, 1e-6  # s; m and entries of matrices; s
ASIDE_RAD, ASIDE_M, MET = 0.2, 0.1, 0.001
KINDS = ("rest", "reach", "preshape", "grasp", "hold", "transport", "return",
         "approach", "lift", "place", "release", "retreat", "home")
REFINING = KINDS[KINDS.index("lift"):]  # transport and return
STAGE = dict(rest=0, reach=1, grasp=2, hold=3, transport=3) | {"return": 4}

def matrix(quaternion):
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])

def pose_at(group, time):
    """Where an object was recorded to be: linear and slerp, held at the ends [4, 4]."""
    t, p, o = group["time"][()], group["position"][()], group["orientation"][()]
    b = int(np.searchsorted(t, time, side="right"))
    if b == 0 or len(t) == 1:
        place, turn = p[0], o[0]
    elif b == len(t):
        place, turn = p[-1], o[-1]
    else:
        share = (time - t[b - 1]) / (t[b] - t[b - 1])
        cosine = o[b - 1] @ o[b]
        end, angle = (-o[b] if cosine < 0 else o[b]), np.arccos(min(abs(cosine), 1))
        weight = lambda u: u * np.sinc(u * angle / np.pi) / np.sinc(angle / np.pi)
        place = (1 - share) * p[b - 1] + share * p[b]
        turn = weight(1 - share) * o[b - 1] + weight(share) * end
    out = np.eye(4)
    out[:3, :3], out[:3, 3] = matrix(turn / np.linalg.norm(turn)), place
    return out

def check_refining(phases, sure, report):
    """Lift, place, release, retreat and home are where transport and return say, and in this order."""
    named = lambda kind: [(begin, end) for name, begin, end in phases if name == kind]
    carries, backs = named("transport"), named("return")
    allowed = {}
    if carries:
        allowed["lift"] = carries[0]
    if carries and backs:
        allowed["place"] = carries[-1]
        for kind in ("release", "retreat", "home"):
            allowed[kind] = (carries[-1][1], backs[-1][1])
    before = None
    for (name, begin, end), confidence in zip(phases, sure):
        if name not in REFINING:
            continue
        low, high = allowed.get(name, (np.inf, -np.inf))
        good = begin <= end and 0 <= confidence <= 1 and begin >= low - BORDER and end <= high + BORDER
        good &= name != "lift" or abs(begin - low) <= BORDER
        good &= name != "place" or abs(end - high) <= BORDER
        if before:
            good &= KINDS.index(before[0]) < KINDS.index(name)
            good &= name == "place" or begin >= before[1] - BORDER
        if not good:
            report.add("phase", name, begin, end)
        before = (name, end)

def check_delivered(plan, phases, report):
    """How far a partial plan goes; whether the config allows it is for `morphe verify`."""
    if text(plan.attrs["status"]) != "partial":
        return
    until, end_s = text(plan.attrs["delivered_until"]), plan.attrs["end_s"]
    grasps = any(name == "grasp" for name, _, _ in phases)
    ends = [end for name, _, end in phases if name == until][-1:] or [np.nan]
    may_end = until not in ("rest", "reach", "preshape", "hold", "approach") if grasps else until == "reach"
    if not (may_end and abs(ends[0] - end_s) <= BORDER):
        report.add("status", "delivered_until", end_s, ends[0])
    if not plan.attrs["requested_end_s"] > end_s + BORDER:
        report.add("status", "requested_end_s", plan.attrs["requested_end_s"], end_s)

def check_phases(plan, motion, phases, report):
    sure = plan["phases/confidence"][()]
    before, preshapes, grasps = None, 0, 0
    for (name, begin, end), confidence in zip(phases, sure):
        if name in REFINING:
            continue
        if name == "approach":
            report.add("phase", name, begin, np.nan)
            continue
        if not (np.isfinite([begin, end]).all() and begin <= end and 0 <= confidence <= 1):
            report.add("phase", name, begin, end)
        if name == "preshape":
            inside = before and before[0] == "reach" and not preshapes
            if not (inside and begin >= before[1] - BORDER and end <= before[2] + BORDER):
                report.add("phase", name, begin, before[1] if before else np.nan)
            preshapes += 1
            continue
        grasps += name == "grasp"
        if before:
            wrong = STAGE[before[0]] > STAGE[name] and not (
                grasps == 0 and (before[0], name) == ("hold", "reach"))
            if begin < before[2] - BORDER or wrong:
                report.add("phase", name, begin, before[2])
        if name == "grasp" and grasps > 1:
            report.add("phase", name, begin, np.nan)
        before = (name, begin, end)
    check_refining(phases, sure, report)
    if phases:
        if not plan.attrs["begin_s"] >= phases[0][1] - BORDER:
            report.add("phase", "movement", plan.attrs["begin_s"], phases[0][1])
        if not plan.attrs["end_s"] <= (last := max(end for _, _, end in phases)) + BORDER:
            report.add("phase", "movement", plan.attrs["end_s"], last)
    time, said = motion["demonstration_time"], plan["trajectory/phase"][()]
    within = lambda begin, end: (time >= begin + BORDER) & (time <= end - BORDER)
    refined, least = np.zeros(len(time), bool), {True: np.full(len(time), np.inf), False: np.full(len(time), np.inf)}
    for name, begin, end in phases:
        inside, shortest = within(begin, end), least[name in REFINING]
        refined |= inside & (name in REFINING)
        shortest[inside] = np.minimum(shortest[inside], end - begin)
    good = (said == 0) & np.isinf(least[False]) & ~refined
    for name, begin, end in phases:
        around = (time >= begin - BORDER) & (time <= end + BORDER) & (~refined | (name in REFINING))
        good |= around & (said == KINDS.index(name)) & (end - begin <= least[name in REFINING])
    report.add_runs("phase", "trajectory", ~good, np.zeros(len(time)),
                    lambda k: (said[k], np.nan, k, motion["time"][k]))

def check_goals(robot, plan, phases, report):
    goals, time, tips = plan["goals"], plan["goals/time"][()], plan["goals/tip_position"][()]
    if len(time) < 5:
        report.add("goals", "time", len(time), 5)
    else:
        step = (time[-1] - time[0]) / (len(time) - 1)
        if (np.abs(np.diff(time) - step) > STEP).any():
            report.add("goals", "time", np.diff(time).max(), step)
        for own, wanted in ((time[0], plan.attrs["begin_s"]), (time[-1], plan.attrs["end_s"])):
            if not abs(own - wanted) < step + STEP:
                report.add("goals", "time", own, wanted)
    seen = np.isfinite(tips).all(axis=2)
    any_seen = seen.any(axis=1)
    grasping = np.zeros(len(time), bool)
    for name, begin, end in phases:
        grasping |= (name in ("grasp", "hold")) & (time >= begin) & (time <= end)
    if not any_seen.any() or (grasping.any() and not any_seen[grasping].any()):
        report.add("goals", "tip_position", any_seen[grasping].sum(), grasping.sum())
    if (~seen & ~np.isnan(tips).all(axis=2)).any():
        report.add("goals", "tip_position", np.nan, np.nan)
    for name in ("tip_orientation", "wrist_orientation"):
        turns = goals[name][()]
        if not (np.isnan(turns).all(axis=-1) | (np.abs(np.linalg.norm(turns, axis=-1) - 1) < 1e-6)).all():
            report.add("goals", name, np.nan, np.nan)
    if (goals["reachable"][()] > 1).any():
        report.add("goals", "reachable", np.nan, 1)

def check_scene(robot, plan, phases, report):
    scene, target = plan["scene"], text(plan.attrs["target"])
    if target and target not in scene:
        report.add("scene", "target", np.nan, np.nan)
    last = lambda name: [p for p in phases if p[0] == name][-1:]
    for name, group in scene.items():
        frame = text(group.attrs["attached_frame"]) if "attached_frame" in group.attrs else ""
        attach, release = (group.attrs.get(key, np.nan) for key in ("attach_s", "release_s"))
        if name != target and np.isnan(attach) and np.isnan(release) and not frame:
            continue
        if name != target or np.isnan(attach) or (frame and frame not in robot.frame_names):
            report.add("scene", name, np.nan, np.nan)
            continue
        grasp, transport = last("grasp"), last("transport")
        if not grasp or not abs(attach - grasp[0][2]) <= BORDER:
            report.add("scene", name, attach, np.nan)
        elif transport and not abs(release - transport[0][2]) <= BORDER:
            report.add("scene", name, release, transport[0][2])
        elif not transport and not release >= max(plan.attrs["end_s"], grasp[0][2]) - BORDER:
            report.add("scene", name, release, plan.attrs["end_s"])
    if "reference_frames" not in plan:
        return
    world, begin = plan["reference_frames"], plan.attrs["begin_s"]
    turn = world["recording"][:3, :3]
    if not np.abs(turn @ turn.T - np.eye(3)).max() <= POSE or np.linalg.det(turn) < 0:
        report.add("scene", "reference_frames/recording", np.nan, np.nan)
    wanted = dict(table=None, target=None)
    if "table" in scene and text(scene["table"].attrs["shape"]) == "box":
        wanted["table"] = pose_at(scene["table"], begin)
        wanted["table"][:3, 3] += scene["table"].attrs["size"][2] / 2 * wanted["table"][:3, 2]
    if target in scene:
        wanted["target"] = pose_at(scene[target], begin)
    for name, own in wanted.items():
        stored = world[name][()]
        good = np.isnan(stored).any() if own is None else np.abs(stored - own).max() <= POSE
        if not good:
            report.add("scene", "reference_frames/" + name, np.nan, POSE)

def check_mapped(robot, plan, report):
    mapped, goals = plan["mapped"], plan["goals"]
    q, time = mapped["position"][()], goals["time"][()]
    if len(q) != len(time) or not np.isfinite(q).all():
        return report.add("mapped", "position", len(q), len(time))
    if not np.isfinite(mapped["objective"][()]).all():
        report.add("mapped", "objective", np.nan, np.nan)
    poses, worst = robot.frame_poses(q), {}
    def compare(name, stored, own):
        gap = np.abs(stored - own) / np.maximum(1, np.abs(own))
        gap[np.isnan(stored) & np.isnan(own)] = 0
        if not (gap <= 1e-6).all():
            report.add("mapped", name, np.nan, np.nan)
    tips = range(len(robot.tip_names))
    errors = np.stack([np.linalg.norm(asked_points(robot, goals, m, time, poses)
                                      - goals["tip_position"][:, m], axis=1) for m in tips], axis=1)
    turns = []
    for m in tips:
        turn = poses[:, robot.tips["frame"][m], :3, :3] @ robot.tips["transform"][m, :3, :3]
        goal = np.array([matrix(o) for o in goals["tip_orientation"][:, m]])
        turns.append(2 * np.arcsin(np.minimum(np.linalg.norm(turn - goal, axis=(1, 2)) / 8**0.5, 1)))
    compare("tip_error", mapped["tip_error"][()], errors)
    compare("tip_orientation_error", mapped["tip_orientation_error"][()], np.array(turns).T)
    arm = [frame for frame, chain in zip(robot.centres, robot.chains) if chain == "arm"]
    elbow = goals["elbow_position"][()]
    sums = sum((((in_base(poses, frame, np.zeros(3)) - elbow)**2).sum(axis=1) for frame in arm),
               np.zeros(len(q)) if arm else np.full(len(q), np.nan))
    compare("humanlikeness", mapped["humanlikeness"][:, 0], sums)
    seen = np.isfinite(errors)
    met = lambda by: (~seen | (errors < MET + by)).all(axis=1)
    reachable = (~seen | (goals["reachable"][()] != 0)).all(axis=1)
    own = np.where(~seen.any(axis=1), 3, np.where(met(-1e-9), 0, np.where(reachable, 1, 2)))
    said = mapped["status"][()]
    if ((said != own) & ~((said == 0) & seen.any(axis=1) & met(1e-9))).any():
        report.add("mapped", "status", np.nan, np.nan)

def check_path(robot, plan, motion, report):
    path, goal_time = plan["path"], plan["goals/time"][()]
    q, time, origin = path["position"][()], path["demonstration_time"][()], path["origin"][()]
    if not len(time) or not len(goal_time) or not np.isfinite(time).all() or (np.diff(time) < 0).any():
        return report.add("path", "demonstration_time", len(time), 1)
    if not np.isfinite(q).all():
        return report.add("path", "position", np.nan, np.nan)
    for end in (0, -1):
        if not abs(time[end] - goal_time[end]) <= BORDER:
            report.add("path", "demonstration_time", time[end], goal_time[end])
    mapped = plan["mapped/position"][()]
    if len(mapped) == len(goal_time):
        own = np.stack([np.interp(time, goal_time, mapped[:, j]) for j in range(mapped.shape[1])], axis=1)
        if not (np.abs(q - own)[origin == 0] <= 1e-9).all():
            report.add("path", "position", np.nan, 1e-9)
    slides = [bool(len(of := np.flatnonzero(robot.frames["joint"] == j)) and robot.slides[of[0]])
              for j in range(q.shape[1])]
    most = np.where(slides, ASIDE_M, ASIDE_RAD)
    t = motion["demonstration_time"]
    first = np.maximum(np.searchsorted(time, t - BORDER) - 1, 0)
    last = np.minimum(np.searchsorted(time, t + BORDER, side="right"), len(time) - 1)
    low, high, there = np.full((len(t), q.shape[1]), np.inf), np.full((len(t), q.shape[1]), -np.inf), np.zeros(len(t), bool)
    for k in range(int((last - first).max()) + 1):
        row = np.minimum(first + k, last)
        low, high = np.minimum(low, q[row]), np.maximum(high, q[row])
        there |= origin[row] == plan["trajectory/origin"][()]
    off = (np.maximum(low - motion["position"], motion["position"] - high) - most).max(axis=1)
    at = lambda k: (off[k], np.nan, k, motion["time"][k])
    report.add_runs("path", "trajectory", ~(off <= 0), off, at)
    report.add_runs("path", "origin", ~there, np.zeros(len(t)), at)

def check_transfer(plan, name, report):
    time, way = plan[name]["demonstration_time"][()], plan["trajectory/demonstration_time"][()]
    stands = way[0] if name == "approach" else way[-1]
    if (np.abs(time - stands) > BORDER).any():
        report.add("approach_retreat", "demonstration_time", time.max(), stands)
    said = plan[name]["phase"][()]
    if ((said != 0) & (said != KINDS.index(name))).any():  # files of earlier versions say rest
        report.add("approach_retreat", "phase", said.max(), 0)

def check_promises(robot, plan, motion, phases, report):
    check_phases(plan, motion, phases, report)
    check_delivered(plan, phases, report)
    check_goals(robot, plan, phases, report)
    check_scene(robot, plan, phases, report)
    check_mapped(robot, plan, report)
    check_path(robot, plan, motion, report)
