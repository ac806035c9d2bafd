"""mutants_test.py PROGRAM [--count N] [--first N] [TARGET]…: gives every target so many files that
are made of the seeds (make_seeds.py), the same ones on every machine: none crashes a parser of ours,
keeps it busy without end, or gets anything but one clear error. What a library of others does in its
confined child process is no fault. By hand, with more of them: --count 1000000. For inputs that look
for ways of their own: scripts/fuzz. It takes more than 10 s: 50,000 files, and plans of `verify`, 30 ms each."""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
IN_CHILD = 100  # so many fewer of those that begin a process each


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("targets", nargs="*")
    options = parser.parse_args()
    listed = subprocess.run([options.program, "list"], capture_output=True, text=True, check=True).stdout
    targets = [line.split() for line in listed.splitlines()]
    if unknown := set(options.targets) - {name for name, *_ in targets}:
        parser.error(f"no target: {', '.join(sorted(unknown))}")
    failed, files = [], 0
    with tempfile.TemporaryDirectory(prefix="morphe_seeds_") as folder:
        subprocess.run([sys.executable, "-B", HERE / "make_seeds.py", folder], check=True)
        for name, *child in targets:
            if options.targets and name not in options.targets:
                continue
            count = max(1, options.count // IN_CHILD) if child else options.count
            result = subprocess.run([options.program, name, Path(folder) / name, HERE / "words.dict",
                                     str(options.first), str(count)], stderr=subprocess.PIPE, text=True)
            files += count
            if result.returncode != 0:
                failed.append(name)
                print(f"{name}: exit {result.returncode}\n{result.stderr}")
                if (found := Path(folder) / f"{name}.found").exists():
                    print(f"{found.stat().st_size} bytes: {found.read_bytes()[:2000]!r}")
    print(f"{files} files; failed: {', '.join(failed) or 'none'}")
    return 1 if failed else 0


sys.exit(main())
