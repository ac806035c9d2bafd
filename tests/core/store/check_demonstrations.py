"""Reads a demonstrations.h5 of two full demonstrations with h5py alone; fails on any difference."""
import sys

import h5py
import numpy as np

from contract import assumptions, attributes, flags, shapes, text

with h5py.File(sys.argv[1]) as file:
    assert text(file.attrs["format"]) == "morphe-demonstrations" and file.attrs["version"] == 3
    assert list(file["demonstrations"]) == ["zz", "aa"]  # the order of creation
    demo = file["demonstrations/zz"]
    attributes(demo, ["subject", "task", "hand", "source", "licence", "upper_arm", "forearm",
                      "hand_length", "hand_breadth"])
    assert text(demo.attrs["subject"]) == "ADL001" and text(demo.attrs["hand"]) == "left"
    assert demo.attrs["upper_arm"] == 0.1 + 1.0
    streams = {
        "markers/time": ((4,), "f", "s", None),
        "markers/position": ((4, 3, 3), "f", "m", "world"),
        "sensors/time": ((5,), "f", "s", None),
        "sensors/position": ((5, 2, 3), "f", "m", "world"),
        "sensors/orientation": ((5, 2, 4), "f", "1", "world"),
        "skeleton/time": ((3,), "f", "s", None),
        "skeleton/position": ((3, 2, 3), "f", "m", "world"),
        "skeleton/orientation": ((3, 2, 4), "f", "1", "world"),
        "arm_angles/time": ((6,), "f", "s", None),
        "arm_angles/angles": ((6, 2), "f", "rad", None),
        "hand/time": ((2,), "f", "s", None),
    }
    shapes(demo, {
        **streams, **{"calibration/" + name: what for name, what in streams.items()},
        "hand/angles": ((2, 22), "f", "rad", None),
        "calibration/hand/position": ((2, 21, 3), "f", "m", "world"),
        **{f"objects/{name}/{data}": what
           for k, name in enumerate(["zebra", "cup", "bottle", "pen", "apple"])
           for data, what in {"time": ((k + 1,), "f", "s", None),
                              "position": ((k + 1, 3), "f", "m", "world"),
                              "orientation": ((k + 1, 4), "f", "1", "world")}.items()},
        "objects/apple/vertices": ((4, 3), "f", "m", "object"),
        "objects/apple/triangles": ((2, 3), "i", "1", None),
        **flags(3), **assumptions(2), "accepted_flags/code": ((2,), "S", "", None),
        "labels/begin_s": ((2,), "f", "s", None),
        "labels/end_s": ((2,), "f", "s", None),
        "labels/phase": ((2,), "S", "", None),
    })
    assert text(demo["markers"].attrs["names"]) == ["RSHO1", "RÜAR", "m 3"]
    assert text(demo["skeleton"].attrs["parents"]) == ["", "hips"]
    assert text(demo["hand"].attrs["kind"]) == "glove" and len(demo["hand"].attrs["sensors"]) == 22
    assert list(demo["flags/code"].asstr()) == ["spike", "mirrored", "no_grasp"]
    assert list(demo["flags/response"].asstr()) == ["mended", "flagged", "accepted"]
    assert demo["flags/value"][0] == 20 and np.isnan(demo["flags/begin_s"][1])
    assert list(demo["accepted_flags/code"].asstr()) == ["jitter", "no_grasp"]
    assert list(demo["labels/phase"].asstr()) == ["reach", "grasp"]
    assert [text(demo["objects"][name].attrs["shape"]) for name in demo["objects"]] == \
        ["sphere", "box", "cylinder", "capsule", "mesh"]
    assert list(demo["sensors/orientation"][0, 0]) == [0.1, 0.7, -0.7, 0.1]  # w first
    assert np.isnan(demo["markers/position"]).any()
