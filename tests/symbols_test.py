#!/usr/bin/env python3
"""No program or shared library of a build shows anything of Eigen to the packages that it loads.

Packages hold the same templates, compiled for other processors: a function that is shown takes the
place of theirs, and two halves of a product that do not fit end in a broken heap.

  symbols_test.py BUILD                  the check
  symbols_test.py --self-test COMPILER   builds programs and libraries that show something of each
                                         kind; each must be found
"""

import pathlib
import subprocess
import sys
import tempfile

EIGEN = "Eigen::"
EXECUTABLE, SHARED = 2, 3  # e_type of an ELF file


def is_loaded(path):
    """Whether it is a program or a shared library: not an object file, not an archive."""
    with path.open("rb") as file:
        head = file.read(18)
    if head[:4] != b"\x7fELF":
        return False
    order = "little" if head[5] == 1 else "big"
    return int.from_bytes(head[16:18], order) in (EXECUTABLE, SHARED)


def shown(path):
    """The symbols that a program or library gives to others."""
    command = ["nm", "--dynamic", "--demangle", "--defined-only", "--format=posix", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def check(build):
    found, files = [], 0
    for path in sorted(build.rglob("*")):
        if "CMakeFiles" in path.parts or path.is_symlink() or not path.is_file() or not is_loaded(path):
            continue
        files += 1
        found += [f"{path.relative_to(build)}: {name}" for name in shown(path) if EIGEN in name]
    return found, files


SOURCE = """
#include <vector>
namespace Eigen {
struct __attribute__((visibility("default"))) Matrix { double x = 0; };
template <class T> SHOWN double product(T x) { return 2 * x.x; }
}
template SHOWN double Eigen::product(Eigen::Matrix);
template class std::vector<Eigen::Matrix>;
int main() {}
"""
DEFAULT = '-DSHOWN=__attribute__((visibility("default")))'
HIDDEN = "-DSHOWN="
MAP = pathlib.Path(__file__).resolve().parent.parent / "cmake/exports_nothing.map"
# What is built, with which flags, and what must be found in it.
CASES = [
    ("library.so", ["-shared", DEFAULT], ["Eigen::product", "std::vector<Eigen::Matrix"]),
    ("program", ["-rdynamic", DEFAULT], ["Eigen::product", "std::vector<Eigen::Matrix"]),
    ("standard.so", ["-shared", "-fvisibility=hidden", HIDDEN], ["std::vector<Eigen::Matrix"]),
    ("mapped.so", ["-shared", DEFAULT, f"-Wl,--version-script={MAP}"], []),
    ("mapped", ["-rdynamic", DEFAULT, f"-Wl,--version-script={MAP}"], []),
    ("object.o", ["-c", DEFAULT], []),
]


def self_test(compiler):
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "source.cpp"
        source.write_text(SOURCE, encoding="utf-8")
        for name, flags, expected in CASES:
            build = pathlib.Path(folder) / "build"
            build.mkdir(exist_ok=True)
            file = build / name
            subprocess.run([compiler, "-fPIC", *flags, source, "-o", file], check=True)
            found, files = check(build)
            if files != (file.suffix != ".o"):
                failures.append(f"{name}: {files} files were looked at")
            if bool(found) != bool(expected):
                failures.append(f"{name}: found {found}")
            failures += [f"{name}: {part}: not found" for part in expected if part not in "\n".join(found)]
            file.unlink()
    return failures


def main(arguments):
    if arguments[:1] == ["--self-test"]:
        failures = self_test(*arguments[1:])
        print("\n".join(failures) or f"{len(CASES)} cases, as planted")
        return 1 if failures else 0
    found, files = check(pathlib.Path(*arguments))
    if not files:
        found.append("nothing was built")
    print("\n".join(found) or f"{files} programs and libraries show nothing of Eigen")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
