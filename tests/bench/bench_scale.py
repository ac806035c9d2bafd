#!/usr/bin/python3
"""What a run takes per demonstration as a dataset grows: processor seconds, peak memory and bytes;
and what a second core gives, against what it gives a loop that only counts. Synthetic recordings of
one movement; an arm without a hand, one start of the search, frames at 25 Hz.

  bench_scale.py MORPHE [--counts 100 1000 10000] [--jobs 2]   a row each, in this order
  bench_scale.py MORPHE --cores [--counts 400] [--repeat 5] [--config FILE] [--set a.b=value]

10,000 demonstrations take 7 GB under --folder (default: where temporary files lie)."""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/cli"))
from many import CONFIG, SYNTHETIC  # noqa: E402
from support import MORPHE  # noqa: E402

LOOP = "n = 0\nfor i in range(40_000_000): n += i"


def measured(command):
    """Seconds on the clock, processor seconds, peak memory in MB."""
    start = time.perf_counter()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"ended with {os.waitstatus_to_exitcode(status)}: {command}")
    return time.perf_counter() - start, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


class Runs:
    def __init__(self, folder, arguments):
        self.folder, self.out = folder, folder / "out"
        (folder / "synthetic.yaml").write_text(SYNTHETIC.replace("[1, 2]", "[1, 1]"))
        (folder / "config.yaml").write_text(CONFIG)
        self.config = arguments.config or folder / "config.yaml"
        settings = arguments.set + ([] if arguments.config else ["reconstruct.rate_hz=25"])
        self.settings = [word for setting in settings for word in ("--set", setting)]

    def dataset(self, count):
        file = self.folder / f"{count}.h5"
        if not file.exists():
            measured([MORPHE, "synthesize", self.folder / "synthetic.yaml", "--out", file,
                      "--count", count])
            (self.folder / f"{count}.truth.h5").unlink()
        return file

    def run(self, count, jobs):
        shutil.rmtree(self.out, ignore_errors=True)
        return measured([MORPHE, "run", self.config, *self.settings, "--dataset",
                         self.dataset(count), "--out", self.out, "--jobs", jobs, "--json"])

    def megabytes(self, *files):
        return [os.stat(self.folder / file).st_size / 1e6 for file in files]


def by_count(runs, counts, jobs):
    print(f"{'demonstrations':>14}{'processor s each':>18}{'peak MB':>9}{'dataset MB':>12}"
          f"{'journal MB':>12}{'plans MB':>10}")
    for count in counts:
        _, processor, peak = runs.run(count, jobs)
        sizes = runs.megabytes(f"{count}.h5", "out/journal.sqlite", "out/plans.h5")
        print(f"{count:14}{processor / count:18.4f}{peak:9.1f}{sizes[0]:12.0f}{sizes[1]:12.0f}"
              f"{sizes[2]:10.0f}", flush=True)


def loops(count):
    """Processes that only count, at once: seconds until the last has ended."""
    start = time.perf_counter()
    for process in [subprocess.Popen([sys.executable, "-c", LOOP]) for _ in range(count)]:
        process.wait()
    return time.perf_counter() - start


def by_cores(runs, count, repeat):
    print(f"{'load':>6}{'run, 1 thread s':>17}{'2 threads s':>13}{'gain':>7}{'gain of loops':>15}"
          f"{'ratio':>7}")
    ratios = []
    runs.dataset(count)
    for _ in range(repeat):
        loop = [loops(1), loops(2)]
        one, two = (runs.run(count, jobs)[0] for jobs in (1, 2))
        loop = [loop[0] + loops(1), loop[1] + loops(2)]  # before and after, as the load may change
        gain, most = one / two, 2 * loop[0] / loop[1]
        ratios.append(gain / most)
        print(f"{os.getloadavg()[0]:6.1f}{one:17.2f}{two:13.2f}{gain:7.3f}{most:15.3f}"
              f"{ratios[-1]:7.3f}", flush=True)
    print(f"median of the ratios: {statistics.median(ratios):.3f}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--counts", type=int, nargs="+")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--cores", action="store_true")
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--config", type=pathlib.Path)
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--folder")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=arguments.folder) as name:
        runs = Runs(pathlib.Path(name), arguments)
        if arguments.cores:
            by_cores(runs, (arguments.counts or [400])[0], arguments.repeat)
        else:
            by_count(runs, arguments.counts or [100, 1000, 10000], arguments.jobs)


if __name__ == "__main__":
    main()
