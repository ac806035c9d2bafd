#!/usr/bin/env python3
"""Checks that every file includes the header of each name of ours that it uses, directly or through
other headers. The unity build compiles many files as one and would let a missing include pass.

  self_contained_test.py [ROOT]        the check
  self_contained_test.py --self-test   removes includes and uses foreign names; each must be found

It reads the text alone. A name is a type, function or constant that a header of core/, stages/ or pipeline/
declares at namespace scope. A type counts as used wherever its name stands, a function or constant
where it is qualified by its folder's namespace, or called or named in a file of the same namespace.
What it cannot see (macros, functions that several folders have, calls that only argument-
dependent lookup finds, headers of the standard library) is left to `scripts/test --types`, which compiles each file by itself.
"""

import functools
import pathlib
import re
import sys

import names_test

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^#include "((?:core|stages|pipeline)/[^"]+)"', re.M)
NAMESPACE = re.compile(r"\bnamespace\s+([\w:]*)\s*$")
# Behind it, at namespace scope, a name is declared.
NO_FUNCTION = "void|bool|operator|alignas|decltype|static_assert|requires|if|for|while|switch|return"
FUNCTION = re.compile(rf"(?<![\w:.])(?!(?:{NO_FUNCTION})\b)([a-z]\w*)\s*\($")
CONSTANT = re.compile(r"\b(?:constexpr|const)\b[\w:<>,&*\s]*?\b([a-z]\w*)\s*(?:\[\w*\]\s*)?[={]")
FORWARD = re.compile(r"\b(?:struct|class|enum(?: class)?)\s+(\w+)\s*(?::\s*[\w:]+\s*)?$")
CONSTANT_NAME = re.compile(r"k[A-Z]")
TYPE = re.compile(r"\b(?:struct|class|union|enum|enum class|using|concept|typename)\s+(\w+)\b")
# A type and a name behind it: a parameter, a member, a local.
NO_TYPE = "return|throw|else|new|case"
LOCAL = re.compile(rf"\b(?!(?:{NO_TYPE})\b)(?:\w+|(?<=[>&*\]]))\s*[>&*\]]*\s+[&*]*(\w+)\s*(?=[,;=(){{:\[])")
WORD = re.compile(r"(?P<before>(?:\b\w+\s*::\s*)+|\.\s*|->\s*)?\b(?P<name>[A-Za-z_]\w*)\b")


def plain(text):
    """The text without comments, strings and lines of the preprocessor."""
    text = names_test.NOISE.sub(lambda found: "\n" * found.group().count("\n") or " ", text)
    return re.sub(r"^\s*#.*$", "", text, flags=re.M)


def declared_in(text):
    """{(namespace, name): whether it is a type} at namespace scope; what is unnamed is left out."""
    found = {}
    for _, namespace, name in names_test.types_of(text):
        if "{}" not in namespace and name:
            found[namespace, name] = True
    scopes, begin = [], 0
    text = names_test.TEMPLATE.sub("", plain(text))
    for at in re.finditer(r"[{};(]", text):
        at_namespace = None not in scopes
        head = text[begin:at.start()]
        namespace = "::".join(scopes) if at_namespace else ""
        if at.group() == "(":
            if at_namespace and "=" not in head and (function := FUNCTION.search(head + "(")):
                found.setdefault((namespace, function[1]), False)
            continue
        if at_namespace and at.group() in "{;":
            if (forward := FORWARD.search(head)) and at.group() == ";":
                found.setdefault((namespace, forward[1]), True)
            elif constant := CONSTANT.search(head + at.group()):
                found.setdefault((namespace, constant[1]), False)
        if at.group() == "{":
            opened = NAMESPACE.search(head)
            scopes.append((opened[1] or "{}") if opened and at_namespace else None)
        elif at.group() == "}" and scopes:
            scopes.pop()
        begin = at.end()
    return {key: kind for key, kind in found.items() if "{}" not in key[0] and key[0].startswith("morphe")}


class Tree:
    """The sources {path: text}, who declares a name, and what a file includes."""

    def __init__(self, sources):
        self.sources = sources
        self.types, self.others = {}, {}  # (namespace, name) -> headers
        for path, text in sources.items():
            if not path.endswith(".hpp"):
                continue
            for (namespace, name), is_type in declared_in(text).items():
                (self.types if is_type else self.others).setdefault((namespace, name), set()).add(path)

    @functools.cached_property
    def overloaded(self):
        """Names of functions of several namespaces: their arguments decide which is called."""
        spaces = {}
        for namespace, name in self.others:
            spaces.setdefault(name, set()).add(namespace)
        return {name for name, where in spaces.items() if len(where) > 1}

    @functools.cache
    def reached(self, path):
        """The file and every header of ours that it includes."""
        seen, open_ = {path}, [path]
        while open_:
            for name in INCLUDE.findall(self.sources.get(open_.pop(), "")):
                if name not in seen:
                    seen.add(name)
                    open_.append(name)
        return frozenset(seen)

    @functools.cache
    def own_names(self, path):
        """Types, and whatever else looks declared in the file: parameters, members, locals."""
        text = plain(self.sources[path])
        return frozenset(TYPE.findall(text)), frozenset(LOCAL.findall(text))

    def headers_of(self, word, text, own):
        """The headers that declare what a word means; nothing if it is no name of ours."""
        name, before = word["name"], re.sub(r"\s", "", word["before"] or "").removeprefix("morphe::")
        if before.endswith((".", "->")) or before == "std::":
            return None
        called = text[word.end():word.end() + 1] in ("(", "<")
        if before:
            return self.types.get((f"morphe::{before[:-2]}", name)) or self.others.get((f"morphe::{before[:-2]}", name))
        for namespace in (own, names_test.NOUNS):
            if headers := self.types.get((namespace, name)):
                return headers
            if called and name in self.overloaded:
                return None
            if (called or CONSTANT_NAME.match(name)) and (headers := self.others.get((namespace, name))):
                return headers
        return None

    def missing(self, path):
        """Sorted [(name, header)] that the file uses and does not include."""
        text, own, reached = plain(self.sources[path]), names_test.namespace_of(path), self.reached(path)
        locals_ = self.own_names(path)[1]
        types = frozenset().union(*(self.own_names(file)[0] for file in reached if file in self.sources))
        found = set()
        for word in WORD.finditer(text):
            headers = self.headers_of(word, text, own)
            if headers and not headers & reached and word["name"] not in types:
                if word["before"] or word["name"] not in locals_:
                    found.add((word["name"], min(headers)))
        return sorted(found)


def sources_of(root):
    return {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
            for top in ("core", "stages", "pipeline") for path in (root / top).rglob("*.[ch]pp")}


def check(sources, paths=None):
    tree = Tree(sources)
    return [f"{path}: uses {name} and does not include {header}"
            for path in sorted(paths or sources) for name, header in tree.missing(path)]


# A file, what is removed from it or put at its end, and the name that is missing then.
PLANTED = [
    ("stages/repair/repair_strategy.cpp", None, "namespace morphe::repair { math::QuinticPiece planted(); }", "QuinticPiece"),
    ("stages/import/guess/body_cues.cpp", '#include "core/math/rotation.hpp"\n', "", "principal_axes"),
    ("stages/scene/other_arm.cpp", '#include "core/math/rotation.hpp"\n', "", "shortest_rotation"),
]


def self_test(sources):
    before = set(check(sources))
    for path, removed, added, name in PLANTED:
        if removed and removed not in sources[path]:
            yield f"{path} has no {removed}"
        text = sources[path].replace(removed or "\0", "") + added
        found = set(check({**sources, path: text}, [path])) - before
        if not any(f"{path}: uses {name} " in line for line in found):
            yield f"{path}: nobody misses {name}: {found}"
    missed, count = misses(sources)
    if missed < LEAST_SHARE * count or count < 100:
        yield f"of {count} includes that were taken out {missed} are missed"


# Of includes that are taken out, and that no other header brings, so many must be missed.
LEAST_SHARE, EVERY = 0.95, 4


def misses(sources):
    """(missed, taken out): one include at a time, of every fourth that is not of the file's own header,
    nor of the one that declares the readers of a folder of formats: they are defined there, not used."""
    whole = Tree(sources)
    cases = [(path, header) for path in sorted(sources) if path.endswith(".cpp")
             for header in INCLUDE.findall(sources[path]) if header != path.replace(".cpp", ".hpp") and not header.endswith("/readers.hpp")][::EVERY]
    missed = count = 0
    for path, header in cases:
        others = set(INCLUDE.findall(sources[path])) - {header}
        if any(header in whole.reached(other) for other in others):
            continue
        count += 1
        whole.sources = {**sources, path: sources[path].replace(f'#include "{header}"\n', "")}
        whole.reached.cache_clear()
        whole.own_names.cache_clear()
        missed += bool(whole.missing(path))
    return missed, count


def main(arguments):
    if arguments == ["--self-test"]:
        found = list(self_test(sources_of(ROOT)))
        print("\n".join(found) or f"{len(PLANTED)} planted faults found, and nearly every include that was taken out")
    else:
        sources = sources_of(pathlib.Path(arguments[0]) if arguments else ROOT)
        found = check(sources)
        print("\n".join(found) or f"{len(sources)} files include what they use of ours")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
