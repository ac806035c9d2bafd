#!/usr/bin/python3
"""How often what `morphe explain` advises makes an infeasible movement executable: every advice is
given to `morphe run` as --set KEY=VALUE, on a dataset of that one recording.

  bench_advice.py MORPHE [--movements N] [--recordings N] [--seeds S…] [--pipelines NAME…] [--keep FOLDER]

The movements: all that are infeasible in the shipped pipelines and in recordings that synthesize
makes (configs/synthetic/reach_to_grasp.yaml, planned by pa10_dlr_hit2.yaml), evenly N of them."""
import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parents[2]
PIPELINES = ROOT / "configs/pipelines"
SEVERAL = ("robots",)  # for several robots: those have their own


def run(morphe, *arguments):
    result = subprocess.run([str(word) for word in (morphe, *arguments)], capture_output=True, text=True)
    if result.returncode not in (0, 1):
        sys.exit(f"{' '.join(map(str, arguments))}: {result.stderr}")
    return result.stdout


def planned(morphe, options, folder):
    """(label, config, dataset, run's folder) of every set of movements."""
    names = options.pipelines or [f.stem for f in sorted(PIPELINES.glob("*.yaml")) if f.stem not in SEVERAL]
    for name in names:
        config, out = PIPELINES / f"{name}.yaml", folder / name
        run(morphe, "run", config, "--out", out)
        yield name, config, out / "demonstrations.h5", out
    config = PIPELINES / "pa10_dlr_hit2.yaml"
    for seed in options.seeds:
        dataset, out = folder / f"made{seed}.h5", folder / f"seed{seed}"
        run(morphe, "synthesize", ROOT / "configs/synthetic/reach_to_grasp.yaml", "--out", dataset,
            "--count", options.recordings, "--seed", seed)
        run(morphe, "run", config, "--dataset", dataset, "--out", out)
        yield f"synthetic, seed {seed}", config, dataset, out


def of_one_recording(dataset, name, file):
    with h5py.File(dataset) as source, h5py.File(file, "w") as target:
        for key, value in source.attrs.items():
            target.attrs[key] = value
        group = target.create_group("demonstrations", track_order=True)
        source.copy(f"demonstrations/{name}", group)


def status_with(morphe, config, dataset, plan, settings, folder):
    words = [word for one in settings for word in ("--set", one)]
    run(morphe, "run", config, "--dataset", dataset, "--out", folder, "--fresh", *words)
    with h5py.File(folder / "plans.h5") as file:
        if plan not in file["plans"]:
            return "gone"
        attributes = file["plans"][plan].attrs
        return (attributes["reason"] or attributes["status"]).decode()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("morphe")
    parser.add_argument("--movements", type=int, default=10)
    parser.add_argument("--recordings", type=int, default=10)
    parser.add_argument("--seeds", type=int, nargs="*", default=[1, 2])
    parser.add_argument("--pipelines", nargs="*")
    parser.add_argument("--keep", type=Path)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = options.keep or Path(name)
        folder.mkdir(parents=True, exist_ok=True)
        movements = []
        for label, config, dataset, out in planned(options.morphe, options, folder):
            for plan in json.loads(run(options.morphe, "explain", out, "--json"))["plans"]:
                movements.append((label, config, dataset, plan))
        step = max(1, len(movements) / options.movements)
        chosen = [movements[int(k * step)] for k in range(min(options.movements, len(movements)))]
        print(f"{len(movements)} infeasible movements, {len(chosen)} tried")
        tried, helped, first = Counter(), Counter(), Counter()
        for label, config, dataset, plan in chosen:
            print(f"{label}, {plan['plan']}: {plan['reason']}")
            one, by = folder / "one.h5", "nothing"
            of_one_recording(dataset, plan["plan"].split("/")[0], one)
            for advice in plan["advice"]:
                if not advice["settings"]:
                    continue
                status = status_with(options.morphe, config, one, plan["plan"], advice["settings"], folder / "again")
                tried[advice["kind"]] += 1
                helped[advice["kind"]] += status == "executable"
                if status == "executable" and by == "nothing":
                    by = advice["kind"]
                print(f"  {advice['kind']:18} {' '.join(advice['settings']):70} {status}")
            first[by] += 1
        for kind in ("may_solve", "relaxes_tolerance", "changes_assumption"):
            print(f"{kind}: {helped[kind]} of {tried[kind]} advices made their movement executable")
        print(f"of {len(chosen)} movements {first['may_solve']} are executable by what may solve them, "
              f"{first['relaxes_tolerance']} more by what relaxes a tolerance, {first['changes_assumption']} more by what "
              f"changes an assumption, {first['nothing']} by none")


if __name__ == "__main__":
    main()
