"""Plans with a lie in them, after which the certificate was made to agree: `morphe verify` finds every
kind that tests/forged_plans.py knows, and accepts nothing that tests/verify_plans.py rejects. By hand, for
hours: tests/forged_plans.py build/release/morphe PLANS.h5… --count 100000 --grasps 10000
Takes half a minute of processor time: 170 plans are judged, up to three times each."""
import re

import h5py
import numpy as np

from support import MORPHE, CommandCase, carried_run, from_home_run, json, main, morphe, python_verify

import forged_plans

# What is left may be a plan as good as the one before: another motion that holds all that it says.
# Nor can it be told what was recorded, or what a joint that moves no tip was mapped to.
NO_LIES = {"a_position_moved", "a_velocity_changed",
           "an_acceleration_changed", "a_joint_shifted_throughout", "an_object_of_another_size",
           "mapped_elsewhere"}
# These plans have an approach, no goals of orientation, no pad that sinks in, and end with the grasp.
NOT_HERE = {"an_approach_nobody_asked_for", "a_mapped_turn_less", "tip_orientation_error_max_in_the_certificate",
            "a_penetration_deeper", "an_obstacle_on_the_way_of_the_target", "released_in_the_air",
            "held_drift_in_the_certificate", "held_turn_in_the_certificate", "a_home_after_the_return",
            "a_mesh_smaller", "a_mesh_halved", "a_mesh_inside_out", "a_mesh_of_the_inputs_smaller",  # test_meshes.py
            "a_mesh_of_the_inputs_halved", "a_mesh_of_the_inputs_inside_out",
            "another_arm_thinner", "an_arm_that_was_there", "an_arm_elsewhere", "an_arm_too_late",
            "a_doubt_left_out", "a_finger_joint_elsewhere"}

# Nothing was doubted there, and no joint of a finger was recorded.
NOT_CARRIED = {"a_doubt_left_out", "a_finger_joint_elsewhere"}


def setUpModule():
    global PLANS, CARRIED
    PLANS, CARRIED = from_home_run(), carried_run()


class Forged(CommandCase):
    def test_the_honest_plans_pass(self):
        for verdict in (self.json_of("verify", PLANS), json.loads(python_verify(PLANS).stdout)):
            self.assertEqual(verdict["violations"], [])

    def test_every_kind_of_lie_is_found(self):
        tally = forged_plans.each(MORPHE, [PLANS], 1)
        self.assertEqual(tally.wrong, [])
        self.assertGreaterEqual(len(tally.made), 200)
        carried = {kind for kind, (family, _, _) in forged_plans.KINDS.items() if family == "carried"}
        self.assertLessEqual(set(forged_plans.KINDS) - set(tally.made), NOT_HERE | carried)
        self.assertEqual({kind for kind in tally.missed} - NO_LIES, set())

    def test_every_lie_about_a_carried_target_and_the_recording_is_found(self):
        families = {"carried", "recording"}
        tally = forged_plans.each(MORPHE, [CARRIED], 1, families)
        self.assertEqual(tally.wrong, [])
        self.assertEqual(set(tally.missed) - NO_LIES, set())
        made = {kind for kind, (family, _, _) in forged_plans.KINDS.items() if family in families} - set(tally.made)
        self.assertLessEqual(made, NOT_CARRIED)

    def test_nothing_passes_that_the_other_judge_rejects(self):
        families = {family for family, _, _ in forged_plans.KINDS.values()} - {"robot table", "form of the file", "infeasible plans", "recording"}
        tally = forged_plans.run(MORPHE, [PLANS], 40, families, 2)
        self.assertGreaterEqual(sum(tally.made.values()), 40)
        self.assertEqual(tally.wrong, [])
        self.assertEqual(set(tally.missed) - NO_LIES, set())

    def test_a_file_without_plans(self):
        copy = self.folder / "plans.h5"
        copy.write_bytes(PLANS.read_bytes())
        with h5py.File(copy, "r+") as file:
            for name in list(file["plans"]):
                del file["plans"][name]
        result = morphe("verify", copy)
        self.assertEqual(result.returncode, 1)
        self.assertIn("file: structure plans: 0, limit 1\n", result.stdout)
        self.assertEqual(python_verify(copy).returncode, 1)

    def test_a_movement_left_out(self):
        copy = self.folder / "plans.h5"
        copy.write_bytes(PLANS.read_bytes())
        with h5py.File(copy, "r+") as file:
            name = next(iter(file["plans"]))
            file["plans"][name].move("000", "001")
        violations = json.loads(morphe("verify", copy, "--json").stdout)["violations"]
        self.assertEqual([(row["plan"], row["cause"], row["subject"]) for row in violations],
                         [("", "structure", f"plans/{name}/000")])

    def test_inputs_that_do_not_make_the_robot(self):
        copy = self.folder / "plans.h5"
        def violations(change):
            copy.write_bytes(PLANS.read_bytes())
            with h5py.File(copy, "r+") as file:
                change(file["inputs"])
            return json.loads(morphe("verify", copy, "--json").stdout)["violations"]
        def without(inputs):
            del inputs["robots"]
        row, = violations(without)
        self.assertEqual((row["plan"], row["cause"]), ("", "config"))
        self.assertNotIn("/tmp", row["subject"])
        def faster(inputs):
            text = inputs["robots/pa10.yaml"][()].decode()
            attributes = dict(inputs["robots/pa10.yaml"].attrs)
            del inputs["robots/pa10.yaml"]
            inputs["robots/pa10.yaml"] = np.bytes_(re.sub("velocity: [0-9.]+", "velocity: 0.9", text))
            inputs["robots/pa10.yaml"].attrs.update(attributes)
        self.assertIn(("", "robot", "velocity"),
                      {(row["plan"], row["cause"], row["subject"]) for row in violations(faster)})


if __name__ == "__main__":
    main()
