"""Several things in one recording: a synthetic person with a known truth puts one cup aside, then another,
without going home in between; and pours."""
import h5py
import numpy as np

from formats import text
from support import QUICK, REFERENCE, CommandCase, json, main, morphe, python_verify
from tracked_hands import quaternions_of, rotation

RATE_HZ, GRASP_S, REACH_S, CARRY_S, RAISED_M = 100, 0.3, 0.9, 1.2, 0.08
# The grasp of ADL001DR2, from which all postures are made: an arm, and a hand around a cup of 77 mm.
SHOULDER, ELBOW, WRIST = np.array([[0.214, -0.257, 0.320], [0.239, -0.177, 0.059], [0.195, 0.073, 0.059]])
THUMB, INDEX = np.array([[-0.053, 0.104, 0.029], [0.029, 0.147, 0.019]])  # from the wrist
PALM = np.array([[0.3356, -0.7111, 0.6178], [0.9106, 0.0769, -0.4061], [0.2412, 0.6988, 0.6734]])
CUP, HOME = np.array([0.0385, 0.10]), np.array([0.04, -0.13, 0.01])
BESIDE = np.array([0, -0.11, 0.05])  # from where a hand goes around a cup


def progress(u):
    u = np.clip(u, 0, 1)
    return u**3 * (10 - 15 * u + 6 * u * u)


class Person:
    """Moves of the hand from its posture at the grasp, one after the other."""

    def __init__(self):
        self.moves, self.turns, self.open, self.now, self.at = [], [], [], 0.6, HOME

    def go(self, to, duration_s):
        self.moves.append((self.now, duration_s, np.subtract(to, self.at)))
        self.now, self.at = self.now + duration_s, np.array(to)

    def leave(self):
        self.go(self.at + BESIDE, 0.6)
        self.now -= 0.25

    def take(self, at):
        """By way of a place beside it; all in one go."""
        if self.open:
            self.leave()
        self.open.append((self.now, 0.4, 0.03))
        self.go(np.add(at, BESIDE), REACH_S)
        self.now -= 0.3
        self.go(at, 0.6)
        self.open.append((self.now - 0.2, 0.2, -0.03))
        self.now += GRASP_S
        return self.now

    def put(self, to):
        self.moves += [(self.now, CARRY_S / 2, np.array([0, 0, RAISED_M])),
                       (self.now + CARRY_S / 2, CARRY_S / 2, np.array([0, 0, -RAISED_M]))]
        self.go(to, CARRY_S)
        put_down = self.now
        self.now += 0.15
        self.open.append((self.now, 0.2, 0.03))
        self.now += 0.25
        return put_down

    def finish(self):
        self.leave()
        self.open.append((self.now + 0.4, 0.4, -0.03))
        self.go(HOME, REACH_S)
        self.time = np.arange(0, self.now + 0.6, 1 / RATE_HZ)
        steps = lambda rows, width: sum((progress((self.time - begin) / length)[:, None] * np.reshape(by, (1, width))
                                         for begin, length, by in rows), np.zeros((len(self.time), width)))
        self.wrist = WRIST + HOME + steps(self.moves, 3)
        self.opening, self.turn = steps(self.open, 1), steps(self.turns, 1)[:, 0]
        return self

    def pose(self):
        """The rotation of hand and cup about the axis between the tips' middle and the person's right."""
        return rotation((0, 1, 0), self.turn)

    def clip(self, file, **objects):
        turned = self.pose()
        middle, side = (THUMB + INDEX) / 2, (INDEX - THUMB) / np.linalg.norm(INDEX - THUMB)
        centre = self.wrist + middle
        place = lambda point: centre + (turned @ (point - middle)[:, :, None])[:, :, 0]
        wrist = place(np.zeros((len(self.time), 3)))
        joints = np.full((len(self.time), 21, 3), np.nan)
        joints[:, 0] = wrist
        joints[:, 4], joints[:, 8] = place(THUMB - self.opening / 2 * side), place(INDEX + self.opening / 2 * side)
        left, _, right = np.linalg.svd(PALM)
        palm = left @ right
        rotations = np.full((len(self.time), 3, 4), np.nan)
        rotations[:, 2] = quaternions_of(turned @ palm)
        body = np.stack([np.broadcast_to(SHOULDER, wrist.shape), self.elbow(wrist), wrist], 1)
        np.savez(file, times=self.time, rebuilt=1.0, axes="x y z", unit="m", hand="right", subject="person",
                 joint_order="openpose", mano_right_joints=joints, mano_right_wrist_pos=wrist,
                 body_joints=body, body_rotations=rotations,
                 body_joint_names=["right_shoulder", "right_elbow", "right_hand"], **objects)
        return file

    @staticmethod
    def elbow(wrist):
        upper, fore = np.linalg.norm(ELBOW - SHOULDER), np.linalg.norm(WRIST - ELBOW)
        way = wrist - SHOULDER
        far = np.linalg.norm(way, axis=1, keepdims=True)
        along = way / far
        foot = (upper**2 - fore**2 + far**2) / (2 * far)
        aside = (ELBOW - SHOULDER) - along * ((ELBOW - SHOULDER) * along).sum(1, keepdims=True)
        return (SHOULDER + foot * along + np.sqrt(np.maximum(upper**2 - foot**2, 0)) * aside
                / np.linalg.norm(aside, axis=1, keepdims=True))

    def cup(self, name, taken, put_down):
        """A cup that is with the hand between two times."""
        held = np.clip(np.round(self.time * RATE_HZ).astype(int), round(taken * RATE_HZ), round(put_down * RATE_HZ))
        pose = np.broadcast_to(np.eye(4), (len(self.time), 4, 4)).copy()
        pose[:, :3, :3] = self.pose()[held]
        pose[:, :3, 3] = (self.wrist + (THUMB + INDEX) / 2)[held]
        return {f"object_{name}_pose": pose, f"object_{name}_shape": "cylinder", f"object_{name}_size": CUP}


class TwoThings(CommandCase):
    def plan(self, clip, *settings):
        out = self.folder / "out"
        self.succeeds("run", REFERENCE, "--dataset", clip, "--out", out, *QUICK, "--set", "retime.sample_rate_hz=50",
                      "--set", "scene.table.height=0.03", *settings)
        own, other = morphe("verify", out, "--json"), python_verify(out / "plans.h5")
        self.assertEqual(json.loads(own.stdout)["violations"], [])
        self.assertEqual(json.loads(other.stdout)["violations"], [])
        return out / "plans.h5"

    def test_two_cups_are_two_movements(self):
        person, first, second = Person(), [0.06, 0, 0], [-0.12, 0.03, 0]
        times = [(person.take(first), person.put([0.14, 0.08, 0])), (person.take(second), person.put([-0.02, 0.10, 0]))]
        person.finish()
        clip = person.clip(self.folder / "two.npz", **person.cup("first", *times[0]), **person.cup("second", *times[1]))
        with h5py.File(self.plan(clip, "--set", "segment.plan_until=return")) as file:
            plans = list(file["plans"]["two"].values())
            self.assertEqual(len(plans), 2)
            for plan, name, (taken, put_down) in zip(plans, ("first", "second"), times):
                self.assertEqual(text(plan.attrs["status"]), "executable", text(plan.attrs["detail"]))
                self.assertEqual(text(plan.attrs["target"]), name)
                cup = plan["scene"][name]
                self.assertAlmostEqual(cup.attrs["attach_s"], taken, delta=0.12)
                self.assertAlmostEqual(cup.attrs["release_s"], put_down, delta=0.12)
                self.assertGreater(plan.attrs["end_s"], put_down + 0.2)
            # The first one rests where it was put while the second is carried.
            other, time = plans[1]["scene/first"], plans[1]["trajectory/demonstration_time"][()]
            self.assertGreater(time[0], times[0][1])
            resting = other["position"][()][other["time"][()] >= times[0][1]]
            self.assertLess(np.ptp(resting, axis=0).max(), 1e-6)
            names = [list(plan["phases/name"].asstr()) for plan in plans]
            self.assertNotIn("home", names[0])
            self.assertIn("home", names[1])


    def test_pouring(self):
        """The cup's tilt is that of its recorded pose; without one, that of the hand."""
        person = Person()
        taken = person.take([0, 0, 0])
        person.moves.append((person.now, 0.8, np.array([0, 0, 0.12])))
        person.turns = [(person.now + 0.8, 0.8, [-1.0]), (person.now + 2.0, 0.8, [1.0])]
        person.moves.append((person.now + 2.8, 0.8, np.array([0, 0, -0.12])))
        person.now += 3.6
        put_down = person.now
        person.now += 0.4
        person.finish()
        for cups in (person.cup("cup", taken, put_down), {}):
            clip = person.clip(self.folder / "pour.npz", **cups)
            with h5py.File(self.plan(clip, "--set", "segment.plan_until=return")) as file:
                plan = file["plans/pour/000"]
                self.assertEqual(text(plan.attrs["status"]), "executable", text(plan.attrs["detail"]))
                base_from_world, cup = plan["reference_frames/recording"][:3, :3], plan["scene/cup"]
                tilts = []
                for w, x, y, z in cup["orientation"][()]:
                    axis = np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])
                    tilts.append(np.degrees(np.arccos(np.clip(base_from_world[:, 2] @ axis, -1, 1))))
                self.assertAlmostEqual(max(tilts), np.degrees(1.0), delta=2)
                self.assertLess(tilts[0], 2)
                self.assertLess(tilts[-1], 2)


if __name__ == "__main__":
    main()
