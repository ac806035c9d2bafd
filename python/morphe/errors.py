"""Exceptions of the package. Each message is one line that says what is wrong and where."""
from __future__ import annotations


class Error(Exception):
    """The base of all exceptions of this package."""


class FileError(Error):
    """A file is missing, is no plans.h5, or lacks what a plans.h5 of this version has."""

    def __init__(self, file: str, path: str, problem: str) -> None:
        super().__init__(f"{file}: {path}: {problem}" if path else f"{file}: {problem}")
        self.file = file
        self.path = path  #: of the dataset, group or attribute (`/plans/drink/000@status`); "": the whole file
        self.problem = problem


class NoTrajectoryError(Error):
    """A curve was asked of a plan that has none."""


class VerifyError(Error):
    """`morphe verify` rejects the file. `violations` has all that it found, as its JSON does."""

    def __init__(self, message: str, violations: list[dict[str, object]]) -> None:
        super().__init__(message)
        self.violations = violations
