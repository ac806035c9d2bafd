"""Writes a demonstrations.h5 the way a user of h5py would, without any special options."""
import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1], "w") as file:
    file.attrs["format"] = "morphe-demonstrations"
    file.attrs["version"] = 3
    for name in ("b", "a"):
        demo = file.create_group("demonstrations/" + name)
        demo.attrs["subject"] = np.bytes_("S 1")  # of fixed length
        demo.attrs["hand"] = "right"
        markers = demo.create_group("markers")
        markers.attrs["names"] = ["one", "two"]
        markers["time"] = np.arange(3)
        markers.create_dataset("position", data=np.arange(18.0).reshape(3, 2, 3),
                               compression="gzip", dtype="f4")
        labels = demo.create_group("labels")
        labels["begin_s"] = [0.5]
        labels["end_s"] = [1.5]
        labels["phase"] = ["reach"]
