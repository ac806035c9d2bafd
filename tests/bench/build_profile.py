#!/usr/bin/python3
"""Measures where the processor time of building and testing goes: by folder, header, template and test.

  build_profile.py [--build DIR] [--traces] [--top N] [--update]

Builds the release preset with its tests anew in DIR (build/profile), each compiler call timed by
itself, and runs ctest; then prints tables of the folders and tests that take the most. Without a
compiler cache; what is up to date in DIR is not built again, and keeps its times. --traces also
compiles every source of the program with clang's -ftime-trace, unoptimised, and adds tables of headers and
templates; a template's time includes what it instantiates. --update writes the tables into CONTRIBUTING.md."""
import argparse
import collections
import concurrent.futures
import json
import os
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


def run(*command, folder=ROOT):
    subprocess.run([str(word) for word in command], cwd=folder, check=True, stdout=subprocess.DEVNULL)


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
    """Runs ctest, a test for each core at a time; {test: seconds}."""
    run("ctest", "--test-dir", build, "--output-log", build / "tests.txt", "--quiet", "-j", os.cpu_count())
    said = (build / "tests.txt").read_text(encoding="utf-8")
    return collections.Counter({name: float(seconds) for name, seconds in
                                re.findall(r"Test +#\d+: (\S+) [.]+ +Passed +([\d.]+) sec", said)})


def trace(clang, source, out, folder):
    """Compiles a source unoptimised; the events of clang's -ftime-trace, none if clang cannot compile it."""
    command = [str(word) for word in (*clang, "-ftime-trace", "-c", source, "-o", out)]
    if subprocess.run(command, cwd=folder, check=False, stderr=subprocess.DEVNULL).returncode != 0:
        print(f"clang cannot compile {source}: left out", file=sys.stderr)
        return []
    return json.loads(out.with_suffix(".json").read_text(encoding="utf-8"))["traceEvents"]


def traces(build):
    """Compiles the program's sources with clang, the precompiled header once; ({header: s}, {template: s})."""
    headers, templates = collections.Counter(), collections.Counter()
    out = build / "traces"
    out.mkdir(exist_ok=True)
    entries = [entry for entry in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
               if entry["file"].endswith("cxx") and "/tests/" not in entry["file"]]
    flags = sorted({word for entry in entries for word in flags_of(entry["command"])})
    clang = ["clang++", *flags, "-w", "-O0"]
    header = out / "precompiled.pch"
    add_trace(trace([*clang, "-x", "c++-header", "-Xclang", "-emit-pch"], ROOT / "cmake/precompiled.hpp", header, build), headers, templates)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        jobs = [pool.submit(trace, [*clang, "-include-pch", header], entry["file"], out / f"{number}.o", entry["directory"])
                for number, entry in enumerate(entries)]
        for job in jobs:
            add_trace(job.result(), headers, templates)
    return headers, templates


def flags_of(command):
    words = shlex.split(command)
    for k, word in enumerate(words):
        if word.startswith(("-D", "-I", "-std", "-march", "-fPIC")):
            yield word
        elif word == "-isystem":
            yield f"-isystem{words[k + 1]}"


def without_arguments(name):
    """Eigen::Matrix<double, 6, 6>::Matrix<int> -> Eigen::Matrix::Matrix"""
    count = 1
    while count:
        name, count = re.subn(r"<[^<>]*>", "", name)
    return name


def add_trace(events, headers, templates):
    """Adds a source's events; one inside another of the same name is in that one already."""
    until = {}
    for event in sorted((event for event in events if "dur" in event), key=lambda event: (event["ts"], -event["dur"])):
        if event["name"] == "Source":
            sums, name = headers, re.sub(r".*/(include|include/eigen3|c\+\+/\d+)/", "", event["args"]["detail"])
            name = name.removeprefix(f"{ROOT}/")
        elif event["name"] in ("InstantiateFunction", "InstantiateClass"):
            sums, name = templates, without_arguments(event["args"]["detail"])
        else:
            continue
        if event["ts"] >= until.get(name, 0):
            sums[name] += event["dur"] / 1e6
            until[name] = event["ts"] + event["dur"]


def table(title, counter, top, disjoint=True):
    """The largest figures; with what the others sum up to, where no figure contains another."""
    rows = [f"| {title} | s |", "|---|---|"]
    rows += [f"| {name} | {seconds:.0f} |" for name, seconds in counter.most_common(top)]
    others = [seconds for _, seconds in counter.most_common()[top:]]
    if others and disjoint:
        rows.append(f"| the other {len(others)} | {sum(others):.0f} |")
    return "\n".join(rows) + "\n"


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
              table(f"tests, {os.cpu_count()} at a time: clock", by_test(build), arguments.top)]
    if arguments.traces:
        headers, templates = traces(build)
        tables += [table("headers, with all that they include: clang's clock", headers, arguments.top, disjoint=False),
                   table("templates, with all that they instantiate: clang's clock", templates, arguments.top, disjoint=False)]
    text = "\n".join(tables)
    print(text, flush=True)
    if arguments.update:
        before, _, after = PAGE.read_text(encoding="utf-8").partition(BEGIN)
        PAGE.write_text(before + BEGIN + text + END + after.partition(END)[2], encoding="utf-8")


if __name__ == "__main__":
    main()
