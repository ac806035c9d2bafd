#!/usr/bin/python3
"""What a budget of capsules a link costs and gains: a robot is set up with each, and planned for.

bench_budget.py MORPHE ARM.urdf HAND.urdf --config CONFIG [--budgets N…] [--jobs N]

Columns: capsules of the robot; of its meshes the least share of the surface that is inside, the
largest gap, and how far the capsules stand off (median of the links' medians, largest 95 %); plans,
their median clearance [mm], tips [mm], and seconds of planning, the best of three runs."""
import argparse
import re
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import h5py

FIGURES = re.compile(r"# \S+: ([\d.]+) % inside, ([\d.]+) mm outside at most, ([\d.]+) mm off the surface \(95 %: ([\d.]+)\)")


def measured(arguments, budget, folder):
    robot = folder / "robot.yaml"
    begin = time.monotonic()
    subprocess.run([arguments.morphe, "robot", "setup", arguments.arm, arguments.hand, "--out", robot,
                    *(["--capsules", str(budget)] if budget else [])], check=True, capture_output=True)
    setup_s = time.monotonic() - begin
    texts = [path.read_text() for path in folder.glob("*.yaml")]
    figures = [[float(v) for v in found] for text in texts for found in FIGURES.findall(text)]
    config = folder / "config.yml"
    config.write_text(f"extends: {arguments.config.resolve()}\nrobot: {{file: {robot}}}\n")
    seconds = []
    for turn in range(3):
        begin = time.monotonic()
        subprocess.run([arguments.morphe, "run", config, "--out", folder / f"run{turn}", "--jobs", str(arguments.jobs)],
                       check=True, capture_output=True)
        seconds.append(time.monotonic() - begin)
    with h5py.File(folder / "run0/plans.h5") as file:
        capsules = len(file["robot/capsules/radius"])
        plans = [plan for demonstration in file["plans"].values() for plan in demonstration.values()]
        certificates = [dict(plan["certificate"].attrs) for plan in plans if plan.attrs["status"] == b"executable"]
    def of(name):
        values = [1e3 * float(c[name]) for c in certificates]
        return f"{statistics.median(values):9.2f}" if values else f"{'-':>9}"
    inside, gap, median, most = zip(*figures)
    return (f"{budget or 'default':>8} {capsules:>9} {min(inside):>9.1f} {max(gap):>7.2f} {statistics.median(median):>10.1f} "
            f"{max(most):>7.1f} {f'{len(certificates)} of {len(plans)}':>8} {of('clearance')} {of('tip_error_max')} "
            f"{setup_s:>8.1f} {min(seconds):>7.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=lambda name: Path(name).resolve())
    parser.add_argument("arm", type=Path)
    parser.add_argument("hand", type=Path)
    parser.add_argument("--config", type=Path, required=True, help="whose robot is replaced")
    parser.add_argument("--budgets", type=int, nargs="+", default=[1, 4, 0, 16], help="0: setup's own")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    print(f"{'budget':>8} {'capsules':>9} {'inside %':>9} {'gap mm':>7} {'median mm':>10} {'95 % mm':>7} {'plans':>8} "
          f"{'clearance':>9} {'tips mm':>9} {'setup s':>8} {'plan s':>7}")
    for budget in arguments.budgets:
        with tempfile.TemporaryDirectory(prefix="morphe_budget_") as folder:
            print(measured(arguments, budget, Path(folder)), flush=True)


if __name__ == "__main__":
    main()
