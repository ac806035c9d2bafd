#!/usr/bin/python3
"""From URDFs to their first plans, nothing written by hand: setup, place, run, verify.

bench_first_plan.py MORPHE DATASET ARM.urdf[,HAND.urdf]… [--set a.b=value]… [--keep FOLDER]

Columns: seconds of setup, place and run on the machine's cores; joints and capsules; of the run,
executable movements, goals out of reach [%], tips [mm], tempo, the median of the movements' upper-arm
errors and the palm's [degrees]; the upper arm with the base where the person's shoulder is; what verify found; what setup
asks to be checked."""
import argparse
import json
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import h5py

DEGREE = 57.29577951308232


class Failed(Exception):
    pass


def called(*command):
    begin = time.monotonic()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode:
        raise Failed(done.stderr.strip().splitlines()[-1])
    return time.monotonic() - begin, done.stdout


def first_plan(arguments, robot, folder):
    morphe, seconds, checks = arguments.morphe, 0.0, []
    parts = [Path(part).resolve() for part in robot.split(",")]
    for part in parts:
        took, said = called(morphe, "robot", "setup", part, "--out", folder / f"{part.stem}.yaml")
        seconds += took
        checks += [line.removeprefix("check: ") for line in said.splitlines() if line.startswith("check: ")]
    description = folder / f"{parts[0].stem}.yaml"
    if len(parts) > 1:
        description = folder / "both.yaml"
        took, _ = called(morphe, "robot", "setup", *(folder / f"{part.stem}.yaml" for part in parts), "--out", description)
        seconds += took
    report = json.loads(called(morphe, "robot", description, "--json")[1])
    config = folder / "config.yaml"
    config.write_text(f"dataset: {{file: {arguments.dataset}}}\nrobot: {{file: {description}}}\n")
    more = [word for value in arguments.set for word in ("--set", value)]
    place_s, said = called(morphe, "place", config, "--out", folder / "placed.yaml", "--json", *more)
    placed = json.loads(said)
    configured, best = placed["configured"], placed["placements"][0]
    run_s, said = called(morphe, "run", folder / "placed.yaml", "--out", folder / "plans", "--json", *more)
    run = json.loads(said)
    verified = json.loads(subprocess.run([morphe, "verify", folder / "plans/plans.h5", "--json"], capture_output=True,
                                         text=True, check=False).stdout)
    with h5py.File(folder / "plans/plans.h5") as file:
        plans = [plan for demonstration in file["plans"].values() for plan in demonstration.values()]
        certificates = [dict(plan["certificate"].attrs) for plan in plans if plan.attrs["status"] == b"executable"]

    def median(values, unit=1.0, digits=1):
        return f"{unit * statistics.median(values):.{digits}f}" if values else "-"
    return (seconds, place_s, run_s, len(report["joints"]), report["capsules"],
            f"{run['executable']} of {run['movements']}", f"{100 * best['unreachable_share']:.1f}",
            median([float(c["tip_error_mean"]) for c in certificates], 1e3, 2),
            median([float(c["duration_ratio"]) for c in certificates], 1, 2),
            median([float(c["upper_arm_error_mean"]) for c in certificates], DEGREE), f"{DEGREE * best['palm_error']:.1f}",
            f"{DEGREE * configured['upper_arm_error_median']:.1f}", len(verified["violations"]), "; ".join(checks))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=lambda name: Path(name).resolve())
    parser.add_argument("dataset", type=lambda name: Path(name).resolve())
    parser.add_argument("robots", nargs="+", metavar="ARM.urdf[,HAND.urdf]")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--keep", type=Path, help="folder for what is made")
    arguments = parser.parse_args()
    print(f"{'robot':<34} {'setup s':>7} {'place s':>7} {'run s':>6} {'joints':>6} {'capsules':>8} {'executable':>10} "
          f"{'reach %':>7} {'tips':>6} {'tempo':>6} {'upper arm':>9} {'palm':>6} {'before':>6} {'found':>5}  to check")
    for robot in arguments.robots:
        name = "+".join(Path(part).stem for part in robot.split(","))
        with tempfile.TemporaryDirectory(prefix="morphe_first_") as scratch:
            folder = Path(scratch) if arguments.keep is None else (arguments.keep / name).resolve()
            folder.mkdir(parents=True, exist_ok=True)
            try:
                row = first_plan(arguments, robot, folder)
            except Failed as error:
                print(f"{name:<34} {error}", flush=True)
                continue
            print("{:<34} {:>7.1f} {:>7.1f} {:>6.1f} {:>6} {:>8} {:>10} {:>7} {:>6} {:>6} {:>9} {:>6} {:>6} {:>5}  {}".format(name, *row),
                  flush=True)


if __name__ == "__main__":
    main()
