#!/usr/bin/python3
"""Counts the flags and questions of recordings that nobody damaged.

  false_alarms.py MORPHE [--dataset PATH]… [--synthetic N] [--seed S] [--keep FOLDER] [--json FILE]

Each dataset is planned as it is: by default all of datasets/, and N synthetic recordings (200) in three
forms, as trackers with a glove, as marker clusters and as points of a skeleton. Every flag of a
recording or a movement counts, also one that is mended, unless TRUE_FLAGS states why it is right; so
does every recording that cannot be imported. Exit 1: a shipped recording has a false alarm, or more
than 1 of 200 synthetic ones."""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

from answers import QUICK, flags_of
from recordings import ROOT, config_for
from synthetic_takes import synthesize

SYNTHETIC_SHARE = 1 / 200
# Flags that are right, with the fact that makes them so.
TRUE_FLAGS = {
    ("wrists", "incomplete_movement"): "it begins and ends while the hand moves: a second of a test of the format",
    ("wrists_v2", "incomplete_movement"): "the same",
    ("rofunc_take", "lost_rows"): "8 of 906 frames are shipped",
    ("box_begin", "incomplete_movement"): "it ends during the reach",
    ("propulsion", "incomplete_movement"): "it begins and ends between two pushes",
    ("cmu_12_01_walk", "incomplete_movement"): "the arms swing when it begins and when it ends",
}
# Flags that question what is inferred and not the recording: a synthetic hand may take a thing in the
# air, or a thin one.
NOT_OF_DAMAGE = {"unlikely_target"}


def run_dataset(morphe, dataset, folder):
    """({recording: its flags}, lines about recordings that cannot be imported)."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "demonstrations.h5"
    command = [morphe, "import", dataset, "--out", file]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if not file.exists():
        return {}, result.stderr.splitlines()[:1]
    with h5py.File(file) as store:
        flags = {name: flags_of(group) for name, group in store["demonstrations"].items()}
        config = config_for(next(iter(store["demonstrations"].values())))
    settings = [word for setting in QUICK for word in ("--set", setting)]
    planned = subprocess.run([str(word) for word in (morphe, "run", config, "--dataset", file, "--out", folder / "out",
                                                     "--quiet", *settings)], capture_output=True, text=True)
    if not (folder / "out/plans.h5").exists():
        return flags, planned.stderr.splitlines()[:1]
    with h5py.File(folder / "out/plans.h5") as store:
        for name, plans in store["plans"].items():
            for plan in plans.values():
                flags[name] += [one for one in flags_of(plan) if not any(one.resembles(known) for known in flags[name])]
    return flags, result.stderr.splitlines() if result.returncode else []


def print_alarms(title, flags, failures):
    """Returns the number of recordings with a false alarm."""
    wrong = {name: [flag for flag in found if (name, flag.code) not in TRUE_FLAGS and flag.code not in NOT_OF_DAMAGE]
             for name, found in flags.items()}
    wrong = {name: found for name, found in wrong.items() if found}
    print(f"{title}: {len(flags)} recordings, {len(wrong)} with a false alarm, {len(failures)} lines about others")
    for name, found in wrong.items():
        for flag in found:
            print(f"  FALSE {name}: {flag.code} ({flag.response}): {flag.text}")
    for line in failures:
        print(f"  FALSE {line}")
    return len(wrong) + len(failures)


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=Path)
    parser.add_argument("--dataset", metavar="PATH", type=Path, action="append", help="manifest, folder or demonstrations.h5")
    parser.add_argument("--synthetic", metavar="N", type=int, default=200, help="synthetic recordings; 0: none")
    parser.add_argument("--seed", type=int, default=1, help="of the synthetic recordings")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="keep recordings and plans there")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the flags of all recordings")
    return parser.parse_args()


def main():
    options = parse_options()
    morphe, failed, everything = options.morphe.resolve(), False, {}
    with tempfile.TemporaryDirectory(prefix="morphe_alarms_") as scratch:
        folder = (options.keep or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        datasets = options.dataset or sorted((ROOT / "datasets").glob("*/recordings.yaml"))
        for number, dataset in enumerate(datasets):
            flags, failures = run_dataset(morphe, dataset, folder / f"shipped_{number}")
            failed |= print_alarms(dataset, flags, failures) > 0
            everything |= flags
        manifests = synthesize(morphe, options.synthetic, options.seed, folder) if options.synthetic else []
        for manifest in manifests:
            flags, failures = run_dataset(morphe, manifest, folder / f"run_{manifest.parent.name}")
            wrong = print_alarms(f"synthetic {manifest.parent.name}", flags, failures)
            failed |= wrong > SYNTHETIC_SHARE * options.synthetic
            everything |= flags
    if options.json:
        options.json.write_text(json.dumps({name: [vars(flag) for flag in found] for name, found in everything.items()},
                                           indent=1) + "\n")
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
