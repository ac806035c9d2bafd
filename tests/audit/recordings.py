"""The recordings that the study damages: the points of every demonstration of some datasets."""
import fnmatch
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import h5py

from take import Take, take_of_demonstration, text_of

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tests/cli"))
import recorded  # noqa: E402

ARM = ROOT / "configs/pipelines/pa10_dlr_hit2.yaml"
HAND = ROOT / "configs/pipelines/hand_keypoints.yaml"
LEAST_ROWS = 50


@dataclass
class Recording:
    name: str
    subject: str
    take: Take
    config: Path
    other_static: Take = None


def import_dataset(morphe, dataset, folder):
    """A dataset as demonstrations.h5; None if no recording of it can be read."""
    file = folder / f"{dataset.parent.name}_{dataset.stem}.h5"
    result = subprocess.run([morphe, "import", dataset, "--out", file], capture_output=True, text=True)
    if not file.exists():
        print(f"{dataset}: {result.stderr.splitlines()[0]}", file=sys.stderr)
        return None
    return file


def joints_of(take):
    """The same trial as a skeleton of five joints; None without the landmarks of its static trial."""
    if not take.static or not {"RGTH", "RLEP", "RSPR"} <= set(take.static.names):
        return None
    if not {"RTHUM", "RFTP", "RUAR1", "RLAR1"} <= set(take.names):
        return None
    trial, still = (recorded.Recorded(t.names, t.position) for t in (take, take.static))
    joints = recorded.joints_of(trial, still)
    return Take(joints.names, joints.position, take.rate)


def config_for(demonstration):
    """The config of a robot with an arm, or of a hand if no arm was recorded."""
    streams = set(demonstration)
    return HAND if "hand" in streams and not streams & {"markers", "sensors", "skeleton"} else ARM


def recordings_of(file):
    found = []
    with h5py.File(file) as store:
        for name, group in store["demonstrations"].items():
            take = take_of_demonstration(group)
            if take is None or len(take.position) < LEAST_ROWS:
                continue
            subject = text_of(group.attrs.get("subject", name))
            found.append(Recording(name, subject, take, config_for(group)))
            if joints := joints_of(take):
                found.append(Recording(f"{name}.joints", subject, joints, ARM))
    return found


def load_recordings(morphe, datasets, pattern, folder):
    """Those whose names match the pattern, each with the static trial of another person."""
    files = [import_dataset(morphe, dataset, folder) for dataset in datasets]
    everything = [one for file in files if file for one in recordings_of(file)]
    still = {one.subject: one.take.static for one in everything if one.take.static}
    for one in everything:
        others = [static for subject, static in still.items() if subject != one.subject]
        one.other_static = others[0] if others else None
    return [one for one in everything if fnmatch.fnmatch(one.name, pattern)]
