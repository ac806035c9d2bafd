"""Reads the plans that Morphe writes (plans.h5) with NumPy and h5py alone.

    import morphe

    morphe.verify("outputs/first")  # the program's judgement; this package has none of its own
    with morphe.Plans("outputs/first") as plans:
        for plan in plans.select(status="executable"):
            state = plan.at(0.5)  # position, velocity, acceleration, jerk of the certified curve

Units are m, s and rad, poses 4x4 matrices in the robot's base frame. Reading is not judging: a file that is
read without an error may still be false. docs/python.md explains the package, docs/formats.md the file.
"""
from .errors import Error, FileError, NoTrajectoryError, VerifyError
from .judge import Verdict, verify
from .motion import Motion, State
from .plan import (ASSUMPTION_KINDS, STATUSES, Assumption, Certificate, Contact, Finding, Goals, Grasp, KindClearance,
                   Phase, Plan, Quality, SceneObject)
from .plans import Plans
from .plotting import plot
from .robot import Frame, Joint, Robot, Tip

__version__ = "0.1.0"
__all__ = [
    "ASSUMPTION_KINDS", "STATUSES", "Assumption", "Certificate", "Contact", "Error", "FileError", "Finding", "Frame", "Goals",
    "Grasp", "Joint", "KindClearance", "Motion", "NoTrajectoryError", "Phase", "Plan", "Plans", "Quality", "Robot",
    "SceneObject", "State", "Tip", "Verdict", "VerifyError", "plot", "verify",
]
