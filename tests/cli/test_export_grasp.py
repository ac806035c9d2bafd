"""`morphe export` of plans that name contacts: the grasp beside the trajectory, as plans.h5 holds it."""
import csv
import json

import h5py
import numpy as np

import formats
from support import CommandCase, main, planned_sample

PLAN = "ADL001DR2/000"


def setUpModule():
    global PLANS
    PLANS = planned_sample("--set", "grasp.close_fingers=true")


def rows_of(file):
    with open(file, newline="") as text:
        return list(csv.DictReader(text))


class ExportGrasp(CommandCase):
    def setUp(self):
        super().setUp()
        file = h5py.File(PLANS)
        self.addCleanup(file.close)
        self.grasp = file["plans"][PLAN]["grasp"]
        self.time = file["plans"][PLAN]["trajectory/time"][()]
        self.joints = list(file["robot/joint_names"].asstr())

    def exported(self, kind, *arguments):
        self.succeeds("export", PLANS, "--format", kind, "--out", self.folder / kind, *arguments)
        return self.folder / kind

    def indexed(self, kind):
        plans = json.loads((self.folder / kind / f"index_{kind}.json").read_text())["plans"]
        return {plan["plan"]: plan.get("grasp") for plan in plans}

    def test_tables_hold_every_contact_and_joint(self):
        out = self.exported("csv")
        self.assertEqual(self.indexed("csv"), {
            PLAN: ["ADL001DR2_000_contacts.csv", "ADL001DR2_000_grasp_force.csv"], "ADL001AR1/000": None})
        rows = rows_of(out / "ADL001DR2_000_contacts.csv")
        contacts = self.grasp["contacts"]
        self.assertEqual([row["tip"] for row in rows], list(contacts["tip"].asstr()))
        self.assertEqual([row["origin"] for row in rows], list(contacts["origin"].asstr()))
        self.assertEqual([row["state"] for row in rows], list(contacts["state"].asstr()))
        for column, name in (("signed_distance_m", "signed_distance"), ("pad_angle_rad", "pad_angle"),
                             ("normal_force_N", "normal_force")):
            self.assertEqual([float(row[column] or "nan") for row in rows],
                             [float(x) for x in contacts[name][()]])
        for prefix, name, unit in (("point", "point", "_m"), ("normal", "normal", "")):
            values = [[float(row[f"{prefix}_{axis}{unit}"]) for axis in "xyz"] for row in rows]
            np.testing.assert_array_equal(values, contacts[name][()])
        joints = rows_of(out / "ADL001DR2_000_grasp_force.csv")
        self.assertEqual([row["joint"] for row in joints], self.joints)
        for column, values in (("grasp", self.grasp["grasp_posture"]),
                               ("grasp_torque", self.grasp["grasp_force/torque"]),
                               ("servo_target", self.grasp["grasp_force/servo_target"])):
            np.testing.assert_array_equal([float(row[column]) for row in joints], values[()])

    def test_json_is_the_group_of_the_file(self):
        out = self.exported("ros-json", "--delay", "0.5")
        self.assertEqual(self.indexed("ros-json")[PLAN], ["ADL001DR2_000_grasp.json"])
        read = json.loads((out / "ADL001DR2_000_grasp.json").read_text())
        self.assertEqual((read["format"], read["version"], read["plan"]), ("morphe-grasp", 1, PLAN))
        self.assertEqual(read["joints"], self.joints)
        self.assertIn("kept apart from the trajectory", read["note"])
        self.assertAlmostEqual(read["time_s"], 0.5 + self.time[self.grasp.attrs["sample"]], 12)
        self.assertEqual(set(read["quality"]), set(self.grasp["quality"].attrs))
        self.assertEqual(read["quality"]["available_force"], self.grasp["quality"].attrs["available_force"])
        np.testing.assert_array_equal(read["object_pose"], self.grasp["object_pose"][()])
        np.testing.assert_array_equal(read["grasp_force"]["servo_target"], self.grasp["grasp_force/servo_target"][()])
        np.testing.assert_array_equal([one["point"] for one in read["contacts"]],
                                      self.grasp["contacts/point"][()])
        self.assertEqual(set(read["contacts"][0]), set(self.grasp["contacts"]))
        for name in self.grasp.attrs:  # what the group's attributes are called, whatever they are
            self.assertIn(name, read)
        # The trajectory is the one of a plan without contacts: nothing of the squeeze is in it.
        points = json.loads((out / "ADL001DR2_000.json").read_text())["points"]
        self.assertEqual(len(points), len(self.time) + 1)

    def test_robomimic_has_it_beside_its_data(self):
        with h5py.File(self.exported("robomimic") / "robomimic.hdf5") as file:
            demos = {formats.text(demo.attrs["plan"]): name for name, demo in file["data"].items()}
            self.assertEqual(set(file["grasps"]), {demos[PLAN]})
            stored = file["grasps"][demos[PLAN]]
            self.assertEqual(set(stored), set(self.grasp))
            for name in ("contacts/point", "contacts/normal_force", "grasp_force/torque", "grasp_posture"):
                np.testing.assert_array_equal(stored[name][()], self.grasp[name][()])
            self.assertEqual(dict(stored["quality"].attrs).keys(), dict(self.grasp["quality"].attrs).keys())
            self.assertNotIn("grasp", file["data"][demos[PLAN]])


if __name__ == "__main__":
    main()
