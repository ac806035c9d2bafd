#!/usr/bin/env python3
"""Holds every #include under core/, stages/ and pipeline/ against cmake/folders.txt, the table that CMake
links from, and the table against its rules.

  includes_test.py [ROOT]        the check
  includes_test.py --self-test   plants one bad include or row of each kind in what was read; each must be found
"""

import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PLAN = "cmake/folders.txt"
PRECOMPILED = "cmake/precompiled.hpp"

# Open to every folder, as the table says.
OPEN = ("Eigen/", "unsupported/Eigen/", "fmt/")
# Headers of packages, beside those of the standard library and the system.
PACKAGED = re.compile(r"(.*/.*|\w+\.hpp|hdf5\.h|H5\w+\.h|sqlite3\.h|zlib\.h|tinyxml2\.h|nlopt\.h)$")
SYSTEM = re.compile(r"(sys|linux|gnu|sanitizer)/")

# From the one that includes none of the others to the one that may include them all.
LAYERS = ("core", "stages", "pipeline")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


class Plan:
    """The table: packages {name: (once, header prefixes)}, folders {path: (folders, packages)}."""

    def __init__(self, text):
        self.packages, self.folders, self.wrong = {}, {}, []
        last_name = {}  # collision -> core/collision
        users = {}
        flagged = {}  # path -> where it is said how it is compiled
        for number, line in enumerate(text.splitlines(), 1):
            words = line.split()
            if not words or words[0].startswith("#"):
                continue
            where = f"{PLAN}:{number}"
            parts = [part.split() for part in " ".join(words[1:]).split(":")]
            if words[0] == "package":
                # A CMake target may hold "::".
                head, _, headers = " ".join(words[1:]).partition(" : ")
                self.packages[words[1]] = ("once" in head.split(), tuple(headers.split()))
                continue
            if words[0] in ("light", "inline"):
                flagged |= dict.fromkeys(words[1:], where)
                continue
            path = parts[0][0]
            folders = [last_name.get(name, name) for name in (parts[1] if len(parts) > 1 else [])]
            packages = parts[2] if len(parts) > 2 else []
            for name in folders:
                if name not in self.folders:
                    self.wrong.append(f"{where}: {path} names {name}, which does not stand above it")
            for name in packages:
                users.setdefault(name, []).append(path)
                if name not in self.packages:
                    self.wrong.append(f"{where}: there is no package '{name}'")
                elif self.packages[name][0] and len(users[name]) > 1:
                    self.wrong.append(f"{where}: {name} is for one folder alone, {users[name][0]}")
            self.wrong += [f"{where}: {complaint}" for complaint in self.against_rules(path, folders)]
            name = path.split("/", 1)[1]
            if name in last_name:
                self.wrong.append(f"{where}: there is a folder called {name} already")
            last_name[name] = path
            self.folders[path] = (set(folders), set(packages))
        self.wrong += [f"{where}: there is no folder {path}" for path, where in flagged.items() if path not in self.folders]

    @staticmethod
    def against_rules(path, folders):
        for there in filter(lambda there: layer_of(there) in LAYERS, folders):
            layer, other = layer_of(path), layer_of(there)
            if LAYERS.index(other) > LAYERS.index(layer):
                yield f"{layer}/ never includes {other}/: {path} names {there}"
            elif layer == other == "stages" and path.split("/")[1] != there.split("/")[1]:
                yield f"no step includes another: {path} names {there}"


def layer_of(path):
    return path.split("/", 1)[0]


@functools.cache
def folder_of(path):
    return pathlib.PurePosixPath(path).parent.as_posix()


def complaint(source, bracket, target, plan):
    """What is wrong with `source` including `target`, "" if nothing."""
    home = folder_of(source)
    folders, packages = plan.folders.get(home, (set(), set()))
    if layer_of(target) in LAYERS:
        there = folder_of(target)
        return "" if there == home or there in folders else f"{PLAN} draws no arrow from {home} to {there}"
    if target == PRECOMPILED:
        return f"{PRECOMPILED} is the compiler's business"
    if bracket == '"':
        return "not written from the repository's root"
    for name, (_, headers) in plan.packages.items():
        if target.startswith(headers):
            return "" if name in packages else f"{PLAN} does not give {name} to {home}"
    if PACKAGED.match(target) and not SYSTEM.match(target) and not target.startswith(OPEN):
        return f"{PLAN} knows no package with this header"
    return ""


@functools.cache
def includes_of(text):
    """[(line, bracket, header)]; the self-test asks for the same text again with every fault."""
    found = ((number, INCLUDE.match(line)) for number, line in enumerate(text.splitlines(), 1))
    return [(number, *match.groups()) for number, match in found if match]


def sources_of(root):
    """{path: text} of the table and of every source under core/, stages/ and pipeline/."""
    files = [path for top in LAYERS for path in sorted((root / top).rglob("*"))
             if path.suffix in {".hpp", ".cpp", ".h", ".c"}]
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in [root / PLAN, *files]}


def check(sources):
    plan = Plan(sources[PLAN])
    found, used = list(plan.wrong), {}
    for source, text in sources.items():
        if source == PLAN:
            continue
        home = folder_of(source)
        if home not in plan.folders:
            found.append(f"{source}: {PLAN} has no folder {home}")
        for number, bracket, header in includes_of(text):
            used.setdefault(home, set()).add(folder_of(header))
            wrong = complaint(source, bracket, header, plan)
            if wrong:
                found.append(f"{source}:{number}: {header}: {wrong}")
    for home, (folders, _) in plan.folders.items():
        for there in sorted(folders - used.get(home, set())):
            found.append(f"{PLAN}: {home}: nothing in it includes {there}")
    return found


PLANTED = [
    ("core/motion/plan.hpp", '#include "stages/repair/repair_strategy.hpp"'),
    ("core/motion/plan.hpp", '#include "core/config/node.hpp"'),
    ("core/config/node.hpp", "#  include <core/robot/forward_kinematics.hpp>"),
    ("core/robot/forward_kinematics.hpp", '#include "core/collision/world.hpp"'),
    ("core/robot/forward_kinematics.hpp", '#include "core/robot/files/description.hpp"'),
    ("core/collision/world.hpp", '#include "core/humanlike/terms.hpp"'),
    ("stages/verify/planted.cpp", '#include "core/robot/forward_kinematics.hpp"'),
    ("pipeline/run/planted.cpp", '#include "core/solve/minimise.hpp"'),
    ("core/robot/forward_kinematics.cpp", "#include <fcl/narrowphase/collision.h>"),
    ("stages/verify/planted.cpp", "#include <hdf5.h>"),
    ("core/humanlike/planted.cpp", "#include <nlopt.hpp>"),
    ("core/humanlike/planted.cpp", "#include <boost/optional.hpp>"),
    ("stages/map/planted.cpp", "#include <ompl/base/State.h>"),
    ("pipeline/planning/planted.cpp", "#include <CLI/CLI.hpp>"),
    ("pipeline/planning/planted.cpp", '#include "pipeline/commands/commands.hpp"'),
    ("pipeline/explain/planted.cpp", '#include "stages/verify/verify.hpp"'),
    ("stages/import/guess/planted.cpp", '#include "stages/import/formats/bvh_file.hpp"'),
    ("stages/import/clips/planted.cpp", '#include "stages/import/import.hpp"'),
    ("stages/repair/repair.cpp", '#include "stages/check/check_path.hpp"'),
    ("stages/repair/repair.cpp", '#include "pipeline/planning/plan_movement.hpp"'),
    ("stages/repair/repair.cpp", '#include "pipeline/run/journal.hpp"'),
    ("stages/repair/repair.cpp", '#include "repair.hpp"'),
    ("stages/planted.cpp", ""),
]
PLANTED_ROWS = [
    "folder stages/planted : repair",
    "folder stages/planted : planning",
    "folder stages/planted : run",
    "folder stages/import/planted : stages/map",
    "folder core/planted : repair",
    "folder stages/planted : verify",
    "folder stages/planted : later",
    "folder stages/planted : : fcl",
    "folder stages/planted : : nothing",
    "folder stages/human",
    "folder core/planted : planning",
    "light stages/planted",
]
ALLOWED = [
    ("pipeline/planning/planted.cpp", '#include "stages/repair/repair_strategy.hpp"\n#include "stages/map/map_movement.hpp"'),
    ("stages/repair/planted.cpp", "#include <ompl/base/State.h>\n#include <sys/stat.h>\n#include <Eigen/Core>"),
    ("core/humanlike/planted.cpp", '#include "core/robot/forward_kinematics.hpp"'),
]


def self_test():
    failures, sources = [], sources_of(ROOT)
    before = set(check(sources))
    plants = [(name, line, True) for name, line in PLANTED]
    plants += [(PLAN, row, True) for row in PLANTED_ROWS]
    plants += [(name, line, False) for name, line in ALLOWED]
    for name, line, bad in plants:
        planted = {**sources, name: sources.get(name, "") + line + "\n"}
        found = [entry for entry in check(planted) if entry not in before]
        if bad != (len(found) >= 1 and found[0].startswith(name + ":")):
            failures.append(f"{name}: {line}: {'not found' if bad else found}")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        failures = self_test()
        print("\n".join(failures) or f"{len(PLANTED) + len(PLANTED_ROWS)} planted faults found, none too many")
        return 1 if failures else 0
    sources = sources_of(pathlib.Path(arguments[0]) if arguments else ROOT)
    found = check(sources)
    if len(sources) == 1:
        found.append("no sources were found")
    print("\n".join(found) or f"{len(sources) - 1} files, every arrow as drawn")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
