"""How a robot stands: what `morphe place` allows by default, and the words for it. It takes more than 10 s:
three small searches for a place and the setup of a robot with legs."""
import re

from support import REFERENCE, CommandCase, main, write_two_recordings

# So small a search takes seconds; what it finds is no good measure of it.
SMALL = ("--candidates", 8, "--refine", 2, "--plan", 1, "--set", "map.coarse_step_s=0.1")


def small_person():
    """A robot with legs and two arms, each with two fingers; X forward, Y left, Z up."""
    parts = ['<link name="pelvis"/>']

    def add(parent, name, place, axis=None, limits=(-2, 2), body=None):
        """A link on `parent`, turning about `axis` if there is one, with a cylinder (radius, length, height)."""
        kind = "revolute" if axis else "fixed"
        shape = body and (f'<collision><origin xyz="0 0 {body[2]}"/><geometry>'
                          f'<cylinder radius="{body[0]}" length="{body[1]}"/></geometry></collision>')
        parts.append(f'<link name="{name}">{shape or ""}</link><joint name="{name}_joint" type="{kind}">'
                     f'<parent link="{parent}"/><child link="{name}"/><origin xyz="{place[0]} {place[1]} {place[2]}"/>')
        if axis:
            parts.append(f'<axis xyz="{axis}"/>'
                         f'<limit lower="{limits[0]}" upper="{limits[1]}" velocity="3" effort="50"/>')
        parts.append("</joint>")

    add("pelvis", "torso", (0, 0, 0.1), body=(0.1, 0.3, 0.15))
    for side, y in (("left", 1), ("right", -1)):
        add("pelvis", f"{side}_hip", (0, 0.1 * y, -0.05), "0 1 0", body=(0.05, 0.3, -0.2))
        add(f"{side}_hip", f"{side}_knee", (0, 0, -0.4), "0 1 0", (0, 2), (0.05, 0.3, -0.2))
        add("torso", f"{side}_shoulder_pitch", (0, 0.2 * y, 0.35), "0 1 0", (-3, 3))
        add(f"{side}_shoulder_pitch", f"{side}_shoulder_roll", (0, 0, 0), "1 0 0", (-2.8, 2.8))
        add(f"{side}_shoulder_roll", f"{side}_shoulder_yaw", (0, 0, -0.1), "0 0 1", (-2.8, 2.8), (0.035, 0.15, -0.1))
        add(f"{side}_shoulder_yaw", f"{side}_elbow", (0, 0, -0.2), "0 1 0", (-2.5, 0.1), (0.03, 0.15, -0.12))
        add(f"{side}_elbow", f"{side}_wrist_yaw", (0, 0, -0.15), "0 0 1", (-2.8, 2.8))
        add(f"{side}_wrist_yaw", f"{side}_wrist_roll", (0, 0, -0.12), "1 0 0", (-1.6, 1.6))
        add(f"{side}_wrist_roll", f"{side}_wrist_pitch", (0, 0, 0), "0 1 0", (-1.6, 1.6))
        add(f"{side}_wrist_pitch", f"{side}_hand", (0, 0, -0.08), body=(0.03, 0.05, 0))
        for finger, turn in (("thumb", 1), ("index", -1)):
            add(f"{side}_hand", f"{side}_{finger}_finger", (-0.02 * turn, 0, -0.04), f"0 {turn} 0", (-0.2, 0.8),
                (0.008, 0.06, -0.04))
    return f'<robot name="small_person">{"".join(parts)}</robot>'


class Standing(CommandCase):
    def test_an_arm_stands_upright_unless_more_is_allowed(self):
        """The reference arm is on its side, since upright it cannot let its upper arm hang: no upright place is
        better, which is said."""
        recordings = write_two_recordings(self.folder)
        done = self.succeeds("place", REFERENCE, "--dataset", recordings, *SMALL, "--quiet")
        configured, best = done.stdout.splitlines()[2:4]
        self.assertTrue(configured.endswith("  is on its side, its axis to the person's right and 15 degrees down"))
        self.assertTrue(best.endswith("  stands upright"))
        self.assertIn("note: the best placement found is no better than the configured one, in which the base is on "
                      "its side", done.stdout)
        self.assertIn("note: only upright bases were searched", done.stdout)
        hung = self.json_of("place", REFERENCE, "--dataset", recordings, *SMALL, "--mount", "ceiling")
        self.assertEqual(hung["placements"][0]["stands"], "hangs")
        self.assertEqual(hung["body_frame"], "")

    def test_a_robot_with_legs_faces_the_persons_way(self):
        recordings = write_two_recordings(self.folder)
        urdf, robot, config = (self.folder / name for name in ("person.urdf", "person.yaml", "config.yaml"))
        urdf.write_text(small_person())
        self.succeeds("robot", "setup", urdf, "--hand", "right_hand", "--capsules", 1, "--out", robot)
        self.assertRegex(self.succeeds("robot", robot).stdout,
                         r"stands upright on its body \(\w+\): up is \(0 0 1\), forward \(1\.00 -?0\.00 0\.00\)")
        config.write_text(f"robot: {{file: {robot}}}\n")
        placed = self.folder / "placed.yaml"
        done = self.succeeds("place", config, "--dataset", recordings, *SMALL, "--quiet", "--out", placed)
        configured, best = done.stdout.splitlines()[2:4]
        self.assertTrue(configured.endswith("  stands upright, facing the person's right"))
        self.assertTrue(best.endswith("  stands upright, facing the person's way"))
        turn = re.search(r"angle: (.*) deg", done.stdout)[1]
        self.assertLessEqual(abs(float(turn) - 90), 30.1)
        self.assertIn("note: the robot has a body (", done.stdout)
        self.assertIn("found_by: place\n", placed.read_text())
        # A run from there says how the base stands, and no advice names the command that placed it.
        ran = self.succeeds("run", placed, "--dataset", recordings, "--out", self.folder / "run", "--set",
                            "map.coarse_step_s=0.1", "--set", "check.tracking_tolerance_grasp=0.00001")
        self.assertIn("with this placement: the base stands upright, facing the person's way\n", ran.stdout)
        self.assertNotIn("morphe place", ran.stdout)
        self.assertIn("  try: ", ran.stdout)
        moved = self.succeeds("run", placed, "--dataset", recordings, "--out", self.folder / "moved", "--set",
                              "map.coarse_step_s=0.1", "--set", "placement.shoulder_offset=[0, -2, 0]")
        self.assertIn("morphe place", moved.stdout, "no search has found this placement")


if __name__ == "__main__":
    main()
