"""Asks the program whether a plans.h5 is true. This package judges nothing itself."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
from dataclasses import dataclass
from typing import Any, Optional, Union

from .errors import Error, VerifyError
from .plans import plans_file

Path = Union[str, "os.PathLike[str]"]


@dataclass(frozen=True)
class Verdict:
    """How many plans `morphe verify` accepted, by status."""

    executable: int
    approximate: int
    partial: int
    infeasible: int


def verify(path: Path, *, dataset: Optional[Path] = None, program: Optional[Path] = None) -> Verdict:
    """Runs `morphe verify` on a plans.h5 or the folder of a run, with `dataset` (demonstrations.h5) also against
    the recordings. The program is `program`, or else the environment's MORPHE, or `morphe` in PATH.

    Raises VerifyError with the first violation; Error if the program is not found or cannot read the file.
    """
    file = plans_file(path)
    wanted = str(program or os.environ.get("MORPHE") or "morphe")
    command = shutil.which(wanted)
    if command is None:
        raise Error(f"{wanted}: no such program, so nothing was verified: install Morphe, or name its program by "
                    "verify(..., program=PATH) or MORPHE=PATH")
    words = ["--dataset", os.fspath(dataset)] if dataset is not None else []
    done = subprocess.run([command, "verify", str(file), "--json", *words], capture_output=True, text=True, check=False)
    try:
        said: dict[str, Any] = json.loads(done.stdout)
        violations: list[dict[str, Any]] = said["violations"]
        counts = {name: int(said[name]) for name in ("executable", "approximate", "partial", "infeasible")}
    except (ValueError, KeyError, TypeError):
        raise Error(done.stderr.strip() or f"{command} verify: exit code {done.returncode}, without a verdict") from None
    if violations:
        raise VerifyError(f"{file}: {_sentence(violations[0])}; {len(violations)} in all", violations)
    if done.returncode != 0:
        raise Error(f"{command} verify: exit code {done.returncode}, though it found no violation")
    return Verdict(**counts)


def _sentence(violation: dict[str, Any]) -> str:
    where = f"{violation['plan']}: " if violation.get("plan") else ""
    return (f"{where}{violation['cause']} of {violation['subject']} at {violation['time_s']} s is {violation['value']}, "
            f"limit {violation['limit']}")
