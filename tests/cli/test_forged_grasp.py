"""`morphe verify` accepts the contacts, the quality and the grasp force that `run` wrote, and finds
whatever of them is forged beyond its tolerances. Takes 14 s of processor time: 80 plans are judged."""
import shutil

import h5py
import numpy as np

from support import CommandCase, add_copy, json, main, morphe, planned_sample

PLAN = "ADL001DR2/000"
OF_A_GRASP = ("grasp", "contact", "quality", "grasp_force")


def setUpModule():
    """Sampled coarsely, so that a plan is judged in a fraction of the time."""
    global PLANS
    PLANS = planned_sample("--set", "grasp.close_fingers=true", "--set", "retime.sample_rate_hz=50")


def add(dataset, where, change):
    values = dataset[()]
    values[where] += change
    dataset[...] = values


def scale(attributes, factor, *names):
    for name in names:
        attributes[name] = attributes[name] * factor


class Forged(CommandCase):
    """Every forged copy of the plan is added to one file, which is verified once at the end of a test."""

    def setUp(self):
        super().setUp()
        self.copy, self.judges = self.folder / "plans.h5", {}
        shutil.copy(PLANS, self.copy)
        self.file = h5py.File(self.copy, "r+")
        self.addCleanup(self.file.close)

    def forge(self, what, change, judge):
        """A copy of the plan is changed; what is found of it, (cause, subject), is for `judge`."""
        name = f"forged_{len(self.judges)}"
        change(add_copy(self.file, PLAN, name))
        self.judges[f"{name}/000"] = what, judge

    def finds(self, cause, subject, change, nothing_else=False):
        def judge(found):
            self.assertIn((cause, subject), found)
            if nothing_else:
                self.assertEqual(found, {(cause, subject)})
        self.forge(f"{cause} {subject}", change, judge)

    def verify_all(self):
        """Nothing is found but of the plans that were forged."""
        self.file.close()
        rows = json.loads(morphe("verify", self.copy, "--json").stdout)["violations"]
        self.assertEqual({row["plan"] for row in rows} - set(self.judges), set())
        for plan, (what, judge) in self.judges.items():
            with self.subTest(what):
                judge({(row["cause"], row["subject"]) for row in rows if row["plan"] == plan})

    def test_the_honest_plan_passes(self):
        with h5py.File(PLANS) as file:
            contacts = file["plans"][PLAN]["grasp/contacts"]
            self.assertGreaterEqual(len(contacts["tip"]), 2)
            self.assertGreater(file["plans"][PLAN]["grasp/quality"].attrs["epsilon_lower"], 0)
        self.forge("nothing", lambda plan: None, lambda found: self.assertEqual(found, set()))
        self.verify_all()

    def test_where_and_how_the_hand_is(self):
        def of(name):
            return lambda plan, where=0, by=1e-5: add(plan["grasp"][name], where, by)
        for name, where in (("object_pose", (0, 3)), ("palm_pose_in_object", (1, 3)),
                            ("palm_pose_in_object", (0, 0)), ("tips_in_object", (0, 1)),
                            ("grasp_posture", 3), ("pregrasp_posture", 8)):
            self.finds("grasp", name, lambda plan: of(name)(plan, where))

        def from_elsewhere(plan):
            direction = plan["grasp"].attrs["approach_direction"]
            plan["grasp"].attrs["approach_direction"] = direction[[1, 2, 0]]
        self.finds("grasp", "approach_direction", from_elsewhere, nothing_else=True)

        def one_later(plan):
            plan["grasp"].attrs.modify("sample", plan["grasp"].attrs["sample"] + 1)
        self.finds("grasp", "sample", one_later, nothing_else=True)

        def not_widest(plan):  # a posture of the trajectory, but the hand was wider open
            plan["grasp/pregrasp_posture"][...] = plan["grasp/grasp_posture"][()]
        self.finds("grasp", "pregrasp_posture", not_widest, nothing_else=True)
        self.verify_all()

    def test_contacts(self):
        tip = "thumb_tip"

        def off_the_surface(plan):
            where = plan["grasp/contacts/normal"][0]
            add(plan["grasp/contacts/point"], 0, -2e-5 * where)
        self.finds("contact", f"{tip}/point", off_the_surface)

        def along_the_surface(plan):  # along the cylinder's axis, by more than what cannot be told
            add(plan["grasp/contacts/point"], (0, 2), 1e-4)
        self.finds("contact", f"{tip}/pad", along_the_surface)

        def flipped(plan):
            plan["grasp/contacts/normal"][0] = -plan["grasp/contacts/normal"][0]
        self.finds("contact", f"{tip}/normal", flipped)

        def turned(plan):
            x, y, z = plan["grasp/contacts/normal"][0]
            a = 0.005
            plan["grasp/contacts/normal"][0] = [np.cos(a) * x - np.sin(a) * y,
                                                np.sin(a) * x + np.cos(a) * y, z]
        self.finds("contact", f"{tip}/normal", turned)

        def longer(plan):
            plan["grasp/contacts/normal"][0] = 1.001 * plan["grasp/contacts/normal"][0]
        self.finds("contact", f"{tip}/normal", longer)

        for name, change in (("signed_distance", 2e-5), ("pad_angle", 1e-4), ("confidence", 1.0)):
            self.finds("contact", f"{tip}/{name}",
                       lambda plan: add(plan["grasp/contacts"][name], 0, change), nothing_else=True)
        self.finds("contact", f"{tip}/desired_point",
                   lambda plan: add(plan["grasp/contacts/desired_point"], 0, 1e-3), nothing_else=True)

        self.finds("contact", f"{tip}/demonstrated_point",
                   lambda plan: add(plan["grasp/contacts/demonstrated_point"], 0, 1e-3), nothing_else=True)

        def only_near(plan):
            plan["grasp/contacts/state"][0] = "near"
        self.finds("contact", f"{tip}/state", only_near)

        def another_link(plan):
            names = plan["grasp/contacts/link"][()]
            plan["grasp/contacts/link"][0] = names[1]
        self.finds("contact", f"{tip}/link", another_link)

        def none(plan):
            plan["grasp/contacts/point"][0, 0] = np.nan
        self.finds("finite", f"grasp/contacts/{tip}", none)

        def wider(plan):  # the pads sink into the cup by 2 mm, 1 mm is allowed
            plan["scene/cup"].attrs["size"] = plan["scene/cup"].attrs["size"] + [0.002, 0]

        def sinks_in(found):
            deepest = {subject for cause, subject in found if cause == "contact"}
            self.assertTrue(any(subject.endswith("/penetration") for subject in deepest), deepest)
        self.forge("penetration", wider, sinks_in)
        self.verify_all()

    def test_quality(self):
        def of(*names, by):
            return lambda plan: scale(plan["grasp/quality"].attrs, by, *names)
        for name, by in (("friction_coefficient", 1.2), ("torsional_friction", 2), ("mass", 0.5),
                         ("characteristic_length", 1.01), ("available_force", 1.1), ("required_force_worst", 0.9),
                         ("required_force_worst", 1.5), ("required_force_gravity", 0.9), ("required_force_gravity", 1.5)):
            self.finds("quality", name, of(name, by=by))
        both = "epsilon_lower", "epsilon_upper"
        self.finds("quality", "epsilon_lower", of(*both, by=1.1), nothing_else=True)
        self.finds("quality", "epsilon_upper", of(*both, by=0.8), nothing_else=True)
        self.finds("quality", "epsilon", of("epsilon_upper", by=1.5), nothing_else=True)

        def beside(plan):
            centre = plan["grasp/quality"].attrs["centre_of_mass"]
            plan["grasp/quality"].attrs["centre_of_mass"] = centre + [0, 0, 0.001]
        self.finds("quality", "centre_of_mass", beside)
        for name in (*both, "required_force_worst", "required_force_gravity", "available_force", "mass"):
            def none(plan):
                plan["grasp/quality"].attrs[name] = np.nan
            self.forge(f"no {name}", none, lambda found: self.assertTrue(
                {cause for cause, _ in found} & {"quality"}))
        self.verify_all()

    def test_a_quality_that_the_config_was_made_to_agree_with(self):
        """What came out of it stays what it was."""
        plan = self.file["plans"][PLAN]
        config = self.file.attrs["config"]
        self.file.attrs["config"] = np.bytes_(config.replace(b"  friction_coefficient: 0.8", b"  friction_coefficient: 1.6"))
        plan["grasp/quality"].attrs["friction_coefficient"] = 1.6
        self.file.close()
        rows = json.loads(morphe("verify", self.copy, "--json").stdout)["violations"]
        self.assertEqual({row["plan"] for row in rows if row["cause"] not in ("config", "assumption")} - {PLAN}, set())
        found = {row["subject"] for row in rows if row["cause"] == "quality"}
        self.assertIn("required_force_gravity", found)
        self.assertNotIn("friction_coefficient", found)

    def test_squeeze(self):
        tip = "thumb_tip"
        self.finds("grasp_force", "torque", lambda plan: add(plan["grasp/grasp_force/torque"], 8, 1e-4))
        self.finds("grasp_force", "servo_target",
                   lambda plan: add(plan["grasp/grasp_force/servo_target"], 8, 1e-4), nothing_else=True)
        self.finds("grasp_force", "torque", lambda plan: add(plan["grasp/grasp_force/torque"], 0, 1e-3))
        self.finds("grasp_force", "force_balance",
                   lambda plan: add(plan["grasp/contacts/normal_force"], 0, -0.8))
        self.finds("grasp_force", f"{tip}/normal_force", lambda plan: add(plan["grasp/contacts/normal_force"], 0, 1.0))
        self.finds("grasp_force", f"{tip}/normal_force", lambda plan: add(plan["grasp/contacts/normal_force"], 0, -20.0))

        def outside_of_the_cone(plan):
            plan["grasp/contacts/friction_force"][0] = 8 * plan["grasp/contacts/friction_force"][0]
        self.finds("grasp_force", f"{tip}/friction_cone", outside_of_the_cone)

        def along_the_normal(plan):
            add(plan["grasp/contacts/friction_force"], 0, 0.1 * plan["grasp/contacts/normal"][0])
        self.finds("grasp_force", f"{tip}/friction_cone", along_the_normal)

        def left_out(plan):
            del plan["grasp/grasp_force"]
        self.finds("grasp_force", "torque", left_out, nothing_else=True)

        def run_as_a_motion(plan):
            sample = plan["grasp"].attrs["sample"]
            plan["trajectory/position"][sample + 1] = plan["grasp/grasp_force/servo_target"][()]
        self.finds("grasp_force", "trajectory", run_as_a_motion)
        self.verify_all()

    def test_goals_of_pads(self):
        def share(value):
            def change(plan):
                plan["goals/tip_to_pad_share"][0, 0] = value
            return change
        for value in (-0.1, 1.1, np.nan):
            self.finds("structure", "goals/tip_to_pad_share", share(value), nothing_else=True)
        self.verify_all()

    def test_every_number_of_a_grasp_is_held_against_something(self):
        """Any number of grasp/ that is changed by a tenth, or by 0.1, is found."""
        with h5py.File(PLANS) as file:
            grasp = file["plans"][PLAN]["grasp"]
            places = []
            grasp.visititems(lambda name, item: places.append(name)
                             if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" else None)
        self.assertGreaterEqual(len(places), 13)
        for name in places:
            def change(plan):
                values = plan["grasp"][name][()]
                values.reshape(-1)[0] = 1.1 * values.reshape(-1)[0] + 0.1
                plan["grasp"][name][...] = values
            self.forge(name, change, lambda found: self.assertTrue(
                {cause for cause, _ in found} & set(OF_A_GRASP), found))
        self.verify_all()


if __name__ == "__main__":
    main()
