#!/usr/bin/python3
"""Follows docs/adding.md: makes its files and edits in a copy of the tree, compiles what is new or
changed there, runs the examples' own tests, and holds the copy against the tests of includes, names
and documents. What the tables say of a file must be in it. It takes more than 10 s: twenty sources
are compiled, and the page places its robot.

  adding_test.py MORPHE [CXX]    MORPHE checks the robot; CXX, the compiler (g++)
"""
import concurrent.futures
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPIED = ("core", "stages", "pipeline", "examples", "cmake", "configs", "docs", "tests", "scripts")
FLAGS = ["-std=c++20", "-O0", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-DFMT_SHARED", "-I/usr/include/eigen3",
         "-DEIGEN_MAX_ALIGN_BYTES=16", "-DEIGEN_MALLOC_ALREADY_ALIGNED=0"]

# What the page may say of a file. A place is a whole line, or how one line begins; the marks around
# a line that holds a grave accent are two.
BLOCK = r":\n```\w+\n(?P<{0}>.*?)^```$"
ORDER = re.compile(
    r"^New file `(?P<new>[^`]+)`" + BLOCK.format("text") +
    r"|^In `(?P<file>[^`]+)`, (?P<how>after|in place of) the line (?P<begins>that begins )?"
    r"(?:`` ?(?P<line2>.+?) ?``|`(?P<line>[^`]+)`)" + BLOCK.format("put") +
    r"|^In `(?P<file3>[^`]+)`, on the line that begins `(?P<line3>[^`]+)`, replace `(?P<old>[^`]+)` by `(?P<by>[^`]+)`\.$",
    re.M | re.S)

# What most files of the examples include is compiled once, for those files alone that reach it by
# their own includes: a file that lacks one still does not compile. Tests include GoogleTest as well.
COMMON = "core/motion/scene.hpp"
GTEST = "gtest/gtest.h"

# An example's test is a program of its own: these files of the tree are all that it stands on.
PROGRAMS = {
    "tests/stages/import/markers_csv_test.cpp": [
        "stages/import/formats/markers_csv.cpp", "stages/import/formats/marker_columns.cpp", "stages/import/formats/marker_recording.cpp",
        "stages/import/recording/conventions.cpp", "stages/import/recording/apply_name_map.cpp", "stages/import/recording/arm_names.cpp",
        "stages/import/formats/extract_joints.cpp", "stages/import/formats/rigid_bodies.cpp", "stages/import/trackers/hand_tracker.cpp",
        "stages/import/trackers/hand_checks.cpp", "stages/import/trackers/hand_clip.cpp", "stages/import/trackers/hand_curl.cpp",
        "stages/import/trackers/world_checks.cpp", "stages/import/trackers/unseen_hands.cpp", "stages/import/trackers/time_unit.cpp", "core/math/statistics.cpp", "core/motion/bounding_box.cpp",
        "core/files/csv.cpp", "core/files/table_text.cpp", "core/files/text_encoding.cpp", "core/motion/stream_report.cpp",
        "stages/import/recording/repeated_names.cpp", "stages/import/recording/unseen_points.cpp",
        "stages/import/recording/unit_words.cpp", "stages/import/recording/column_label.cpp"],
    "tests/core/humanlike/range_middle_term_test.cpp": [],
    "tests/core/humanlike/palm_position_term_test.cpp": ["core/humanlike/frame_goal.cpp", "core/humanlike/loads.cpp"],
    "tests/stages/export/trajectory_jsonl_test.cpp": ["stages/export/trajectory_jsonl.cpp"],
    "tests/stages/dwell/dwell_test.cpp": ["stages/dwell/dwell.cpp"],
}


def edited(lines, place, begins, how, put):
    """The lines after an edit; its place must be there once."""
    at = [k for k, line in enumerate(lines) if (line.startswith(place) if begins else line == place)]
    if len(at) != 1:
        raise ValueError(f"'{place}' is there {len(at)} times")
    return [*lines[: at[0] + (how == "after")], *put, *lines[at[0] + 1 :]]


def follow(page, copy):
    """Does what the page says; returns the files that are new or changed."""
    touched = []
    for order in ORDER.finditer(page):
        name = order["new"] or order["file"] or order["file3"]
        path = copy / name
        touched += [name] if name not in touched else []
        if order["new"]:
            if path.exists():
                raise ValueError(f"{name}: is there already")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(order["text"], encoding="utf-8")
            continue
        lines = path.read_text(encoding="utf-8").splitlines()
        try:
            if order["file3"]:
                at = [k for k, line in enumerate(lines) if line.startswith(order["line3"])]
                if len(at) != 1 or order["old"] not in lines[at[0]]:
                    raise ValueError(f"'{order['line3']}' with '{order['old']}' is not there once")
                lines[at[0]] = lines[at[0]].replace(order["old"], order["by"])
            else:
                place = order["line2"] or order["line"]
                lines = edited(lines, place, bool(order["begins"]), order["how"], order["put"].splitlines())
        except ValueError as error:
            raise ValueError(f"{name}: {error}") from error
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return touched


def wrong_table(page):
    """The table says which files each section makes and which it changes."""
    for heading, section in re.findall(r"^## (A.*?)\n(.*?)(?=^## |\Z)", page, re.M | re.S):
        orders = list(ORDER.finditer(section))
        made = sorted({order["new"].rpartition("/")[2] for order in orders if order["new"]})
        changed = sorted({(order["file"] or order["file3"]).rpartition("/")[2] for order in orders if not order["new"]})
        row = re.search(rf"^\| \[{heading.lower()}\]\([^)]*\) \|([^|]*)\|([^|]*)\|$", page, re.M | re.I)
        for what, names, cell in (("makes", made, row and row[1]), ("changes", changed, row and row[2])):
            if cell is None or sorted(re.findall(r"`([^`]+)`", cell)) != names:
                yield f"docs/adding.md: '{heading}' {what} " + (" ".join(f"`{name}`" for name in names) or "–")


def wrong_names(page):
    """A row that begins with a link to a file: every name in it must stand in that file."""
    prose = re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S)
    for link, row in re.findall(r"^\| \[[^\]]+\]\(([^)#]+)[^|]*\|(.*)\|$", prose, re.M):
        text = (ROOT / "docs" / link).read_text(encoding="utf-8")
        for name in re.findall(r"`(\w+)`", row):
            if not re.search(rf"\b{name}\b", text):
                yield f"docs/adding.md: {link} has no {name}"


def run(command, folder):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


def reached(copy, name):
    """What a file includes, itself or through files of the tree."""
    found, left = set(), [name]
    while left:
        path = copy / left.pop()
        headers = re.findall(r'^#include [<"]([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.M) if path.exists() else []
        left += set(headers) - found
        found.update(headers)
    return found


def precompiled(compiler, copy, name, *headers):
    """A header of headers beside what it was compiled to, where the compiler finds that."""
    header = copy / "objects" / name
    header.write_text("".join(f"#include <{included}>\n" for included in headers), encoding="utf-8")
    done = run([compiler, *FLAGS, "-I", copy, "-x", "c++-header", header, "-o", f"{header}.gch"], copy)
    return header, set(headers), done.stderr if done.returncode else ""


def compiled(compiler, copy, name, headers, to=None):
    """What the compiler says against a source; `headers` are compiled already, the larger one first."""
    what = ["-c", "-o", to] if to else ["-fsyntax-only"]
    fitting = [header for header, held, _ in headers if held <= reached(copy, name)]
    common = ["-include", fitting[0]] if fitting else []
    done = run([compiler, *FLAGS, "-I", copy, *common, *what, copy / name], copy)
    return f"{name}: does not compile:\n{done.stderr}" if done.returncode else ""


def object_of(copy, name):
    return copy / "objects" / name.replace("/", "_").replace(".cpp", ".o")


def together(copy, test, touched):
    """The files that an example's test stands on: those that the page makes or changes by themselves,
    the others, which the program was built from, as one source."""
    others = [name for name in PROGRAMS[test] if name not in touched]
    if not others:
        return [test, *PROGRAMS[test]]
    source = f"objects/{test.replace('/', '_')}"
    (copy / source).write_text("".join(f'#include "{name}"\n' for name in others), encoding="utf-8")
    return [test, source, *(name for name in PROGRAMS[test] if name in touched)]


def wrong_code(compiler, copy, touched):
    (copy / "objects").mkdir()
    headers = [precompiled(compiler, copy, "tests.hpp", GTEST, COMMON), precompiled(compiler, copy, "common.hpp", COMMON)]
    if wrong := [f"{COMMON}: does not compile:\n{said}" for *_, said in headers if said]:
        return wrong
    parts = {test: together(copy, test, touched) for test in PROGRAMS}
    linked = sorted({name for names in parts.values() for name in names})
    checked = [name for name in touched if name.endswith(".cpp") and name not in linked]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(compiled, compiler, copy, name, headers) for name in checked]
        jobs += [pool.submit(compiled, compiler, copy, name, headers, object_of(copy, name)) for name in linked]
        wrong = [job.result() for job in jobs if job.result()]
    if wrong:
        return wrong
    for test, names in parts.items():
        program = copy / "objects/program"
        objects = [object_of(copy, name) for name in names]
        done = run([compiler, *objects, "-o", program, "-lgtest", "-lgtest_main", "-lfmt", "-lpthread"], copy)
        if done.returncode == 0:
            done = run([program], copy)
        if done.returncode:
            wrong.append(f"{test}: {done.stdout}{done.stderr}")
    return wrong


def wrong_documents(morphe, copy, page):
    """The copy has no program of its own: the commands of the steps' pages stay out, and a new command is
    missed, which shows that it was looked for."""
    new = {f"docs/formats.md: morphe {name}: does not exist" for name in re.findall(r"^New file `pipeline/commands/(\w+)_command.cpp`", page, re.M)}
    for test in (["tests/includes_test.py"], ["tests/names_test.py"], ["tests/docs_test.py", morphe, "--still"]):
        done = run(["/usr/bin/python3", *test], copy)
        missed = new if test[0] == "tests/docs_test.py" else set()
        if set(done.stdout.splitlines()) != missed if missed else done.returncode:
            yield f"{test[0]}: {done.stdout}{done.stderr}"
    for block in re.findall(r"^```sh\n(.*?)^```$", page, re.M | re.S):
        done = run(["bash", "-e", "-c", block], copy)
        if done.returncode:
            yield f"docs/adding.md: {block}{done.stderr}"


def main(arguments):
    if not 1 <= len(arguments) <= 2:
        print(__doc__, file=sys.stderr)
        return 2
    morphe, compiler = pathlib.Path(arguments[0]).resolve(), arguments[1] if arguments[1:] else "g++"
    with tempfile.TemporaryDirectory() as name:
        copy = pathlib.Path(name)
        for top in COPIED:
            shutil.copytree(ROOT / top, copy / top)
        for file in [*ROOT.glob("*.md"), ROOT / "LICENSE", ROOT / "CITATION.cff"]:
            shutil.copy(file, copy)
        (copy / "datasets").symlink_to(ROOT / "datasets")
        for folder in ("outputs", "build/release"):
            (copy / folder).mkdir(parents=True)
        shutil.copy(ROOT / "outputs/README.md", copy / "outputs")
        (copy / "build/release/morphe").symlink_to(morphe)
        page = (ROOT / "docs/adding.md").read_text(encoding="utf-8")
        try:
            touched = follow(page, copy)
        except (OSError, ValueError) as error:
            print(f"docs/adding.md cannot be followed: {error}")
            return 1
        found = list(wrong_documents(morphe, copy, page)) + wrong_code(compiler, copy, touched)
        found += [*wrong_names(page), *wrong_table(page)]
        said = len(re.findall(r"^(?:New file|In) `", page, re.M))
        if said != len(list(ORDER.finditer(page))):
            found.append("docs/adding.md: says something to do that this test does not understand")
    print("\n".join(found) or f"{len(touched)} files made or changed, all as the page says")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
