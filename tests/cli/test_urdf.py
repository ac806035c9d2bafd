"""`morphe robot FILE --urdf OUT`: the same robot for other programs, with what its URDF said beyond
motion: names, pictures, masses, efforts."""
import xml.etree.ElementTree as ElementTree

import numpy as np

from support import SOURCE, CommandCase, main

ROBOTS = SOURCE / "configs/robots"
SHIPPED = sorted((ROBOTS / "urdf").glob("*.urdf"))
MOVING = ("revolute", "continuous", "prismatic")

RICH = """<?xml version="1.0"?>
<robot name="rich">
  <material name="steel"><color rgba="0.5 0.5 0.6 1"/><texture filename="meshes/steel.png"/></material>
  <link name="stand">
    <inertial><origin xyz="0 0 0.1" rpy="0 0 0"/><mass value="4.5"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0.01" izz="0.3"/></inertial>
    <visual name="foot"><geometry><mesh filename="meshes/foot.stl" scale="0.001 0.001 0.001"/></geometry><material name="steel"/></visual>
    <collision><geometry><mesh filename="package://rich_description/foot.stl"/></geometry></collision>
  </link>
  <link name="upper">
    <visual><origin xyz="0 0 0.2" rpy="0.1 0 0"/><geometry><cylinder radius="0.05" length="0.4"/></geometry></visual>
    <visual><geometry><mesh filename="file:///opt/rich/upper.dae"/></geometry></visual>
    <collision><origin xyz="0 0 0.2"/><geometry><cylinder radius="0.05" length="0.4"/></geometry></collision>
  </link>
  <link name="lower"><collision><geometry><sphere radius="0.06"/></geometry></collision></link>
  <link name="tool"/>
  <joint name="turn" type="revolute"><parent link="stand"/><child link="upper"/><origin xyz="0 0 0.3" rpy="0 0.2 0"/><axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.25" effort="87.5" velocity="2"/><dynamics damping="0.3" friction="0.1"/></joint>
  <joint name="spin" type="continuous"><parent link="upper"/><child link="lower"/><origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
    <limit effort="12" velocity="3"/></joint>
  <joint name="bolted" type="fixed"><parent link="lower"/><child link="tool"/><origin xyz="0 0 0.2"/></joint>
</robot>
"""
DESCRIPTION = """name: rich
urdf: {file: given/rich.urdf, acceleration: 5, jerk: 50}
chains: [{name: arm, first: turn, last: spin}]
palm: tool
tips: [{name: wrist, frame: tool, finger: wrist}]
"""


def numbers(element, name, default):
    return np.array([float(v) for v in (element.get(name, default) if element is not None else default).split()])


def turned(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def placed(rotation, translation):
    m = np.eye(4)
    m[:3, :3], m[:3, 3] = rotation, translation
    return m


class Urdf:
    """Links, joints and forward kinematics of a URDF, in whatever order it has them."""

    def __init__(self, file):
        self.root = ElementTree.parse(file).getroot()
        self.links = {link.get("name"): link for link in self.root.findall("link")}
        self.joints = {joint.get("name"): joint for joint in self.root.findall("joint")}
        below = {joint.find("child").get("link") for joint in self.joints.values()}
        (self.base,) = set(self.links) - below

    def moving(self):
        return {name: joint for name, joint in self.joints.items()
                if joint.get("type") in MOVING and joint.find("mimic") is None}

    def value(self, name, q):
        mimic = self.joints[name].find("mimic")
        if mimic is None:
            return q[name]
        return float(mimic.get("multiplier", 1)) * self.value(mimic.get("joint"), q) + float(mimic.get("offset", 0))

    def poses(self, q):
        found, joints = {self.base: np.eye(4)}, list(self.joints.items())
        while joints:
            waiting = []
            for name, joint in joints:
                parent = found.get(joint.find("parent").get("link"))
                if parent is None:
                    waiting.append((name, joint))
                    continue
                origin = joint.find("origin")
                roll, pitch, yaw = numbers(origin, "rpy", "0 0 0")
                turn = turned([0, 0, 1], yaw) @ turned([0, 1, 0], pitch) @ turned([1, 0, 0], roll)
                m = parent @ placed(turn, numbers(origin, "xyz", "0 0 0"))
                if joint.get("type") in MOVING:
                    axis, value = numbers(joint.find("axis"), "xyz", "1 0 0"), self.value(name, q)
                    slides = joint.get("type") == "prismatic"
                    m = m @ (placed(np.eye(3), value * axis / np.linalg.norm(axis)) if slides
                             else placed(turned(axis, value), [0, 0, 0]))
                found[joint.find("child").get("link")] = m
            assert len(waiting) < len(joints)
            joints = waiting
        return found


class WrittenUrdf(CommandCase):
    def written(self, file, name="out.urdf"):
        out = self.folder / name
        self.printed = self.succeeds("robot", file, "--urdf", out).stdout
        return Urdf(out)

    def same_motion(self, source, written, held):
        """Every link of the source stands where it stood, joints that are held where it was said."""
        random = np.random.default_rng(1)
        for _ in range(5):
            q = {name: random.uniform(-1, 1) for name in source.moving()}
            for name, joint in written.moving().items():
                limit = joint.find("limit")
                q[name] = random.uniform(float(limit.get("lower")), float(limit.get("upper")))
            q.update(held)
            before, after = source.poses(q), written.poses(q)
            anchor = np.linalg.inv(after[source.base])
            for link, pose in before.items():
                np.testing.assert_allclose(anchor @ after[link], pose, rtol=0, atol=1e-9, err_msg=link)

    def test_every_shipped_urdf_comes_back(self):
        for file in SHIPPED:
            source, written = Urdf(file), self.written(file)
            # Joints that move no tip are held where they are nearest to zero, and it is said.
            held = {}
            for name in set(source.moving()) - set(written.moving()):
                limit = source.joints[name].find("limit")
                held[name] = np.clip(0.0, float(limit.get("lower")), float(limit.get("upper")))
                self.assertIn(f"{name} at {held[name]:.4g}", self.printed)
            self.assertLessEqual(set(source.links), set(written.links), file)
            self.assertLessEqual(set(source.joints), set(written.joints), file)
            self.same_motion(source, written, held)
            report = {joint["name"]: joint for joint in self.json_of("robot", file)["joints"]}
            self.assertEqual(list(report), list(written.moving()), file)
            for name, joint in written.moving().items():
                limit, given = joint.find("limit"), source.joints[name].find("limit")
                for key in ("lower", "upper", "velocity"):
                    self.assertEqual(float(limit.get(key)), report[name][key], (file, name))
                self.assertEqual(float(limit.get("effort")), float(given.get("effort")), (file, name))
            # Read again by the program: the same joints, limits and motion.
            again = self.json_of("robot", self.folder / "out.urdf")["joints"]
            for joint in again:
                for key in ("lower", "upper", "velocity"):
                    self.assertEqual(joint[key], report[joint["name"]][key], (file, joint["name"]))

    def test_pictures_masses_and_forces_are_kept(self):
        given = self.folder / "given"
        given.mkdir()
        (given / "rich.urdf").write_text(RICH)
        (self.folder / "rich.yaml").write_text(DESCRIPTION)
        (self.folder / "elsewhere").mkdir()
        source, written = Urdf(given / "rich.urdf"), self.written(self.folder / "rich.yaml", "elsewhere/out.urdf")
        self.same_motion(source, written, {})
        self.assertEqual(written.base, "stand")
        self.assertEqual([joint.get("type") for joint in written.joints.values()],
                         ["revolute", "continuous", "fixed", "fixed"])
        stand, was = written.links["stand"], source.links["stand"]
        self.assertEqual(ElementTree.tostring(stand.find("inertial")).strip(),
                         ElementTree.tostring(was.find("inertial")).strip())
        mesh = stand.find("visual/geometry/mesh")
        self.assertEqual((mesh.get("filename"), mesh.get("scale")), ("../given/meshes/foot.stl", "0.001 0.001 0.001"))
        material = stand.find("visual/material")
        self.assertEqual((material.get("name"), material.find("color").get("rgba")), ("steel", "0.5 0.5 0.6 1"))
        self.assertEqual(material.find("texture").get("filename"), "../given/meshes/steel.png")
        self.assertEqual(stand.find("collision/geometry/mesh").get("filename"), "package://rich_description/foot.stl")
        self.assertEqual(len(written.links["upper"].findall("visual")), 2)
        self.assertEqual(written.links["upper"].findall("visual")[1].find("geometry/mesh").get("filename"),
                         "file:///opt/rich/upper.dae")
        self.assertEqual(len(written.links["upper"].findall("collision")), 1)  # its own, not Morphe's capsules too
        self.assertEqual(written.joints["turn"].find("limit").get("effort"), "87.5")
        self.assertEqual(written.joints["turn"].find("dynamics").get("damping"), "0.3")
        self.assertEqual(written.joints["spin"].find("limit").get("effort"), "12")
        for said in ("inertias: not given for upper, lower, tool", "visuals: not given for lower, tool"):
            self.assertIn(f"out.urdf: {said}\n", self.printed)
            self.assertIn(f"<!-- {said} -->", (self.folder / "elsewhere/out.urdf").read_text())
        self.assertNotIn("efforts", self.printed)

    def test_two_urdfs_in_one_with_their_prefix(self):
        written = self.written(ROBOTS / "iiwa14_allegro.yaml")
        arm, hand = Urdf(ROBOTS / "urdf/iiwa14.urdf"), Urdf(ROBOTS / "urdf/allegro.urdf")
        self.assertLessEqual(set(arm.links) | {f"hand_{link}" for link in hand.links}, set(written.links))
        self.assertLessEqual(set(arm.joints) | {f"hand_{joint}" for joint in hand.joints}, set(written.joints))
        q = {name: 0.1 for name in written.moving()}
        before, after = hand.poses({name: 0.1 for name in hand.moving()}), written.poses(q)
        anchor = np.linalg.inv(after[f"hand_{hand.base}"])
        for link, pose in before.items():
            np.testing.assert_allclose(anchor @ after[f"hand_{link}"], pose, rtol=0, atol=1e-9)

    def test_what_nobody_knows_is_said(self):
        self.written(ROBOTS / "pa10.yaml")
        for said in ("efforts: not given for any part; written as 0", "inertias: not given for any part", "visuals: not given for any part"):
            self.assertIn(f"out.urdf: {said}\n", self.printed)
        self.assertIn('"robot": "pa10"', self.succeeds("robot", ROBOTS / "pa10.yaml", "--json", "--urdf",
                                                       self.folder / "again.urdf").stdout)


main()
