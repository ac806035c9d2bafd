"""morphe robot: every shipped robot, what it writes, and what it refuses."""
import re
import xml.etree.ElementTree as ElementTree

import numpy as np

from support import SOURCE, CommandCase, line_of, main, morphe, replace

ROBOTS = SOURCE / "configs/robots"


def turned(axis, angle):
    """Rodrigues."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def pose(element):
    xyz, rpy = ([float(v) for v in element.get(name).split()] for name in ("xyz", "rpy"))
    m = np.eye(4)
    m[:3, :3] = turned([0, 0, 1], rpy[2]) @ turned([0, 1, 0], rpy[1]) @ turned([1, 0, 0], rpy[0])
    m[:3, 3] = xyz
    return m


def urdf_poses(file, angles):
    """Forward kinematics of a URDF whose joints stand parents first; angles by joint."""
    poses = {"base": np.eye(4)}
    for joint in ElementTree.parse(file).getroot().iter("joint"):
        m = poses[joint.find("parent").get("link")] @ pose(joint.find("origin"))
        if joint.get("type") == "revolute":
            mimic = joint.find("mimic")
            angle = angles[joint.get("name")] if mimic is None else (
                float(mimic.get("multiplier")) * angles[mimic.get("joint")] + float(mimic.get("offset")))
            turn = np.eye(4)
            turn[:3, :3] = turned([float(v) for v in joint.find("axis").get("xyz").split()], angle)
            m = m @ turn
        poses[joint.find("child").get("link")] = m
    return poses


class Shipped(CommandCase):
    def test_no_robot_is_made_to_touch_itself(self):
        for file in sorted(ROBOTS.glob("*.yaml")):
            found = self.json_of("robot", file, "--self-collision", 500)
            self.assertEqual(found["samples"], 500)
            self.assertEqual(found["always"], [], file)
            if file.stem != "robotiq_2f85":  # all of whose pairs are excused, by proof
                self.assertGreater(len(found["never"]) + len(found["sometimes"]), 0, file)
            self.assertEqual(found, self.json_of("robot", file, "--self-collision", 500))
        text = self.succeeds("robot", ROBOTS / "wam.yaml", "--self-collision", 500).stdout
        self.assertTrue(re.match(r"\d+ pairs of capsules in 500 positions: 0 always overlap, ", text))
        self.assertEqual(morphe("robot", ROBOTS / "wam.yaml", "--self-collision", 0).returncode, 2)

    def test_every_robot_is_printed_drawn_and_written(self):
        for file in sorted(ROBOTS.glob("*.yaml")):
            svg, urdf = self.folder / "r.svg", self.folder / "r.urdf"
            text = self.succeeds("robot", file, "--svg", svg, "--urdf", urdf).stdout
            report = self.json_of("robot", file)
            self.assertEqual(report["robot"], file.stem)
            self.assertTrue(text.startswith(f"{file.stem}: joints {len(report['joints'])}, "))
            for joint in report["joints"]:
                self.assertLess(joint["lower"], joint["upper"])
                self.assertIn(f"\n{joint['name']} ", text)
            self.assertEqual(ElementTree.parse(svg).getroot().get("width"), "1240")
            joints = ElementTree.parse(urdf).getroot().findall("joint")
            turning = [j for j in joints if j.get("type") in ("revolute", "continuous", "prismatic")]
            self.assertEqual([j.get("name") for j in turning if j.find("mimic") is None],
                             [j["name"] for j in report["joints"]])
            self.assertEqual([j.get("name") for j in turning if j.find("mimic") is not None],
                             [c["frame"] for c in report["coupled"]])

    def test_the_urdf_of_the_hand_bends_as_published(self):
        urdf = self.folder / "hand.urdf"
        self.succeeds("robot", ROBOTS / "dlr_hit2.yaml", "--urdf", urdf)
        report = self.json_of("robot", ROBOTS / "dlr_hit2.yaml")
        angles = {joint["name"]: 0.0 for joint in report["joints"]}
        angles["middle_proximal"], angles["middle_middle"] = 0.4, 0.3
        tip = urdf_poses(urdf, angles)["middle_tip"][:3, 3]
        # In the plane through the finger: along z of the palm, and out of it along x.
        turns, lengths = [0.4, 0.7, 1.0], [0.055, 0.025, 0.025]
        along = sum(l * np.cos(a) for l, a in zip(lengths, turns))
        out = sum(l * np.sin(a) for l, a in zip(lengths, turns))
        np.testing.assert_allclose(tip, [-0.0037 + out, 0.01, 0.119044 + along], rtol=0, atol=1e-12)

    def test_the_same_bytes_twice(self):
        for name in ("a", "b"):
            self.succeeds("robot", ROBOTS / "pa10_dlr_hit2.yaml", "--svg", self.folder / f"{name}.svg",
                          "--urdf", self.folder / f"{name}.urdf")
        for suffix in ("svg", "urdf"):
            self.assertEqual((self.folder / f"a.{suffix}").read_bytes(),
                             (self.folder / f"b.{suffix}").read_bytes())


class Refused(CommandCase):
    """A description with one fault: file, line, key, exit 2, and nothing written."""

    def faulty(self, old, new):
        file = self.folder / "robot.yaml"
        file.write_text((ROBOTS / "pa10.yaml").read_text())
        replace(file, old, new)
        return file

    def robot_refuses(self, file, beginning, *mentioned):
        out = self.folder / "out.svg"
        self.refuses(morphe("robot", file, "--svg", out), beginning, *mentioned)
        self.assertFalse(out.exists())

    def test_a_parent_that_does_not_exist(self):
        file = self.faulty("parent: arm", "parent: leg")
        self.robot_refuses(file, f"{file}:{line_of(file, 'leg')}: frames[0].parent", "'leg'")

    def test_frames_in_a_loop(self):
        file = self.faulty("parent: arm}", "parent: rim}\n  - {name: rim, parent: flange}")
        self.robot_refuses(file, f"{file}:{line_of(file, 'parent: rim')}: frames[0].parent", "its own ancestor")

    def test_a_joint_coupled_to_itself(self):
        file = self.faulty("lower: -255 deg.*", "couple: {joint: E2}}")
        self.robot_refuses(file, f"{file}:{line_of(file, 'couple')}: chains[0].joints[4].couple.joint",
                           "itself")

    def test_limits_that_cross(self):
        file = self.faulty("lower: -91 deg", "lower: 92 deg")
        self.robot_refuses(file, f"{file}:{line_of(file, '92 deg')}: chains[0].joints[1].upper",
                           "above lower")

    def test_a_tip_on_nothing(self):
        file = self.faulty("chain: arm, finger", "chain: hand, finger")
        self.robot_refuses(file, f"{file}:{line_of(file, 'chain: hand')}: tips[0].chain", "'hand'")

    def test_a_urdf_with_a_missing_link_or_a_zero_axis(self):
        urdf, file = self.folder / "arm.urdf", self.folder / "arm.yaml"
        self.succeeds("robot", ROBOTS / "pa10.yaml", "--urdf", urdf)
        file.write_text("name: arm\nurdf: {file: arm.urdf, acceleration: 1, jerk: 1}\n"
                        "chains: [{name: arm, first: S1, last: flange}]\n"
                        "tips: [{name: wrist, frame: flange, finger: wrist}]\n")
        self.assertEqual(len(self.json_of("robot", file)["joints"]), 7)
        whole = urdf.read_text()
        replace(urdf, '<parent link="E1"/>', '<parent link="nowhere"/>')
        self.robot_refuses(file, f"{urdf}:{line_of(urdf, 'nowhere')}: joint E2.parent", "'nowhere'")
        urdf.write_text(whole)
        replace(urdf, '<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>')
        axis = line_of(urdf, '<axis xyz="0 0 0"/>')
        self.robot_refuses(file, f"{urdf}:{axis}: joint S1.axis", "zero")
        urdf.write_text("no xml")
        self.robot_refuses(file, f"{urdf}:1", "XML")

    def test_a_drawing_that_cannot_be_written(self):
        out = self.folder / "no/where.svg"
        self.refuses(morphe("robot", ROBOTS / "pa10.yaml", "--svg", out), out, "cannot be written")


main()
