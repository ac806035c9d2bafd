"""Reads groups of an HDF5 file. Each error names the file and the path in it.

Links to other files, and datasets whose values are in other files, are refused: a plans.h5 has none.
"""
from __future__ import annotations

import dataclasses
import typing
from typing import Any, NoReturn, TypeVar

import h5py
import numpy as np
import numpy.typing as npt

from .errors import FileError

Floats = npt.NDArray[np.float64]
Row = TypeVar("Row")
#: Stands for "an error if it is missing".
REQUIRED: Any = object()


def _dataclass(row: type[Any]) -> Any:
    """Returns a dataclass as one of which mypy does not ask whether it is one: TypeVars have no bound for it."""
    return row


class Node:
    """A group, and what is read from it."""

    def __init__(self, file: str, group: Any) -> None:
        self.file = file
        self._group = group

    def fail(self, name: str, problem: str) -> NoReturn:
        """Raises FileError for a member, or for an attribute if the name begins with @."""
        group = str(self._group.name)
        separator = "" if name.startswith("@") or group.endswith("/") else "/"
        raise FileError(self.file, group + separator + name, problem)

    def names(self) -> tuple[str, ...]:
        """Returns the names of the members, in the order in which they were written."""
        return tuple(str(name) for name in self._group)

    def has(self, name: str) -> bool:
        return name in self._group

    def _member(self, name: str, kind: Any, words: str) -> Any:
        if self._group.get(name, getlink=True) is None:
            self.fail(name, "is missing")
        if not isinstance(self._group.get(name, getlink=True), h5py.HardLink):
            self.fail(name, "is a link, which a plans.h5 does not have")
        try:
            member = self._group[name]
        except (OSError, KeyError, RuntimeError) as error:
            self.fail(name, f"cannot be read ({error})")
        if not isinstance(member, kind):
            self.fail(name, f"is not a {words}")
        return member

    def group(self, name: str) -> Node:
        return Node(self.file, self._member(name, h5py.Group, "group"))

    def _values(self, name: str) -> Any:
        dataset = self._member(name, h5py.Dataset, "dataset")
        if dataset.external or dataset.is_virtual:
            self.fail(name, "has its values in another file")
        try:
            return dataset[()]
        except (OSError, RuntimeError, ValueError, TypeError) as error:
            self.fail(name, f"cannot be read ({error})")

    def array(self, name: str, *shape: int) -> Floats:
        """Returns numbers; -1 in `shape` stands for any length."""
        found = np.asarray(self._values(name))
        if found.dtype.kind not in "fiu":
            self.fail(name, "does not contain numbers")
        if len(shape) != found.ndim or any(want not in (-1, have) for want, have in zip(shape, found.shape)):
            wanted = ", ".join("any" if n < 0 else str(n) for n in shape)
            self.fail(name, f"has the shape {list(found.shape)}, not [{wanted}]")
        return found.astype(np.float64)

    def integers(self, name: str, count: int = -1) -> tuple[int, ...]:
        found = self.array(name, count)
        if not np.all(found == np.rint(found)):
            self.fail(name, "does not contain whole numbers")
        return tuple(int(value) for value in found)

    def texts(self, name: str, count: int = -1) -> tuple[str, ...]:
        found = np.asarray(self._values(name))
        if found.ndim != 1 or (count >= 0 and len(found) != count):
            self.fail(name, f"has the shape {list(found.shape)}, not [{'any' if count < 0 else count}]")
        return tuple(self._decoded(name, value) for value in found.tolist())

    def content(self, name: str) -> bytes:
        """Returns the bytes of a stored file: a text, or numbers of 8 bits."""
        found = self._values(name)
        return found if isinstance(found, bytes) else np.asarray(found, dtype=np.uint8).tobytes()

    def words(self, name: str, count: int) -> tuple[str, ...]:
        """Returns the words of numbers whose attribute `meaning` is a list such as 0=rest,1=reach."""
        dataset = self._member(name, h5py.Dataset, "dataset")
        listed = Node(self.file, dataset).text("meaning")
        by_number = {number: word for number, _, word in (pair.partition("=") for pair in listed.split(","))}
        numbers = self.integers(name, count)
        for number in numbers:
            if str(number) not in by_number:
                self.fail(name, f"has the value {number}, which its attribute 'meaning' does not explain")
        return tuple(by_number[str(number)] for number in numbers)

    def _decoded(self, name: str, value: object) -> str:
        if isinstance(value, bytes):
            try:
                return value.decode()
            except UnicodeDecodeError:
                self.fail(name, "is not UTF-8")
        if not isinstance(value, str):
            self.fail(name, "is not a text")
        return value

    def _attribute(self, name: str, default: Any) -> Any:
        if name not in self._group.attrs:
            if default is REQUIRED:
                self.fail("@" + name, "is missing")
            return default
        try:
            return self._group.attrs[name]
        except (OSError, RuntimeError, TypeError, ValueError) as error:
            self.fail("@" + name, f"cannot be read ({error})")

    def text(self, name: str, default: Any = REQUIRED) -> str:
        """Returns an attribute that is a text."""
        return self._decoded("@" + name, self._attribute(name, default))

    def number(self, name: str, default: Any = REQUIRED) -> float:
        """Returns an attribute that is a number."""
        found = self._attribute(name, default)
        if np.ndim(found) or not isinstance(found, (int, float, np.number)):
            self.fail("@" + name, "is not a number")
        return float(found)

    def vector(self, name: str, default: Any = REQUIRED) -> Floats:
        """Returns an attribute that is a list of numbers."""
        found = np.asarray(self._attribute(name, default))
        if found.ndim != 1 or found.dtype.kind not in "fiu":
            self.fail("@" + name, "is not a list of numbers")
        return found.astype(np.float64)

    def rows(self, row: type[Row]) -> tuple[Row, ...]:
        """Returns the columns of this group as rows: one dataset for each field of a dataclass. Fields of
        the type array hold the rest of the dimensions; fields with a default may be absent."""
        hints = typing.get_type_hints(row)
        columns: dict[str, Any] = {}
        count = -1
        for field in dataclasses.fields(_dataclass(row)):
            if not self.has(field.name) and field.default is not dataclasses.MISSING:
                continue
            column: Any
            if hints[field.name] is str:
                column = self.texts(field.name, count)
            elif hints[field.name] is float:
                column = self.array(field.name, count).tolist()
            elif hints[field.name] is int:
                column = self.integers(field.name, count)
            else:
                column = self.array(field.name, count, -1)
            columns[field.name], count = column, len(column)
        return tuple(row(**dict(zip(columns, values))) for values in zip(*columns.values()))

    def figures(self, row: type[Row], default: Any = REQUIRED, **given: object) -> Row:
        """Returns a dataclass with an attribute of this group for each of its fields that is not given."""
        hints = typing.get_type_hints(row)
        values = dict(given)
        for field in dataclasses.fields(_dataclass(row)):
            if field.name not in given:
                value: object = (self.number(field.name, default) if hints[field.name] is float
                                 else self.vector(field.name, default))
                values[field.name] = value
        return row(**values)
