"""A plans.h5, plan by plan."""
from __future__ import annotations

import difflib
import os
from pathlib import Path
from types import TracebackType
from typing import Callable, Collection, Iterator, Optional, Union

import h5py

from .errors import FileError
from .hdf5 import Node
from .plan import STATUSES, Plan
from .read_plan import read_assumptions, read_plan, read_status
from .robot import read_robot

FORMAT, VERSION = "morphe-plans", 3
Words = Union[str, Collection[str], None]


class Plans:
    """An open plans.h5. Plans are read one at a time, as a file may hold very many.

    It believes the file: it checks that the form is that of a plans.h5, never whether what is said is true.
    Run `morphe verify` or morphe.verify(path) before anything moves.
    """

    def __init__(self, path: Union[str, os.PathLike[str]]) -> None:
        """Opens a plans.h5, or that of a run's folder. Raises FileError."""
        self.path = plans_file(path)
        try:
            self._file = h5py.File(self.path, "r")
        except OSError as error:
            raise FileError(str(self.path), "", f"is not a readable HDF5 file ({error})") from None
        try:
            self._root = Node(str(self.path), self._file)
            self._read_header()
        except BaseException:
            self._file.close()
            raise

    def _read_header(self) -> None:
        root = self._root
        found = root.text("format", "")
        if found != FORMAT:
            root.fail("@format", f"is '{found}', not '{FORMAT}': this is no plans.h5")
        version = root.number("version")
        if version != VERSION:
            root.fail("@version", f"is {version:g}, but this package reads version {VERSION}: use the package of the "
                                  "Morphe that wrote the file, or plan again")
        self.software = root.text("software")
        self.config = root.text("config")  #: the effective YAML
        self.config_sha256 = root.text("config_sha256")
        self.dataset_sha256 = root.text("dataset_sha256")
        self.inputs_sha256 = root.text("inputs_sha256", "")
        self.settings = tuple(root.text("settings", "").splitlines())
        self.robot = read_robot(root.group("robot"))
        self.assumptions = read_assumptions(root)
        demonstrations = root.group("plans")
        self.names = tuple(f"{demonstration}/{movement}" for demonstration in demonstrations.names()
                           for movement in demonstrations.group(demonstration).names())

    def close(self) -> None:
        self._file.close()

    def __enter__(self) -> Plans:
        return self

    def __exit__(self, kind: Optional[type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.close()

    def __len__(self) -> int:
        return len(self.names)

    def __iter__(self) -> Iterator[Plan]:
        return (self[name] for name in self.names)

    def __getitem__(self, plan: Union[str, int]) -> Plan:
        """Reads a plan by its name (`drink/000`) or its number in the file."""
        name = self.names[plan] if isinstance(plan, int) else plan
        if name not in self.names:
            near = difflib.get_close_matches(name, self.names, 1)
            raise KeyError(f"{self.path} has no plan '{name}'" + (f"; did you mean '{near[0]}'?" if near else ""))
        return read_plan(self._plan_node(name), name, self.robot, self.assumptions)

    def select(self, *, status: Words = None, reason: Words = None, demonstration: Words = None, subject: Words = None,
               task: Words = None, target: Words = None, where: Optional[Callable[[Plan], bool]] = None) -> Iterator[Plan]:
        """Reads the plans that have one of the words in each of the filters that are given, and of which `where`
        is true. Others are not read beyond their attributes."""
        for word in _words(status):
            if word not in STATUSES:
                raise ValueError(f"unknown status '{word}'; the statuses are {', '.join(STATUSES)}")
        asked = {"status": status, "reason": reason, "subject": subject, "task": task, "target": target}
        return self._selected(demonstration, {key: words for key, words in asked.items() if words is not None}, where)

    def _selected(self, demonstration: Words, asked: dict[str, Words], where: Optional[Callable[[Plan], bool]]) -> Iterator[Plan]:
        for name in self.names:
            if demonstration is not None and name.split("/")[0] not in _words(demonstration):
                continue
            node = self._plan_node(name)
            read_status(node)
            if all(node.text(key) in _words(words) for key, words in asked.items()):
                plan = self[name]
                if where is None or where(plan):
                    yield plan

    def inputs(self) -> tuple[str, ...]:
        """Returns the names of the files from which the plans were made: config, robot, scene, meshes."""
        found: list[str] = []
        if self._root.has("inputs"):
            self._file["inputs"].visititems(lambda name, item: found.append(name) if isinstance(item, h5py.Dataset) else None)
        return tuple(found)

    def read_input(self, name: str) -> bytes:
        """Returns the bytes of one of them."""
        *folders, file = name.split("/")
        node = self._root.group("inputs")
        for folder in folders:
            node = node.group(folder)
        return node.content(file)

    def _plan_node(self, name: str) -> Node:
        demonstration, movement = name.split("/")
        return self._root.group("plans").group(demonstration).group(movement)


def plans_file(path: Union[str, os.PathLike[str]]) -> Path:
    """Returns the plans.h5 that a path names: itself, or that in the folder of a run. Raises FileError."""
    file = Path(path)
    if file.is_dir():
        file = file / "plans.h5"
    if not file.exists():
        raise FileError(str(file), "", "does not exist")
    return file


def _words(words: Words) -> Collection[str]:
    return () if words is None else (words,) if isinstance(words, str) else words
