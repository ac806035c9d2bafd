"""The documents as a site: scripts/docs. All Markdown files of the sources, in their folders, so that a link
leads to the same place here and on GitHub."""
import os
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent

project = "Morphe"
author = "The Morphe authors"
release = version = re.search(r"^project\(morphe VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
extensions = ["myst_parser"]
include_patterns = ["*.md", "docs/**.md", "core/**.md", "stages/**.md", "pipeline/**.md", "configs/**.md", "datasets/**.md",
                    "outputs/README.md", "python/**.md", "scripts/**.md", "tests/**.md"]
exclude_patterns = ["build", ".git", "outputs/*/**", "**/node_modules"]
root_doc = "README"
source_suffix = {".md": "markdown"}
myst_heading_anchors = 6
# A file of a language that Pygments does not know is shown as it is.
suppress_warnings = ["misc.highlighting_failure", "myst.header"]

html_theme = "furo"
html_title = f"Morphe {release}"
html_show_sphinx = False
html_copy_source = False
html_static_path = []
html_permalinks_icon = "#"

MENU = {
    "Use": ["docs/tour", "docs/troubleshooting", "docs/glossary", "docs/certificate", "docs/formats", "configs/README",
            "outputs/README", "docs/scale", "CHANGELOG"],
    "Recordings": ["docs/recordings", "docs/clips", "docs/hand_trackers", "docs/audit", "docs/hostile_files", "datasets/README"],
    "Robots": ["configs/robots/README", "docs/robot_controllers", "docs/grasp_quality"],
    "Steps": [f"docs/steps/{path.stem}" for path in sorted((ROOT / "docs/steps").glob("*.md"))],
    "Sources": ["docs/design", "docs/adding", "docs/library", "docs/python", "CONTRIBUTING"],
}
LINK = re.compile(r"\[([^\]\[]*)\]\(([^)\s#]+)(#[^)\s]*)?\)")


def with_menu(text):
    listed = {name for names in MENU.values() for name in names}
    others = sorted(str(path.relative_to(ROOT).with_suffix("")) for top in ("core", "stages", "pipeline", "datasets", "python", "scripts", "tests")
                    for path in (ROOT / top).rglob("*.md"))
    for caption, names in [*MENU.items(), ("Folders", [name for name in others if name not in listed])]:
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {caption}\n\n" + "\n".join(names) + "\n```\n"
    return text


def read(app, name, source):
    """A link to a folder leads to its README, or to the first of its pages; without one it is text."""
    folder = Path(app.env.doc2path(name)).parent

    def to_page(link):
        text, target = link[1], link[2]
        if re.match(r"\w+:", target) or not (folder / target).is_dir():
            return link[0]
        pages = [folder / target / "README.md", *sorted((folder / target).glob("*.md"))]
        found = next((page for page in pages if page.is_file()), None)
        return f"[{text}]({os.path.relpath(found, folder)})" if found else text

    source[0] = LINK.sub(to_page, source[0])
    if name == root_doc:
        source[0] = with_menu(source[0])


def setup(app):
    app.connect("source-read", read)
