#!/usr/bin/python3
"""The whole UE_ADLdatabase (MiaH-kin/UE_ADLdatabase, 16 people), or a part of it, planned as its
authors sorted it: what segmentation finds against the windows to which they cut their joint angles,
and what becomes of the plans; a row a person.

  ue_adl_database.py MORPHE DATABASE --out FOLDER [--config CONFIG] [--jobs N] [--only GLOB] [--json FILE]

Nothing is fetched: DATABASE is a folder that holds ADL001, ADL002, … An angle file
(ADL001DR2angles.csv, ADL003_AL5angles.csv) has a row every 10 ms from where the movement begins to
where it ends, and does not say where in its recording that is: it is laid where its `Finger
Velocity` correlates best with the speed of the fingertip's marker. The run goes on where it was
stopped."""
import argparse
import csv
import json
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
MOVING = ("reach", "preshape", "grasp", "transport", "return")
CLEAR = 0.95  # least correlation of a window that counts


def recording_of(name):
    """What the names of a recording and of its angles have in common: ADL003_AL5angles, ADL003AL5."""
    return re.sub(r"angles$", "", name).replace("_", "").upper()


def finger_velocities(database):
    """{recording: the column of its angle file}."""
    windows = {}
    for file in sorted(database.rglob("*angles.csv")):
        with open(file, newline="", encoding="utf-8-sig") as text:
            rows = list(csv.DictReader(text))
        if rows and "Finger Velocity" in rows[0]:
            windows[recording_of(file.stem)] = np.array([float(row["Finger Velocity"]) for row in rows])
    return windows


def tip_speed(demonstration):
    """Of the fingertip's marker [m/s], NaN where it was not seen."""
    marker = ("R" if demonstration.attrs["hand"].decode() == "right" else "L") + "FTP"
    markers = demonstration["markers"]
    names = [name.decode() for name in markers.attrs["names"]]
    position = markers["position"][:, names.index(marker)]
    time = markers["time"][()]
    return time, np.linalg.norm(np.gradient(position, time, axis=0), axis=1)


def window_of(demonstration, velocity):
    """(begin, end) [s] in the recording, None where no place is clear."""
    time, speed = tip_speed(demonstration)
    length, best, at = len(velocity), CLEAR, None
    for begin in range(len(speed) - length + 1):
        part = speed[begin:begin + length]
        if np.isnan(part).any() or part.std() == 0 or velocity.std() == 0:
            continue
        correlation = np.corrcoef(part, velocity)[0, 1]
        if correlation > best:
            best, at = correlation, begin
    return None if at is None else (time[at], time[at + length - 1])


def found_motion(plan):
    """(begin, end) [s] of what moves in the movement of a plan, None without one."""
    phases = plan["phases"]
    spans = [(begin, end) for name, begin, end in
             zip(phases["name"].asstr()[()], phases["begin_s"][()], phases["end_s"][()]) if name in MOVING]
    return (spans[0][0], spans[-1][1]) if spans else None


class Person:
    def __init__(self):
        self.trials, self.without, self.several = 0, 0, 0
        self.status = defaultdict(int)
        self.begin, self.end, self.upper_arm, self.humanlike = [], [], [], []

    def add(self, plans, window):
        self.trials += 1
        motions = [found_motion(plan) for plan in plans.values()]
        motions = [motion for motion in motions if motion]
        self.without += not motions
        self.several += len(motions) > 1
        if window and motions:
            near = min(motions, key=lambda motion: abs(motion[0] - window[0]))
            self.begin.append(near[0] - window[0])
            self.end.append(near[1] - window[1])
        for plan in plans.values():
            self.status[plan.attrs["status"].decode()] += 1
            if "certificate" in plan and "trajectory" in plan:
                self.upper_arm.append(np.degrees(plan["certificate"].attrs["upper_arm_error_mean"]))
                self.humanlike.append(1e4 * plan["certificate"].attrs["humanlikeness_final"])

    def join(self, other):
        self.trials, self.without, self.several = (
            self.trials + other.trials, self.without + other.without, self.several + other.several)
        for status, count in other.status.items():
            self.status[status] += count
        for name in ("begin", "end", "upper_arm", "humanlike"):
            getattr(self, name).extend(getattr(other, name))

    def row(self):
        def of(values, function):
            return float(function(values)) if values else float("nan")
        size = [1000 * abs(value) for value in self.begin], [1000 * abs(value) for value in self.end]
        return {"trials": self.trials, "no movement": self.without, "several": self.several,
                "windows": len(self.begin),
                "begin ms": of(size[0], np.median), "95 %": of(size[0], lambda v: np.percentile(v, 95)),
                "end ms": of(size[1], np.median), "95 % ": of(size[1], lambda v: np.percentile(v, 95)),
                "executable": self.status["executable"], "approximate": self.status["approximate"],
                "infeasible": self.status["infeasible"],
                "upper arm deg": of(self.upper_arm, np.median), "humanlike cm^2": of(self.humanlike, np.median)}


def people_of(out, windows):
    people = defaultdict(Person)
    with h5py.File(out / "demonstrations.h5") as recorded, h5py.File(out / "plans.h5") as planned:
        for name, demonstration in recorded["demonstrations"].items():
            velocity = windows.get(recording_of(name))
            window = None if velocity is None else window_of(demonstration, velocity)
            people[demonstration.attrs["subject"].decode()].add(planned["plans"].get(name, {}), window)
    return people


def table(rows):
    columns = ["person", *next(iter(rows.values()))]
    cells = [columns] + [[name, *(f"{value:.1f}" if isinstance(value, float) else str(value)
                                  for value in row.values())] for name, row in rows.items()]
    widths = [max(len(row[k]) for row in cells) for k in range(len(columns))]
    return "\n".join("  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=Path)
    parser.add_argument("database", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="the run's folder")
    parser.add_argument("--config", type=Path, default=ROOT / "configs/pipelines/pa10_dlr_hit2.yaml")
    parser.add_argument("--jobs", type=int, default=0)
    parser.add_argument("--only", default="ADL*", help="folders of the database (ADL00[1-4])")
    parser.add_argument("--json", type=Path, help="the same as JSON")
    options = parser.parse_args()
    folders = sorted(folder for folder in options.database.glob(options.only)
                     if folder.is_dir() and not folder.name.endswith("angles"))
    if not folders:
        sys.exit(f"{options.database}: no folder is called {options.only}")
    words = [options.morphe, "run", options.config, "--out", options.out, "--jobs", options.jobs, "--quiet"]
    for folder in folders:
        words += ["--dataset", folder]
    if subprocess.run([str(word) for word in words], stdout=sys.stderr).returncode not in (0, 1):
        sys.exit("morphe run failed")
    people = people_of(options.out, finger_velocities(options.database))
    everyone = Person()
    for person in people.values():
        everyone.join(person)
    rows = {name: people[name].row() for name in sorted(people)} | {"all": everyone.row()}
    print(table(rows))
    if options.json:
        options.json.write_text(json.dumps(rows, indent=1) + "\n")


if __name__ == "__main__":
    main()
