#!/usr/bin/env python3
"""No word of an enumeration is compared as text: phases, causes, reasons, statuses, hands, modes and
the like are values, and their names stand in one table each (names_of). And comments are sentences:
clauses that begin with "what", "none" or "nothing" are rare in them.

  words_test.py [ROOT]        the check: no == or != between such a word and anything
  words_test.py --self-test   plants a comparison of each kind, and such clauses; every one must be found
"""
import pathlib
import re
import shutil
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LAYERS = ("core", "stages", "pipeline")
TABLE = re.compile(r"names_of\((\w+)\)\s*\{\s*(?://[^\n]*\n\s*)*return\s*\{(.*?)\}", re.S)
# Words that are also the names of other things: of an object, of a chain of joints, of a kind of
# obstacle that a study puts there. Where they are meant stands beside them.
OTHERS = {
    ("core/collision", "table"): "the object that scene.table makes",
    ("stages/scene/scene_options.cpp", "table"): "the object that scene.table makes",
    ("stages/verify", "table"): "the object that scene.table makes",
    ("pipeline/commands/import_question_text.cpp", "rate"): "a question of the audit",
    ("stages/import", "unit"): "a question of the audit, or a convention",
    ("stages/import", "axes"): "a question of the audit, or a convention",
    ("stages/import", "rate"): "a question of the audit, or a convention",
    ("stages/check/check_collisions.cpp", "table"): "the object that scene.table makes",
    ("stages/scene/scene_options.cpp", "mesh"): "a key of the config, which has convex beside it",
    ("core/robot/files/mount_points.cpp", "base"): "the frame",
    ("core/robot/files/urdf_joints.cpp", "fixed"): "a URDF's type of joint",
    ("pipeline/commands/inspect_report.cpp", "shoulder"): "the joint",
    ("stages/reconstruct/joint_centre.cpp", "shoulder"): "the joint",
    ("pipeline/report/film_instants.cpp", "approach"): "the name of a motion",
    ("pipeline/report/film_instants.cpp", "retreat"): "the name of a motion",
    ("pipeline/study/obstacles.cpp", "reach"): "a kind of obstacle",
}


def words(root):
    """{word: the enumerations that have it}"""
    found = {}
    for path in (path for top in LAYERS for path in sorted((root / top).rglob("*.hpp"))):
        for enumeration, body in TABLE.findall(path.read_text(encoding="utf-8")):
            for word in filter(None, re.findall(r'"([^"]*)"', body)):
                found.setdefault(word, []).append(enumeration)
    return found


def check(root):
    known, found = words(root), []
    either = re.compile(r'[=!]=\s*"([^"]*)"|"([^"]*)"\s*[=!]=')
    for top in LAYERS:
        for path in sorted((root / top).rglob("*.[ch]pp")):
            name = path.relative_to(root).as_posix()
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for match in either.finditer(line.split("//")[0]):
                    word = match[1] if match[1] is not None else match[2]
                    meant = any(name.startswith(place) and word == other for place, other in OTHERS)
                    if word in known and word and not meant:
                        found.append(f'{name}:{number}: compares "{word}", a word of {" and ".join(known[word])}')
    return found


# Per 1,000 words of comments, at most: Ceres, COLMAP, MuJoCo, Crocoddyl and Coal have 0.0 to 1.0.
RARE = {"what": 1.0, "none": 0.5, "nothing": 0.8}
LEXEMES = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)


def comments_of(text):
    return " ".join(found.group() for found in LEXEMES.finditer(text) if found.group().startswith(("//", "/*")))


def clauses(root):
    words = [word for top in LAYERS for path in sorted((root / top).rglob("*.[ch]pp"))
             for word in re.findall(r"[a-z]+", comments_of(path.read_text(encoding="utf-8")).lower())]
    for word, most in RARE.items():
        share = 1000 * words.count(word) / max(1, len(words))
        if share > most:
            yield f"{share:.2f} of 1,000 words of comments are '{word}'; at most {most} may be: write whole sentences"


PLANTED = [
    'bool a(const std::string& phase) { return phase == "grasp"; }',
    'bool b(const std::string& cause) { return cause != "tracking"; }',
    'bool c(const std::string& reason) { return "no_path" == reason; }',
    'bool d(const std::string& hand) { return hand == "left"; }',
    'bool e(const std::string& mode) { return mode == "fastest"; }',
]


def self_test():
    missed = 0
    for line in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for top in LAYERS:
                shutil.copytree(ROOT / top, copy / top)
            (copy / "stages/map/planted.cpp").write_text(f"{line}\n", encoding="utf-8")
            if not any("planted.cpp:1:" in fault for fault in check(copy)):
                print(f"not found: {line}")
                missed += 1
    for word in RARE:
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for top in LAYERS:
                shutil.copytree(ROOT / top, copy / top)
            (copy / "stages/map/planted.cpp").write_text(f"// {word} is left\n" * 200, encoding="utf-8")
            if not any(f"'{word}'" in fault for fault in clauses(copy)):
                print(f"not found: comments that say '{word}'")
                missed += 1
    print(f"{len(PLANTED) + len(RARE) - missed} of {len(PLANTED) + len(RARE)} planted faults found")
    return 1 if missed else 0


def main(arguments):
    if arguments == ["--self-test"]:
        return self_test()
    root = pathlib.Path(arguments[0]) if arguments else ROOT
    faults = [*check(root), *clauses(root)]
    print("\n".join(faults) or f"{len(words(root))} words, none compared as text; comments are sentences")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
