"""A plan's grasp judged from the file alone (docs/formats.md): poses, contacts, and the forces of its
squeeze. Epsilon and the newtons needed are told by `morphe verify` alone. Part of verify_plans.py;
causes and subjects are those of `morphe verify`."""
import numpy as np

from verify_geometry import Mesh, goals_at, segment_solid_distance, text
from verify_promises import pose_at

SAME, POINT, AXIS, UNIT = 1e-6, 1e-5, 2e-5, 1e-6
GAP, TILT, SLIDE = 2e-4, np.radians(60), 0.015  # of a contact that touches; m, rad, m
DRIFT, TURN = 5e-4, np.radians(1)  # of a pad in the hand that carries; m, rad

def check_grasp(robot, plan, motion, phases, poses, report):
    target = text(plan.attrs["target"])
    grasps = [begin for name, begin, _ in phases if name == "grasp"]
    if "grasp" not in plan:
        if grasps and target in plan["scene"]:
            report.add("grasp", "missing", -1, 0)
        return
    grasp, time = plan["grasp"], motion["demonstration_time"]
    if target not in plan["scene"]:
        return report.add("grasp", "target", np.nan, np.nan)
    sample = min(int(np.searchsorted(time, grasps[0])), len(time) - 1) if grasps else -1
    if grasp.attrs["sample"] != sample:
        return report.add("grasp", "sample", grasp.attrs["sample"], sample)
    q, here = motion["position"][sample], poses[sample]
    base_from_object = pose_at(plan["scene"][target], time[sample])
    object_from_base = np.linalg.inv(base_from_object)
    tip_at = lambda p, m: (p[..., robot.tips["frame"][m], :, :] @ robot.tips["transform"][m])[..., :3, 3]
    own = dict(grasp_posture=q, object_pose=base_from_object,
               palm_pose_in_object=object_from_base @ here[robot.palm],
               tips_in_object=np.array([(object_from_base @ np.r_[tip_at(here, m), 1])[:3]
                                        for m in range(len(robot.tip_names))]))
    for name, value in own.items():
        if not np.abs(grasp[name][()] - value).max(initial=0) <= SAME:
            report.add("grasp", name, np.abs(grasp[name][()] - value).max(), SAME)
    thumb, index = (np.flatnonzero(robot.fingers == finger)[:1] for finger in (0, 1))
    postures, wide = motion["position"][:1], np.zeros(1)
    if len(thumb) and len(index):
        postures = motion["position"][:sample + 1]
        wide = np.linalg.norm(tip_at(poses[:sample + 1], thumb[0]) - tip_at(poses[:sample + 1], index[0]), axis=1)
    same = np.abs(postures - grasp["pregrasp_posture"][()]).max(axis=1) <= SAME
    if not (same & (wide.max() - wide <= SAME)).any():
        report.add("grasp", "pregrasp_posture", np.nan, SAME)
    check_who_touches(robot, plan, time[sample], report)
    held = held_figures(robot, plan, motion, phases, poses)
    for name, limit in (("held_drift", DRIFT), ("held_turn", TURN)):
        if held[name] > limit:
            report.add("contact", name, held[name], limit)
    if "contacts" in grasp:
        check_contacts(robot, plan, here, object_from_base, report)
        check_squeeze(robot, plan, here, base_from_object, motion, sample, report)

def held_figures(robot, plan, motion, phases, poses):
    """By how much touching pads move and turn in the palm while the target is carried."""
    found = {"held_drift": np.nan, "held_turn": np.nan}
    ways = [(begin, end) for name, begin, end in phases if name == "transport"]
    if not text(plan.attrs["target"]) or not any(b < plan.attrs["end_s"] for b, _ in ways) or "grasp/contacts" not in plan:
        return found
    sample, contacts = plan["grasp"].attrs["sample"], plan["grasp/contacts"]
    held = np.flatnonzero(motion["demonstration_time"] <= ways[-1][1])
    held = held[held >= sample]
    from_palm = np.linalg.inv(poses[held, robot.palm])
    names, pads = [text(t) for t in robot.tip_names], robot.pads()
    for k in np.flatnonzero(touches(contacts)):
        m = names.index(text(contacts["tip"][k]))
        link = from_palm @ poses[held, robot.tips["frame"][m]]
        place = link @ np.r_[pads[m][1], 1]
        turn = np.einsum("ij,kjl->kil", link[0, :3, :3].T, link[:, :3, :3])
        chord = np.linalg.norm(turn - np.eye(3), axis=(1, 2)) / np.sqrt(8)
        found = {"held_drift": np.fmax(found["held_drift"], np.linalg.norm(place - place[0], axis=1).max()),
                 "held_turn": np.fmax(found["held_turn"], 2 * np.arcsin(np.minimum(chord, 1)).max())}
    return found

def check_who_touches(robot, plan, time, report):
    goals, contacts = plan["goals"], plan["grasp"].get("contacts")
    tips = [text(t) for t in contacts["tip"][()]] if contacts else []
    for m, name in enumerate(text(t) for t in robot.tip_names):
        share = 0
        if "tip_to_pad_share" in goals:
            share = np.interp(time, goals["time"][()], goals["tip_to_pad_share"][:, m])
        if tips.count(name) != (share > 0):
            report.add("contact", name + "/missing", tips.count(name), share > 0)
        closed = "auto_closed" in goals and goals["auto_closed"][m] == 1
        for k in (k for k, tip in enumerate(tips) if tip == name):
            if (text(contacts["origin"][k]) == "auto_closed") != closed:
                report.add("contact", name + "/origin", not closed, closed)

class Surface:
    """The target, and signed distances to it, in its frame."""

    def __init__(self, group):
        self.shape, self.size = text(group.attrs["shape"]), group.attrs.get("size")
        self.mesh = Mesh(group["vertices"][()], group["triangles"][()]) if self.shape == "mesh" else None

    def distance(self, a, b):
        a, b = np.atleast_2d(a), np.atleast_2d(b)
        return (self.mesh.segment_distance(a, b) if self.mesh else
                segment_solid_distance(self.shape, self.size, a, b))

    def outwards(self, point):
        steps = 1e-6 * np.eye(3)
        return (self.distance(point + steps, point + steps) - self.distance(point - steps, point - steps)) / 2e-6

def angle(a, b):
    return np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)

def touches(contacts):
    return (contacts["signed_distance"][()] <= GAP) & (contacts["pad_angle"][()] <= TILT)

def check_contacts(robot, plan, here, object_from_base, report):
    contacts, surface = plan["grasp/contacts"], Surface(plan["scene"][text(plan.attrs["target"])])
    names, pads = [text(t) for t in robot.tip_names], robot.pads()
    for k, tip in enumerate(text(t) for t in contacts["tip"][()]):
        note = lambda what, value, limit: report.add("contact", f"{tip}/{what}", value, limit)
        capsule = pads[names.index(tip)][0] if tip in names else -1
        if capsule < 0 or text(robot.capsule_names[capsule]) != text(contacts["link"][k]):
            note("link", np.nan, np.nan)
            continue
        asked, point, normal, gap, turned, sure = (
            contacts[name][k] for name in ("desired_point", "point", "normal", "signed_distance", "pad_angle", "confidence"))
        if not 0 <= sure <= 1:
            note("confidence", sure, 1)
        if not np.isfinite(np.r_[asked, point, normal, gap, turned]).all():
            report.add("finite", "grasp/contacts/" + tip, np.nan, np.nan)
            continue
        caps = robot.capsules
        pose, radius = here[caps["frame"][capsule]], caps["radius"][capsule]
        a, b = ((object_from_base @ pose @ np.r_[caps[end][capsule], 1])[:3] for end in ("from", "to"))
        for what, place in (("desired_point", asked), ("point", point)):
            if not abs(away := surface.distance(place, place)[0]) <= POINT:
                note(what, abs(away), POINT)
        m, when = names.index(tip), plan["trajectory/demonstration_time"][plan["grasp"].attrs["sample"]]
        goal = goals_at(plan["goals"], "tip_position", m, np.array([when]))[0]
        share = 0
        if "tip_to_pad_share" in plan["goals"]:
            share = np.interp(when, plan["goals/time"][()], plan["goals/tip_to_pad_share"][:, m])
        off = np.linalg.norm((object_from_base @ np.r_[goal, 1])[:3] - asked) - radius
        if text(contacts["origin"][k]) == "auto_closed":
            frames = plan["goals/time"][()]
            after = min(np.searchsorted(frames, when), len(frames) - 1)
            still = np.linalg.norm(np.subtract(*plan["goals/tip_position"][max(after - 1, 0):][:2, m]))
            off = max(-off - still, off - still - np.linalg.norm(b - a))
        else:
            off = abs(off)
        if np.isfinite(off) and not off <= POINT + 0.05 * (1 - share):
            note("desired_point", off, POINT)
        own = surface.distance(a, b)[0] - radius
        if not abs(gap - own) <= POINT:
            note("signed_distance", gap, own)
        if not own >= -plan.attrs["max_penetration"] - 1e-6:
            note("penetration", -own, plan.attrs["max_penetration"])
        on_axis = point - (radius + own) * normal
        share = np.clip((on_axis - a) @ (b - a) / max((b - a) @ (b - a), 1e-99), 0, 1)
        if not np.linalg.norm(on_axis - a - share * (b - a)) <= AXIS:
            note("pad", np.linalg.norm(on_axis - a - share * (b - a)), AXIS)
        unit = abs(np.linalg.norm(normal) - 1) <= UNIT
        if not unit or not angle(-normal, surface.outwards(on_axis)) <= 1e-3:
            note("normal", np.nan, 1e-3)
        middle = (object_from_base[:3, :3] @ here[robot.tips["frame"][names.index(tip)], :3, :3]
                  @ robot.tips["transform"][names.index(tip), :3, 0])
        if not abs(turned - angle(middle, normal)) <= 1e-6:
            note("pad_angle", turned, angle(middle, normal))
        if (text(contacts["state"][k]) == "touching") != touches(contacts)[k]:
            note("state", np.nan, np.nan)
        shown = contacts["demonstrated_point"][k]
        if text(contacts["origin"][k]) == "auto_closed":
            off = 0 if np.isnan(shown).all() else np.inf
        else:
            off = max(abs(surface.distance(shown, shown)[0]), np.linalg.norm(asked - shown) - SLIDE)
        if not off <= POINT:
            note("demonstrated_point", off, POINT)

def left_over(wrench, ways):
    """Norm of what moments, each up to its way's length, leave of a wrench: one after the other."""
    share, torque = np.zeros(len(ways)), wrench[3:].copy()
    for _ in range(1000):
        for k, way in enumerate(ways):
            if not way @ way > 0:
                continue
            others = torque - share[k] * way
            share[k] = np.clip(-(others @ way) / (way @ way), -1, 1)
            torque = others + share[k] * way
    return np.hypot(np.linalg.norm(wrench[:3]), np.linalg.norm(torque))

def check_squeeze(robot, plan, here, base_from_object, motion, sample, report):
    """Forces within their cones that balance, torques that make them, beside the trajectory."""
    grasp, contacts, quality = plan["grasp"], plan["grasp/contacts"], plan["grasp/quality"].attrs
    tips = [text(t) for t in contacts["tip"][()]]
    touching = np.flatnonzero(touches(contacts))
    presses = set(touching) if len(touching) >= 2 else set()
    force, friction = contacts["normal_force"][()], contacts["friction_force"][()]
    for k, tip in enumerate(tips):
        if k not in presses and not (np.isnan(force[k]) and np.isnan(friction[k]).all()):
            report.add("grasp_force", tip + "/normal_force", force[k], np.nan)
    if "grasp_force" not in grasp:  # nothing balances where the signed epsilon is not above 0
        if len(touching) >= 2 and quality["epsilon_lower"] > 1e-3:
            report.add("grasp_force", "torque", np.nan, np.nan)
        return
    if not presses:
        return report.add("grasp_force", "torque", np.nan, np.nan)
    torque, target = grasp["grasp_force/torque"][()], grasp["grasp_force/servo_target"][()]
    if not np.isfinite(np.r_[torque, target]).all():
        return report.add("finite", "grasp/grasp_force", np.nan, np.nan)
    wrench, ways, own, q = np.zeros(6), [], np.zeros(len(torque)), motion["position"][sample]
    for k in touching:
        point, normal = contacts["point"][k], contacts["normal"][k]
        if not force[k] >= 0:
            report.add("grasp_force", tips[k] + "/normal_force", force[k], 0)
        most, used = quality["friction_coefficient"] * force[k], np.linalg.norm(friction[k])
        if not max(used - most, abs(friction[k] @ normal)) <= 1e-6 * max(1, force[k]):
            report.add("grasp_force", tips[k] + "/friction_cone", used, most)
        whole = force[k] * normal + friction[k]
        wrench += np.r_[whole, np.cross((point - quality["centre_of_mass"]) / quality["characteristic_length"], whole)]
        spare = np.sqrt(max(0, 1 - min(1, used / most if most > 0 else 1)**2))
        ways.append(quality["torsional_friction"] * force[k] * spare / quality["characteristic_length"] * normal)
        own += levers(robot, q, robot.tips["frame"][[text(t) for t in robot.tip_names].index(tips[k])],
                      (base_from_object @ np.r_[point, 1])[:3]) @ (base_from_object[:3, :3] @ whole)
    left, allowed = left_over(wrench, ways), 0.03 * force[touching].max() + 2e-3
    if not left <= allowed:
        report.add("grasp_force", "force_balance", left, allowed)
    if not np.abs(torque - own).max() <= 1e-6:
        report.add("grasp_force", "torque", np.abs(torque - own).max(), 1e-6)
    turned = target - grasp["grasp_posture"][()]
    if torque.any():  # one stiffness for all
        stiffness = torque @ torque / (torque @ turned) if torque @ turned else np.inf
        if not np.abs(turned - torque / stiffness).max() <= 1e-6:
            report.add("grasp_force", "servo_target", np.abs(turned - torque / stiffness).max(), 1e-6)
    if np.abs(turned).max() > 1e-6:
        moved = np.abs(motion["position"][sample:] - target)[:, torque != 0]
        if (moved.max(axis=1, initial=0) <= 1e-6).any():
            report.add("grasp_force", "trajectory", 0, 1e-6)

def levers(robot, q, frame, point):
    """How a point on a frame moves with each joint of the fingers, by differences [n, 3]."""
    palm, f, way = robot.palm, robot.frames, np.zeros((len(q), 3))
    of_arm, at = set(), palm
    while at >= 0:
        of_arm.add(int(f["joint"][at]))
        at = f["parent"][at]
    in_frame = np.linalg.inv(robot.frame_poses(q[None])[0, frame]) @ np.r_[point, 1]
    for j in set(range(len(q))) - of_arm:
        step = np.zeros(len(q))
        step[j] = 1e-6
        ends = robot.frame_poses(np.stack([q + step, q - step]))[:, frame] @ in_frame
        way[j] = (ends[0] - ends[1])[:3] / 2e-6
    return way
