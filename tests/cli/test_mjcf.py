"""morphe robot setup with the XML of MuJoCo: it becomes a URDF beside the description."""
import shutil
import xml.etree.ElementTree as ElementTree

from support import SOURCE, CommandCase, main, morphe, sha256

FILES = SOURCE / "tests/data/mjcf"


class Mjcf(CommandCase):
    def set_up(self, name, *more, out="robot.yaml"):
        out = self.folder / out
        return out, self.succeeds("robot", "setup", FILES / f"{name}.xml", "--out", out, *more).stdout

    def test_an_arm_becomes_a_urdf_and_a_description(self):
        out, said = self.set_up("27_arm_as_published")
        urdf = out.with_suffix(".urdf")
        self.assertIn(f"converted to {urdf}", said)
        robot = self.json_of("robot", out)
        self.assertIn("\nname: six_axes\n", out.read_text())
        self.assertEqual([j["name"] for j in robot["joints"]],
                         ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint",
                          "wrist_2_joint", "wrist_3_joint"])
        links = [link.get("name") for link in ElementTree.parse(urdf).getroot().iter("link")]
        self.assertIn("attachment_site", links)
        # The URDF is read as any other, and gives the same joints.
        again = self.json_of("robot", urdf)
        self.assertEqual(again["joints"], robot["joints"])
        # The same files, the same bytes.
        before = sha256(out), sha256(urdf)
        self.set_up("27_arm_as_published")
        self.assertEqual((sha256(out), sha256(urdf)), before)

    def test_meshes_are_relative_to_the_urdf(self):
        lab = self.folder / "lab"
        shutil.copytree(FILES, lab)
        text = (lab / "21_meshes.xml").read_text()
        joints = "".join(f"<body name='x{k}' pos='0 0 0.2'><joint name='x{k}' axis='{'0 0 1' if k % 2 else '0 1 0'}'/>"
                         "<geom type='mesh' mesh='brick'/>" for k in range(3)) + "</body>" * 3
        (lab / "arm.xml").write_text(text.replace("<geom type=\"mesh\" mesh=\"large\"/>", joints))
        (self.folder / "made").mkdir()
        out = self.folder / "made/arm.yaml"
        said = self.succeeds("robot", "setup", lab / "arm.xml", "--out", out).stdout
        self.assertIn("../lab/meshes/brick.stl", out.with_suffix(".urdf").read_text())
        self.assertNotIn("not found", said)
        self.assertRegex(out.read_text(), r"# x1: \S+ % inside")

    def test_a_urdf_of_somebody_else_stays(self):
        urdf = self.folder / "robot.urdf"
        urdf.write_text("<robot name='mine'/>")
        result = morphe("robot", "setup", FILES / "27_arm_as_published.xml", "--out", self.folder / "robot.yaml")
        self.refuses(result, urdf, "exists and was not made by setup")
        self.assertEqual(urdf.read_text(), "<robot name='mine'/>")

    def test_a_broken_file_is_named_with_its_line(self):
        lab = self.folder / "lab"
        shutil.copytree(FILES, lab)
        part = lab / "parts/forearm.xml"
        part.write_text(part.read_text().replace('name="j2"', 'name="j2" axis="0 0 0"'))
        result = morphe("robot", "setup", lab / "22_includes.xml", "--out", self.folder / "x.yaml")
        self.refuses(result, f"{part}:2", "joint j2.axis: must not be zero")
        self.assertFalse((self.folder / "x.urdf").exists())

    def test_where_a_urdf_or_a_description_is_asked_the_way_is_said(self):
        mjcf = FILES / "27_arm_as_published.xml"
        self.refuses(morphe("robot", mjcf), mjcf, "is an MJCF", "morphe robot setup")
        wrong = self.folder / "wrong.yaml"
        wrong.write_text(f"name: x\nurdf: {{file: '{mjcf}'}}\nchains: []\n")
        self.refuses(morphe("robot", wrong), mjcf, "is a model of MuJoCo (MJCF), not a URDF", "morphe robot setup")

    def test_angles_that_look_like_radians_are_to_be_checked(self):
        mjcf = self.folder / "arm.xml"
        text = (FILES / "27_arm_as_published.xml").read_text()
        mjcf.write_text(text.replace(' angle="radian"', "").replace("6.28319", "3.1"))
        said = self.succeeds("robot", "setup", mjcf, "--out", self.folder / "arm.yaml").stdout
        self.assertIn("check: angles are in degrees, MuJoCo's default", said)


if __name__ == "__main__":
    main()
