#!/usr/bin/python3
"""Holds the documents against the program and the sources.

  docs_test.py MORPHE            links, tables of keys and folders, the list of commands; then runs what the
                                 READMEs, the tour, the page of controllers and those of the steps show,
                                 in a copy, and compares what is shown as printed: to the letter, where
                                 the build is the one that printed it (SHOWN_BY)
  docs_test.py MORPHE --still    without running these commands
  docs_test.py MORPHE --update   first rewrites keys and defaults of the tables from the sources (the
                                 meaning of a key stays with it; that of a new one has to be written),
                                 then what the README shows as printed
  docs_test.py --self-test       plants faults: each must be found, and a table be mended

It takes more than 10 s: the documents show some eighty commands, among them 22 runs and 3 placements.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

import h5py
import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent
TRIED = ("README.md", "outputs/README.md", "docs/tour.md", "docs/robot_controllers.md")
STEPS = sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "docs/steps").glob("*.md"))
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
# Of what the commands above it print, a page may state a line: <!-- prints: 5 movements: 5 executable -->
PRINTS = re.compile(r"^<!-- prints: (.*?) -->$", re.M)
# What the documents show was printed by a build with these compilers and packages, and must be what
# they print again. With others the search may settle in another of several postures that serve the
# goals alike, with millimetres and tempo of its own: there figures may differ by this share, or by two
# of the last digit that is shown. Small whole numbers are counts, and exact everywhere.
SHOWN_BY = ("GNU 12.2", "OMPL 1.5", "NLopt 2.7", "Eigen3 3.4", "x86-64-v3", "glibc 2.36")
SHARE, LAST_DIGITS, COUNT = 0.3, 2, 20
NUMBER = re.compile(r"-?\d+(\.\d+)?(e-?\d+)?")
# A line that no two runs have alike.
TAKES_TIME = re.compile(r"\d+ frames; \d+ frames/s per core; \d+ ms per movement: map \d+")


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


# --- links ---------------------------------------------------------------------------------------


def anchors(markdown):
    """GitHub's names of a document's headings."""
    headings = re.findall(r"^#+ (.*)$", FENCE.sub("", markdown), re.M)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in headings}


def wrong_links():
    documents = [*ROOT.glob("*.md"), ROOT / "outputs/README.md"]
    documents += [path for top in ("docs", "datasets", "core", "stages", "pipeline", "configs", "examples", "python", "scripts", "tests")
                  for path in (ROOT / top).rglob("*.md")]
    for document in documents:
        where = document.relative_to(ROOT)
        for link in re.findall(r"\]\(([^)\s]+)\)", FENCE.sub("", document.read_text(encoding="utf-8"))):
            if re.match(r"\w+:", link):  # elsewhere
                continue
            name, _, anchor = link.partition("#")
            target = document.parent / name if name else document
            if not target.exists():
                yield f"{where}: {link}: leads nowhere"
            elif anchor and anchor not in anchors(target.read_text(encoding="utf-8")):
                yield f"{where}: {link}: no such heading"


# --- tables of keys ------------------------------------------------------------------------------

FIELDS = re.compile(r"fields\(\w+& \w+, (?:\w+::)?(\w+)& \w+\) \{(.*?)^\}", re.M | re.S)
CALL = re.compile(r'\b\w+(\.required)?\("(\w+)",\s*\w+\.([\w.]+)[,)]')
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
    value = re.sub(r"^\w+::", "", value)  # of an enumeration: its name
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


def as_written(default):
    """A default as the tables show it."""
    if isinstance(default, list):
        return "[" + ", ".join(map(as_written, default)) + "]"
    if isinstance(default, float):
        text = f"{default:.12g}"
        return re.sub(r"e([+-])0*", lambda e: "e-" if e[1] == "-" else "e", text)
    return default


def sources_of(struct):
    """The file that holds a struct and its fields()."""
    for top in ("core", "stages", "pipeline"):
        for path in sorted((ROOT / top).rglob("*.hpp")):
            text = path.read_text(encoding="utf-8")
            if f"struct {struct} {{" in text and struct in [name for name, _ in FIELDS.findall(text)]:
                return text
    return ""


TERMS = re.compile(r"using Terms = std::tuple<(.*?)>;", re.S)
PART = re.compile(r"\bfields\(\w+, \w+\.(\w+)\)")
parts = set()  # structs whose keys stand in the table of the struct that holds them


def rows_of_terms(sources):
    """Those of the objective's terms: off, but for the weights that default_objective() sets."""
    for term in re.findall(r"\w+(?=,|$)", re.sub(r"\s|//", "", TERMS.search(text_of("core/humanlike/terms.hpp"))[1])):
        for key, default in rows_of(sources_of(term), term):
            usual = re.search(rf"get<humanlike::{term}>\(\)\.weight = (\S+);", sources)
            yield key, as_written(plain(usual[1])) if usual else default


def rows_of(sources, struct):
    parts.add(struct)
    for body in [body for name, body in FIELDS.findall(sources) if name == struct]:
        for statement in body.split(";"):
            if call := CALL.search(statement):
                required, key, path = call.groups()
                yield f"`{key}`", "required" if required else as_written(default_of(sources, struct, path))
            elif part := PART.search(statement):
                kind = declaration(sources, struct, part[1])[0].split("::")[-1]
                yield from rows_of_terms(sources) if kind == "FrameObjective" else rows_of(sources_of(kind), kind)


def rows_of_code(files, struct):
    """[(key, default)] of a struct's fields(), in their order."""
    sources = "\n".join(text_of(name) for name in files)
    if struct == "ManifestEntry":  # the keys that only a recording has stand outside
        return [
            (f"`{key}`", "required" if required else as_written(default_of(sources, struct, path)))
            for required, key, path in CALL.findall(sources)
        ]
    return list(rows_of(sources, struct))


def cells_of(table):
    return [[c.strip() for c in row.split("|", 3)[1:3]] + [row.split("|", 3)[3].rstrip(" |")] for row in table]


def generated(comment, table):
    """A table as the sources have it: their keys and defaults, the meanings that it gave them."""
    *files, struct = comment.split()
    head, rows = table.splitlines()[:2], cells_of(table.splitlines()[2:])
    meanings = {key: meaning.strip() for key, _, meaning in rows}
    lines = [f"| {key} | {default} | {meanings.get(key, '')} |" for key, default in rows_of_code(files, struct)]
    return "".join(line + "\n" for line in [*head, *lines])


def with_keys(text):
    """A document with its tables as the sources have them."""
    return TABLE.sub(lambda m: f"<!-- keys: {m[1]} -->\n{generated(m[1], m[2])}", text)


def wrong_tables(name, text):
    for comment, table in TABLE.findall(text):
        struct, mended = comment.split()[-1], generated(comment, table)
        if mended.count("\n") == 2:
            yield f"{name}: {struct}: has no fields() in {comment}"
        for line in table.splitlines():
            if line not in mended.splitlines():
                yield f"{name}: {struct}: is not so: {line}"
        for line in mended.splitlines():
            if line not in table.splitlines():
                yield f"{name}: {struct}: should be there: {line} (--update)"
        if sorted(mended.splitlines()) == sorted(table.splitlines()) and mended != table:
            yield f"{name}: {struct}: is not in the order of the code (--update)"
        for key, _, meaning in cells_of(table.splitlines()[2:]):
            if meaning.strip() in ("", "–"):
                yield f"{name}: {struct}: {key}: has no meaning"


def with_tables():
    """The documents that have tables of keys."""
    return ["docs/formats.md", "docs/audit.md", *STEPS]


def wrong_keys():
    documented = set()
    for name in with_tables():
        yield from wrong_tables(name, text_of(name))
        documented |= {comment.split()[-1] for comment, _ in TABLE.findall(text_of(name))}
    for top in ("core", "stages", "pipeline"):
        for path in sorted((ROOT / top).rglob("*.[hc]pp")):
            # The keys of `generate` are explained by the schema of robots.
            if path in (ROOT / "core/config/fields.hpp", ROOT / "core/robot/files/generated_specs.hpp"):
                continue
            for struct, _ in FIELDS.findall(path.read_text(encoding="utf-8")):
                if struct not in documented | parts | {"FrameObjective"}:
                    yield f"docs: {struct} ({path.relative_to(ROOT)}) has no table"


# --- flags ---------------------------------------------------------------------------------------


def wrong_flags(page):
    """docs/audit.md has one row for each flag of the program, with a meaning and an answer."""
    names = text_of("core/motion/recording_flag.hpp").split("names_of(FlagCode)")[1].split("};")[0]
    codes = re.findall(r'"(\w+)"', names)
    rows = re.findall(r"^\| `(\w+)` \| [^|]+ \| [^|]+ \|$", page, re.M)
    for code in codes:
        if rows.count(code) != 1:
            yield f"docs/audit.md: flag {code} has {rows.count(code)} rows, not 1"


# --- folders -------------------------------------------------------------------------------------

FOLDERS = re.compile(r"(<!-- folders: (.*?) -->\n)(.*?)(<!-- until here -->)", re.S)


def table_of_folders(plan):
    """A line for each row `folder PATH : FOLDER… : PACKAGE…` of a plan, with the first sentence of its README."""
    lines = ["| folder | contents | includes |", "|---|---|---|"]
    for path, others in re.findall(r"^folder (\S+)[ \t]*(?::([^:\n]*))?", text_of(plan), re.M):
        readme = ROOT / path / "README.md"
        sentence = readme.read_text(encoding="utf-8").split("\n\n", 1)[1].splitlines()[0] if readme.exists() else ""
        lines.append(f"| [{path}](../{path}) | {sentence} | {' '.join(others.split())} |")
    return "\n".join(lines) + "\n"


def with_folders(text):
    return FOLDERS.sub(lambda found: found[1] + table_of_folders(found[2]) + found[4], text)


def wrong_folders():
    for path in re.findall(r"^folder (\S+)", text_of("cmake/folders.txt"), re.M):
        if not (ROOT / path / "README.md").exists():
            yield f"{path}: has no README.md that says what it is and where to begin"
    if with_folders(text_of("docs/design.md")) != text_of("docs/design.md"):
        yield "docs/design.md: its table of folders is not that of cmake/folders.txt and the READMEs: --update"


# --- commands ------------------------------------------------------------------------------------


def run(command, folder, **more):
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, **more)


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", text)) - {"--help"}


def synopsis(block):
    """{command: options} of lines that begin with `morphe`."""
    found = {}
    for name, rest in re.findall(r"^morphe ([a-z]+(?: [a-z]+(?= ))?)(.*)$", block, re.M):
        found.setdefault(name, set()).update(options_in(rest))
    return found


def help_of(*command):
    """Without its examples."""
    return run([*command, "--help"], ROOT).stdout.partition("Examples:")[0]


def subcommands(*command):
    listed = help_of(*command).partition("Subcommands:")[2]
    return set(re.findall(r"^  (\w+)", listed, re.M))


def wrong_commands(morphe):
    part = text_of("docs/formats.md").split("\n## Command line\n")[1]
    present, planned = [synopsis(block) for _, block in FENCE.findall(part)[:2]]
    commands = subcommands(morphe)
    commands |= {f"{name} {inner}" for name in commands for inner in subcommands(morphe, name)}
    for name in sorted(commands ^ set(present)):
        yield f"docs/formats.md: morphe {name}: " + ("is not listed" if name in commands else "does not exist")
    for name in sorted(commands & set(present)):
        real = options_in(help_of(morphe, *name.split()))
        for option in sorted(real ^ present[name]):
            yield f"docs/formats.md: morphe {name} {option}: " + (
                "is not listed" if option in real else "does not exist")
        for option in sorted(real & planned.get(name, set()) - {"--dataset", "--out"}):
            yield f"docs/formats.md: morphe {name} {option}: is there, not planned"


# --- keys and options in prose -------------------------------------------------------------------

# `robot.control` and the like are other people's programs.
DOTTED = re.compile(r"(?<![\w./-])([a-z]+(?:\.[a-z_]\w*)+)(?![\w(/.])")
OTHER_FILES = re.compile(r"\.(md|yaml|h5|hpp|cpp|py|json|csv|html|svg|txt)$")


def in_prose(text):
    return re.findall(r"`([^`\n]+)`", FENCE.sub("", text))


def is_key(schema, path):
    for name in path:
        schema = schema.get("items", schema).get("properties", {}).get(name)
        if schema is None:
            return False
    return True


def wrong_prose(name, text, schema, options):
    """Each `section.key` of a config and each `--option` that prose names."""
    for code in in_prose(text):
        for key in DOTTED.findall(code):
            section = key.split(".")[0]
            if section in schema["properties"] and section != "robot" and not OTHER_FILES.search(key):
                if not is_key(schema, key.split(".")):
                    yield f"{name}: `{key}`: there is no such key"
        for option in options_in(code) if code.startswith(("--", "morphe ")) else ():
            if option not in options:
                yield f"{name}: `{option}`: nothing takes such an option"


def known_options(morphe):
    """Those of the program, of scripts, tests and benchmarks, and of the build."""
    commands = subcommands(morphe)
    texts = [help_of(morphe, *name.split()) for name in sorted(
        commands | {f"{name} {inner}" for name in commands for inner in subcommands(morphe, name)})]
    texts += [path.read_text(encoding="utf-8") for top in ("scripts", "tests", "cmake") for path in sorted((ROOT / top).rglob("*"))
              if path.is_file() and (path.suffix in {".py", ".cmake"} or top == "scripts" and not path.suffix
                                     or path.match("tests/bench/*.cpp"))]
    return set().union(*map(options_in, texts)) | {"--help", "--version"}


def wrong_words(morphe):
    schema, options = json.loads(text_of("configs/schema/config.json")), known_options(morphe)
    documents = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "configs").glob("*.md")]
    for document in documents:
        if document.name != "CHANGELOG.md":  # tells of keys that are gone
            yield from wrong_prose(document.relative_to(ROOT).as_posix(), document.read_text(encoding="utf-8"), schema, options)


# --- messages that are quoted ----------------------------------------------------------------------

QUOTED = re.compile(r"^\| (`+)(.+?)\1 \|", re.M)


def wrong_messages(text):
    """What docs/troubleshooting.md says that the program prints, but for the `…` of each case."""
    sources = "".join(path.read_text(encoding="utf-8") for top in ("core", "stages", "pipeline")
                      for path in sorted((ROOT / top).rglob("*.cpp")))
    sources = re.sub(r'"\s*\n\s*"', "", sources)  # literals that stand one after the other
    for _, messages in QUOTED.findall(text):
        for part in filter(None, (piece.strip() for piece in re.split("…|`, `", messages))):
            if part not in sources:
                yield f"docs/troubleshooting.md: nothing prints '{part}'"


# --- what READMEs and steps show -----------------------------------------------------------------------


def tolerance(a, b):
    """How far two printed figures may be from each other."""
    decimals = len(a.partition(".")[2])
    larger = max(abs(float(a)), abs(float(b)))
    if decimals == 0:
        return 0 if larger < COUNT else SHARE * larger
    return max(SHARE * larger, LAST_DIGITS * 10.0**-decimals) + 1e-9


def same_line(shown, printed):
    words, others = shown.split(), printed.split()
    if len(words) != len(others):
        return False
    for a, b in zip(words, others):
        if NUMBER.fullmatch(a) and NUMBER.fullmatch(b):
            if abs(float(a) - float(b)) > tolerance(a, b):
                return False
        elif a != b:
            return False
    return True


def wrong_output(where, shown, printed, exact):
    a, b = shown.splitlines(), [line.rstrip() for line in printed.splitlines()]
    if len(a) != len(b):
        yield f"{where}: {len(a)} lines are shown as printed, {len(b)} are:\n{printed}"
    for x, y in zip(a, b):
        if TAKES_TIME.match(x) and TAKES_TIME.match(y):
            continue
        if x != y if exact else not same_line(x, y):
            yield f"{where}: shown:   {x}\n{' ' * len(where)}  printed: {y}"


def missing_output(where, stated, printed):
    if stated not in printed:
        yield f"{where}: '{stated}' is stated, but the commands above it print:\n{printed}"


def blocks_of(document):
    """Kind and text of the fenced blocks and of the stated lines, in their order."""
    blocks = [(m.start(), m[1], m[2]) for m in FENCE.finditer(document)]
    blocks += [(m.start(), "prints", m[1]) for m in PRINTS.finditer(document)]
    return [(kind, block) for _, kind, block in sorted(blocks)]


def shown_by_such_a_build(folder):
    """Whether the program that wrote the sample's plans is built as the one that the documents show."""
    with h5py.File(folder / "outputs/sample/plans.h5") as plans:
        return all(part in plans.attrs["built_with"].decode() for part in SHOWN_BY)


def result_of(command, folder, done_before):
    """What a command prints, and what is wrong with it ("" if nothing). None is run twice."""
    if command not in done_before:
        done_before[command] = fresh_result_of(command, folder)
    return done_before[command]


def fresh_result_of(command, folder):
    first = command.split()[0]
    if first in ("scripts/run", "scripts/test"):
        done = run([ROOT / first, "--help"], ROOT)
    elif first in ("build/release/morphe", "echo") or first.startswith("python"):
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
        present, done_before = sorted(path.name for path in folder.iterdir()), {}
        for readme in (*TRIED, *STEPS):
            printed, document = "", text_of(readme)
            if readme in STEPS and [kind for kind, _ in FENCE.findall(document)].count("sh") != 1:
                yield f"{readme}: should have one block of commands"
            for kind, block in blocks_of(document):
                if kind == "prints":
                    yield from missing_output(readme, block, printed)
                elif kind == "sh":
                    printed = ""
                    for command in filter(None, block.splitlines()):
                        output, wrong = result_of(command, folder, done_before)
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
                    document = document.replace(f"```text\n{block}```", f"```text\n{lines}```", 1)
                    (ROOT / readme).write_text(document, encoding="utf-8")
                elif kind == "text":
                    yield from wrong_output(readme, block, printed, shown_by_such_a_build(folder))
                elif kind == "yaml":
                    try:
                        yaml.safe_load(block)
                    except yaml.YAMLError as error:
                        yield f"{readme}: this is no YAML: {error}"
                elif kind:  # without a kind it is a drawing
                    yield f"{readme}: a block of kind '{kind}' that nobody tries"
        for name in sorted(path.name for path in folder.iterdir()):
            if name not in present:
                yield f"{name}: was written beside outputs/"


# --- the proof that faults are seen ---------------------------------------------------------------

# A line of the README as it is shown, as it is printed, and whether that is the same.
LINES = [
    ("ADL001DR2/000 executable 0.05 0.031 8.9 1.26", "ADL001DR2/000 executable 0.07 0.030 9.0 1.25", True),
    ("ADL001DR2/000 executable 0.05", "ADL001DR2/000 executable 0.5", False),
    ("ADL001DR2/000 executable 0.05", "ADL001DR2/000 executable 0.50", False),
    ("ADL001DR2/000 executable 0.29", "ADL001DR2/000 executable 0.44", False),
    ("clearance 3.3", "clearance 1.1", False),
    ("tempo 1.26", "tempo 2.00", False),
    ("ADL001DR2/000 executable 0.05", "ADL001DR2/000 infeasible 0.05", False),
    ("5 movements: 5 executable", "5 movements: 4 executable", False),
    ("0 of 1138 fingertip goals", "1 of 1138 fingertip goals", False),
    ("1060 samples, 2.12 s", "1100 samples, 2.20 s", True),
    ("1060 samples, 2.12 s", "1060 samples", False),
]
# What is planted in a page of a step, and whether --update mends it.
PLANTED = [
    ("| `cutoff_hz` | 8 |", "| `cutoff_hz` | 9 |", True),
    ("| `cutoff_hz` | 8 |", "| `cut_off_hz` | 8 |", False),
    ("| `shoulder_from_first_wrist` | [0, -0.21, 0.24] |", "| `shoulder_from_first_wrist` | [0, -0.21, 0.25] |", True),
    ("| `rate_hz` | 100 | of the clock that every stream is brought to |\n", "", False),
    ("of the clock that every stream is brought to |", "|", False),
    ("of the clock that every stream is brought to |", "– |", False),
    ("reconstruct_options.hpp HumanOptions", "reconstruct_options.hpp HumanOption", False),
]


def self_test():
    for shown, printed, same in LINES:
        if same_line(shown, printed) != same:
            yield f"'{shown}' and '{printed}' should {'be' if same else 'not be'} the same"
    if len(list(wrong_flags(text_of("docs/audit.md").replace("| `spike` |", "| `spikes` |")))) != 1:
        yield "a flag without a row is not found"
    if not list(wrong_messages("| `no … prints such a thing` | |")):
        yield "a message that nothing prints is not found"
    for exact, shown, printed, wrong in [(True, "tempo 1.26", "tempo 1.27", True), (False, "tempo 1.26", "tempo 1.27", False),
                                         (True, "tempo 1.26", "tempo 1.26  ", False),
                                         (True, "9 frames; 3 frames/s per core; 4 ms per movement: map 3",
                                          "9 frames; 2 frames/s per core; 5 ms per movement: map 5", False)]:
        if bool(list(wrong_output("", shown, printed, exact))) != wrong:
            yield f"'{shown}' and '{printed}' are judged wrongly{' by the build that printed it' if exact else ''}"
    made_up = "```sh\na\n```\n<!-- prints: 5 executable -->\n```sh\nb\n```\n"
    if [kind for kind, _ in blocks_of(made_up)] != ["sh", "prints", "sh"]:
        yield "a stated line is not found between the blocks"
    if list(missing_output("", "5 executable", "5 executable, 0")) or not list(missing_output("", "5 e", "4 e")):
        yield "a stated line is judged wrongly"
    page = text_of("docs/steps/reconstruct.md")
    yield from wrong_tables("as it is", page)
    if with_keys(page) != page:
        yield "what is right is changed"
    if with_folders("<!-- folders: cmake/folders.txt -->\n| old |\n<!-- until here -->").count("](../stages/") < 10:
        yield "the table of folders is not made from the rows"
    schema = {"properties": {"map": {"properties": {"mode": {}}}}}
    for prose, wrong in (("`map.mode` and `--out`", False), ("`map.joint_distance`", True), ("`morphe run --uot`", True)):
        if bool(list(wrong_prose("", prose, schema, {"--out"}))) != wrong:
            yield f"{prose} is judged wrongly"
    for right, wrong, mended in PLANTED:
        planted = page.replace(right, wrong)
        if planted == page:
            yield f"'{right}' is not there to be changed"
        if not list(wrong_tables("", planted)):
            yield f"'{wrong}' in place of '{right}' is not found"
        if (with_keys(planted) == page) != mended:
            yield f"'{wrong}' in place of '{right}' is {'not ' if mended else ''}mended"


def main(arguments):
    if arguments == ["--self-test"]:
        found = list(self_test())
        print("\n".join(found) or f"{len(LINES)} lines and {len(PLANTED)} planted faults judged as they should be")
        return 1 if found else 0
    if not arguments or set(arguments[1:]) - {"--still", "--update"}:
        print(__doc__, file=sys.stderr)
        return 2
    morphe, update = pathlib.Path(arguments[0]).resolve(), "--update" in arguments
    if update:
        for name in with_tables():
            (ROOT / name).write_text(with_keys(text_of(name)), encoding="utf-8")
        (ROOT / "docs/design.md").write_text(with_folders(text_of("docs/design.md")), encoding="utf-8")
    found = [*wrong_links(), *wrong_keys(), *wrong_folders(), *wrong_commands(morphe), *wrong_words(morphe)]
    found += wrong_messages(text_of("docs/troubleshooting.md"))
    found += wrong_flags(text_of("docs/audit.md"))
    if "--still" not in arguments:
        found += wrong_examples(morphe, update)
    print("\n".join(found) or "the documents hold")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
