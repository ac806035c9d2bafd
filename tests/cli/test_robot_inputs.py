"""What a robot's file is, is said; meshes are found where they are; inputs are checked before work."""
import gzip
import struct

from support import SOURCE, CommandCase, main, morphe, sha256
from terminal import Terminal

URDFS = SOURCE / "configs/robots/urdf"
POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1234567\n"


def triangles(size):
    """A tetrahedron as a binary STL."""
    points = [(0, 0, 0), (size, 0, 0), (0, size, 0), (0, 0, size)]
    data = b" " * 80 + struct.pack("<I", 4)
    for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)):
        data += struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *points[k]) for k in face) + b"\0\0"
    return data


def arm(mesh, links=6):
    """A chain of joints that turn about z and y in turns; mesh(k) names the mesh of link k."""
    text = "<?xml version='1.0' encoding='utf-8'?><robot name='made'><link name='l0'/>"
    for k in range(1, links + 1):
        shape = f"<collision><geometry><mesh filename='{mesh(k)}'/></geometry></collision>" if mesh(k) else ""
        text += (f"<link name='l{k}'>{shape}</link><joint name='j{k}' type='revolute'><parent link='l{k - 1}'/>"
                 f"<child link='l{k}'/><origin xyz='0 0 0.2'/><axis xyz='{'0 0 1' if k % 2 else '0 1 0'}'/>"
                 "<limit lower='-2' upper='2' velocity='2' effort='10'/></joint>\n")
    return text + "</robot>\n"


class RobotInputs(CommandCase):
    def put(self, name, content):
        file = self.folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def set_up(self, *inputs, out="out.yaml", code=0):
        result = morphe("robot", "setup", *inputs, "--capsules", 1, "--out", self.folder / out)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        return result.stdout + result.stderr

    def test_files_that_are_no_robot_are_named(self):
        xacro = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:arm/></robot>"
        cases = (("arm.urdf", POINTER, "is a Git LFS pointer", "git lfs pull"),
                 ("arm.xacro", xacro, "is a xacro file", "xacro {file} > arm.urdf"),
                 ("arm.urdf.xacro", xacro, "is a xacro file", "xacro {file} > arm.urdf"),
                 ("arm.sdf", "<?xml version='1.0'?><!-- a <robot> --><sdf version='1.9'/>", "is a model in SDF"),
                 ("arm.usd", b"PXR-USDC\0\0\0\1", "is a USD scene", "export the robot as URDF"),
                 ("arm.usda", "#usda 1.0\n(\n)\n", "is a USD scene"),
                 ("arm.urdf.gz", gzip.compress(b"<robot name='r'/>"), "is a gzip archive", "unpack it"),
                 ("page.urdf", "<!DOCTYPE html>\n<html><body/></html>", "is a web page"),
                 ("empty.urdf", "", "is empty"), ("blank.xml", " \n", "is empty but for blanks"),
                 ("mesh.urdf", "solid x\nfacet normal 0 0 1\n", "is a mesh (STL)"),
                 ("arm.step", "ISO-10303-21;\n", "is a CAD model (STEP)"))
        for name, content, *words in cases:
            file = self.put(name, content)
            said = self.set_up(file, code=2)
            for word in words:
                self.assertIn(word.format(file=file), said)
            self.assertTrue(said.startswith(str(file)), said)
        self.assertFalse((self.folder / "out.yaml").exists())

    def test_a_description_of_another_kind_is_named_too(self):
        for name, content, word in (("robot.yaml", POINTER, "is a Git LFS pointer"),
                                    ("arm.yaml", "<robot name='r'/>", "is a URDF, not a robot description")):
            file = self.put(name, content)
            config = self.put("config.yaml", (SOURCE / "configs/pipelines/pa10_dlr_hit2.yaml").read_text())
            config.write_text(config.read_text().replace("../robots/pa10_dlr_hit2.yaml", str(file)))
            self.assertIn(word, morphe("run", config, "--out", self.folder / "run").stderr)

    def test_utf_16_is_read(self):
        plain = self.put("plain.urdf", arm(lambda k: ""))
        wide = self.put("wide.urdf", arm(lambda k: "").encode("utf-16"))
        self.assertEqual(self.json_of("robot", plain)["joints"], self.json_of("robot", wide)["joints"])

    def test_many_missing_meshes_are_one_line(self):
        urdf = self.put("arm.urdf", arm(lambda k: f"package://foo/meshes/l{k}.stl"))
        said = self.set_up(urdf)
        self.assertIn("6 meshes of package foo were not found", said)
        self.assertIn("first 'package://foo/meshes/l1.stl'", said)
        self.assertIn("--package foo=DIR", said)
        self.assertEqual(said.count("not found"), 1, said)

    def test_many_pointers_are_one_line(self):
        for k in range(1, 7):
            self.put(f"meshes/l{k}.stl", POINTER)
        said = self.set_up(self.put("arm.urdf", arm(lambda k: f"meshes/l{k}.stl")))
        self.assertRegex(said, r"meshes/l1.stl and 5 other meshes: is a Git LFS pointer, .*git lfs pull")
        self.assertEqual(said.count("Git LFS"), 1, said)

    def test_packages_are_found_by_the_ends_of_their_paths(self):
        for place, tail in (("ws/src/foo/meshes", False), ("ws/share/foo/meshes", False), ("ws/foo/meshes", False),
                            ("ws/robot/meshes", False), ("ws/robot/urdf/collision", True)):
            for k in range(1, 7):
                self.put(f"{place}/collision/l{k}.stl" if not tail else f"{place}/l{k}.stl", triangles(0.1))
            urdf = self.put("ws/robot/urdf/arm.urdf", arm(lambda k: f"package://foo/meshes/collision/l{k}.stl"))
            said = self.set_up(urdf)
            self.assertNotIn("not found", said)
            self.assertEqual(said.count("found by the end of their path"), int(tail), said)
            self.assertRegex((self.folder / "out.yaml").read_text(), r"# l1: \S+ % inside")
            for k in range(1, 7):
                (self.folder / (f"{place}/collision/l{k}.stl" if not tail else f"{place}/l{k}.stl")).unlink()
            (self.folder / "out.yaml").unlink()

    def test_inputs_are_checked_before_work(self):
        arm_urdf = self.put("arm.urdf", arm(lambda k: ""))
        result = morphe("robot", "setup", arm_urdf, self.folder / "gone.urdf", "--out", self.folder / "both.yaml")
        self.refuses(result, self.folder / "gone.urdf", "cannot be read")
        broken = self.put("hand.urdf", "<robot name='h'><link name='a'/></robot>")
        result = morphe("robot", "setup", arm_urdf, broken, "--out", self.folder / "both.yaml")
        self.refuses(result, f"{broken}:1", "has no joints")
        result = morphe("robot", "setup", arm_urdf, "--out", self.folder / "none/arm.yaml")
        self.refuses(result, self.folder / "none/arm.yaml", "cannot be written")
        result = morphe("robot", "setup", arm_urdf, "--package", "foo=/nowhere", "--out", self.folder / "arm.yaml")
        self.refuses(result, "--package foo=/nowhere", "is not a folder")
        result = morphe("robot", "setup", arm_urdf, URDFS / "allegro.urdf", "--out", self.folder / "arm.yaml")
        self.refuses(result, self.folder / "arm.yaml", "would be written twice")
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["arm.urdf", "hand.urdf"])

    def test_progress_is_shown_on_a_terminal_alone(self):
        for k in range(1, 7):
            self.put(f"meshes/l{k}.stl", triangles(0.1))
        urdf = self.put("arm.urdf", arm(lambda k: f"meshes/l{k}.stl"))
        seen = Terminal("robot", "setup", urdf, "--capsules", 1, "--out", self.folder / "seen.yaml")
        self.assertEqual(seen.end(300)[0], 0, seen.seen)
        self.assertIn("2 of 6 links covered", seen.seen)
        self.assertNotIn("covering", "\n".join(seen.lines()))
        self.assertNotIn("covering", self.set_up(urdf))
        self.assertEqual(sha256(self.folder / "seen.yaml"), sha256(self.folder / "out.yaml"))


if __name__ == "__main__":
    main()
