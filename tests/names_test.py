#!/usr/bin/env python3
"""One name, one type: every file under core/, stages/ and pipeline/ writes into the namespace of its folder,
no namespace defines a type twice, and no folder's type is called like a noun of core/motion/.

  names_test.py [ROOT]        the check
  names_test.py --self-test   plants one fault of each kind in what was read; each must be found

A folder's namespace is morphe:: and its name (robot/files: robot); the nouns of core/motion/
and what pipeline/library/ adds to them are in morphe itself; import and export, which C++ keeps for
itself, are imports and exports. What is unnamed in a .cpp file has internal linkage, but its types
may not be called like one that the file could see.
"""

import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEPT_BY_CPP = {"import": "imports", "export": "exports"}
NOUNS = "morphe"

NOISE = re.compile(r"//[^\n]*|/\*.*?\*/|R\"\(.*?\)\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])'", re.S)
TEMPLATE = re.compile(r"\btemplate\s*<[^<>\n]*(?:<[^<>\n]*>[^<>\n]*)*>")
# Types of another folder, declared only.
DECLARED = re.compile(r"^namespace morphe::\w+ \{\n(?:(?:struct|class) \w+;.*\n)+\}", re.M)
TOKEN = re.compile(
    r"(?P<namespace>\bnamespace\s+(?P<opened>[\w:]*)\s*\{)"
    r"|(?P<type>\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(?:MORPHE_EXPORT\s+)?(?P<name>\w+)\b(?!\s*(?:::|<))(?=[^;{}()=]*\{))"
    r"|\busing\s+(?P<alias>\w+)\s*="
    r"|(?P<open>\{)|(?P<close>\})"
)


def namespace_of(path):
    folder = path.split("/")[1]
    return NOUNS if folder in ("motion", "library") else f"{NOUNS}::{KEPT_BY_CPP.get(folder, folder)}"


@functools.cache
def types_of(text):
    """[(line, namespace, name)] of every type at namespace scope; "{}" stands for an unnamed one. The
    self-test asks for the same text again with every fault."""
    text = NOISE.sub(lambda found: "\n" * found.group().count("\n"), text)
    text = TEMPLATE.sub("", text)
    found_types = []
    scopes = []  # a namespace's name, or None for any other brace
    for found in TOKEN.finditer(text):
        if found["namespace"]:
            scopes.append(found["opened"] or "{}")
        elif found["open"]:
            scopes.append(None)
        elif found["close"]:
            if scopes:
                scopes.pop()
        elif None not in scopes:
            line = text.count("\n", 0, found.start()) + 1
            found_types.append((line, "::".join(scopes), found["name"] or found["alias"]))
    return found_types


@functools.cache
def opened_by(text):
    return set(re.findall(r"^namespace (morphe[\w:]*) \{", DECLARED.sub("", text), re.M))


def sources_of(root):
    """{path: text} of every source under core/, stages/ and pipeline/."""
    files = [path for top in ("core", "stages", "pipeline") for path in (root / top).rglob("*") if path.suffix in {".hpp", ".cpp"}]
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in files}


def check(sources):
    found, seen = [], {}
    for source, text in sorted(sources.items()):
        own = namespace_of(source)
        opened = opened_by(text)
        if opened - {own}:
            found.append(f"{source}:1: opens {', '.join(sorted(opened - {own}))}, not {own}")
        found += [f"{source}:{line}: {name}: of which quantity, in which unit?" for line, name in unquantified(text)]
        for line, namespace, name in types_of(text):
            seen.setdefault((namespace, name), []).append(f"{source}:{line}")
    for (namespace, name), places in sorted(seen.items()):
        unnamed = namespace.endswith("{}")
        if len(places) > 1 and not unnamed and namespace.startswith(NOUNS):
            found.append(f"{places[1]}: {namespace}::{name} is defined already: {places[0]}")
        outer = namespace.removesuffix("::{}")
        hidden = [outer] if unnamed else []
        hidden += [NOUNS] if outer != NOUNS else []
        for visible in hidden:
            if (visible, name) in seen and namespace.startswith(NOUNS):
                found.append(f"{places[0]}: {name} hides {visible}::{name}: {seen[visible, name][0]}")
    return found


# Names of a mood or a bare number: a constant says of which quantity it is, and in which unit. KeyBounds
# contain their unit, and bounds::kShare says that they are those of a share.
FORBIDDEN = set("""kAbout kAboutAsMuch kAlong kBeyond kClosed kDeepest kEnds kEnough kFar kFarthest kFewest kFirst kFlat
    kHair kLargest kLatest kLeast kLong kLongest kMany kMost kNear kNearly kNone kOften kOftenEnough kOutside kPatience
    kPulls kReach kRest kRounds kSame kShare kSoonSeen kStep kSteps kStill kSure kTimes kTolerance kToTheEnd kTries
    kWeak""".split())
CONSTANT = re.compile(r"\bconstexpr\b(?! KeyBounds\b)[^;(){]*?\b(k[A-Z]\w*)\s*(?:\[\w*\]\s*)?[={]")


def unquantified(text):
    """[(line, name)] of constants whose name says no quantity."""
    return [(text.count("\n", 0, found.start(1)) + 1, found[1]) for found in CONSTANT.finditer(text) if found[1] in FORBIDDEN]


PLANTED = [
    ("stages/map/planted.cpp", "namespace morphe::map {\nnamespace {\nconstexpr int kOftenEnough = 4;\n}\n}\n"),
    ("core/collision/planted.hpp", "namespace morphe::collision {\nstruct CollisionWorld {\n};\n}\n"),
    ("core/collision/planted.cpp", "namespace morphe::collision {\nstruct Twice {};\nenum class Twice { a };\n}\n"),
    ("core/collision/planted.cpp", "namespace morphe::collision {\nusing CollisionWorld = int;\n}\n"),
    ("core/collision/planted.cpp", "namespace morphe::collision {\nstruct Plan final : Base {};\n}\n"),
    ("core/collision/planted.cpp", "namespace morphe::collision {\nnamespace {\nstruct CollisionWorld {};\n}\n}\n"),
    ("core/collision/planted.hpp", "namespace morphe::collision {\nclass MORPHE_EXPORT CollisionWorld {\n};\n}\n"),
    ("core/collision/planted.cpp", "namespace morphe::solve {\n}\n"),
    ("stages/map/planted.cpp", "namespace morphe {\nstruct Loose {};\n}\n"),
]
ALLOWED = [
    ("core/collision/planted.cpp", "namespace morphe::collision {\nstruct CollisionWorld;\nstruct A { struct Plan {}; };\n}\n"),
    ("stages/map/planted.cpp", 'namespace morphe::map {\n// struct Plan {}\nconst char* a = "struct Plan {";\n}\n'),
    ("pipeline/run/planted.hpp", "namespace morphe::solve {\nstruct Minimum;  // elsewhere\n}\n"),
    ("stages/export/planted.cpp", "namespace morphe::exports {\nnamespace {\nstruct Row {};\n}\n}\n"),
    ("core/motion/planted.hpp", "namespace morphe {\nnamespace bounds {\ninline constexpr KeyBounds kShare{0, 1};\n}\n}\n"),
]


def self_test():
    failures, sources = [], sources_of(ROOT)
    before = set(check(sources))
    for name, text in PLANTED + ALLOWED:
        found = [entry for entry in check({**sources, name: text}) if entry not in before]
        bad = (name, text) in PLANTED
        if bad != (len(found) >= 1 and "planted" in found[0]):
            failures.append(f"{name}: {text!r}: {'not found' if bad else found}")
    return failures


def main(arguments):
    if arguments == ["--self-test"]:
        failures = self_test()
        print("\n".join(failures) or f"{len(PLANTED)} planted faults found, none too many")
        return 1 if failures else 0
    sources = sources_of(pathlib.Path(arguments[0]) if arguments else ROOT)
    found = check(sources)
    if not sources:
        found.append("no sources were found")
    print("\n".join(found) or f"{len(sources)} files, one type a name")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
