"""The verdicts of the study: the answer to a damaged recording against that to the undamaged one."""
import hashlib
import re
from dataclasses import dataclass

import numpy as np

from answers import BRANCHES, JOINT_RAD, POINT_M, QUICK, TIP_M, ask_take, compare_plans, points_apart
from damages import Moments, NotApplicable, Patient
from take import Roles

NEAR_S = 0.2    # a flag names a damage that is this near
WRONG_M = 0.01  # points that were mended and are farther from where they were are wrong


@dataclass
class Verdict:
    recording: str
    damage: str
    verdict: str
    remark: str = ""
    tips_mm: float = 0.0
    joints_rad: float = 0.0


@dataclass
class Case:
    """A damaged recording."""
    recording: object
    damage: object
    damaged: object  # its take
    folder: object

    def verdict(self, word, remark="", difference=("", 0.0, 0.0)):
        return Verdict(self.recording.name, self.damage.name, word, remark,
                       round(1000 * difference[1], 2), round(difference[2], 3))


class Study:
    """The undamaged plans of the recordings, and what is asked of Morphe."""

    def __init__(self, morphe, folder):
        self.morphe, self.folder, self.known = morphe, folder, {}

    def healthy(self, recording, search=QUICK):
        key = recording.name, search
        if key not in self.known:
            folder = self.folder / recording.name / f"undamaged_{search[0]}"
            self.known[key] = ask_take(self.morphe, recording.config, recording.take, folder, search)
        return self.known[key]

    def difference(self, case, answer):
        """(words, tips [m], joints [rad]) from the nearest of the undamaged plans."""
        first = compare_plans(answer, self.healthy(case.recording))
        if first[0] or first[1] > TIP_M or first[2] <= JOINT_RAD:
            return first
        pairs = [first]
        for search in BRANCHES:
            again = self.ask(case, search)
            pairs += [compare_plans(again, self.healthy(case.recording, other)) for other in BRANCHES]
        return min((pair for pair in pairs if not pair[0]), key=lambda pair: pair[2])

    def moments(self, recording):
        movements, rate = self.healthy(recording).movements, recording.take.rate
        count = len(recording.take.position)
        if not movements or np.isnan([*movements[0].limits, movements[0].grasp_s]).any():
            return Moments(*(int(share * count) for share in (0.25, 0.4, 0.55, 0.7)))
        (begin, end), grasp = movements[0].limits, movements[0].grasp_s
        return Moments(*(min(count - 2, round(t * rate)) for t in (begin, (begin + grasp) / 2, grasp, end)))

    def patient(self, recording, damage):
        key = f"{recording.name} {damage.name}".encode()
        return Patient(recording.take.copy(), Roles(recording.take), self.moments(recording),
                       np.random.default_rng(list(hashlib.sha256(key).digest()[:8])), recording.other_static)

    def judge(self, recording, damage):
        """The verdict; None if the recording lacks what the damage changes."""
        patient = self.patient(recording, damage)
        try:
            damage.apply(patient)
        except NotApplicable:
            return None
        case = Case(recording, damage, patient.take, self.folder / recording.name / damage.name)
        healthy = self.healthy(recording)
        if damage.exact:  # the import alone is sooner
            answer = self.ask(case, planned=False)
            flags = fitting_flags(case, answer, healthy)
            if is_mended(flags) and points_apart(answer, healthy) <= POINT_M:
                return case.verdict("mended", flags[0].text)
        answer = self.ask(case)
        return self.stated(case, answer, healthy) or self.unstated(case, answer, healthy)

    def ask(self, case, search=QUICK, planned=True):
        folder = case.folder if search == QUICK else case.folder.with_name(f"{case.folder.name}_{search[0]}")
        return ask_take(self.morphe, case.recording.config, case.damaged, folder, search, planned)

    def stated(self, case, answer, healthy):
        """The verdict on a damage that a question, a flag or a message names; otherwise None."""
        if answer.asked & set(case.damage.asks):
            return case.verdict("asked", ", ".join(sorted(answer.asked)))
        flags = fitting_flags(case, answer, healthy)
        if is_mended(flags):
            return self.mended(case, answer, healthy, flags)
        if flags:
            return case.verdict("noticed", flags[0].text)
        new = [line for line in answer.messages() if line not in healthy.messages()]
        lines = [line for line in new if case.damage.told and re.search(case.damage.told, line)]
        return case.verdict("told", lines[0]) if lines else None

    def mended(self, case, answer, healthy, flags):
        apart = points_apart(answer, healthy)
        if apart <= POINT_M:
            return case.verdict("mended", flags[0].text)
        difference = self.difference(case, answer)
        if is_harmless(difference):
            return case.verdict("mended", flags[0].text, difference)
        wrong = case.damage.exact or (apart > WRONG_M and all(flag.response == "mended" for flag in flags))
        if not wrong:
            return case.verdict("noticed", flags[0].text, difference)
        return case.verdict("WRONG", f"{flags[0].text}; points {1000 * apart:.1f} mm apart; {difference[0]}", difference)

    def unstated(self, case, answer, healthy):
        if answer.error:
            return case.verdict("SILENT", answer.error.splitlines()[0])
        if not answer.movements and not healthy.movements:
            return case.verdict("unplanned")
        difference = self.difference(case, answer)
        if is_harmless(difference):
            planned = any(len(movement.joints) for movement in answer.movements)
            return case.verdict("harmless" if planned else "unplanned", "", difference)
        if case.damage.undecidable:
            return case.verdict("undecidable", case.damage.undecidable, difference)
        other = ", ".join(sorted({flag.code for flag in new_flags(answer, healthy)}))
        return case.verdict("SILENT", "; ".join(filter(None, [difference[0], other and f"other flags: {other}"])), difference)


def is_harmless(difference):
    words, tips, joints = difference
    return not words and tips <= TIP_M and joints <= JOINT_RAD


def is_mended(flags):
    return any(flag.response == "mended" for flag in flags)


def new_flags(answer, healthy):
    return [flag for flag in answer.flags if not any(flag.resembles(known) for known in healthy.flags)]


def fitting_flags(case, answer, healthy):
    flags = [flag for flag in new_flags(answer, healthy) if flag.code in case.damage.fits]
    if not case.damaged.damaged:
        return flags
    first, last = (row / case.damaged.rate for row in case.damaged.damaged)
    return [flag for flag in flags if flag.overlaps(first - NEAR_S, last + NEAR_S)]
