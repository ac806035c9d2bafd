"""Every numeric key of every kind of YAML file has a lower and an upper bound in its schema, and the
program keeps to them: at the bounds a value is accepted, beyond them, infinite or not a number it is
refused with the file, line, key and bounds.

The schemas are walked, so that a new key is tested when it is declared."""
import copy
import json
import re

import yaml

from support import SOURCE, CommandCase, main, morphe

ROBOT = SOURCE / "configs/robots/pa10.yaml"
BOUND = re.compile(r"must be (at least|above) (\S+) and (at most|below) (\S+?)(?: [a-zA-Z].*)?, not ")
LINE = re.compile(r"^(?P<file>.+?):(?P<line>\d+): (?P<path>[^:]+): (?P<message>.*)$", re.M)
AT_ONCE = 12  # keys of one file; of more than twenty errors the rest is only counted

URDF = """\
<robot name="arm"><link name="base"/><link name="tool"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="tool"/><axis xyz="0 0 1"/>
<origin xyz="0 0 0.3"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint></robot>
"""
LIMITS = {"lower": -1, "upper": 1, "velocity": 1, "acceleration": 1, "jerk": 1}
DH = {"theta": 0, "d": 0.1, "a": 0.1, "alpha": 0}
# Their numbers are read one after the other, so that each is tested alone.
ROBOTS = [
    {"name": "r",
     "chains": [{"name": "arm", "mount": {"position": [0, 0, 0], "rpy": [0, 0, 0]},
                 "joints": [{"name": "a", **DH, **LIMITS}, {"name": "b", **DH, **LIMITS},
                            {"name": "c", **DH, **LIMITS, "couple": {"joint": "a", "ratio": 1, "offset": 0}}]}],
     "frames": [{"name": "o", "parent": "arm", "mount": {"position": [0, 0, 0], "rpy": [0, 0, 0]}},
                {"name": "p", "parent": "arm", "mount": {"quaternion": [1, 0, 0, 0]}},
                {"name": "q", "parent": "arm", "mount": {"matrix": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}],
     "fixed_joints": [{"joint": "b", "position": 0}],
     "palm": "p",
     "tips": [{"name": "t", "chain": "arm", "finger": "wrist", "pad_depth": 0.01,
               "mount": {"position": [0, 0, 0]}}],
     "natural_posture": [{"joint": "a", "value": 0}],
     "collision": {"capsules": [{"name": "k", "frame": "a", "from": [0, 0, 0], "to": [0, 0, 1], "radius": 0.1}]}},
    {"name": "r", "generate": {"arm": {"joints": 6, "length": 0.6, "limit": 3, "velocity": 1, "acceleration": 1,
                                       "jerk": 1, "radius": 0.01}}},
    {"name": "r", "generate": {"hand": {"fingers": 5, "length": 0.2, "breadth": 0.1, "velocity": 1,
                                        "acceleration": 1, "jerk": 1, "radius": 0.01}}},
    {"name": "r", "urdf": {"file": "arm.urdf", "velocity": 1, "acceleration": 1, "jerk": 1,
                           "limits": [{"joint": "turn", **LIMITS,
                                       "braking": {"twice_deceleration": 1, "velocity_offset": 0.1,
                                                   "lower_end": -1, "upper_end": 1}}]},
     "tips": [{"name": "t", "frame": "turn", "finger_curve_share": 0.5}], "palm": "turn"},
]
# What is not reached there: the same keys, at other places.
SAME_AS = (("parts[].generate", "generate"), ("parts[].mount", "frames[].mount"), ("tips[].mount", "frames[].mount"),
           ("chains[].mount", "frames[].mount"))


class Leaf:
    """A numeric key: its place in the schema and the schema of its value."""

    def __init__(self, steps, schema):
        self.steps, self.schema = steps, schema
        self.lower = schema.get("minimum", schema.get("exclusiveMinimum"))
        self.upper = schema.get("maximum", schema.get("exclusiveMaximum"))
        self.whole = "integer" in types_of(schema)

    def __str__(self):
        return "".join("[]" if step == 0 else f".{step}" for step in self.steps).lstrip(".")

    def path(self):
        return "".join(f"[{step}]" if step == 0 else f".{step}" for step in self.steps).lstrip(".")

    def step(self, bound):
        return 1 if self.whole else max(abs(bound) * 1e-5, 1e-9)

    def inside(self):
        low, high = self.step(self.lower), self.step(self.upper)
        return (self.lower + ("exclusiveMinimum" in self.schema) * low,
                self.upper - ("exclusiveMaximum" in self.schema) * high)

    def outside(self):
        """By what it tells: one value beyond each bound, and what no key may be."""
        below = self.lower - ("minimum" in self.schema) * self.step(self.lower)
        above = self.upper + ("maximum" in self.schema) * self.step(self.upper)
        found = {"below": below, "above": above, "huge": 1e308, "minus huge": -1e308, "nan": ".nan", "inf": ".inf"}
        for value in (0, -1):
            if not self.lower <= value <= self.upper:
                found[str(value)] = value
        return found


def types_of(schema):
    types = schema.get("type", [])
    return [types] if isinstance(types, str) else types


def leaves_of(schema, steps=()):
    if steps[:1] == ("robots",):  # the whole config again
        return
    if "boolean" not in types_of(schema) and {"number", "integer"} & set(types_of(schema)):
        if steps[-1] not in ("seed", "long_seeds") and steps[-2:-1] != ("long_seeds",):
            yield Leaf(steps, schema)
    for key, value in schema.get("properties", {}).items():
        yield from leaves_of(value, (*steps, key))
    if "items" in schema:
        yield from leaves_of(schema["items"], (*steps, 0))


def sample(schema):
    """The least that the schema permits."""
    if "enum" in schema:
        return schema["enum"][0]
    types = types_of(schema)
    if "object" in types:
        return {key: sample(schema["properties"][key]) for key in schema.get("required", ())}
    if "array" in types:
        return [sample(schema["items"]) for _ in range(schema.get("minItems", 1))]
    if "boolean" in types:
        return True if len(types) < 3 else "x"
    if {"number", "integer"} & set(types):
        return Leaf((), schema).inside()[0] if "minimum" in schema or "exclusiveMinimum" in schema else 1
    return "x"


def put(document, schema, steps, value):
    """Sets a value in a document that is made, as far as it is missing, from the schema."""
    for step, after in zip(steps, [*steps[1:], None]):
        inner = schema["items"] if step == 0 else schema["properties"][step]
        if after is None:
            document[step] = value
            return
        if step != 0 and document.get(step) in (None, "x"):
            document[step] = sample(inner)
            if "object" in types_of(inner) and not isinstance(document[step], dict):
                document[step] = {}
        document, schema = document[step], inner


class Bounds(CommandCase):
    def check(self, document, leaves, what, command):
        """Writes the document, runs the command on it and compares what it says with the bounds."""
        text = yaml.safe_dump(document, sort_keys=False, default_flow_style=False)
        text = re.sub(r"'(\.nan|\.inf)'", r"\1", text)
        file = self.folder / "file.yaml"
        file.write_text(text)
        result = command(file)
        self.assertEqual(result.returncode, 2, f"{what}\n{text}\n{result.stdout}{result.stderr}")
        said = {}
        for match in LINE.finditer(result.stderr):
            said.setdefault(match["path"], (match["line"], match["message"]))
        if what == "inside":
            self.assertNotRegex(result.stderr, BOUND, text)
            self.assertIn("unknown", result.stderr, text)
            return
        for leaf in leaves:
            if what not in leaf.outside():
                continue
            with self.subTest(str(leaf), what=what):
                value = leaf.outside()[what]
                self.assertIn(leaf.path(), said, f"{value}\n{result.stderr}")
                line, message = said[leaf.path()]
                written = text.splitlines()[int(line) - 1].split()[-1]
                self.assertTrue(written == value if isinstance(value, str) else float(written) == value, written)
                if isinstance(value, str) or (leaf.whole and abs(value) > 2**63):
                    self.assertRegex(message, r"^must be a (whole )?number, not ")
                    continue
                found = BOUND.match(message)
                self.assertTrue(found, message)
                for told, bound in ((found[2], leaf.lower), (found[4], leaf.upper)):
                    self.assertAlmostEqual(float(told), bound, delta=1e-5 * abs(bound))
                self.assertEqual(found[1] == "above", "exclusiveMinimum" in leaf.schema)
                self.assertEqual(found[3] == "below", "exclusiveMaximum" in leaf.schema)

    def walk(self, schema, base, command):
        """All keys at and beyond their bounds, some at once."""
        leaves = list(leaves_of(schema))
        self.assertTrue(leaves)
        for leaf in leaves:
            self.assertIsNotNone(leaf.lower, f"{leaf} has no lower bound")
            self.assertIsNotNone(leaf.upper, f"{leaf} has no upper bound")
            self.assertLess(leaf.lower, leaf.upper, str(leaf))
        for end in (0, 1):
            document = {**copy.deepcopy(base), "no_such_key": 1}
            for leaf in leaves:
                put(document, schema, leaf.steps, leaf.inside()[end])
            self.check(document, leaves, "inside", command)
        for begin in range(0, len(leaves), AT_ONCE):
            some = leaves[begin:begin + AT_ONCE]
            for what in sorted({name for leaf in some for name in leaf.outside()}):
                document = copy.deepcopy(base)
                for leaf in some:
                    if what in leaf.outside():
                        put(document, schema, leaf.steps, leaf.outside()[what])
                self.check(document, some, what, command)

    def schema(self, kind):
        return json.loads(self.succeeds("schema", kind).stdout)

    def run_config(self, file):
        return morphe("run", file, "--dataset", self.folder / "nowhere.h5", "--out", self.folder / "out")

    def test_of_configs(self):
        self.walk(self.schema("config"), {"robot": {"file": str(ROBOT)}}, self.run_config)

    def test_of_scenes(self):
        def run(scene):
            config = self.folder / "config.yaml"
            config.write_text(f"robot: {{file: {ROBOT}}}\nscene: {{file: {scene}}}\n")
            return self.run_config(config)
        self.walk(self.schema("scene"), {}, run)

    def test_of_synthetic_recordings(self):
        self.walk(self.schema("synthetic"), {},
                  lambda file: morphe("synthesize", file, "--count", 1, "--out", self.folder / "made.h5"))

    def test_of_manifests(self):
        self.walk(self.schema("manifest"), {"recordings": [{"file": "a.csv"}]},
                  lambda file: morphe("import", file, "--out", self.folder / "made.h5"))

    def test_of_studies(self):
        for branch in self.schema("study")["allOf"]:
            name = branch["if"]["properties"]["study"]["const"]
            schema = branch["then"]
            with self.subTest(name):
                self.walk(schema, {**sample(schema), "study": name},
                          lambda file: morphe("study", file, "--out", self.folder / "out", "--quick"))

    def test_of_robots(self):
        """One number at a time: a robot description is read until its first error."""
        schema = self.schema("robot")
        (self.folder / "arm.urdf").write_text(URDF)
        leaves = {str(leaf): leaf for leaf in leaves_of(schema)}
        tested = set()
        for robot in ROBOTS:
            for steps in numbers_in(robot):
                name = str(Leaf(tuple(0 if isinstance(step, int) else step for step in steps), {}))
                leaf = leaves[name]
                if name in tested:
                    continue
                tested.add(name)
                for what, value in leaf.outside().items():
                    document = copy.deepcopy(robot)
                    at = document
                    for step in steps[:-1]:
                        at = at[step]
                    at[steps[-1]] = value
                    own = Leaf(steps, leaf.schema)
                    own.path = lambda: "".join(f"[{s}]" if isinstance(s, int) else f".{s}" for s in steps).lstrip(".")
                    self.check(document, [own], what, lambda file: morphe("robot", file))
        for leaf in leaves:
            for place, same in SAME_AS:
                if leaf.startswith(place):
                    leaf = same + leaf[len(place):]
            self.assertIn(leaf, tested)


def numbers_in(value, steps=()):
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from numbers_in(inner, (*steps, key))
    elif isinstance(value, list):
        for k, inner in enumerate(value):
            yield from numbers_in(inner, (*steps, k))
    elif isinstance(value, (int, float)):
        yield steps


if __name__ == "__main__":
    main()
