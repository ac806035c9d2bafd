#!/usr/bin/python3
"""Measures the processor time and the clock of the project's own commands on fresh clones of commits.

  bench_build.py COMMIT… [--commands run test ci] [--json OUT] [--keep DIR]

`run` is scripts/run and `test` is scripts/test in the same clone after it; `ci` is .ci/run in a clone
of its own. Packages are installed before the clock starts, and a compiler cache is not used. Where
several commits are named, each command runs for all of them in turn, and the ratio to the first
commit is printed. The machine should do nothing else meanwhile. --json adds the figures to OUT, with
the machine's name; figures that OUT holds already for a commit and this machine are not measured
again. --keep leaves each clone's build log and test log in DIR."""
import argparse
import json
import os
import pathlib
import platform
import resource
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMANDS = {"run": ["scripts/run", "--yes"], "test": ["scripts/test", "--yes"], "ci": [".ci/run"]}


def git(*words):
    return subprocess.run(["git", "-C", ROOT, *words], capture_output=True, text=True, check=True).stdout.strip()


def machine():
    """The processor, the number of its cores, and the system."""
    model = [line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")]
    return f"{model[0] if model else platform.machine()}, {os.cpu_count()} cores, {platform.freedesktop_os_release()['PRETTY_NAME']}"


def install(clone):
    """Installs every package that any of the commands would."""
    lists = sorted((clone / "scripts").glob("packages*.txt"))
    names = [line.split("#")[0].strip() for file in lists for line in file.read_text().splitlines()]
    subprocess.run(["apt-get", "install", "-y", "--no-install-recommends", *filter(None, names)], check=True,
                   stdout=subprocess.DEVNULL, env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})


def measure(clone, command):
    """Runs the command in the clone; returns seconds of processor and clock, and its exit code."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    with open(clone / f"{command}.log", "w") as log:
        code = subprocess.run(COMMANDS[command], cwd=clone, stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
                              env={**os.environ, "CCACHE_DISABLE": "1"}, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return {"processor_time_s": round(processor, 1), "clock_s": round(time.monotonic() - begin, 1), "exit_code": code}


def keep(clone, command, folder):
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copy(clone / f"{command}.log", folder)
    for file in clone.glob("build/*/.ninja_log"):
        shutil.copy(file, folder / f"{command}.{file.parent.name}.ninja_log")
    for file in clone.glob("build/*/Testing/Temporary/LastTest.log"):
        shutil.copy(file, folder / f"{command}.{file.parents[2].name}.LastTest.log")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("commits", nargs="+", metavar="COMMIT")
    parser.add_argument("--commands", nargs="+", choices=COMMANDS, default=list(COMMANDS))
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_args()
    commits = [git("rev-parse", "--short=10", commit) for commit in arguments.commits]
    known = json.loads(arguments.json.read_text()) if arguments.json and arguments.json.exists() else []
    here, failed = machine(), False
    print(f"{here}\n{'command':8} {'commit':10} {'processor s':>12} {'clock s':>9}  ratios to {commits[0]}")
    with tempfile.TemporaryDirectory(prefix="morphe_build_") as folder:
        for command in arguments.commands:
            first = None
            for commit in commits:
                row = next((row for row in known if (row["machine"], row["commit"], row["command"]) == (here, commit, command)),
                           None)
                if row is None:
                    clone = pathlib.Path(folder, commit + ("_ci" if command == "ci" else ""))
                    if not clone.exists():
                        subprocess.run(["git", "clone", "--quiet", ROOT, clone], check=True)
                        subprocess.run(["git", "-C", clone, "checkout", "--quiet", "--detach", commit], check=True)
                        install(clone)
                    row = {"machine": here, "commit": commit, "command": command, **measure(clone, command)}
                    known.append(row)
                    if arguments.keep:
                        keep(clone, command, arguments.keep / commit)
                    if arguments.json:
                        arguments.json.write_text(json.dumps(known, indent=1) + "\n")
                first = first or row
                failed = failed or row["exit_code"] != 0
                print(f"{command:8} {commit:10} {row['processor_time_s']:12.1f} {row['clock_s']:9.1f}"
                      f"  {row['processor_time_s'] / first['processor_time_s']:.2f} {row['clock_s'] / first['clock_s']:.2f}"
                      + (f"  exit code {row['exit_code']}" if row["exit_code"] else ""), flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
