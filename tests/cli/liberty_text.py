"""Writes a synthetic demonstrations.h5 as the text files that Liberty and CyberGlove software
would: an arm, a glove and their calibration pose each, and a manifest that lists them."""
import numpy as np

AXES = "xyz"
TURN = ("qw", "qx", "qy", "qz")


def write_rows(file, names, rows):
    with open(file, "w", encoding="utf-8") as out:
        out.write(",".join(names) + "\n")
        for row in rows:
            out.write(",".join("" if np.isnan(x) else f"{x:.10g}" for x in row) + "\n")


def sensor_columns(sensors):
    names, columns = ["time_s"], [sensors["time"][()][:, None]]
    for k, name in enumerate(sensors.attrs["names"]):
        name = name.decode()
        names += [f"{name}_{axis}_m" for axis in AXES] + [f"{name}_{part}" for part in TURN]
        columns += [sensors["position"][:, k], sensors["orientation"][:, k]]
    return names, columns


def write_arm(file, sensors):
    names, columns = sensor_columns(sensors)
    write_rows(file, names, np.hstack(columns))


def write_pose(file, calibration):
    """Points that were digitised stand in the first rows; one on a joint is called after it."""
    names, columns = sensor_columns(calibration["sensors"])
    points = calibration["markers"]
    rows = len(columns[0])
    sensors = {name.decode() for name in calibration["sensors"].attrs["names"]}
    for k, name in enumerate(points.attrs["names"]):
        name = name.decode()
        name = f"{name}_joint" if name in sensors else name
        names += [f"{name}_{axis}_m" for axis in AXES]
        column = np.full((rows, 3), np.nan)
        column[:len(points["position"])] = points["position"][:, k]
        columns.append(column)
    write_rows(file, names, np.hstack(columns))


def write_glove(file, hand):
    names = [name.decode() for name in hand.attrs["sensors"]]
    write_rows(file, ["time_s"] + [f"{name}_rad" for name in names],
               np.column_stack([hand["time"][()], hand["angles"][()]]))


def write_recordings(demonstrations, folder):
    """`demonstrations`: the open file. Returns the manifest."""
    lines = ["axes: x y z", "recordings:"]
    for name, one in demonstrations["demonstrations"].items():
        write_arm(folder / f"{name}.csv", one["sensors"])
        write_glove(folder / f"{name}_glove.csv", one["hand"])
        write_pose(folder / f"{name}_pose.csv", one["calibration"])
        write_glove(folder / f"{name}_glove_pose.csv", one["calibration/hand"])
        lines.append(f"  - {{file: {name}.csv, glove: {name}_glove.csv, static_trial: {name}_pose.csv, "
                     f"glove_static_trial: {name}_glove_pose.csv, "
                     f"hand_length: {one.attrs['hand_length']:.17g}, "
                     f"hand_breadth: {one.attrs['hand_breadth']:.17g}}}")
    manifest = folder / "recordings.yaml"
    manifest.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return manifest
