"""Robots, solids and meshes of a plans.h5, and distances between them, for verify_plans.py and the
tests: nothing of it is shared with Morphe."""
import numpy as np

POINTS = np.linspace(0, 1, 33)  # of a segment in a solid mesh

def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)

def columns(group, *names):
    return {name: group[name][()] for name in names}

class Robot:
    def __init__(self, group):
        self.joints, self.tip_names = group["joint_names"].asstr()[()], group["tips/name"].asstr()[()]
        self.limits = columns(group, "lower", "upper", "velocity", "acceleration", "jerk")
        self.frames = columns(group["frames"], "parent", "transform", "axis", "joint", "ratio", "offset")
        self.frame_names = group["frames/name"].asstr()[()]
        count = len(self.frame_names)
        self.slides = group["frames/prismatic"][()] if "prismatic" in group["frames"] else np.zeros(count)
        self.tips = columns(group["tips"], "frame", "transform")
        self.capsules = columns(group["capsules"], "frame", "from", "to", "radius", "may_touch_target")
        self.capsule_names = group["capsules/name"].asstr()[()]
        self.centres, self.chains = group["joint_centres/frame"][()], group["joint_centres/chain"].asstr()[()]
        self.braking = columns(curves, *curves) if (curves := group.get("braking_curves")) else {}
        self.shoulder, self.palm = int(group.attrs["shoulder_frame"]), int(group.attrs["palm_frame"])
        self.fingers = group["tips/finger"][()]
        self.allowed = {tuple(sorted(p)) for p in group["allowed_collision_pairs"][()].reshape(-1, 2).tolist()}

    def frame_poses(self, q):
        """base_from_frame [N, J + 1, 4, 4] for joint positions [N, n]; index -1 is the base."""
        f = self.frames
        poses = np.tile(np.eye(4), (len(q), len(f["parent"]) + 1, 1, 1))
        for i, parent in enumerate(f["parent"]):
            turn = np.tile(np.eye(4), (len(q), 1, 1))
            if f["joint"][i] >= 0:
                angle = (f["ratio"][i] * q[:, f["joint"][i]] + f["offset"][i])[:, None, None]
                x, y, z = f["axis"][i]
                if self.slides[i]:
                    turn[:, :3, 3] = angle[:, :, 0] * f["axis"][i]
                    poses[:, i] = poses[:, parent] @ f["transform"][i] @ turn
                    continue
                cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                turn[:, :3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
            poses[:, i] = poses[:, parent] @ f["transform"][i] @ turn
        return poses

    def pads(self):
        """Of each tip the capsule and the end of it that are nearest to it, of those that are fixed to
        it, in its frame: (capsule, centre); (-1, its own place) if there is none."""
        f, caps = self.frames, self.capsules
        def carrier(frame):
            while frame >= 0 and f["joint"][frame] < 0:
                frame = f["parent"][frame]
            return frame
        poses, found = self.frame_poses(np.zeros((1, len(self.joints))))[0], []
        for frame, transform in zip(self.tips["frame"], self.tips["transform"]):
            best = (np.inf, -1, transform[:3, 3])
            for c, (on, *ends) in enumerate(zip(caps["frame"], caps["from"], caps["to"])):
                if carrier(on) != carrier(frame):
                    continue
                for end in ends:
                    centre = (np.linalg.inv(poses[frame]) @ poses[on] @ np.r_[end, 1])[:3]
                    best = min(best, (np.linalg.norm(centre - transform[:3, 3]), c, centre), key=lambda x: x[0])
            found.append(best[1:])
        return found

def in_base(poses, frame, point):
    """A point that is fixed in a frame, in the base frame [N, 3]."""
    return poses[:, frame, :3, :3] @ point + poses[:, frame, :3, 3]

def goals_at(goals, name, m, time):
    rows = goals[name][:, m] if m is not None else goals[name][()]
    return np.stack([np.interp(time, goals["time"][()], rows[:, i]) for i in range(3)], axis=1)

def asked_points(robot, goals, m, time, poses):
    """Where what a tip's goals are for is: the tip, or so much of the way to its pad."""
    frame, own = robot.tips["frame"][m], robot.tips["transform"][m, :3, 3]
    at = in_base(poses, frame, own)
    if "tip_to_pad_share" not in goals:
        return at
    share = np.interp(time, goals["time"][()], goals["tip_to_pad_share"][:, m])[:, None]
    return at + share * (in_base(poses, frame, robot.pads()[m][1]) - at)

def segment_distance(p, p_end, q, q_end):
    """Least distance of segments, [N, 3] each: best point of one, then of the other, clamped."""
    u, v, w = p_end - p, q_end - q, p - q
    dot = lambda a, b: np.einsum("ni,ni->n", a, b)
    uu, vv, uv, uw, vw = dot(u, u) + 1e-99, dot(v, v) + 1e-99, dot(u, v), dot(u, w), dot(v, w)
    area = uu * vv - uv * uv
    parallel = area <= 1e-12 * uu * vv
    s = np.where(parallel, 0, np.clip((uv * vw - vv * uw) / np.where(parallel, 1, area), 0, 1))
    t = np.clip((uv * s + vw) / vv, 0, 1)
    s = np.clip((uv * t - uw) / uu, 0, 1)
    return np.linalg.norm(w + s[:, None] * u - t[:, None] * v, axis=1)

def signed_distance(shape, size, p):
    """Of points [N, 3] in the solid's frame, < 0 inside."""
    if shape in ("sphere", "capsule"):
        half = size[1] / 2 if shape == "capsule" else 0
        axis = np.clip(p[:, 2:], -half, half) * [0, 0, 1]
        return np.linalg.norm(p - axis, axis=1) - size[0]
    if shape == "box":
        d = np.abs(p) - np.asarray(size) / 2
    else:  # cylinder
        d = np.stack([np.hypot(p[:, 0], p[:, 1]) - size[0], np.abs(p[:, 2]) - size[1] / 2], axis=1)
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

def nearest_in(shape, size, p):
    """The points of a solid that are nearest to points [N, 3], both in its frame."""
    if shape == "box":
        return np.clip(p, -np.asarray(size) / 2, np.asarray(size) / 2)
    if shape == "cylinder":
        shrink = np.minimum(1, size[0] / (np.hypot(p[:, 0], p[:, 1]) + 1e-99))
        return np.c_[p[:, :2] * shrink[:, None], np.clip(p[:, 2], -size[1] / 2, size[1] / 2)]
    axis = np.clip(p[:, 2:], *(np.array([-1, 1]) * (size[1] / 2 if shape == "capsule" else 0))) * [0, 0, 1]
    return axis + (p - axis) * np.minimum(1, size[0] / (np.linalg.norm(p - axis, axis=1) + 1e-99))[:, None]

def farthest_in(shape, size, way):
    """The points of a solid that are farthest in directions [N, 3]."""
    if shape == "box":
        return np.where(way < 0, -0.5, 0.5) * size
    if shape == "cylinder":
        flat = size[0] * way[:, :2] / (np.hypot(way[:, 0], way[:, 1]) + 1e-99)[:, None]
        return np.c_[flat, np.where(way[:, 2] < 0, -0.5, 0.5) * size[1]]
    half = size[1] / 2 if shape == "capsule" else 0
    return size[0] * way + np.where(way[:, 2:] < 0, -half, half) * [0, 0, 1]

def radius_about_centre(shape, size):
    """Of a ball that contains the solid."""
    return {"sphere": size[0], "box": np.linalg.norm(size) / 2, "capsule": size[0] + size[-1] / 2,
            "cylinder": np.hypot(size[0], size[-1] / 2)}[shape]

def projected_points(a, b, turn, place, rounds=20_000, still=1e-7):
    """The nearest points of convex solids, as below, by projections on one and the other until they
    stand still, which takes long for faces that are nearly parallel."""
    on_a, on_b, left = place.copy(), place.copy(), np.arange(len(place))
    for _ in range(rounds):
        before, turned, placed = on_b[left], turn[left], place[left]
        on_a[left] = nearest_in(*a, before)
        own = nearest_in(*b, np.einsum("nji,nj->ni", turned, on_a[left] - placed))
        on_b[left] = np.einsum("nij,nj->ni", turned, own) + placed
        left = left[np.abs(on_b[left] - before).max(axis=1) > still]
        if len(left) == 0:
            break
    return on_a, on_b

def solids_distance(a, b, turn, place):
    """Least distance of convex solids (shape, size), with b at turn [N, 3, 3] and place [N, 3] in the
    frame of a. Of those that overlap minus the way out along an axis of one of them."""
    rotate = lambda p: np.einsum("nij,nj->ni", turn, p)
    back = lambda p: np.einsum("nji,nj->ni", turn, p)
    on_a, on_b = projected_points(a, b, turn, place)
    distance = np.linalg.norm(on_a - on_b, axis=1)
    axes = [sign * np.tile(e, (len(place), 1)) for e in np.eye(3) for sign in (1, -1)]
    ways = np.stack(axes + [rotate(way) for way in axes])
    gaps = np.stack([np.einsum("ni,ni->n", way, place + rotate(farthest_in(*b, -back(way))) - farthest_in(*a, way))
                     for way in ways])
    return np.where(distance < 1e-7, np.minimum(gaps.max(axis=0), 0), distance)

class Mesh:
    """Triangles hang together in parts by shared edges; a part whose edges all have an even number
    of triangles is solid, any other a sheet."""

    def __init__(self, vertices, triangles):
        vertices, place = np.unique(vertices, axis=0, return_inverse=True)
        corners = place.reshape(-1)[triangles]
        corners = corners[(np.diff(np.sort(corners, axis=1), axis=1) > 0).all(axis=1)]
        edges = np.sort(np.stack([corners, np.roll(corners, -1, axis=1)], axis=2), axis=2)
        edge = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)[1].reshape(-1, 3)
        self.part, last = np.arange(len(corners)), None
        while last is None or (self.part != last).any():  # the least that it hangs together with
            last, least = self.part, np.full(edge.max() + 1, len(corners))
            np.minimum.at(least, edge, self.part[:, None])
            self.part = least[edge].min(axis=1)
        leaky = (np.bincount(edge.ravel()) % 2 == 1)[edge].any(axis=1)
        self.solid = ~np.isin(self.part, self.part[leaky])
        self.corners = vertices[corners].transpose(1, 0, 2)  # [3, M, 3]
        self.radius = np.linalg.norm(vertices, axis=1).max()

    def faces(self, p):
        """Distances [N, M] of points to what of the faces is under them, elsewhere inf."""
        a, u, v = self.corners[0], *(self.corners[1:] - self.corners[0])
        uu, vv, uv = ((x * y).sum(axis=1) for x, y in ((u, u), (v, v), (u, v)))
        area, w = uu * vv - uv * uv, p[:, None] - a
        flat = area <= 1e-24 * uu * vv
        uw, vw = (w * u).sum(axis=2), (w * v).sum(axis=2)
        s, t = (x / np.where(flat, 1, area) for x in (vv * uw - uv * vw, uu * vw - uv * uw))
        away = np.linalg.norm(w - s[:, :, None] * u - t[:, :, None] * v, axis=2)
        return np.where((s >= 0) & (t >= 0) & (s + t <= 1) & ~flat, away, np.inf)

    def pierced(self, p, way):
        """Which triangles [N, M] the lines p + t * way meet, and the height of p over their planes
        and what way adds to it."""
        away = self.corners[:, None] - p[:, None]
        side = [(np.cross(away[i], away[(i + 1) % 3]) * way[:, None]).sum(axis=2) > 0 for i in range(3)]
        normal = np.cross(self.corners[1] - self.corners[0], self.corners[2] - self.corners[0])
        normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-99
        return (side[0] == side[1]) & (side[1] == side[2]), -(away[0] * normal).sum(axis=2), way @ normal.T

    def inside(self, p):
        met, height, rise = self.pierced(p, np.tile([0.36, 0.48, 0.8], (len(p), 1)))
        odd = np.zeros((len(p), len(self.part)), int)
        np.add.at(odd.T, self.part, (met & (height * rise < 0) & self.solid).T)
        return (odd % 2 == 1).any(axis=1)

    def surface_distance(self, p, p_end):
        """Least distance of segments [N, 3] to the triangles."""
        count, shape = self.corners.shape[1], (len(p), self.corners.shape[1])
        ends = np.repeat(p, count, axis=0), np.repeat(p_end, count, axis=0)
        edges = [segment_distance(*ends, *(np.tile(self.corners[k % 3], (len(p), 1)) for k in (i, i + 1)))
                 .reshape(shape) for i in range(3)]
        met, height, rise = self.pierced(p, p_end - p)
        through = met & (np.minimum(np.abs(height), np.abs(height + rise)) > 1e-12) & (height * (height + rise) < 0)
        return np.where(through, 0, np.minimum.reduce([self.faces(p), self.faces(p_end), *edges])).min(axis=1)

    def segment_distance(self, p, p_end):
        """That, but of a segment in the solid how deep the deepest of 33 points on it lies."""
        rows = np.array_split(np.arange(len(p)), 1 + len(p) * self.corners.shape[1] // 200_000)
        distance = np.concatenate([self.surface_distance(p[k], p_end[k]) for k in rows])
        entered = np.concatenate([self.inside(p[k]) for k in rows]) | (distance < 1e-9)
        for n in np.flatnonzero(entered):
            points = p[n] + POINTS[:, None] * (p_end[n] - p[n])
            distance[n] = -np.where(self.inside(points), self.surface_distance(points, points), 0).max()
        return distance
