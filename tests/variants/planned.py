"""Recordings and their variants, planned together; and the plans as the study compares them."""
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "tests/audit"), str(ROOT / "tests")]
from take import take_of_demonstration, text_of, write_vicon_csv  # noqa: E402
from verify_branches import branch_of  # noqa: E402
from verify_geometry import Robot  # noqa: E402

from variant_list import variant_of  # noqa: E402

ORIGINAL = "original"
OTHER_HAND = {"right": "left", "left": "right"}


@dataclass
class Recording:
    name: str
    hand: str
    take: object


@dataclass
class Planned:
    """A plan of a movement."""
    status: str
    branch: object         # of the driven path, or of the mapped one without a trajectory
    stored: tuple          # number and words in the file; None in files of earlier versions
    mapped: tuple          # time [F] of the demonstration, joints [F, n]
    driven: tuple          # the same of the trajectory; no rows without one
    objective: float       # mean of the mapped frames
    duration_ratio: float
    robot: object


def import_recordings(morphe, dataset, folder):
    """The recordings of a folder, manifest or file that have points, by name."""
    file = folder / f"dataset_{dataset.resolve().parent.name}_{dataset.stem}.h5"
    result = subprocess.run([morphe, "import", dataset, "--out", file], capture_output=True, text=True)
    if not file.exists():
        sys.exit(f"{dataset} cannot be imported:\n{result.stderr}")
    with h5py.File(file) as store:
        found = [Recording(name, text_of(group.attrs["hand"]), take_of_demonstration(group))
                 for name, group in store["demonstrations"].items()]
    return [one for one in found if one.take]


def write_dataset(recording, variant, folder, seed):
    """Writes the recording, or a variant of it, with a manifest."""
    folder.mkdir(parents=True, exist_ok=True)
    take = recording.take if variant == ORIGINAL else variant_of(recording.take, variant, seed)
    hand = OTHER_HAND[recording.hand] if variant == "mirrored" else recording.hand
    name = f"{recording.name}_again" if variant == "renamed" else recording.name
    write_vicon_csv(take, folder / "trial.csv")
    static = ""
    if take.static:
        write_vicon_csv(take.static, folder / "still.csv")
        static = ", static_trial: still.csv"
    manifest = folder / "recordings.yaml"
    manifest.write_text("format: vicon-csv\nrecordings:\n"
                        f"  - {{file: trial.csv, hand: {hand}, name: {name}{static}}}\n", encoding="utf-8")
    return manifest


def rows_of(group, time):
    return time[()], group["position"][()]


def planned_of(plan, robot):
    mapped = rows_of(plan["mapped"], plan["goals/time"]) if len(plan["mapped/position"]) else (np.empty(0),) * 2
    driven = (np.empty(0), np.empty((0, 0)))
    if "trajectory" in plan:
        driven = rows_of(plan["trajectory"], plan["trajectory/demonstration_time"])
    time, joints = driven if len(driven[0]) else mapped
    branch = branch_of(robot, joints, time) if len(time) else None
    status = text_of(plan.attrs["status"])
    if status == "executable" and plan["certificate"].attrs["repaired"]:
        status = "repaired"
    stored = None
    if "branch" in plan.attrs:
        stored = int(plan.attrs["branch"]), [text_of(word) for word in plan["branch_words"][()]]
    objective = plan["mapped/objective"][()]
    return Planned(status, branch, stored, mapped, driven, float(np.mean(objective)) if len(objective) else np.nan,
                   float(plan["certificate"].attrs["duration_ratio"]), robot)


def plan_variant(morphe, config, settings, recording, variant, folder, seed):
    """The plans of the movements; a variant that cannot be read has no plans."""
    manifest = write_dataset(recording, variant, folder, seed)
    command = [morphe, "run", config, "--dataset", manifest, "--out", folder / "out", "--jobs", "1", "--quiet", "--fresh"]
    command += [word for setting in settings for word in ("--set", setting)]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    file = folder / "out/plans.h5"
    if not file.exists():
        last = result.stderr.strip().splitlines()[-1:]
        print(f"{recording.name} {variant}: not planned: {' '.join(last)}", file=sys.stderr)
        return []
    with h5py.File(file) as store:
        robot = Robot(store["robot"])
        return [planned_of(plan, robot) for movements in store["plans"].values() for plan in movements.values()]
