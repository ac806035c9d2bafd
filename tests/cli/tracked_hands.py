"""The shipped Adroit demonstrations, written as the files of hand trackers: each in the order of
joints, units, axes and rates of its format, and with what it cannot see. The hand's joints are
those of the simulated hand, from the recorded angles."""
import json

import h5py
import numpy as np

FINGERS = ("thumb", "index", "middle", "ring", "little")
# Rows as keypoints: wrist, then four a finger; what stands there is Aria's landmark, -1 = none.
ARIA = (5, -1, 6, 7, 0, 8, 9, 10, 1, 11, 12, 13, 2, 14, 15, 16, 3, 17, 18, 19, 4)
Y_UP = np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])  # x right, y up, -z forward <- ours
FIRST_ANGLE = {"index": 5, "middle": 9, "ring": 13, "little": 18}
BASE = {"index": (0.033, 0, 0.095), "middle": (0.011, 0, 0.099), "ring": (-0.011, 0, 0.095),
        "little": (-0.034, 0, 0.088)}


def rotation(axis, angle):
    """[N, 3, 3] about a fixed axis, or one matrix for one angle."""
    x, y, z = np.asarray(axis, float) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.asarray(angle)[..., None, None]
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * (k @ k)


def matrix_of(q):
    w, x, y, z = np.moveaxis(np.asarray(q), -1, 0)
    return np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w),
                     2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w),
                     2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
                    -1).reshape(*w.shape, 3, 3)


def quaternion_of(matrix):
    """w, x, y, z of one rotation matrix: the eigenvector of the largest eigenvalue."""
    (a, b, c), (d, e, f), (g, h, i) = matrix
    k = np.array([[a + e + i, h - f, c - g, d - b], [h - f, a - e - i, b + d, c + g],
                  [c - g, b + d, e - a - i, f + h], [d - b, c + g, f + h, i - a - e]])
    return np.linalg.eigh(k)[1][:, -1]


def quaternions_of(matrices):
    return np.array([quaternion_of(matrix) for matrix in matrices])


def chain(base, turns):
    """Points of a chain in the palm [N, K, 3]: its base, then the end of each (turn, length)."""
    at, turned, points = base, np.broadcast_to(np.eye(3), turns[0][0].shape), []
    for turn, length in turns:
        turned = turned @ turn
        at = at + length * turned[:, :, 2]
        points.append(at)
    return points


def fingers_in_palm(q):
    """[N, 21, 3]: z to the fingers, palm facing -y, x to the thumb's side; the wrist at 0."""
    joints = np.zeros((len(q), 21, 3))
    tilt = np.broadcast_to(rotation((0, 1, 0), np.pi / 4), (len(q), 3, 3))
    base = np.broadcast_to(np.array([0.034, -0.009, 0.029]), (len(q), 3))
    x, y, z = np.eye(3)
    joints[:, 1] = base
    joints[:, 2], joints[:, 3], joints[:, 4] = chain(
        base, [(tilt @ rotation(-z, q[:, 22]) @ rotation(x, q[:, 23]), 0.038),
               (rotation(x, q[:, 24]) @ rotation(y, q[:, 25]), 0.032),
               (rotation(y, q[:, 26]), 0.0275)])
    for k, finger in enumerate(FINGERS[1:], 1):
        first, palm = FIRST_ANGLE[finger], np.broadcast_to(np.eye(3), (len(q), 3, 3))
        base = np.broadcast_to(np.array(BASE[finger]), (len(q), 3))
        if finger == "little":
            half, palm = np.array([-0.017, 0, 0.044]), rotation((0.571, 0, 0.821), q[:, 17])
            base = half + palm @ half
        joints[:, 4 * k + 1] = base
        joints[:, 4 * k + 2], joints[:, 4 * k + 3], joints[:, 4 * k + 4] = chain(
            base, [(palm @ rotation(y, q[:, first]) @ rotation(x, q[:, first + 1]), 0.045),
                   (rotation(x, q[:, first + 2]), 0.025), (rotation(x, q[:, first + 3]), 0.026)])
    return joints


class Hand:
    """One demonstration: [N] times, [N, 21, 3] keypoints and the poses of palm and handle."""

    def __init__(self, one):
        self.time = one["sensors/time"][()]
        self.wrist = one["sensors/position"][:, 0]
        self.turn = matrix_of(one["sensors/orientation"][:, 0])  # as HumanMotion's hand frame
        self.palm = self.turn @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
        self.angles = one["arm_angles/angles"][()]
        self.in_palm = fingers_in_palm(self.angles)
        self.joints = np.einsum("nij,nkj->nki", self.palm, self.in_palm) + self.wrist[:, None]
        self.tips = one["hand/position"][()]
        self.handle = one["objects/handle/position"][()]
        assert np.abs(self.joints[:, 4::4] - self.tips).max() < 1e-9

    def every(self, rows):
        """Some of the rows alone."""
        some = object.__new__(Hand)
        for name, values in vars(self).items():
            setattr(some, name, values[rows])
        return some


def hands_of(file):
    with h5py.File(file) as h5:
        return {name: Hand(one) for name, one in h5["demonstrations"].items()}


def write_table(file, names, rows):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join([",".join(names), *(",".join(row) for row in rows)]) + "\n")


def numbers(values, digits=9):
    return [f"{value:.{digits}g}" for value in np.ravel(values)]


def write_aria(hand, folder):
    """The device turns and goes about; the left hand is never seen, the right not in 20 rows."""
    def device(t):
        turn = rotation((0, 0, 1), 0.4 * np.sin(3 * t)) @ rotation((1, 0, 0), -2 + 0.2 * np.cos(2 * t))
        return turn, np.stack([0.1 * np.sin(2 * t), -0.4 + 0 * t, 0.6 + 0.05 * np.cos(3 * t)], -1)

    names = ["tracking_timestamp_us"]
    for side in ("left", "right"):
        names.append(f"{side}_tracking_confidence")
        names += [f"t{axis}_{side}_landmark_{k}_device" for k in range(21) for axis in "xyz"]
    for side in ("left", "right"):
        names += [f"t{axis}_{side}_device_wrist" for axis in "xyz"]
        names += [f"q{axis}_{side}_device_wrist" for axis in "xyzw"]
    turn, place = device(hand.time)
    rows, unseen = [], ["0"] * 63
    for i, t in enumerate(hand.time):
        points = np.zeros((21, 3))
        for keypoint, landmark in enumerate(ARIA):
            if landmark >= 0:
                points[landmark] = turn[i].T @ (hand.joints[i, keypoint] - place[i])
        hidden = 40 <= i < 60
        rows.append([str(round(t * 1e6)), "-1", *unseen, "0" if hidden else "0.98",
                     *(unseen if hidden else numbers(points, 6)),
                     *["0"] * 6, "1", *["0"] * 6, "1"])
    write_table(folder / "hand_tracking/hand_tracking_results.csv", names, rows)
    names = ["graph_uid", "tracking_timestamp_us", "utc_timestamp_ns"]
    names += [f"t{axis}_world_device" for axis in "xyz"] + [f"q{axis}_world_device" for axis in "xyzw"]
    names += [f"gravity_{axis}_world" for axis in "xyz"] + ["quality_score"]
    stamps = np.arange(int(hand.time[0] * 1e6), int(hand.time[-1] * 1e6) + 1000, 1000)
    turn, place = device(stamps * 1e-6)
    write_table(folder / "slam/closed_loop_trajectory.csv", names,
                [["6b2", str(stamp), "0", *numbers(place[i], 7),
                  *numbers(np.roll(quaternion_of(turn[i]), -1), 9), "0", "0", "-9.81", "1"]
                 for i, stamp in enumerate(stamps)])
    return folder / "hand_tracking/hand_tracking_results.csv"


def write_optitrack(hand, folder):
    """Millimetres, y up. The wrist and the handle are rigid bodies; a tip is hidden for a while."""
    bodies = {"Hand": (hand.wrist, hand.turn),
              "handle": (hand.handle, np.broadcast_to(np.eye(3), hand.turn.shape))}
    joints = [f"right_{finger}_{joint}" for finger in FINGERS
              for joint in (("cmc", "mcp", "ip", "tip") if finger == "thumb" else
                            ("mcp", "pip", "dip", "tip"))]
    types, names, quantities, axes = ["", "Type"], ["", "Name"], ["", ""], ["Frame", "Time (Seconds)"]
    for body in bodies:
        types += ["Rigid Body"] * 8
        names += [body] * 8
        quantities += ["Rotation"] * 4 + ["Position"] * 3 + ["Mean Marker Error"]
        axes += ["X", "Y", "Z", "W", "X", "Y", "Z", ""]
    for joint in joints:
        types += ["Marker"] * 3
        names += [joint] * 3
        quantities += ["Position"] * 3
        axes += ["X", "Y", "Z"]
    rate = round(1 / (hand.time[1] - hand.time[0]))
    lines = [f"Format Version,1.23,Take Name,door,Export Frame Rate,{rate:.6f},Rotation Type,"
             "Quaternion,Length Units,Millimeters,Coordinate Space,Global", "", ",".join(types),
             ",".join(names), ",ID" + "," * (len(types) - 2), ",".join(quantities), ",".join(axes)]
    for i, t in enumerate(hand.time):
        row = [str(round(t * rate)), f"{t:.3f}"]
        for place, turn in bodies.values():
            row += [f"{x:.6f}" for x in np.roll(quaternion_of(Y_UP @ turn[i]), -1)]
            row += [f"{x:.6f}" for x in 1000 * Y_UP @ place[i]] + ["0.2"]
        for k in range(20):
            hidden = k == 7 and 100 <= i < 104
            row += [""] * 3 if hidden else [f"{x:.6f}" for x in 1000 * Y_UP @ hand.joints[i, k + 1]]
        lines.append(",".join(row))
    file = folder / "take.csv"
    file.write_text("\r\n".join(lines) + "\r\n")
    (folder / "names.yaml").write_text("Hand: right_wrist\n")
    return file


def finger_chain(finger):
    """Axes, points and lengths of a finger with four joints, as UmeTrack has it, in a right palm."""
    x, y, z = np.eye(3)
    if finger == "thumb":
        tilt, at = rotation(y, np.pi / 4), np.array([0.034, -0.009, 0.029])
        return ([tilt @ -z, tilt @ x, tilt @ y, tilt @ y],
                [at, at, at + 0.038 * tilt[:, 2], at + 0.070 * tilt[:, 2]],
                [at + 0.038 * tilt[:, 2], at + 0.070 * tilt[:, 2], at + 0.0975 * tilt[:, 2]])
    at = np.array(BASE[finger])
    if finger == "little":  # the palm's arch bends, the last two joints are one
        return ([np.array([0.571, 0, 0.821]), y, x, x], [at / 2, at, at, at + 0.045 * z],
                [at, at + 0.045 * z, at + 0.070 * z, at + 0.096 * z])
    return ([y, x, x, x], [at, at, at + 0.045 * z, at + 0.070 * z],
            [at, at + 0.045 * z, at + 0.070 * z, at + 0.096 * z])


def assumed_capsules(axes, points, angles):
    """[N] rotations and shifts after the second, third and fourth joint."""
    turn, shift, bones = np.broadcast_to(np.eye(3), (len(angles), 3, 3)), np.zeros((len(angles), 3)), []
    for k, (axis, point) in enumerate(zip(axes, points)):
        step = rotation(axis, angles[:, k])
        shift = shift + np.einsum("nij,nj->ni", turn, point - step @ point)
        turn = turn @ step
        if k > 0:
            bones.append((turn, shift))
    return bones


def angles_for(finger, tips, angles):
    """Angles that put the tip where it was: exact for three fingers, sought for the others."""
    axes, points, rest = finger_chain(finger)

    def reached(angles):
        turn, shift = assumed_capsules(axes, points, angles)[-1]
        return turn @ rest[-1] + shift

    angles = angles.copy()
    for _ in range(60):
        missed = tips - reached(angles)
        if np.abs(missed).max() < 1e-8:
            break
        jacobian = np.stack([(reached(angles + step) - reached(angles - step)) / 2e-6
                             for step in 1e-6 * np.eye(4)], -1)
        square = jacobian @ jacobian.transpose(0, 2, 1) + 1e-7 * np.eye(3)
        angles += np.einsum("nji,nj->ni", jacobian, np.linalg.solve(square, missed[..., None])[..., 0])
    assert np.abs(missed).max() < 1e-5, finger
    return angles


def write_hot3d(hand, folder):
    """A Quest: y up. Stamps stand twice, 0.08 ms apart; the hand is missing in ten frames."""
    folder.mkdir(parents=True, exist_ok=True)
    mirror = np.diag([-1.0, 1, 1])  # the model is a left hand
    model = {key: [] for key in ("joint_rotation_axes", "joint_rest_positions")}
    landmarks, bone_of, all_angles = [None] * 21, [1] * 21, []
    for f, finger in enumerate(FINGERS):
        axes, points, rest = finger_chain(finger)
        model["joint_rotation_axes"] += [list(-mirror @ axis / np.linalg.norm(axis)) for axis in axes]
        model["joint_rest_positions"] += [list(1000 * mirror @ point) for point in points]
        for place, k, bone in zip(rest[-4:], range(4 - len(rest), 4), (0, 1, 2, 2)[-len(rest):]):
            landmark = ARIA[1 + 4 * f + k]
            landmarks[landmark], bone_of[landmark] = list(1000 * mirror @ place), 2 + 3 * f + bone
        first = FIRST_ANGLE.get(finger, 0)
        columns = {"thumb": [22, 23, 25, 26], "little": range(17, 21)}
        start = hand.angles[:, columns.get(finger, range(first, first + 4))]
        all_angles.append(angles_for(finger, hand.in_palm[:, 4 * f + 4], start))
    landmarks[5], landmarks[20] = [0, 0, 0], [0, 0, 60]
    model["joint_rotation_axes"] += [[1, 0, 0], [0, 0, 1]]
    model["joint_rest_positions"] += [[0, 0, 0]] * 2
    model["landmark_rest_positions"] = landmarks
    model["landmark_rest_bone_indices"] = [[bone, 0, 0] for bone in bone_of]
    model["landmark_rest_bone_weights"] = [[1, 0, 0]] * 21
    (folder / "umetrack_hand_user_profile.json").write_text(json.dumps({"hand_model": model}))
    (folder / "metadata.json").write_text(json.dumps(
        {"headset": "Quest3", "participant_id": "P1", "object_uids": ["7"],
         "object_names": ["handle"]}))
    lines, objects = [], []
    angles = np.hstack([*all_angles, np.zeros((len(hand.time), 2))])
    for i, t in enumerate(hand.time):
        hands = {"1": {"wrist_xform": {"t_xyz": list(Y_UP @ hand.wrist[i]),
                                       "q_wxyz": list(quaternion_of(Y_UP @ hand.palm[i]))},
                       "joint_angles": list(angles[i]), "hand_confidence": 1.0}}
        for stamp in (round(t * 1e9) + 10**14, round(t * 1e9) + 10**14 + 80_000):
            lines.append(json.dumps({"timestamp_ns": stamp,
                                     "hand_poses": {} if 150 <= i < 160 else hands}))
            objects.append(["7", str(stamp), *numbers(Y_UP @ hand.handle[i], 12), "1", "0", "0", "0"])
    (folder / "umetrack_hand_pose_trajectory.jsonl").write_text("\n".join(lines) + "\n")
    write_table(folder / "dynamic_objects.csv",
                ["object_uid", "timestamp[ns]", "t_wo_x[m]", "t_wo_y[m]", "t_wo_z[m]", "q_wo_w",
                 "q_wo_x", "q_wo_y", "q_wo_z"], objects)
    return folder / "umetrack_hand_pose_trajectory.jsonl"


def write_mvnx(hand, folder):
    """x forward, y left, z up; times rounded to milliseconds; a T-pose before the motion."""
    to_file = np.array([[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    order = ("First", "Second", "Third", "Fourth", "Fifth")
    labels, joints, tips = ["RightCarpus"], [0], {}
    for f, ordinal in enumerate(order):
        parts = ("MC", "PP", "DP") if f == 0 else ("MC", "PP", "MP", "DP")
        keypoints = (1, 2, 3) if f == 0 else (0, *(4 * f + k for k in (1, 2, 3)))
        labels += [f"Right{ordinal}{part}" for part in parts]
        joints += keypoints
        length = np.linalg.norm(hand.in_palm[0, 4 * f + 4] - hand.in_palm[0, 4 * f + 3])
        tips[f"Right{ordinal}DP"] = (f"pRight{ordinal}Tip", length, 4 * f + 4)

    def segment(label):
        name, length, _ = tips.get(label, ("pOrigin", 0, 0))
        return (f'<segment label="{label}"><points><point label="{name}"><pos_b>0 {-length:.9f} 0'
                "</pos_b></point></points></segment>")

    file = folder / "door.mvnx"
    hand_axes = np.array([[0.0, 1, 0], [0, 0, -1], [-1, 0, 0]])  # as columns: -z, x, -y
    frames = ['<frame time="0" index="" type="tpose"/>']
    for i in range(len(hand.time)):
        places = hand.joints[i, joints] @ to_file.T
        turns = []
        for label, joint in zip(labels, joints):
            along = np.array([0, -1.0, 0])
            if label in tips:
                along = to_file @ (hand.joints[i, tips[label][2]] - hand.joints[i, joint])
            along = along / np.linalg.norm(along)  # where the segment's -y points
            side = np.cross(along, [0.36, 0.48, 0.8])
            side /= np.linalg.norm(side)
            turns.append(quaternion_of(np.stack([side, -along, np.cross(side, -along)], -1)))
        body = quaternion_of(to_file @ hand.turn[i] @ hand_axes.T)
        frames.append(
            f'<frame time="{round(10 * i)}" index="{i}" type="normal">'
            f'<orientation>1 0 0 0 {" ".join(numbers(body, 7))}</orientation>'
            f'<position>0 0 0.9 {" ".join(numbers(to_file @ hand.wrist[i], 7))}</position>'
            f'<orientationFingersRight>{" ".join(numbers(turns, 7))}</orientationFingersRight>'
            f'<positionFingersRight>{" ".join(numbers(places, 7))}</positionFingersRight></frame>')
    file.write_text('<?xml version="1.0" encoding="UTF-8"?>\n<mvnx version="4">'
                    '<subject label="P1" frameRate="100"><segments>' + segment("Pelvis") +
                    segment("RightHand") + "</segments><fingerTrackingSegmentsRight>" +
                    "".join(map(segment, labels)) + "</fingerTrackingSegmentsRight><frames>" +
                    "\n".join(frames) + "</frames></subject></mvnx>\n")
    return file


def in_hand(hand):
    """Keypoints in the hand's own frame: x out of the palm, y to the thumb, z to the fingers."""
    return np.einsum("nji,nkj->nki", hand.turn, hand.joints - hand.wrist[:, None])


def write_manus(hand, folder):
    """Centimetres in left-handed axes: thumb at -x, palm at -y."""
    nodes = ["Hand", "Thumb_CMC", "Thumb_MCP", "Thumb_DIP", "Thumb_TIP"]
    keypoints = [0, 1, 2, 3, 4]
    for f, finger in enumerate(("Index", "Middle", "Ring", "Pinky"), 1):
        nodes += [f"{finger}_{joint}" for joint in ("CMC", "MCP", "PIP", "DIP", "TIP")]
        keypoints += [0, *(4 * f + k for k in (1, 2, 3, 4))]
    names = ["Frame", "Elapsed_Time_In_Milliseconds", "Time"]
    for node in nodes:
        names += [f"{node}_{what}_{axis}" for what in ("Position", "Rotation") for axis in "XYZ"]
    points = 100 * in_hand(hand) @ np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, 1]])
    rows = [[str(i), f"{1000 * t:.3f}", "00:00:00:000",
             *(text for k in keypoints for text in [*numbers(points[i, k], 7), "0", "0", "0"])]
            for i, t in enumerate(hand.time)]
    write_table(folder / "door_R.csv", names, rows)
    return folder / "door_R.csv"


APPLE = [(f"{finger}Finger" if finger != "thumb" else finger) + joint for finger in FINGERS
         for joint in ("Knuckle", "IntermediateBase", "IntermediateTip", "Tip")]


def matrices(turn, place):
    """[N, 4, 4]."""
    all_of_them = np.zeros((len(place), 4, 4))
    all_of_them[:, :3, :3], all_of_them[:, :3, 3], all_of_them[:, 3, 3] = turn, place, 1
    return all_of_them


def write_avp_jsonl(hand, folder):
    """Matrices column by column, y up; fingers in the wrist's frame; no hand in ten frames."""
    folder.mkdir(parents=True, exist_ok=True)
    wrist = matrices(Y_UP @ hand.palm, hand.wrist @ Y_UP.T)
    lines = []
    for i, t in enumerate(hand.time):
        line = {"timestamp": t, "systemTime": 1.7e9 + t, "headMatrix": list(np.eye(4).T.ravel())}
        if not 50 <= i < 60:
            line["rightHand"] = {"wrist": list(wrist[i].T.ravel())}
            for k, name in enumerate(APPLE, 1):
                joint = np.eye(4)
                joint[:3, 3] = hand.in_palm[i, k]
                line["rightHand"][name] = list(joint.T.ravel())
        lines.append(json.dumps(line))
    (folder / "tracking.jsonl").write_text("\n".join(lines) + "\n")
    return folder / "tracking.jsonl"


def write_avp_npz(hand, folder):
    """Z up already; fingers in the wrist's frame, metacarpals at it; zeros in ten frames."""
    folder.mkdir(parents=True, exist_ok=True)
    count = len(hand.time)
    wrist = matrices(hand.palm, hand.wrist)[:, None]
    wrist[30:40] = 0
    fingers = np.broadcast_to(np.eye(4), (count, 25, 4, 4)).copy()
    for f in range(5):
        first = 1 if f == 0 else 1 + 5 * f  # behind a metacarpal
        fingers[:, first:first + 4, :3, 3] = hand.in_palm[:, 4 * f + 1:4 * f + 5]
    np.savez(folder / "door.npz", stream_right_wrist=wrist, stream_right_fingers=fingers,
             stream_head=np.broadcast_to(np.eye(4), (count, 1, 4, 4)),
             stream_right_pinch_distance=np.zeros(count))
    return folder / "door.npz"


def write_egodex(hand, folder):
    """Float32 matrices row by row, y up; confidence 0 in ten frames."""
    folder.mkdir(parents=True, exist_ok=True)
    sure = np.ones(len(hand.time), np.float32)
    sure[20:30] = 0
    with h5py.File(folder / "0.hdf5", "w") as file:
        file.attrs["llm_description"] = "open a door"
        file["camera/intrinsic"] = np.eye(3, dtype=np.float32)
        file["transforms/camera"] = matrices(Y_UP, np.zeros((len(hand.time), 3))).astype(np.float32)
        for name, k in [("rightHand", 0)] + [("right" + name[0].upper() + name[1:], k)
                                             for k, name in enumerate(APPLE, 1)]:
            place = hand.joints[:, k] @ Y_UP.T
            file[f"transforms/{name}"] = matrices(Y_UP @ hand.palm, place).astype(np.float32)
            file[f"confidences/{name}"] = sure
    return folder / "0.hdf5"
