#!/usr/bin/python3
"""What `morphe report` takes and how fast its page is in Chromium without a GPU, beside an empty page
in the same browser: the shipped plans, and the same plans as often as it takes.

  bench_report.py MORPHE PLANS.h5 [--counts 5 400 1000] [--repeat 3]

first: opening to the first frame of a movement; list: opening to the table; act: the slowest of
sorting, filtering, searching and opening a movement among them, each to the next frame."""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import h5py

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import browser  # noqa: E402

LIST_THERE = "return document.querySelectorAll('table.plan-table tbody:not(.spacer) tr').length > 0"
SCENE_THERE = "return document.querySelector('.instant')?.textContent.startsWith('robot')"
NEXT_FRAME = "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => done(performance.now() - start)));"
ACTS = {
    "sort": "const start = performance.now(); document.querySelectorAll('table.plan-table th button')[4].click();" + NEXT_FRAME,
    "filter": "const start = performance.now(); document.querySelector('.count.status-executable').click();" + NEXT_FRAME,
    "search": "const start = performance.now(); const s = document.querySelector('input[type=search]');"
              "s.value = '3'; s.dispatchEvent(new Event('input'));" + NEXT_FRAME,
}
OPEN = ("const [row, done] = arguments, start = performance.now();"
        "location.hash = document.querySelectorAll('table.plan-table a')[row].getAttribute('href');"
        "const look = () => (document.querySelector('.instant')?.textContent.startsWith('robot') && "
        "!document.querySelector('#movement').hidden && document.querySelector('.plot')"
        " ? requestAnimationFrame(() => done(performance.now() - start)) : requestAnimationFrame(look)); look();")
FRAMES = ("const done = arguments[0]; document.querySelector('.play').click(); let frames = 0; const start = performance.now();"
          "const count = () => { ++frames; const spent = performance.now() - start;"
          "if (spent < 3000) requestAnimationFrame(count);"
          "else { document.querySelector('.play').click(); done(1000 * frames / spent); } };"
          "requestAnimationFrame(count);")


def many(plans, count, out):
    """The plans again and again under other names."""
    with h5py.File(plans) as source, h5py.File(out, "w", track_order=True) as file:
        for key in source:
            if key != "plans":
                source.copy(key, file)
        for key, value in source.attrs.items():
            file.attrs[key] = value
        group = file.create_group("plans", track_order=True)
        names = list(source["plans"])
        for k in range(count):
            source.copy(f"plans/{names[k % len(names)]}", group, f"movement_{k:05}")


def measured(command):
    start = time.perf_counter()
    process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"ended with {os.waitstatus_to_exitcode(status)}: {command}")
    return time.perf_counter() - start, used.ru_maxrss / 1024


def seconds_to(window, url, script):
    window.get("about:blank")
    start = time.perf_counter()
    window.get(url)
    while not window.execute_script(script):
        time.sleep(0.005)
    window.execute_async_script("const done = arguments[0]; requestAnimationFrame(() => done(0))")
    return time.perf_counter() - start


def acts(window):
    """Slowest of each act [ms], the filter taken back after each."""
    slowest = {}
    for name, script in ACTS.items():
        times = []
        for _ in range(3):
            times.append(window.execute_async_script(script))
        slowest[name] = max(times)
    window.execute_script("const s = document.querySelector('input[type=search]'); s.value = ''; s.dispatchEvent(new Event('input'))")
    times = []
    for row in (0, 3, 1):
        times.append(window.execute_async_script(OPEN, row))
        window.execute_script("document.querySelector('#back').click()")
        browser.wait_until(window, LIST_THERE)
    slowest["open"] = max(times)
    return slowest


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("morphe", type=pathlib.Path)
    parser.add_argument("plans", type=pathlib.Path)
    parser.add_argument("--counts", type=int, nargs="+", default=[5, 400, 1000])
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    print("plans  report s  peak MB  page MB  empty s  list s  first s  frames/s  sort ms  filter ms  search ms  open ms")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "empty.html").write_text("<!doctype html><title>empty</title>")
        for count in arguments.counts:
            file, page = folder / f"{count}.h5", folder / f"{count}.html"
            many(arguments.plans, count, file)
            spent, peak = measured([arguments.morphe.resolve(), "report", file, "--out", page])
            with browser.open_browser() as window:
                url = page.as_uri()
                median = lambda *what: statistics.median(seconds_to(window, *what) for _ in range(arguments.repeat))  # noqa: E731
                empty = median((folder / "empty.html").as_uri(), "return true")
                first = median(url + "#movement_00001/000/0.5", SCENE_THERE)
                frames = window.execute_async_script(FRAMES)
                listed = median(url, LIST_THERE)
                slow = acts(window)
            print(f"{count:5} {spent:9.2f} {peak:8.0f} {page.stat().st_size / 1e6:8.2f} {empty:8.2f} {listed:7.2f} {first:8.2f}"
                  f" {frames:9.1f} {slow['sort']:8.0f} {slow['filter']:10.0f} {slow['search']:10.0f} {slow['open']:8.0f}",
                  flush=True)
            file.unlink()


main()
