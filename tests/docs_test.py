#!/usr/bin/python3
"""Holds the documents against the program and the sources.

  docs_test.py MORPHE            links, tables of keys, the list of commands; then runs what the
                                 READMEs show, in a copy, and compares what it prints
  docs_test.py MORPHE --still    without running the READMEs' commands
  docs_test.py MORPHE --update   rewrites what the README shows as printed
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
READMES = ("README.md", "outputs/README.md")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
# Printed figures may differ by this much: on another processor the search may settle in another of
# several postures that serve the goals alike, with millimetres and tempo of its own.
SHARE, LEAST = 0.3, 0.5
NUMBER = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


# --- links ---------------------------------------------------------------------------------------


def anchors(markdown):
    """GitHub's names of a document's headings."""
    headings = re.findall(r"^#+ (.*)$", FENCE.sub("", markdown), re.M)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}


def wrong_links():
    documents = [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "outputs/README.md"]
    documents += [path for top in ("docs", "datasets") for path in (ROOT / top).rglob("*.md")]
    for document in documents:
        where = document.relative_to(ROOT)
        for link in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", document.read_text(encoding="utf-8"))):
            if re.match(r"\w+:", link):
                continue
            name, _, anchor = link.partition("#")
            target = document.parent / name if name else document
            if not target.exists():
                yield f"{where}: {link}: leads nowhere"
            elif anchor and anchor not in anchors(target.read_text(encoding="utf-8")):
                yield f"{where}: {link}: no such heading"


# --- tables of keys ------------------------------------------------------------------------------

FIELDS = re.compile(r"fields\(\w+& \w+, (?:\w+::)?(\w+)& \w+\) \{(.*?)^\}", re.M | re.S)
CALL = re.compile(r'\b\w+(\.required)?\("(\w+)",\s*\w+\.([\w.]+)\)')
TABLE = re.compile(r"<!-- keys: (.*?) -->\n((?:\|.*\n)+)")


def declaration(sources, struct, member):
    """Type and default ("" if none) of a struct's member."""
    body = re.search(rf"^( *)struct {struct} \{{\n(.*?)^\1\}};", sources, re.M | re.S).group(2)
    body = re.sub(r"//.*", "", body)
    body = re.sub(r"struct \w+ \{.*?\};", "", body, flags=re.S)
    for statement in re.split(r";", body):
        found = re.search(rf"[\s,]{member}\s*(?:=\s*(\{{.*?\}}|\w+\(.*?\)|[^,]+?))?\s*(?:,|$)", statement, re.S)
        if found and statement.strip():
            return statement.split()[0], found.group(1) or ""
    raise KeyError(f"{struct}::{member}")


def plain(value):
    """A default as C++ or the document writes it, made comparable."""
    value = value.strip()
    if value == "Vec3::Zero()":
        return [0.0] * 3
    if re.match(r"(\{|\[|Vec3\()", value):
        return [float(x) for x in NUMBER_LIST.findall(re.sub("^Vec3", "", value))]
    return float(value) if NUMBER.fullmatch(value) else value.strip('"')


NUMBER_LIST = re.compile(r"-?[\d.]+(?:e-?\d+)?")


def default_of(sources, struct, path):
    owner, _, member = path.rpartition(".")
    kind, default = declaration(sources, owner.capitalize() if owner else struct, member)
    if default:
        return plain(default)
    if kind.startswith("std::vector"):
        return []
    return "–" if kind in ("std::string", "FileOption") or kind.startswith("std::optional") else "section"


def expected_rows(sources, struct):
    bodies = [body for name, body in FIELDS.findall(sources) if name == struct]
    calls = [call for body in bodies for call in CALL.findall(body)]
    if struct == "ManifestEntry":  # the keys that only a recording has stand outside
        calls = CALL.findall(sources)
    return [(key, "required" if required else default_of(sources, struct, path)) for required, key, path in calls]


def wrong_keys():
    formats, documented = text_of("docs/formats.md"), set()
    for comment, table in TABLE.findall(formats):
        *files, struct = comment.split()
        documented.add(struct)
        cells = [[c.strip() for c in row.split("|")[1:-1]] for row in table.splitlines()[2:]]
        stated = [(row[0].strip("`"), plain(row[1])) for row in cells]
        expected = expected_rows("\n".join(text_of(name) for name in files), struct)
        if not expected:
            yield f"docs/formats.md: {struct}: has no fields() in {files}"
        for row in expected:
            if row not in stated:
                yield f"docs/formats.md: {struct}: {row[0]}: should have the default {row[1]}"
        for key in [s[0] for s in stated]:
            if key not in [e[0] for e in expected]:
                yield f"docs/formats.md: {struct}: {key}: there is no such key"
    for top in ("pipeline", "stages"):
        for path in sorted((ROOT / top).rglob("*.[hc]pp")):
            if path == ROOT / "pipeline/config/fields.hpp":
                continue
            for struct, _ in FIELDS.findall(path.read_text(encoding="utf-8")):
                if struct not in documented:
                    yield f"docs/formats.md: {struct} ({path.relative_to(ROOT)}) has no table"


# --- commands ------------------------------------------------------------------------------------


def run(command, folder, **more):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, **more)


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", text)) - {"--help"}


def synopsis(block):
    """{command: options} of lines that begin with `morphe`."""
    found = {}
    for name, rest in re.findall(r"^morphe (\w+)(.*)$", block, re.M):
        found.setdefault(name, set()).update(options_in(rest))
    return found


def wrong_commands(morphe):
    part = text_of("docs/formats.md").split("\n## Command line\n")[1]
    present, planned = [synopsis(block) for _, block in FENCE.findall(part)[:2]]
    listed = run([morphe, "--help"], ROOT).stdout.partition("Subcommands:")[2]
    commands = set(re.findall(r"^  (\w+)", listed, re.M))
    for name in sorted(commands ^ set(present)):
        yield f"docs/formats.md: morphe {name}: " + ("is not listed" if name in commands else "does not exist")
    for name in sorted(commands & set(present)):
        real = options_in(run([morphe, name, "--help"], ROOT).stdout)
        for option in sorted(real ^ present[name]):
            yield f"docs/formats.md: morphe {name} {option}: " + (
                "is not listed" if option in real else "does not exist")
        for option in sorted(real & planned.get(name, set()) - {"--dataset", "--out"}):
            yield f"docs/formats.md: morphe {name} {option}: is there, not planned"


# --- what the READMEs show -----------------------------------------------------------------------


def same_line(shown, printed):
    words, others = shown.split(), printed.split()
    if len(words) != len(others):
        return False
    for a, b in zip(words, others):
        if NUMBER.fullmatch(a) and NUMBER.fullmatch(b):
            x, y = float(a), float(b)
            if abs(x - y) > SHARE * max(abs(x), abs(y)) + LEAST:
                return False
        elif a != b:
            return False
    return True


def wrong_output(where, shown, printed):
    a, b = shown.splitlines(), printed.splitlines()
    if len(a) != len(b):
        yield f"{where}: {len(a)} lines are shown as printed, {len(b)} are:\n{printed}"
    for x, y in zip(a, b):
        if not same_line(x, y):
            yield f"{where}: shown:   {x}\n{' ' * len(where)}  printed: {y}"


def result_of(command, folder):
    """What a command of a README prints, and what is wrong with it ("" if nothing)."""
    first = command.split()[0]
    if first in ("scripts/run", "scripts/test"):
        done = run([ROOT / first, "--help"], ROOT)
    elif first == "build/release/morphe" or first.startswith("python"):
        done = run(["bash", "-c", command], folder)
    else:
        return "", "this test does not know how to try it"
    return done.stdout, "" if done.returncode == 0 else f"exit {done.returncode}: {done.stderr.strip()}"


def wrong_examples(morphe, update):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for shared in ("configs", "datasets"):
            (folder / shared).symlink_to(ROOT / shared)
        (folder / "outputs").mkdir()
        (folder / "build/release").mkdir(parents=True)
        (folder / "build/release/morphe").symlink_to(morphe)
        for readme in READMES:
            printed, document = "", text_of(readme)
            for kind, block in FENCE.findall(document):
                if kind == "sh":
                    printed = ""
                    for command in filter(None, block.splitlines()):
                        output, wrong = result_of(command, folder)
                        printed += output
                        if wrong:
                            yield f"{readme}: {command}: {wrong}"
                elif kind == "python":
                    if len(block.splitlines()) > 20:
                        yield f"{readme}: the Python example has more than 20 lines"
                    done = run(["/usr/bin/python3", "-"], folder, input=block)
                    if done.returncode != 0 or not done.stdout:
                        yield f"{readme}: the Python example: {done.stderr.strip() or 'prints nothing'}"
                elif kind == "text" and update:
                    lines = "".join(line.rstrip() + "\n" for line in printed.splitlines())
                    (ROOT / readme).write_text(document.replace(block, lines), encoding="utf-8")
                elif kind == "text":
                    yield from wrong_output(readme, block, printed)
                else:
                    yield f"{readme}: a block of kind '{kind}' that nobody tries"


def main(arguments):
    if not arguments or set(arguments[1:]) - {"--still", "--update"}:
        print(__doc__, file=sys.stderr)
        return 2
    morphe = pathlib.Path(arguments[0]).resolve()
    found = [*wrong_links(), *wrong_keys(), *wrong_commands(morphe)]
    if "--still" not in arguments:
        found += wrong_examples(morphe, "--update" in arguments)
    print("\n".join(found) or "the documents hold")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
