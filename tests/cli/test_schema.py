"""The JSON schemas of YAML files: those in configs/schema are the program's, every shipped file holds to
its own, and what is wrong for the program is wrong for them, at the same key.

test_schema.py MORPHE; after a change of keys: morphe schema --out configs/schema"""
import json
import os
import re

import jsonschema
import yaml

from support import SOURCE, CommandCase, main, morphe

SHIPPED = {
    "config": ["configs/pipelines/*.yaml", "configs/studies/repair_pipeline.yaml"],
    "robot": ["configs/robots/*.yaml", "datasets/motionbenchmaker/panda.yaml"],
    "scene": ["configs/scenes/*.yaml"],
    "study": ["configs/studies/*.yaml"],
    "synthetic": ["configs/synthetic/*.yaml"],
    "manifest": ["datasets/*/recordings.yaml"],
}
NOT = {"study": {"configs/studies/repair_pipeline.yaml"}}


class Loader(yaml.SafeLoader):
    """YAML 1.2, as editors and the program read it: yes and no are words, 1e-3 is a number."""
    yaml_implicit_resolvers = {}


Loader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(true|false)$"), list("tf"))
Loader.add_implicit_resolver("tag:yaml.org,2002:int", re.compile("^[-+]?[0-9]+$"), list("-+0123456789"))
Loader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$"),
                             list("-+.0123456789"))
Loader.add_implicit_resolver("tag:yaml.org,2002:null", re.compile("^(~|null|)$"), ["~", "n", ""])
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
Loader.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


def validator(kind):
    schema = json.loads((SOURCE / f"configs/schema/{kind}.json").read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def keys_of(error):
    """Of a schema's complaint: the keys that it is about."""
    if error.validator == "additionalProperties":
        return set(re.findall(r"'([^']+)'(?=.*(?:was|were) unexpected)", error.message))
    if error.validator == "required":
        return {re.match(r"'([^']+)' is a required property", error.message)[1]}
    return {[step for step in error.absolute_path if isinstance(step, str)][-1]} if error.absolute_path else set()


def keys_named(stderr):
    """Of the program's: the last key of each line's path, whose parts are keys and places in lists."""
    found = re.findall(r"^\S+?:\d+: ([\w.\[\]]+):", stderr, re.M)
    return {re.sub(r"(\[\d+\])+$", "", path).rpartition(".")[2] for path in found}


ROBOT = SOURCE / "configs/robots"
CONFIG = f"""\
dataset: {{file: {SOURCE}/datasets/ue-adl/recordings.yaml}}
robot: {{file: {ROBOT}/pa10_dlr_hit2.yaml}}
seed: 1
human: {{stature_m: 1.8}}
placement:
  rotation:
    - {{axis: x, angle: 90 deg}}
  shoulder_offset: [0.1, 0.2, 0.3]
scene:
  table: {{infer: true, thickness: 0.02}}
  target: {{height: 0.1}}
  objects:
    - {{name: bowl, shape: cylinder, size: [0.05, 0.06], position: [0.5, 0.5, 0.1]}}
reconstruct: {{rate_hz: 100}}
segment: {{onset_share: 0.05}}
map:
  mode: humanlike
  tip_position: 1000
  starts: 4
  coarse_step_s: 0.1
  natural_posture:
    - {{joint: middle_abduction}}
check: {{required_clearance: 0.001}}
repair: {{attempts: 2}}
retime: {{limit_scaling: 0.9}}
approach:
  home:
    - {{joint: S1, value: 0}}
"""
ROBOT_TEXT = (ROBOT / "pa10.yaml").read_text()
HAND_TEXT = (ROBOT / "dlr_hit2.yaml").read_text()
SCENE_TEXT = """\
objects:
  - name: bowl
    shape: cylinder
    size: [0.05, 0.06]
    position: [0.5, 0.5, 0.1]
"""
STUDY_TEXT = (SOURCE / "configs/studies/hands.yaml").read_text()
SYNTHETIC_TEXT = (SOURCE / "configs/synthetic/reach_to_grasp.yaml").read_text()
# (what stands there, what is planted in its place, the key that is to be named)
MISTAKES = {
    "config": (CONFIG, [
        ("seed: 1", "sede: 1", "sede"),
        ("seed: 1", "seed: first", "seed"),
        ("seed: 1", "seed: -1", "seed"),
        ("seed: 1", "seed: 1.5", "seed"),
        ("robot: {file", "robto: {file", "robto"),
        (f"robot: {{file: {ROBOT}/pa10_dlr_hit2.yaml}}\n", "", "robot"),
        ("robot: {file", "robot: {path", "path"),
        ("human: {stature_m: 1.8}", "human: tall", "human"),
        ("stature_m: 1.8", "stature_m: tall", "stature_m"),
        ("stature_m: 1.8", "stature: 1.8", "stature"),
        ("angle: 90 deg", "angle: 90 degrees", "angle"),
        ("angle: 90 deg", "angel: 90 deg", "angel"),
        ("[0.1, 0.2, 0.3]", "[0.1, 0.2]", "shoulder_offset"),
        ("[0.1, 0.2, 0.3]", "0.1", "shoulder_offset"),
        ("[0.1, 0.2, 0.3]", "[0.1, 0.2, up]", "shoulder_offset"),
        ("infer: true", "infer: yes", "infer"),
        ("infer: true", "infer: 1", "infer"),
        ("thickness: 0.02", "thickness: 2 cm", "thickness"),
        ("thickness: 0.02", "thickness: 0", "thickness"),
        ("thickness: 0.02", "thickness: -0.02", "thickness"),
        ("height: 0.1", "hight: 0.1", "hight"),
        ("name: bowl, shape", "shape", "name"),
        ("position: [0.5, 0.5, 0.1]", "position: [0.5, 0.5, 0.1, 0]", "position"),
        ("rate_hz: 100", "rate: 100", "rate"),
        ("mode: humanlike", "mode: humanly", "mode"),
        ("starts: 4", "starts: four", "starts"),
        ("starts: 4", "strats: 4", "strats"),
        ("starts: 4", "starts: 4.5", "starts"),
        ("coarse_step_s: 0.1", "coarse_step_s: 0", "coarse_step_s"),
        ("- {joint: middle_abduction}", "- middle_abduction", "natural_posture"),
        ("{joint: middle_abduction}", "{joints: middle_abduction}", "joints"),
        ("required_clearance: 0.001", "required_clearance: .nan", "required_clearance"),
        ("required_clearance: 0.001", "required_clearances: 0.001", "required_clearances"),
        ("attempts: 2", "attempts: -2", "attempts"),
        ("limit_scaling: 0.9", "limit_scaling: 1.5", "limit_scaling"),
        ("limit_scaling: 0.9", "limit_scaling: 0", "limit_scaling"),
        ("home:", "hom:", "hom"),
        ("{joint: S1, value: 0}", "{joint: S1, value: zero}", "value"),
        ("check: {required_clearance: 0.001}", "check: [0.001]", "check"),
    ]),
    "robot": (ROBOT_TEXT, [
        ("name: pa10\n", "nmae: pa10\n", "nmae"),
        ("convention: modified", "convention: modern", "convention"),
        ("chains:", "chains: {}\nchians:", "chians"),
        ("theta: 0, d: 0.317", "theta: 0, b: 0.317", "b"),
        ("theta: 0, d: 0.317", "theta: 0, d: far", "d"),
        ("d: 0.317, a: 0, alpha: 0", "d: 0.317, alpha: 0", "a"),
        ("velocity: 0.99, acceleration: 3.1, jerk: 31}", "velocity: 0, acceleration: 3.1, jerk: 31}", "velocity"),
        ("{name: flange, parent: arm}", "{name: flange, perent: arm}", "perent"),
        ("finger: wrist}", "finger: toe}", "finger"),
        ("radius: 0.118", "radius: -0.118", "radius"),
        ("from: [0, 0, 0.03]", "from: [0, 0.03]", "from"),
        ("shoulder: S1", "shoulders: S1", "shoulders"),
    ]),
    "scene": (SCENE_TEXT, [
        ("objects:", "object:", "object"),
        ("shape: cylinder", "shapes: cylinder", "shapes"),
        ("size: [0.05, 0.06]", "size: [0.05, wide]", "size"),
        ("position: [0.5, 0.5, 0.1]", "position: here", "position"),
    ]),
    "study": (STUDY_TEXT, [
        ("study: hands", "study: feet", "study"),
        ("manifest:", "manifests:", "manifests"),
    ]),
    "synthetic": (SYNTHETIC_TEXT, [
        ("rate_hz: 90", "rate_hz: often", "rate_hz"),
        ("glove:", "gloves:", "gloves"),
    ]),
    "manifest": ("recordings:\n  - {file: a.csv, hand: right, upper_arm: 0.3}\n", [
        ("file: a.csv", "files: a.csv", "files"),
        ("hand: right", "hand: third", "hand"),
        ("upper_arm: 0.3", "upper_arm: long", "upper_arm"),
        ("upper_arm: 0.3", "upperarm: 0.3", "upperarm"),
        ("recordings:", "recordings: []\nrecording:", "recording"),
    ]),
}


class Schemas(CommandCase):
    def test_shipped_schemas_are_those_of_the_program(self):
        self.succeeds("schema", "--out", self.folder)
        for kind in MISTAKES:
            made = (self.folder / f"{kind}.json").read_text()
            self.assertEqual((SOURCE / f"configs/schema/{kind}.json").read_text(), made,
                             "morphe schema --out configs/schema")
            self.assertEqual(self.succeeds("schema", kind).stdout, made)
        self.assertEqual(sorted(os.listdir(self.folder)), sorted(os.listdir(SOURCE / "configs/schema")))

    def test_every_shipped_file_holds(self):
        for kind, patterns in SHIPPED.items():
            check = validator(kind)
            for file in [file for pattern in patterns for file in SOURCE.glob(pattern)]:
                if file.relative_to(SOURCE).as_posix() in NOT.get(kind, ()):
                    continue
                with self.subTest(file=file.name):
                    wrong = [error.message for error in check.iter_errors(yaml.load(file.read_text(), Loader))]
                    self.assertEqual(wrong, [])

    def test_keys_have_meanings_and_defaults(self):
        schema = json.loads(self.succeeds("schema", "config").stdout)
        starts = schema["properties"]["map"]["properties"]["starts"]
        self.assertEqual((starts["default"], starts["minimum"]), (24, 1))
        self.assertIn("starts at each key frame", starts["description"])
        self.assertNotIn("`", json.dumps(schema))

    def commands(self, kind, file):
        if kind == "scene":
            config = self.folder / "with_scene.yaml"
            config.write_text(CONFIG.split("scene:")[0] + f"scene: {{file: {file}}}\n")
            return "run", config, "--out", self.folder / "out"
        return {"config": ("run", file, "--out", self.folder / "out"), "robot": ("robot", file),
                "study": ("study", file, "--out", self.folder / "out"),
                "synthetic": ("synthesize", file, "--out", self.folder / "out.h5"),
                "manifest": ("import", file, "--out", self.folder / "out.h5")}[kind]

    def test_planted_mistakes_are_found_at_the_same_key(self):
        planted = 0
        for kind, (text, mistakes) in MISTAKES.items():
            check = validator(kind)
            self.assertEqual([e.message for e in check.iter_errors(yaml.load(text, Loader))], [], kind)
            for right, wrong, key in mistakes:
                with self.subTest(kind=kind, wrong=wrong):
                    self.assertIn(right, text)
                    file = self.folder / f"{kind}.yaml"
                    file.write_text(text.replace(right, wrong, 1))
                    found = set().union(*map(keys_of, check.iter_errors(yaml.load(file.read_text(), Loader))))
                    self.assertIn(key, found, "the schema")
                    said = morphe(*self.commands(kind, file))
                    self.assertEqual(said.returncode, 2, said.stdout)
                    self.assertIn(key, keys_named(said.stderr), said.stderr)
                    planted += 1
        self.assertGreaterEqual(planted, 50)


if __name__ == "__main__":
    main()
