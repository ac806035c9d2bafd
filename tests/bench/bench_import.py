#!/usr/bin/python3
"""How much faster than real time recordings are read, rebuilt and cut: seconds recorded over
seconds taken, program start and writing included. Best of three; one process, one thread.

  bench_import.py MORPHE"""
import pathlib
import subprocess
import sys
import tempfile
import time

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/cli"))
import liberty_text  # noqa: E402


def seconds(command):
    best = float("inf")
    for _ in range(3):
        start = time.perf_counter()
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
        best = min(best, time.perf_counter() - start)
    return best


def recorded(file):
    streams = ("sensors", "markers", "skeleton", "arm_angles", "hand")
    with h5py.File(file) as dataset:
        return sum(max(one[stream]["time"][-1] - one[stream]["time"][0]
                       for stream in streams if stream in one)
                   for one in dataset["demonstrations"].values())


def main(morphe):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        made, file = folder / "made.h5", folder / "read.h5"
        command = [morphe, "synthesize", ROOT / "configs/synthetic/reach_to_grasp.yaml", "--out",
                   made, "--count", "40", "--jobs", "1"]
        took = seconds(command)
        print(f"{'':24}{'recorded s':>12}{'import':>12}{'import + inspect':>18}")
        with h5py.File(made) as dataset:
            manifests = [liberty_text.write_recordings(dataset, folder)]
        print(f"{'synthesize (240 Hz)':24}{recorded(made):12.1f}{recorded(made) / took:12.0f}")
        manifests += sorted((ROOT / "datasets").glob("*/recordings.yaml"))
        for manifest in manifests:
            read = seconds([morphe, "import", manifest, "--out", file])
            cut = seconds([morphe, "inspect", file])
            label = "Liberty (240 Hz)" if manifest.parent == folder else manifest.parent.name
            length = recorded(file)
            print(f"{label:24}{length:12.1f}{length / read:12.0f}{length / (read + cut):18.0f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
