#!/usr/bin/python3
"""Measures where the processor time of building and testing goes: by folder, header, template and test.

  build_profile.py [--build DIR] [--traces] [--top N] [--update]

Builds the release preset with its tests anew in DIR (build/profile), each compiler call timed by
itself, and runs ctest; then prints tables of the folders and tests that take the most. Without a
compiler cache; what is up to date in DIR is not built again, and keeps its times. --traces also
compiles every source with clang's -ftime-trace, and adds tables of headers and templates; a template's
time includes what it instantiates. --update writes the tables into CONTRIBUTING.md."""
import argparse
import collections
import json
import pathlib
import re
import resource
import shlex
import subprocess
import sys

import bench_build

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "CONTRIBUTING.md"
BEGIN, END = "<!-- tests/bench/build_profile.py --traces --update -->\n", "<!-- until here -->\n"


def launch(log, command):
    """Runs a compiler and adds its processor time to the log."""
    code = subprocess.run(command, check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(log, "a", encoding="utf-8") as file:
        file.write(f"{used.ru_utime + used.ru_stime:.2f} {command[-1] if '-o' not in command else command[command.index('-o') + 1]}\n")
    return code


def run(*command):
    subprocess.run([str(word) for word in command], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


def built(build):
    """Builds everything; {object: seconds}."""
    log = build / "compiler_times.txt"
    launcher = ";".join(["/usr/bin/python3", "-B", __file__, "--launch", str(log)])
    run("cmake", "--preset", "release", "-B", build, f"-DCMAKE_CXX_COMPILER_LAUNCHER={launcher}", "-DCCACHE=CCACHE-NOTFOUND")
    run("cmake", "--build", build)
    return dict(reversed(line.split(" ", 1)) for line in log.read_text(encoding="utf-8").splitlines())


def folder_of(target):
    """CMakeFiles/morphe_map.dir/Unity/… -> morphe_map"""
    found = re.search(r"CMakeFiles/(\w+)\.dir/", target)
    return found[1] if found else target


def by_folder(times):
    sums = collections.Counter()
    for target, seconds in times.items():
        sums[folder_of(target) + (" (precompiled header)" if target.endswith(".gch") else "")] += float(seconds)
    return sums


def by_test(build):
    """Runs ctest one by one; {test: seconds}."""
    run("ctest", "--test-dir", build, "--output-log", build / "tests.txt", "--quiet")
    said = (build / "tests.txt").read_text(encoding="utf-8")
    return collections.Counter({name: float(seconds) for name, seconds in
                                re.findall(r"Test +#\d+: (\S+) [.]+ +Passed +([\d.]+) sec", said)})


def traces(build):
    """Compiles what the build compiled with clang; ({header: s}, {template: s})."""
    headers, templates = collections.Counter(), collections.Counter()
    out = build / "traces"
    out.mkdir(exist_ok=True)
    for number, entry in enumerate(json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))):
        words = shlex.split(entry["command"])
        if not entry["file"].endswith(".cxx") and "/bench/" in entry["file"] or not entry["file"].endswith(("cxx", "cpp")):
            continue
        kept = [word for word in words if word.startswith(("-D", "-I", "-std", "-O", "-march", "-fPIC"))]
        kept += [word for k, word in enumerate(words) if word == "-isystem" or words[k - 1] == "-isystem"]
        trace = out / f"{number}.json"
        subprocess.run(["clang++", *kept, "-w", "-include", ROOT / "cmake/precompiled.hpp", "-ftime-trace", "-c",
                        entry["file"], "-o", trace.with_suffix(".o")], cwd=entry["directory"], check=False)
        if trace.exists():
            add_trace(json.loads(trace.read_text(encoding="utf-8"))["traceEvents"], headers, templates)
    return headers, templates


def add_trace(events, headers, templates):
    for event in events:
        if event.get("name") == "Source":
            name = re.sub(r".*/(include|include/eigen3|c\+\+/\d+)/", "", event["args"]["detail"])
            headers[name.removeprefix(f"{ROOT}/")] += event["dur"] / 1e6
        elif event.get("name") in ("InstantiateFunction", "InstantiateClass"):
            templates[re.sub(r"<.*", "", event["args"]["detail"])] += event["dur"] / 1e6


def table(title, counter, top):
    rows = [f"| {title} | s |", "|---|---|"]
    rows += [f"| {name} | {seconds:.0f} |" for name, seconds in counter.most_common(top)]
    rest = sum(seconds for _, seconds in counter.most_common()[top:])
    return "\n".join(rows + ([f"| the other {len(counter) - top} | {rest:.0f} |"] if len(counter) > top else [])) + "\n"


def main():
    if sys.argv[1:2] == ["--launch"]:
        sys.exit(launch(sys.argv[2], sys.argv[3:]))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/profile")
    parser.add_argument("--traces", action="store_true")
    parser.add_argument("--top", type=int, default=12)
    parser.add_argument("--update", action="store_true")
    arguments = parser.parse_args()
    arguments.build.mkdir(parents=True, exist_ok=True)
    build = arguments.build.resolve()
    folders = by_folder(built(build))
    tables = [f"Measured on: {bench_build.machine()}.\n", table("compiling, by target: processor time", folders, arguments.top),
              table("tests, one after the other: clock", by_test(build), arguments.top)]
    if arguments.traces:
        headers, templates = traces(build)
        tables += [table("headers, with what they include: clang's clock", headers, arguments.top),
                   table("templates, with what they instantiate: clang's clock", templates, arguments.top)]
    text = "\n".join(tables)
    print(text)
    if arguments.update:
        before, _, after = PAGE.read_text(encoding="utf-8").partition(BEGIN)
        PAGE.write_text(before + BEGIN + text + END + after.partition(END)[2], encoding="utf-8")


if __name__ == "__main__":
    main()
