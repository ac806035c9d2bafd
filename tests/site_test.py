"""The site of scripts/docs: it is built without a warning, every link in it leads to a file and a place that
exist, nothing is loaded from elsewhere, and its search finds words. It takes more than 10 s: Sphinx is all of it.

site_test.py     (exit 77: this machine has no Sphinx)
"""
import html.parser
import re
import subprocess
import sys
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path
from urllib.parse import unquote, urlsplit

ROOT = Path(__file__).resolve().parent.parent
LOADED = {"script", "link", "img", "iframe", "source"}


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.links, self.names = [], set()  # (tag, target); the places in it
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.names |= {attributes.get("id"), attributes.get("name")}
        for name in ("href", "src"):
            if attributes.get(name) is not None:
                self.links.append((tag, attributes[name]))


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = Path(holder.name)
        cls.built = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-b", "html", "-c", ROOT / "docs/site", "-d", cls.folder / "trees",
                                    ROOT, cls.folder / "site"], capture_output=True, text=True)
        cls.pages = {file: Page(file) for file in (cls.folder / "site").rglob("*.html")}

    def test_no_warning(self):
        self.assertEqual((self.built.returncode, self.built.stderr), (0, ""))

    def test_every_document_is_a_page(self):
        for document in [*ROOT.glob("docs/*.md"), *ROOT.glob("docs/steps/*.md"), ROOT / "README.md", *ROOT.glob("core/*/README.md")]:
            self.assertIn(self.folder / "site" / document.relative_to(ROOT).with_suffix(".html"), self.pages)

    def test_every_link_leads_somewhere(self):
        wrong, checked = [], 0
        for file, page in self.pages.items():
            for tag, link in page.links:
                target = urlsplit(link)
                if target.scheme or target.netloc:
                    if tag in LOADED and not link.startswith("data:"):
                        wrong.append(f"{file}: loads {link}")
                    continue
                goal = (file.parent / unquote(target.path)).resolve() if target.path else file
                checked += 1
                if not goal.is_file():
                    wrong.append(f"{file}: {link}")
                elif target.fragment and goal in self.pages and unquote(target.fragment) not in self.pages[goal].names:
                    wrong.append(f"{file}: {link}: no such place")
        self.assertEqual(wrong, [])
        self.assertGreater(checked, 2000)

    def test_no_style_or_script_loads_from_elsewhere(self):
        for file in [*(self.folder / "site").rglob("*.css"), *(self.folder / "site").rglob("*.js")]:
            self.assertIsNone(re.search(r"""(url\(|@import|import\(|fetch\()\s*["']?(https?:)?//""", file.read_text(encoding="utf-8")), file)

    def test_the_search_needs_no_server(self):
        """Its index is a script, which a browser also loads from the disk."""
        index = (self.folder / "site/searchindex.js").read_text(encoding="utf-8")
        self.assertTrue(index.startswith("Search.setIndex("))
        for word in ("certificate", "docs/troubleshooting", "humanlik"):
            self.assertIn(word, index)
        self.assertIn(("script", "searchindex.js"), [(tag, link.split("?")[0]) for tag, link in self.pages[self.folder / "site/search.html"].links])


if __name__ == "__main__":
    if any(find_spec(name) is None for name in ("sphinx", "myst_parser", "furo")):
        print("site_test: skipped without Sphinx (scripts/packages_docs.txt)")
        sys.exit(77)
    unittest.main()
