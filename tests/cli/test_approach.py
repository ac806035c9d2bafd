"""A plan that can be executed from where the robot stands: approach and retreat, judged by both
verifiers, and a home that cannot be."""
import h5py
import numpy as np

from support import (ONE_RECORDING, QUICK, SOURCE, CommandCase, main, morphe, python_verify, shared_run,
                     write_recordings)

FROM_HOME = SOURCE / "configs/pipelines/pa10_dlr_hit2_from_home.yaml"
SMALL = (*QUICK, "--set", "map.key_frames=2", "--set", "map.reach_search_starts=4")


class Approach(CommandCase):
    def test_home_to_the_first_sample_and_back(self):
        plans = shared_run(FROM_HOME, *SMALL, dataset="one recording") / "out/plans.h5"
        self.assertEqual(morphe("verify", plans).returncode, 0)
        self.assertEqual(python_verify(plans).returncode, 0)
        with h5py.File(plans) as file:
            plan = file["plans/ADL001DR2/000"]
            self.assertEqual(plan.attrs["status"].decode(), "executable")
            joints = [joint.decode() for joint in file["robot/joint_names"]]
            home = np.zeros(len(joints))
            for joint, degrees in (("S2", 30), ("E1", 90), ("W1", 30)):
                home[joints.index(joint)] = np.radians(degrees)
            home = np.clip(home, file["robot/lower"], file["robot/upper"])
            way = plan["trajectory/position"]
            for group, is_unset_pose, meets in (("approach", 0, way[0]), ("retreat", -1, way[-1])):
                position = plan[group]["position"][()]
                np.testing.assert_allclose(position[is_unset_pose], home, rtol=0, atol=1e-6)
                np.testing.assert_allclose(position[-1 - is_unset_pose], meets, rtol=0, atol=1e-6)
                self.assertGreater(plan[group]["clearance"][()].min(), 0.001)
                # Half of the limits at most.
                velocity = np.abs(plan[group]["velocity"][()]) / file["robot/velocity"][()]
                self.assertLessEqual(velocity.max(), 0.5 + 1e-6)

    def test_a_finger_that_leaves_its_limit_at_home(self):
        # Smoothed, the approach began 3e-6 rad beside the open hand.
        plans = self.run_it(SOURCE / "configs/pipelines/rm75_inspire.yaml", ("--set", "approach.retreat=true"))
        self.assertEqual(self.json_of("verify", plans)["violations"], [])
        with h5py.File(plans) as file:
            home = np.clip(0, file["robot/lower"], file["robot/upper"])
            approach = file["plans/ADL001DR2/000/approach/position"][0]
            np.testing.assert_allclose(approach, home, rtol=0, atol=1e-6)

    def test_a_home_in_collision(self):
        # The fingers bent through each other's way, the arm into the table.
        config = self.write("home: [{joint: S2, value: 90 deg}, {joint: E1, value: 137 deg}, {joint: W1, value: 90 deg}]")
        plans = self.run_it(config)
        with h5py.File(plans) as file:
            plan = file["plans/ADL001DR2/000"]
            self.assertEqual(plan.attrs["reason"].decode(), "no_approach")
            self.assertIn("too close", plan.attrs["detail"].decode())
            self.assertNotIn("trajectory", plan)

    def test_a_joint_that_does_not_exist_and_a_value_beyond_its_limit(self):
        for home, message in (("{joint: S9, value: 0}", "has no actuated joint 'S9'"),
                              ("{joint: S2, value: 99 deg}", "beyond the joint's limits")):
            config = self.write(f"home: [{home}]")
            result = morphe("run", config, "--out", f"{self.folder}/out")
            self.assertEqual(result.returncode, 2)
            self.assertIn("config.yaml:2: approach.home[0].", result.stderr)
            self.assertIn(message, result.stderr)

    def write(self, approach):
        config = f"{self.folder}/config.yaml"
        with open(config, "w") as file:
            file.write(f"extends: {SOURCE}/configs/pipelines/pa10_dlr_hit2.yaml\napproach: {{{approach}}}\n")
        return config

    def run_it(self, config, settings=SMALL):
        manifest = write_recordings(self.folder, ONE_RECORDING)
        result = morphe("run", config, "--dataset", manifest, "--out", f"{self.folder}/out", *settings)
        self.assertEqual(result.returncode, 0, result.stderr)
        return f"{self.folder}/out/plans.h5"


main()
