"""Recordings of a known truth, written in other formats, names, units and axes."""
import re
import struct

import numpy as np

JOINT_COLUMNS = ["right_shoulder", "right_elbow", "right_wrist", "right_thumb_tip", "right_index_tip"]


class Recorded:
    """Points [N, K, 3] in metres, NaN where one was not seen, at 100 Hz."""

    def __init__(self, names, position):
        self.names, self.position = list(names), position
        self.time = np.arange(len(position)) / 100

    def called(self, name_of):
        return Recorded([name_of(name) for name in self.names], self.position)

    def seen_as(self, axes):
        """In a frame in which the recorded axes `axes` point right, forward and up."""
        world_from_recorded = np.zeros((3, 3))
        for row, word in enumerate(axes.split()):
            world_from_recorded[row, "xyz".index(word[-1])] = -1 if word[0] == "-" else 1
        return Recorded(self.names, self.position @ world_from_recorded)


def recorded_from_csv(csv):
    rows = csv.read_text(encoding="utf-8-sig").splitlines()
    names = [cell.split(":")[1] for cell in rows[2].split(",") if cell]
    width = 3 * len(names)
    cells = [([float(c) if c.strip() else np.nan for c in row.split(",")[2:2 + width]]
              + [np.nan] * width)[:width] for row in rows[5:] if row.strip(",")]
    return Recorded(names, np.array(cells).reshape(len(cells), -1, 3) / 1000)


def carried(landmark, cluster, still, trial):
    """A point of the static trial, carried by the cluster's best rigid fit in every frame."""
    def shape_of(recorded):
        return np.stack([recorded.position[:, recorded.names.index(n)] for n in cluster], axis=1)
    rest = np.nanmean(shape_of(still), axis=0)
    point = np.nanmean(still.position[:, still.names.index(landmark)], axis=0)
    track = []
    for now in shape_of(trial):
        a, b = rest - rest.mean(axis=0), now - now.mean(axis=0)
        u, _, v = np.linalg.svd(a.T @ b)
        turn = (u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v).T
        track.append(turn @ (point - rest.mean(axis=0)) + now.mean(axis=0))
    return np.array(track)


def joints_of(trial, still):
    """Shoulder, elbow, wrist and two tips of a table trial as points."""
    def four(stem):
        return [f"{stem}{n}" for n in range(1, 5) if f"{stem}{n}" in trial.names]
    def marker(name):
        return trial.position[:, trial.names.index(name)]
    tracks = [carried("RGTH", four("RUAR"), still, trial),
              (carried("RLEP", four("RUAR"), still, trial)
               + carried("RMEP", four("RUAR"), still, trial)) / 2,
              (carried("RSPR", four("RLAR"), still, trial)
               + carried("RSPU", four("RLAR"), still, trial)) / 2,
              marker("RTHUM"), marker("RFTP")]
    return Recorded(JOINT_COLUMNS, np.stack(tracks, axis=1))


def cells_of(points, per_metre, form="{:.9g}"):
    return [form.format(v * per_metre) if np.isfinite(v) else "" for v in points.reshape(-1)]


def trc_text(recorded, unit):
    per_metre = {"mm": 1000, "m": 1}[unit]
    count = len(recorded.names)
    lines = ["PathFileType\t4\t(X/Y/Z)\tsomewhere.trc",
             "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits",
             f"100\t100\t{len(recorded.time)}\t{count}\t{unit}",
             "Frame#\tTime\t" + "\t".join(f"{name}\t\t" for name in recorded.names),
             "\t\t" + "\t".join(f"X{k}\tY{k}\tZ{k}" for k in range(1, count + 1)), ""]
    for i, points in enumerate(recorded.position):
        lines.append("\t".join([str(i + 1), f"{recorded.time[i]:.5f}", *cells_of(points, per_metre)]))
    return "\n".join(lines) + "\n"


def vicon_csv(recorded):
    count = len(recorded.names)
    lines = ["Trajectories", "100", ",," + ",".join(f"S:{name},," for name in recorded.names),
             "Frame,Sub Frame" + ",X,Y,Z" * count, "," + ",mm" * 3 * count]
    for i, points in enumerate(recorded.position):
        lines.append(",".join([str(i + 1), "0", *cells_of(points, 1000)]))
    return "\n".join(lines) + "\n"


def qualisys_tsv(recorded):
    lines = [f"NO_OF_FRAMES\t{len(recorded.time)}", "NO_OF_CAMERAS\t8",
             f"NO_OF_MARKERS\t{len(recorded.names)}", "FREQUENCY\t100", "NO_OF_ANALOG\t0",
             "ANALOG_FREQUENCY\t0", "DESCRIPTION\t--", "DATA_INCLUDED\t3D",
             "MARKER_NAMES\t" + "\t".join(recorded.names)]
    for points in recorded.position:
        lines.append("\t".join(cell or "0.000" for cell in cells_of(points, 1000)))
    return "\n".join(lines) + "\n"


def point_csv(recorded, metres, separator=",", comma=False, axis="_{}", header_lines=1, time="frame"):
    """A row a frame; `time` names the first column: a time [s], or a frame counted from 1."""
    in_seconds = time.lower().startswith("t")
    if header_lines == 1:
        labels = [name + axis.format(letter) for name in recorded.names for letter in "xyz"]
        lines = [separator.join([time, *labels])]
    else:
        lines = [separator.join([""] + [cell for name in recorded.names for cell in (name, "", "")]),
                 separator.join([time] + ["X", "Y", "Z"] * len(recorded.names))]
    for i, points in enumerate(recorded.position):
        first = f"{recorded.time[i]:.4f}" if in_seconds else str(i + 1)
        line = separator.join([first, *cells_of(points, 1 / metres, "{:.7f}")])
        lines.append(line.replace(".", ",") if comma else line)
    return "\n".join(lines) + "\n"


def c3d_bytes(recorded, unit, rate, data_start):
    """Intel, floats; lengths in millimetres whatever `unit` says."""
    def record(group, name, kind, dimensions, data):
        rest = bytes([kind & 255, len(dimensions), *dimensions]) + data + b"\0"
        return (struct.pack("<bb", len(name), group) + name.encode()
                + struct.pack("<h", 2 + len(rest)) + rest)
    def words(name, *values):
        return record(1, name, 2, [] if len(values) == 1 else [len(values)],
                      struct.pack(f"<{len(values)}H", *values))
    width = max(map(len, recorded.names))
    count, frames = len(recorded.names), len(recorded.time)
    parameters = struct.pack("<bb", 5, -1) + b"POINT" + struct.pack("<h", 3) + b"\0"
    parameters += words("USED", count) + words("FRAMES", frames) + words("DATA_START", data_start)
    parameters += record(1, "RATE", 4, [], struct.pack("<f", rate))
    parameters += record(1, "SCALE", 4, [], struct.pack("<f", -1))
    parameters += record(1, "UNITS", -1, [max(1, len(unit))], (unit or " ").encode())
    parameters += record(1, "LABELS", -1, [width, count],
                         "".join(name.ljust(width) for name in recorded.names).encode())
    blocks = -(-(4 + len(parameters) + 2) // 512)
    head = bytes([2, 0x50]) + struct.pack("<5H", count, 0, 1, frames, 0)
    head += struct.pack("<fHHf", -1, data_start, 0, rate)
    section = bytes([1, 0x50, blocks, 84]) + parameters
    data = b"".join(struct.pack("<4f", *(1000 * p if np.isfinite(p).all() else np.zeros(3)),
                                0 if np.isfinite(p).all() else -1)
                    for points in recorded.position for p in points)
    return head.ljust(512, b"\0") + section.ljust(512 * blocks, b"\0") + data


def renamed_bvh(text, scale):
    """A skeleton of Mixamo's names in another's, its lengths times `scale`."""
    def name_of(match):
        name = match.group(2)
        side = {"Left": "_L", "Right": "_R"}.get(re.match("Left|Right|", name).group(), "")
        name = re.sub("^(Left|Right)", "", name)
        for old, new in (("ForeArm", "lower_arm"), ("Arm", "upper_arm"), ("UpLeg", "thigh"),
                         ("Hand", "hand_"), ("Pinky", "little"), ("Shoulder", "clavicle")):
            if name.startswith(old) or (old == "Pinky" and old in name):
                name = name.replace(old, new)
                break
        return f"{match.group(1)} {name.rstrip('_')}{side}"
    head, rows = text.split("MOTION", 1)
    head = re.sub(r"\b(ROOT|JOINT)\s+(\S+)", name_of, head)
    head = re.sub(r"OFFSET\s+(\S+)\s+(\S+)\s+(\S+)",
                  lambda m: "OFFSET " + " ".join(f"{float(v) * scale:.9g}" for v in m.groups()), head)
    moved = len(re.findall("[XYZ]position", head.split("JOINT")[0]))
    lines = rows.strip("\n").splitlines()
    scaled = []
    for line in lines:
        cells = line.split()
        if len(cells) > 10:
            cells[:moved] = [f"{float(v) * scale:.9g}" for v in cells[:moved]]
            line = " ".join(cells)
        scaled.append(line)
    return head + "MOTION\n" + "\n".join(scaled) + "\n"
