#!/usr/bin/python3
"""Plans recordings and variants of them that show the same motion, and says how far the plans differ.

  variants.py MORPHE [--quick] [--config PIPELINE]… [--dataset PATH]… [--recordings GLOB] [--variants GLOB]
              [--synthetic N] [--set KEY=VALUE]… [--jobs N] [--seed N] [--keep FOLDER] [--json FILE] [--require SHARE]

The variants (variant_list.py):
  renamed     the same bytes under another name
  last_digit  every coordinate ± 1e-6 mm
  noisy       every coordinate by up to ± 1 µm
  moved       turned by 30 degrees about the vertical, and shifted
  resampled   at 120 Hz, by cubics
  mirrored    X to -X with right and left exchanged, given as the other hand's: compared as Morphe mirrors it back
A pair of plans is the same if both have the same status and branch, and no joint of the mapped paths ever
differs by more than 0.05 rad. Without --dataset the recordings of datasets/ue-adl are taken. A folder is
imported as `morphe import FOLDER` imports it, with its static trials. --synthetic adds recordings of
`morphe synthesize` as marker clusters. --require makes a smaller share of same pairs exit 1."""
import argparse
import fnmatch
import itertools
import json
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
from compare import SAME_JOINTS_RAD, compare
from planned import ORIGINAL, ROOT, import_recordings, plan_variant
from variant_list import VARIANTS

sys.path.append(str(ROOT / "tests/audit"))
from synthetic_takes import synthesize  # noqa: E402

CONFIG = ROOT / "configs/pipelines/pa10_dlr_hit2.yaml"
DATASET = ROOT / "datasets/ue-adl/recordings.yaml"
QUICK_RECORDINGS, QUICK_VARIANTS = "ADL001DR2", ("last_digit", "moved")


def load_recordings(options, folder):
    morphe = options.morphe.resolve()
    datasets = list(options.dataset or [])
    if options.synthetic:
        datasets.append(synthesize(morphe, options.synthetic, options.seed, folder)[1])
    recordings = [one for dataset in datasets or [DATASET] for one in import_recordings(morphe, dataset, folder)]
    pattern = options.recordings or (QUICK_RECORDINGS if options.quick else "*")
    return [one for one in recordings if fnmatch.fnmatch(one.name, pattern)]


def variants_of(options):
    return [name for name in VARIANTS if fnmatch.fnmatch(name, options.variants)
            and (not options.quick or name in QUICK_VARIANTS)]


def differences_of(plans, recording, robot):
    """A difference for each movement and variant; one that has other movements is named, too."""
    original, found = plans[ORIGINAL], []
    for variant, movements in plans.items():
        if len(movements) != len(original):
            print(f"{robot} {recording.name} {variant}: {len(movements)} movements instead of {len(original)}")
        if variant != ORIGINAL:
            found += [compare(one, other, movement=k, recording=recording.name, robot=robot, variant=variant)
                      for k, (one, other) in enumerate(zip(movements, original))]
    return found


def study_robot(options, config, recordings, folder):
    """(differences, plans of the originals by recording) of a pipeline."""
    def plan(pair):
        (number, recording), variant = pair
        place = folder / config.stem / f"{number:03}_{variant}"
        return plan_variant(options.morphe.resolve(), config, options.set, recording, variant, place, options.seed)
    pairs = list(itertools.product(enumerate(recordings), (ORIGINAL, *variants_of(options))))
    with ThreadPoolExecutor(options.jobs) as pool:
        plans = dict(zip([(number, variant) for (number, _), variant in pairs], pool.map(plan, pairs)))
    found, originals = [], {}
    for number, recording in enumerate(recordings):
        of_it = {variant: movements for (k, variant), movements in plans.items() if k == number}
        found += differences_of(of_it, recording, config.stem)
        originals[recording.name] = of_it[ORIGINAL]
    return found, originals


def share(rows, holds):
    return sum(map(holds, rows)) / len(rows) if rows else float("nan")


def is_same(row):
    """Same status, branch and joints. Two plans without a path are the same if their status is."""
    return row.same_status and row.same_branch and (row.same_joints() or not row.branch and np.isnan(row.joints_rad))


def largest(rows, key):
    values = [getattr(row, key) for row in rows if not np.isnan(getattr(row, key))]
    return max(values, default=float("nan"))


def summary_of(rows):
    return {"pairs": len(rows), "same_status": share(rows, lambda row: row.same_status),
            "same_branch": share(rows, lambda row: row.same_branch), "same": share(rows, is_same),
            "wound_up": sum(bool(row.wound) for row in rows),
            **{key: largest(rows, key) for key in ("joints_rad", "arm_rad", "driven_rad", "palm_deg", "elbow_mm")}}


def print_summaries(rows):
    print(f"{'':28}{'pairs':>6}{'status':>8}{'branch':>8}{'same':>8}{'wound':>7}"
          f"{'joints':>9}{'arm':>8}{'driven':>8}{'palm':>8}{'elbow':>8}")
    for robot in dict.fromkeys(row.robot for row in rows):
        for variant in (*VARIANTS, "all"):
            chosen = [row for row in rows if row.robot == robot and variant in (row.variant, "all")]
            if not chosen:
                continue
            s = summary_of(chosen)
            print(f"{robot[:16]:17}{variant:11}{s['pairs']:6}{s['same_status']:8.0%}{s['same_branch']:8.0%}{s['same']:8.0%}"
                  f"{s['wound_up']:7}{s['joints_rad']:9.3f}{s['arm_rad']:8.3f}{s['driven_rad']:8.3f}"
                  f"{s['palm_deg']:8.1f}{s['elbow_mm']:8.1f}")
    print(f"same: same status and branch, and joints within {SAME_JOINTS_RAD} rad. Largest differences: joints, arm and"
          "\ndriven joints [rad], palm [deg], elbow [mm].")


def print_branches(robot, originals):
    """The branches of the recordings themselves."""
    counts = Counter(", ".join(plan.branch.words()) for plans in originals.values() for plan in plans if plan.branch)
    if counts:
        print(f"{robot}: {len(counts)} branch{'es' if len(counts) > 1 else ''} of the recordings themselves: "
              + "; ".join(f"{count} {words or 'no arm'}" for words, count in counts.most_common()))


def print_different(rows):
    for row in rows:
        if is_same(row):
            continue
        line = f"{row.robot} {row.recording}/{row.movement:03} {row.variant}: joints {row.joints_rad:.3f} rad (arm " \
               f"{row.arm_rad:.3f}), palm {row.palm_deg:.1f} deg, elbow {row.elbow_mm:.1f} mm"
        if not row.same_status:
            line += f"; {row.original_status} -> {row.status}"
        if not row.same_branch:
            line += f"; {row.original_branch} -> {row.branch}"
        print(line)


def originals_json(originals):
    return {name: [{"status": plan.status, "branch": ", ".join(plan.branch.words()) if plan.branch else None,
                    "number": plan.branch.number if plan.branch else None, "stored": plan.stored,
                    "changes": plan.branch.changes if plan.branch else [], "objective": plan.objective,
                    "duration_ratio": plan.duration_ratio} for plan in plans]
            for name, plans in originals.items()}


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=Path)
    parser.add_argument("--quick", action="store_true", help="one recording in two variants")
    parser.add_argument("--config", metavar="PIPELINE", type=Path, action="append", help="by default the reference robot's")
    parser.add_argument("--dataset", metavar="PATH", type=Path, action="append", help="folder, manifest or demonstrations.h5")
    parser.add_argument("--recordings", metavar="GLOB", help="names of recordings")
    parser.add_argument("--variants", metavar="GLOB", default="*", help="names of variants")
    parser.add_argument("--synthetic", metavar="N", type=int, help="synthetic recordings, as marker clusters")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[], help="values of the pipelines")
    parser.add_argument("--jobs", type=int, default=2, help="recordings that are planned at a time")
    parser.add_argument("--seed", type=int, default=1, help="of the noise and of the synthetic recordings")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="keep the files and the plans there")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write all differences")
    parser.add_argument("--require", metavar="SHARE", type=float, default=0.0, help="least share of same pairs, 0 to 1")
    return parser.parse_args()


def run_study(options, folder):
    recordings = load_recordings(options, folder)
    if not recordings or not variants_of(options):
        sys.exit("no recording or variant of these names")
    rows, originals = [], {}
    for config in options.config or [CONFIG]:
        found, originals[config.stem] = study_robot(options, config, recordings, folder)
        rows += found
        print_different(found)
        write_json(options, rows, originals)  # of each robot, as soon as it is known
    return rows, originals


def write_json(options, rows, originals):
    if options.json:
        document = {"summary": summary_of(rows), "differences": [row.as_json() for row in rows],
                    "originals": {robot: originals_json(plans) for robot, plans in originals.items()}}
        options.json.write_text(json.dumps(document, indent=1) + "\n")


def main():
    options = parse_options()
    with tempfile.TemporaryDirectory(prefix="morphe_variants_") as scratch:
        folder = (options.keep or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        rows, originals = run_study(options, folder)
    print_summaries(rows)
    for robot, plans in originals.items():
        print_branches(robot, plans)
    return int(not share(rows, is_same) >= options.require)


if __name__ == "__main__":
    sys.exit(main())
