#!/usr/bin/python3
"""Damages recordings as laboratories do, and says for each damage whether Morphe notices it.

  damage.py MORPHE [--quick] [--recordings GLOB] [--damages GLOB] [--dataset MANIFEST]… [--every-exchange]
            [--synthetic N] [--jobs N] [--keep FOLDER] [--json FILE] [--list]

Each recording is planned as it is and with each damage (damage_list.py), as a file that is given
alone. The answer to a damage is one of
  mended     a flag that fits says so, and the points or the plan are those of the undamaged recording
  asked      the import asks for the answer that removes the damage
  noticed    a flag that fits is there
  told       a new note, reason or error names it
  harmless   no tip of the mapped path differs by more than 1 mm, no joint by more than 0.05 rad, from
             one of the undamaged plans on the same branch
  unplanned  neither the undamaged recording nor this one has a movement
  undecidable  not named, and damage_list.py states why no file can tell it from an undamaged one
  WRONG      mended, but neither the points nor the plan are those of the undamaged recording
  SILENT     anything else
--every-exchange exchanges each two markers of arm and hand instead, for the whole trial and from the
middle of the reach on. Exit 1: a damage is silent or wrongly mended. Without --dataset all recordings
of datasets/ that have points are taken; a dataset of other formats is converted."""
import argparse
import fnmatch
import json
import sys
import tempfile
from collections import Counter, defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from pathlib import Path

from damage_list import all_damages, every_exchange
from recordings import ROOT, load_recordings
from synthetic_takes import synthesize
from take import Roles
from verdicts import Study

VERDICTS = ("mended", "asked", "noticed", "told", "harmless", "unplanned", "undecidable", "WRONG", "SILENT")
FAULTS = ("WRONG", "SILENT")
QUICK_RECORDINGS = "ADL001DR2"
QUICK_DAMAGES = ("exchange_digits_from", "exchange_hand_whole", "spike_index_200mm_1_reach", "gap_index_0.1s_reach",
                 "gap_all_2s", "axes_mirrored_x", "axes_about_vertical_90", "unit_cm_called_mm",
                 "frozen_all_0.3s", "lost_40", "cut_in_reach", "static_of_another")


def print_table(verdicts):
    counts = defaultdict(Counter)
    for one in verdicts:
        counts[one.damage][one.verdict] += 1
        counts["all"][one.verdict] += 1
    width = max(map(len, counts)) + 1
    print(f"{'damage':{width}}" + "".join(f"{word:>12}" for word in VERDICTS))
    for damage in sorted(counts, key=lambda name: (name == "all", list(counts).index(name))):
        print(f"{damage:{width}}" + "".join(f"{counts[damage][word] or '':>12}" for word in VERDICTS))
    for one in verdicts:
        if one.verdict in FAULTS:
            print(f"{one.verdict} {one.recording} {one.damage}: tips {one.tips_mm} mm, joints {one.joints_rad} rad"
                  + (f"; {one.remark}" if one.remark else ""))


def pairs_of(study, recordings, options):
    for recording in recordings:
        if options.every_exchange:
            damages = every_exchange(Roles(recording.take))
        else:
            damages = all_damages()
        for damage in damages:
            if options.quick and not options.every_exchange and damage.name not in QUICK_DAMAGES:
                continue
            if fnmatch.fnmatch(damage.name, options.damages):
                yield recording, damage


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=Path)
    parser.add_argument("--quick", action="store_true", help="one recording and a damage of each kind")
    parser.add_argument("--recordings", metavar="GLOB", help="names of recordings; NAME.joints is NAME as a skeleton")
    parser.add_argument("--damages", metavar="GLOB", default="*", help="names of damages")
    parser.add_argument("--dataset", metavar="PATH", type=Path, action="append", help="manifest, folder or demonstrations.h5")
    parser.add_argument("--synthetic", metavar="N", type=int, help="synthetic recordings instead, as markers and as points")
    parser.add_argument("--every-exchange", action="store_true", help="exchange each two markers of arm and hand")
    parser.add_argument("--jobs", type=int, default=2, help="recordings that are planned at a time")
    parser.add_argument("--keep", metavar="FOLDER", type=Path, help="keep the damaged files and the plans there")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write all verdicts")
    parser.add_argument("--list", action="store_true", help="print the damages, each with what fits it")
    return parser.parse_args()


def main():
    options = parse_options()
    if options.list:
        for damage in all_damages():
            print(f"{damage.name:32} flags {', '.join(damage.fits)}; questions {', '.join(damage.asks) or '-'}")
        return 0
    pattern = options.recordings or (QUICK_RECORDINGS if options.quick else "*")
    with tempfile.TemporaryDirectory(prefix="morphe_damage_") as scratch:
        folder = (options.keep or Path(scratch)).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        datasets = options.dataset or sorted((ROOT / "datasets").glob("*/recordings.yaml"))
        if options.synthetic:
            datasets = synthesize(options.morphe.resolve(), options.synthetic, 1, folder)[1:]
        recordings = load_recordings(options.morphe.resolve(), datasets, pattern, folder)
        study = Study(options.morphe.resolve(), folder)
        with ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(study.healthy, recordings))
            pairs = list(pairs_of(study, recordings, options))
            verdicts = [one for one in pool.map(lambda pair: study.judge(*pair), pairs) if one]
    if not verdicts:
        sys.exit("no recording or damage of these names")
    print_table(verdicts)
    if options.json:
        options.json.write_text(json.dumps([asdict(one) for one in verdicts], indent=1) + "\n")
    return int(any(one.verdict in FAULTS for one in verdicts))


if __name__ == "__main__":
    sys.exit(main())
