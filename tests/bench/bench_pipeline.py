#!/usr/bin/python3
"""What planning takes, counted in frames that are planned: frames for each second of a core, and the
processor time of each step for each movement. On the shipped recordings, on synthetic sensors of some
seeds, and on the shipped recordings with a post in their way.

  bench_pipeline.py MORPHE [--beside OTHER] [--sets shipped obstacle 1 2] [--count 12] [--repeat 3]
                           [--best DIR] [--json OUT]

A set is `shipped`, `obstacle` or the seed of --count synthetic recordings. With --beside every run is
done by both programs in turn, since what else a machine does changes from minute to minute, and the
values of what they plan are compared (compare_values.py; --best: DIR/SET.h5 holds the best sequences).
Figures are medians over --repeat runs of one thread; processor time, not the clock's. Exit 1 if values
are worse."""
import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

import compare_values

ROOT = pathlib.Path(__file__).resolve().parents[2]
PIPELINES = ROOT / "configs/pipelines"
STEPS = ("map", "repair", "certify", "retime", "reconstruct", "check")


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command}: {done.stderr}")
    return done.stdout


def dataset_of(name, program, folder, count):
    """The arguments of a run: config and dataset."""
    if name == "shipped":
        return [PIPELINES / "pa10_dlr_hit2.yaml"]
    if name == "obstacle":
        return [PIPELINES / "pa10_dlr_hit2_obstacle.yaml"]
    file = folder / f"{name}.h5"
    run(program, "synthesize", ROOT / "configs/synthetic/reach_to_grasp.yaml", "--count", count, "--seed", name, "--out",
        file)
    return [PIPELINES / "pa10_dlr_hit2.yaml", "--dataset", file]


def row_of(name, runs):
    """Medians of what `run --json` says."""
    first = runs[0]
    middle = {step: statistics.median(one["stage_ms_per_movement"].get(step, 0) for one in runs)
              for step in sorted(set().union(*(one["stage_ms_per_movement"] for one in runs)))}
    mapped = first["stage_cpu_s"]["map"] * 1e3 / first["stage_ms_per_movement"]["map"]
    return {"case": name, "n": first["frames"], "movements": round(mapped),
            "frames_per_cpu_second": statistics.median(one["frames_per_cpu_second"] for one in runs),
            "stage_ms_per_movement": middle}


def print_row(row, which):
    steps = row["stage_ms_per_movement"]
    others = sum(ms for step, ms in steps.items() if step not in STEPS)
    print(f"{row['case']:<10}{which:<8}{row['movements']:>10}{row['n']:>8}{row['frames_per_cpu_second']:>10.0f}"
          f"{sum(steps.values()):>8.0f}" + "".join(f"{steps.get(step, 0):>12.1f}" for step in STEPS) +
          f"{others:>8.1f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--beside", type=pathlib.Path, help="another build")
    parser.add_argument("--sets", nargs="+", default=["shipped", "obstacle", "1", "2"])
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--best", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    programs = {"": arguments.program.resolve()}
    if arguments.beside:
        programs = {"before": arguments.beside.resolve(), "after": arguments.program.resolve()}
    print(f"{'set':<10}{'':<8}{'movements':>10}{'frames':>8}{'frames/s':>10}{'ms':>8}" +
          "".join(f"{step:>12}" for step in STEPS) + f"{'others':>8}", flush=True)
    rows, worse = [], False
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for of in arguments.sets:
            what = dataset_of(of, arguments.program, folder, arguments.count)
            runs = {which: [] for which in programs}
            for _ in range(arguments.repeat):
                for which, program in programs.items():
                    runs[which].append(json.loads(run(program, "run", *what, "--out", folder / f"{of}-{which}", "--fresh",
                                                      "--jobs", 1, "--json")))
            for which in programs:
                rows.append({**row_of(of, runs[which]), **({"build": which} if which else {})})
                print_row(rows[-1], which)
            if arguments.beside:
                best = arguments.best / f"{of}.h5" if arguments.best else None
                plans = [compare_values.read(folder / f"{of}-{which}/plans.h5") for which in programs]
                figures = compare_values.compare(*plans, compare_values.read(best) if best and best.exists() else None)
                print(" " * 10 + compare_values.line(figures), flush=True)
                worse = worse or compare_values.worse(figures)
    if arguments.json:
        arguments.json.write_text(json.dumps({"bench": "pipeline", "rows": rows}, indent=1) + "\n", encoding="utf-8")
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main())
