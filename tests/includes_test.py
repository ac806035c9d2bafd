#!/usr/bin/env python3
"""Reads every #include under pipeline/ and stages/ and fails on an arrow that goes back.

  includes_test.py [ROOT]        the check
  includes_test.py --self-test   plants one bad include of each kind in a copy; each must be found
"""

import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What a folder of pipeline/ may include beside itself: the arrows of docs/design.md, "The house".
GROUND = {"motion", "config", "solve", "store"}
PIPELINE = {
    "motion": set(),
    "config": {"motion"},
    "solve": {"motion"},
    "store": {"motion"},
    "kinematics": GROUND,
    "human": GROUND | {"kinematics"},
    "collision": GROUND | {"kinematics"},
    "moveit": GROUND | {"kinematics"},
    "humanlike": GROUND | {"kinematics"},
    "verify": {"motion", "store"},
    "run": {"motion", "store", "config"},
}

# The only folder that may include a library's headers.
LIBRARIES = {
    r"fcl/": "pipeline/collision",
    r"(hdf5|H5\w+)\.h$": "pipeline/store",
    r"nlopt\.(h|hpp)$": "pipeline/solve",
    r"ompl/": "stages/repair",
    r"assimp/": "pipeline/collision",
}

# Stages that are made of other stages; the files directly in stages/ are, too.
COMPOSED = {"stages/study"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """pipeline/<folder>, stages/<folder>, or stages for a file directly in it."""
    parts = pathlib.PurePosixPath(path).parts
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def complaint(source, bracket, target):
    """What is wrong with `source` including `target`, "" if nothing."""
    home = folder_of(source)
    for pattern, only in LIBRARIES.items():
        if re.match(pattern, target):
            return "" if home == only else f"only {only} includes this library"
    if not target.startswith(("pipeline/", "stages/")):
        return "not written from the repository's root" if bracket == '"' else ""

    there = folder_of(target)
    if there == home:
        return ""
    if home.startswith("pipeline"):
        if not there.startswith("pipeline/"):
            return "pipeline/ never includes stages/"
        allowed = PIPELINE.get(home.removeprefix("pipeline/"))
        if allowed is None:
            return f"{home} has no row in the table of {pathlib.Path(__file__).name}"
        if there.removeprefix("pipeline/") not in allowed:
            return f"no arrow leads from {home} to {there}"
        return ""
    if there.startswith("stages") and home != "stages" and home not in COMPOSED:
        return "no stage includes another, or what is made of stages"
    return ""


def check(root):
    found, files = [], 0
    for top in ("pipeline", "stages"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in {".hpp", ".cpp", ".h", ".c"}:
                continue
            files += 1
            source = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                match = INCLUDE.match(line)
                wrong = complaint(source, *match.groups()) if match else ""
                if wrong:
                    found.append(f"{source}:{number}: {match.group(2)}: {wrong}")
    return found, files


PLANTED = [
    ("pipeline/motion/plan.hpp", '#include "stages/repair/repair.hpp"'),
    ("pipeline/motion/plan.hpp", '#include "pipeline/config/node.hpp"'),
    ("pipeline/config/node.hpp", "#  include <pipeline/kinematics/forward.hpp>"),
    ("pipeline/kinematics/forward.hpp", '#include "pipeline/collision/world.hpp"'),
    ("pipeline/collision/world.hpp", '#include "pipeline/humanlike/terms.hpp"'),
    ("pipeline/verify/planted.cpp", '#include "pipeline/kinematics/forward.hpp"'),
    ("pipeline/run/planted.cpp", '#include "pipeline/solve/minimise.hpp"'),
    ("pipeline/planted/planted.hpp", '#include "pipeline/motion/plan.hpp"'),
    ("pipeline/kinematics/forward.cpp", "#include <fcl/narrowphase/collision.h>"),
    ("pipeline/verify/planted.cpp", "#include <hdf5.h>"),
    ("pipeline/humanlike/planted.cpp", "#include <nlopt.hpp>"),
    ("stages/map/planted.cpp", "#include <ompl/base/State.h>"),
    ("stages/repair/repair.cpp", '#include "stages/check/check_path.hpp"'),
    ("stages/repair/repair.cpp", '#include "stages/plan_movement.hpp"'),
    ("stages/repair/repair.cpp", '#include "repair.hpp"'),
]
ALLOWED = [
    ("stages/planted.cpp", '#include "stages/repair/repair.hpp"\n#include "stages/map/planted.hpp"'),
    ("stages/repair/planted.cpp", "#include <ompl/base/State.h>"),
    ("pipeline/humanlike/planted.cpp", '#include "pipeline/kinematics/forward.hpp"'),
]


def self_test():
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder)
        for top in ("pipeline", "stages"):
            shutil.copytree(ROOT / top, copy / top)
        before, _ = check(copy)
        for name, line in PLANTED + ALLOWED:
            path = copy / name
            text = path.read_text(encoding="utf-8") if path.exists() else None
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text((text or "") + line + "\n", encoding="utf-8")
            found = [entry for entry in check(copy)[0] if entry not in before]
            bad = (name, line) in PLANTED
            if bad != (len(found) == 1 and found[0].startswith(name + ":")):
                failures.append(f"{name}: {line}: {'not found' if bad else found}")
            if text is None:
                path.unlink()
            else:
                path.write_text(text, encoding="utf-8")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        failures = self_test()
        print("\n".join(failures) or f"{len(PLANTED)} planted includes found, none too many")
        return 1 if failures else 0
    found, files = check(pathlib.Path(arguments[0]) if arguments else ROOT)
    if not files:
        found.append("no sources were found")
    print("\n".join(found) or f"{files} files, every arrow as drawn")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
