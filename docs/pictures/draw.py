#!/usr/bin/python3
"""Draws this folder's pictures anew, from the shipped pipelines: docs/pictures/draw.py build/release/morphe"""
import base64
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/support"))
import browser  # noqa: E402

# picture: pipeline, address on the page, seconds of the clock are in it
PICTURES = {
    "report_first_page": ("robots", ""),
    "report_repaired": ("pa10_dlr_hit2_obstacle", "#ADL001DR2/000/0.9"),
    "report_infeasible": ("fr3", "#ADL006DR2/000"),
    "report_from_home": ("pa10_dlr_hit2_from_home", "#ADL004DR2/000/-0.8"),
}
# Drawn, and nothing left to come: the last of the plots is there.
DRAWN = "return document.querySelectorAll('.plot').length >= 5 || !document.querySelector('#overview').hidden"


def page_of(morphe, pipeline, folder):
    subprocess.run([morphe, "run", ROOT / f"configs/pipelines/{pipeline}.yaml", "--out", folder / pipeline,
                    "--report"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return folder / pipeline / "report.html"


def main():
    morphe = pathlib.Path(sys.argv[1]).resolve()
    here = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        window = browser.open_browser(1280, 720)
        for picture, (pipeline, address) in PICTURES.items():
            window.get(page_of(morphe, pipeline, folder).as_uri() + address)
            browser.wait_until(window, DRAWN)
            shot = window.execute_cdp_cmd("Page.captureScreenshot", {"format": "png"})["data"]
            (here / f"{picture}.png").write_bytes(base64.b64decode(shot))
        window.quit()
        plans = folder / "pa10_dlr_hit2_obstacle/plans.h5"
        subprocess.run([morphe, "report", plans, "--plans", "ADL001DR2/000", "--svg", folder / "films"],
                       check=True, stdout=subprocess.DEVNULL)
        shutil.copy(folder / "films/ADL001DR2_000.svg", here / "filmstrip.svg")


main()
