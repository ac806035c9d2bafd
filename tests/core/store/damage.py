"""damage.py PLANS.h5 FOLDER: copies the file into FOLDER once for every way to spoil it below."""
import pathlib
import shutil
import sys

import h5py
import numpy as np

PLAN = "plans/zz/000/"


def replace(file, name, values, **options):
    tags = dict(file[name].attrs)
    del file[name]
    file.create_dataset(name, data=values, **options)
    file[name].attrs.update(tags)


def claim_more(file):
    del file[PLAN + "goals/time"]
    file.create_dataset(PLAN + "goals/time", (1 << 45,), "f8", chunks=(1 << 20,))


def point_elsewhere(file):
    layout = h5py.VirtualLayout((4,), "f8")
    layout[:] = h5py.VirtualSource("nowhere.h5", "time", (4,))
    del file[PLAN + "goals/time"]
    file.create_virtual_dataset(PLAN + "goals/time", layout)


def set_item(file, name, index, value):
    values = file[name][()]
    values[index] = value
    file[name][...] = values


DAMAGES = {
    "version": lambda f: f.attrs.modify("version", 4),
    "older_version": lambda f: f.attrs.modify("version", 2),
    "format": lambda f: f.attrs.create("format", "morphe-demonstrations"),
    "no_format": lambda f: f.attrs.pop("format"),
    "version_text": lambda f: f.attrs.create("version", "one"),
    "no_robot": lambda f: f.pop("robot"),
    "robot_parent": lambda f: set_item(f, "robot/frames/parent", 1, 1),
    "robot_joint": lambda f: set_item(f, "robot/frames/joint", 0, 3),
    "robot_columns": lambda f: replace(f, "robot/frames/ratio", np.ones(3)),
    "robot_limit": lambda f: replace(f, "robot/jerk", np.ones(2)),
    "robot_tip": lambda f: set_item(f, "robot/tips/frame", 0, -1),
    "robot_pair": lambda f: set_item(f, "robot/allowed_collision_pairs", (0, 0), 3),
    "robot_palm": lambda f: f["robot"].attrs.modify("palm_frame", 4),
    "input_group_loop": lambda f: f["inputs"].__setitem__("again", f["inputs"]),
    "movement_name": lambda f: f.move("plans/zz/000", "plans/zz/first"),
    "movement_dataset": lambda f: f["plans/zz"].__setitem__("007", 1.0),
    "missing": lambda f: f.pop(PLAN + "goals/tip_position"),
    "missing_group": lambda f: f.pop(PLAN + "scene"),
    "missing_attribute": lambda f: f[PLAN].attrs.pop("required_clearance"),
    "missing_trajectory": lambda f: f.pop(PLAN + "trajectory"),
    "extra_trajectory": lambda f: f.copy(PLAN + "trajectory", "plans/zz/001/trajectory"),
    "rank": lambda f: replace(f, PLAN + "goals/tip_position", np.ones((4, 6))),
    "rows": lambda f: replace(f, PLAN + "trajectory/velocity", np.ones((5, 3))),
    "columns": lambda f: replace(f, PLAN + "path/position", np.ones((5, 4))),
    "type": lambda f: replace(f, PLAN + "goals/time", ["a", "b", "c", "d"]),
    "fraction": lambda f: replace(f, PLAN + "path/origin", np.ones(5)),
    "status": lambda f: f[PLAN].attrs.create("status", "infeasible"),
    "shape": lambda f: f[PLAN + "scene/cup"].attrs.create("shape", "cube"),
    "size": lambda f: f[PLAN + "scene/cup"].attrs.create("size", [1.0, 2.0]),
    "no_sample": lambda f: [replace(f, PLAN + "scene/cup/" + name, np.ones((0,) + rest))
                            for name, rest in (("time", ()), ("position", (3,)),
                                               ("orientation", (4,)))],
    "triangle": lambda f: set_item(f, PLAN + "scene/apple/triangles", (0, 0), 4),
    "phase": lambda f: set_item(f, PLAN + "trajectory/phase", 0, 13),
    "origin": lambda f: set_item(f, PLAN + "path/origin", 0, 3),
    "mapped_status": lambda f: set_item(f, PLAN + "mapped/status", 0, 4),
    "grasp_sample": lambda f: f[PLAN + "grasp"].attrs.modify("sample", 6),
    "findings": lambda f: replace(f, PLAN + "findings/excess", np.ones(3)),
    "offset": lambda f: f[PLAN + "goals"].attrs.create("common_base_offset", [1.0, 2.0]),
    "claim_more": claim_more,
    "elsewhere": point_elsewhere,
    "dangling": lambda f: (f.pop(PLAN + "goals/time"),
                           f[PLAN + "goals"].__setitem__("time", h5py.SoftLink("/nowhere"))),
}

source, folder = sys.argv[1], pathlib.Path(sys.argv[2])
for name, damage in DAMAGES.items():
    shutil.copy(source, folder / (name + ".h5"))
    with h5py.File(folder / (name + ".h5"), "r+") as opened:
        damage(opened)
