"""morphe robot setup: a description from a URDF alone, and what hostile files come to. Takes 12 s of
processor time: boxes and a gripper are covered with capsules."""
import base64
import json
import math
import re
import resource
import struct
import time
import xml.etree.ElementTree as ElementTree

from support import SOURCE, CommandCase, line_of, main, morphe

URDFS = SOURCE / "configs/robots/urdf"
CUBE = [(x, y, z) for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)]
FACES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6),
         (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def stl(size):
    """A box as a binary STL."""
    data = b" " * 80 + struct.pack("<I", len(FACES))
    for face in FACES:
        data += struct.pack("<3f", 0, 0, 0)
        for k in face:
            data += struct.pack("<3f", *(a * b for a, b in zip(CUBE[k], size)))
        data += b"\0\0"
    return data


def obj(size):
    lines = ["v " + " ".join(str(a * b) for a, b in zip(v, size)) for v in CUBE]
    lines += ["f " + " ".join(str(k + 1) for k in face) for face in FACES]
    return "\n".join(lines).encode() + b"\n"


def dae(size):
    points = " ".join(str(a * b) for v in CUBE for a, b in zip(v, size))
    corners = " ".join(str(k) for face in FACES for k in face)
    return f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="24">{points}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{corners}</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
""".encode()


def gltf(size):
    data = struct.pack("<24f", *(a * b for v in CUBE for a, b in zip(v, size)))
    data += struct.pack("<36H", *(k for face in FACES for k in face))
    half = [s / 2 for s in size]
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
                       "min": [-h for h in half], "max": half},
                      {"bufferView": 1, "componentType": 5123, "count": 36, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 96},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 72}],
        "buffers": [{"byteLength": 168,
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}).encode()


def arm(links, mesh=lambda k: "", extra=""):
    """A chain of joints that turn about z and y in turns, 0.2 m apart."""
    parts = ["<robot name='made'><link name='l0'/>"]
    for k in range(1, links + 1):
        parts.append(f"<link name='l{k}'>{mesh(k)}</link><joint name='j{k}' type='revolute'>"
                     f"<parent link='l{k - 1}'/><child link='l{k}'/><origin xyz='0 0 0.2'/>"
                     f"<axis xyz='{'0 0 1' if k % 2 else '0 1 0'}'/>"
                     "<limit lower='-2' upper='2' velocity='2' effort='10'/></joint>\n")
    return "".join(parts) + extra + "</robot>\n"


def outside(point, capsule):
    """How far a point is from a capsule: from (3), to (3), radius."""
    a, b, radius = capsule[:3], capsule[3:6], capsule[6]
    along = [y - x for x, y in zip(a, b)]
    length2 = sum(v * v for v in along)
    share = sum((p - x) * v for p, x, v in zip(point, a, along)) / length2 if length2 else 0
    share = min(1, max(0, share))
    return math.dist(point, [x + share * v for x, v in zip(a, along)]) - radius


class Setup(CommandCase):
    def set_up(self, urdf, *more):
        out = self.folder / "robot.yaml"
        return out, self.succeeds("robot", "setup", urdf, "--out", out, *more).stdout

    def test_every_shipped_urdf(self):
        for urdf in sorted(URDFS.glob("*.urdf")):
            begin = time.monotonic()
            out, said = self.set_up(urdf)
            self.assertLess(time.monotonic() - begin, 60)
            self.assertIn(f"{out}: ", said)
            report, shipped = self.json_of("robot", out), self.json_of("robot", URDFS.parent / f"{urdf.stem}.yaml")
            self.assertEqual([j["name"] for j in report["joints"]], [j["name"] for j in shipped["joints"]])
            self.assertEqual([t["name"] for t in report["tips"]], [t["name"] for t in shipped["tips"]])
            self.assertEqual(self.json_of("robot", urdf)["joints"], report["joints"])
            picture = ElementTree.parse(out.with_suffix(".svg")).getroot()
            words = {text.text for text in picture.iter("{http://www.w3.org/2000/svg}text")}
            self.assertTrue(words & {tip["name"] for tip in report["tips"]}, words)
            out.unlink()

    def test_meshes_of_four_kinds_are_found_and_held(self):
        package = self.folder / "made_description"
        (package / "meshes").mkdir(parents=True)
        (package / "package.xml").write_text("<package><name>made_description</name></package>")
        (package / "urdf").mkdir()
        size, kinds = (0.06, 0.08, 0.2), {"stl": stl, "obj": obj, "dae": dae, "gltf": gltf}
        for kind, made in kinds.items():
            (package / f"meshes/box.{kind}").write_bytes(made(size))
        names = [*kinds, "gone"]
        urdf = package / "urdf/made.urdf"

        def mesh(k):
            return ("<collision><origin xyz='0 0 0.1'/><geometry><mesh filename="
                    f"'package://made_description/meshes/box.{names[k - 1]}'/></geometry></collision>")
        urdf.write_text(arm(5, mesh))
        out, said = self.set_up(urdf)
        self.assertEqual(said.count("box.gone"), 1, said)
        text = out.read_text()
        covers = [re.search(rf"# l{k}: (.*)", text)[1] for k in (1, 2, 3, 4)]
        for cover in covers:
            self.assertRegex(cover, r"^(100\.0|99\.\d) % inside, [01]\.\d+ mm outside at most")
        # Every corner of the box is inside a capsule of its link, up to a millimetre.
        for k in (1, 2, 3, 4):
            held = [[float(v) for v in re.findall(r"-?\d+\.?\d*(?:e-\d+)?", line.split("frame:")[1].partition(",")[2])]
                    for line in text.splitlines() if f"frame: l{k}," in line and "radius" in line]
            self.assertTrue(held)
            for corner in CUBE:
                point = [c * s + o for c, s, o in zip(corner, size, (0, 0, 0.1))]
                self.assertLess(min(outside(point, numbers) for numbers in held), 1.01e-3)
        # Under another name, so that the package has to be named; one box is enough for that.
        package = package.rename(self.folder / "renamed")
        elsewhere = self.folder / "alone.urdf"
        elsewhere.write_text(arm(6, lambda k: mesh(k) if k == 1 else ""))
        away, said = self.set_up(elsewhere)
        self.assertIn("made_description", said)
        named, said = self.set_up(elsewhere, "--package", f"made_description={package}")
        self.assertRegex(named.read_text(), r"# l1: \S+ % inside")

    def test_what_a_person_changed_stays(self):
        out, _ = self.set_up(URDFS / "fr3.urdf")
        text = out.read_text().replace("pad_depth: 0.01", "pad_depth: 0.008")
        out.write_text(text)
        _, said = self.set_up(URDFS / "fr3.urdf")
        self.assertIn("pad_depth: 0.008", out.read_text())
        self.assertIn("tips", said)

    def refused(self, text, *words, code=2):
        """In bounded time and memory, and nothing written."""
        urdf, out = self.folder / "bad.urdf", self.folder / "bad.yaml"
        urdf.write_text(text)
        begin = time.monotonic()
        result = morphe("robot", "setup", urdf, "--out", out)
        self.assertLess(time.monotonic() - begin, 60)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 2e6)  # kB
        self.assertEqual(result.returncode, code, result.stderr[:500])
        self.assertTrue(result.stderr.startswith(f"{urdf}:"), result.stderr[:500])
        for word in words:
            self.assertIn(word, result.stderr)
        self.assertFalse(out.exists())

    def test_hostile_urdfs_are_refused(self):
        joint = "<joint name='more' type='revolute'><parent link='{}'/><child link='{}'/><limit lower='-1' upper='1' velocity='1' effort='1'/></joint>"
        self.refused(arm(3, extra=joint.format("l3", "l1")), "l1")  # a loop
        self.refused(arm(3, extra="<link name='other'/>"), "root")
        self.refused(arm(3).replace("lower='-2'", "lower='nan'", 1), "j1", "lower")
        self.refused(arm(3).replace("xyz='0 0 0.2'", "xyz='0 0 1e400'", 1), "j1")
        self.refused(arm(100000), "links")
        self.refused("<robot name='deep'>" + "<a>" * 100000 + "</a>" * 100000 + "</robot>", "nested")
        self.refused("<robot name='empty'><link name='l'/></robot>", "joint")
        self.refused("<robot xmlns:xacro='http://www.ros.org/wiki/xacro' name='x'><xacro:arm/></robot>", "xacro")
        self.refused(arm(2), "neither a hand", "nor an arm")

    def test_several_arms_are_asked_about_and_one_is_taken(self):
        chain = arm(7)
        joints = chain[chain.index("<link name='l1'>"):chain.index("</robot>")]
        for old, new in (("name='l", "name='left_l"), ("link='l", "link='left_l"), ("name='j", "name='left_j"), ("link='left_l0'", "link='l0'")):
            joints = joints.replace(old, new)
        joints = joints.replace("<origin xyz='0 0 0.2'/>", "<origin xyz='0 0.3 0.2'/>", 1)
        both = self.folder / "both.urdf"
        both.write_text(chain.replace("</robot>", joints + "</robot>"))
        out = self.folder / "both.yaml"
        asked = morphe("robot", "setup", both, "--out", out)
        self.assertEqual(asked.returncode, 2)
        self.assertIn("has 2 arms: select one with --arm LINK", asked.stderr)
        self.assertRegex(asked.stderr, r"\n +left_l7 +left +left_j1 +left_j7 +7 ")
        self.assertFalse(out.exists())
        said = self.succeeds("robot", "setup", both, "--out", out, "--arm", "left_l7").stdout
        self.assertRegex(said, r"\nshoulder_centre +left_l1 +0\.0 +300\.0 +400\.0 +derived")
        self.assertRegex(said, r"\nelbow_centre +left_l4 +0\.0 +300\.0 +800\.0 +derived")
        self.assertIn("first: left_j1, last: left_j7", out.read_text())
        # The pair of bones is named if nothing shows it.
        short = self.folder / "short.urdf"
        short.write_text(arm(3))
        self.assertIn("--elbow JOINT", morphe("robot", "setup", short, "--out", out).stderr)
        self.assertIn("elbow_centre", self.succeeds("robot", "setup", short, "--out", out, "--elbow", "j2").stdout)

    def test_missing_limits_are_completed_or_asked_for(self):
        bare = arm(6).replace(" velocity='2' effort='10'", "")
        urdf = self.folder / "bare.urdf"
        urdf.write_text(bare)
        out = self.folder / "bare.yaml"
        self.succeeds("robot", "setup", urdf, "--out", out)
        self.assertRegex(out.read_text(), r"joint: j1, velocity: .*# assumed")

    def test_limits_are_asked_for_and_given(self):
        urdf, out = self.folder / "degrees.urdf", self.folder / "degrees.yaml"
        urdf.write_text(arm(7).replace("lower='-2' upper='2'", "lower='-130' upper='130'", 1))
        asked = morphe("robot", "setup", urdf, "--out", out)
        self.refuses(asked, f"{urdf}:1", "degrees", "--limit j1=-2.269..2.269")
        answer = re.search(r"--limit \S+?(?=\))", asked.stderr)[0].split()
        self.succeeds("robot", "setup", urdf, "--out", out, *answer)
        self.assertAlmostEqual(self.json_of("robot", out)["joints"][0]["upper"], 2.269)
        for wrong in ("j1", "j1=2", "j1=2..1", "=1..2", "j1=a..b"):
            self.refuses(morphe("robot", "setup", urdf, "--out", out, "--limit", wrong), f"--limit {wrong}",
                         "JOINT=LOWER..UPPER")

    def test_what_is_assumed_is_kept_with_the_robot(self):
        urdf = self.folder / "assumed.urdf"
        urdf.write_text(arm(7).replace("lower='-2' upper='2' velocity='2'", "lower='0' upper='0' velocity='0'", 1)
                        .replace("velocity='2'", "velocity='30'", 1))
        out, said = self.set_up(urdf)
        checks = re.findall(r"^check: (.*)$", said, re.M)
        self.assertTrue(any(line.startswith("j1: locked") for line in checks), said)
        self.assertTrue(any("j2 (3.14 instead of 30 rad/s)" in line for line in checks), said)
        self.assertEqual(self.json_of("robot", out)["checks"], checks)
        self.assertEqual(self.json_of("robot", urdf)["checks"], checks)
        self.assertEqual(re.findall(r"^check: (.*)$", self.succeeds("robot", out).stdout, re.M), checks)
        # A line that somebody deletes is done.
        text = out.read_text()
        out.write_text(re.sub(r"  - 'j1: locked.*\n", "", text))
        _, said = self.set_up(urdf)
        self.assertEqual(re.findall(r"^check: (.*)$", said, re.M), [line for line in checks if "locked" not in line])

    def test_a_mimic_of_a_mimic_is_the_first_ones(self):
        extra = ""
        for name, of in (("m1", "j1"), ("m2", "m1")):
            extra += (f"<link name='{name}_l'/><joint name='{name}' type='revolute'><parent link='l3'/><child link='{name}_l'/>"
                      "<axis xyz='0 1 0'/><limit lower='-2' upper='2' velocity='2' effort='1'/>"
                      f"<mimic joint='{of}' multiplier='0.5'/></joint>")
        urdf = self.folder / "mimic.urdf"
        urdf.write_text(arm(6, extra=extra.replace("l3", "l6")))
        self.assertRegex(self.succeeds("robot", urdf).stdout, r"\nm2 +0.25 x j1 \+ 0 deg")

    def test_a_shape_that_stands_for_a_grippers_fingers_is_left_out(self):
        def box(name, at, size):
            return (f"<collision name='{name}'><origin xyz='{at}'/><geometry><box size='{size}'/></geometry></collision>")
        extra = (f"<link name='body'>{box('palm', '0 0 0.03', '0.05 0.2 0.06')}{box('space', '0 0 0.11', '0.05 0.2 0.1')}</link>"
                 "<joint name='fixed' type='fixed'><parent link='l6'/><child link='body'/><origin xyz='0 0 0.1'/></joint>")
        for name, y, more in (("left", 1, ""), ("right", -1, "<mimic joint='left'/>")):
            extra += (f"<link name='{name}_finger'>{box('f', f'0 {0.01 * y} 0.025', '0.02 0.02 0.05')}</link>"
                      f"<joint name='{name}' type='prismatic'><parent link='body'/><child link='{name}_finger'/>"
                      f"<origin xyz='0 0 0.06'/><axis xyz='0 {y} 0'/><limit lower='0' upper='0.04' velocity='0.2' effort='1'/>{more}</joint>")
        urdf = self.folder / "gripper.urdf"
        urdf.write_text(arm(6, extra=extra))
        out, said = self.set_up(urdf)
        self.assertIn("check: shapes of body that contain the finger pads are skipped", said)
        heights = [float(line.split("to: [")[1].split("]")[0].split(",")[2]) + float(line.split("radius: ")[1].rstrip("}"))
                   for line in out.read_text().splitlines() if "name: body_" in line]
        self.assertTrue(heights)
        self.assertLess(max(heights), 0.12)  # the palm ends at 0.06

    def test_meshes_that_are_no_use_are_named_and_do_without(self):
        huge = self.folder / "huge.stl"
        with open(huge, "wb") as file:  # ten million triangles, as a file with holes
            file.write(b" " * 80 + struct.pack("<I", 10_000_000))
            file.truncate(84 + 50 * 10_000_000)
        short = self.folder / "short.stl"
        short.write_bytes(b" " * 80 + struct.pack("<I", 10_000_000) + b"\0" * 500)
        names = {1: "huge.stl", 2: "short.stl", 3: "/etc/passwd"}
        urdf = self.folder / "meshes.urdf"
        urdf.write_text(arm(6, lambda k: f"<collision><geometry><mesh filename='{names[k]}'/></geometry></collision>"
                            if k in names else ""))
        begin = time.monotonic()
        result = morphe("robot", "setup", urdf, "--out", self.folder / "meshes.yaml")
        self.assertLess(time.monotonic() - begin, 60)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, 2e6)
        said = result.stdout + result.stderr
        self.assertIn(result.returncode, (0, 2), said)
        for name in names.values():
            self.assertIn(name, said)
        self.assertNotIn("root:", said)


if __name__ == "__main__":
    main()
