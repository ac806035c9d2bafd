#!/usr/bin/python3
"""Draws this folder's pictures of plans anew, from the shipped pipelines: docs/pictures/draw.py build/release/morphe
cli:report compares the plans that they carry (tests/support/pictures.py) with those of today."""
import base64
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import browser  # noqa: E402
import pictures  # noqa: E402

# Drawn, and nothing left to come: the last of the plots, or of the posters, is there.
DRAWN = "return document.querySelector('.plots')?.dataset.drawn || document.querySelector('.posters')?.dataset.drawn"


def run_of(morphe, pipeline, folder):
    if not (folder / pipeline).exists():
        subprocess.run([morphe, "run", ROOT / f"configs/pipelines/{pipeline}.yaml", "--out", folder / pipeline,
                        "--report"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return folder / pipeline


def main():
    morphe = pathlib.Path(sys.argv[1]).resolve()
    here = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        window = browser.open_browser(1280, 800)
        for picture, (pipeline, plans, address) in pictures.PICTURES.items():
            run = run_of(morphe, pipeline, folder)
            window.get("about:blank")
            window.get((run / "report.html").as_uri() + address)
            browser.wait_until(window, DRAWN)
            window.execute_script("document.activeElement.blur()")
            browser.wait_until(window, "return true")
            shot = base64.b64decode(window.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})["data"])
            listed = subprocess.run([morphe, "list", run, "--only", plans], check=True, capture_output=True, text=True)
            (here / f"{picture}.png").write_bytes(pictures.with_text(shot, pictures.rows_of_list(listed.stdout)))
        window.quit()
        run = run_of(morphe, "pa10_dlr_hit2_obstacle", folder)
        subprocess.run([morphe, "report", run, "--plans", "ADL001DR2/000", "--svg", folder / "films"],
                       check=True, stdout=subprocess.DEVNULL)
        shutil.copy(folder / "films/ADL001DR2_000.svg", here / "filmstrip.svg")


main()
