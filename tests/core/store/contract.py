"""What check_*.py share: compares an open file with a table of what docs/formats.md promises."""
import h5py


def text(attribute):
    """A string attribute, or a list of strings, as str."""
    return attribute.decode() if isinstance(attribute, bytes) else [t.decode() for t in attribute]


def shapes(group, expected):
    """expected: {path: (shape, dtype kind, unit, frame or None)}; nothing more, nothing less."""
    found = {}
    group.visititems(lambda name, item: found.update({name: item})
                     if isinstance(item, h5py.Dataset) else None)
    assert set(found) == set(expected), sorted(set(found) ^ set(expected))
    for name, (shape, kind, unit, frame) in expected.items():
        data = found[name]
        assert data.shape == shape, (name, data.shape)
        assert data.dtype.kind == kind, (name, data.dtype)
        assert data.dtype != "f4"
        assert text(data.attrs["unit"]) == unit, (name, data.attrs["unit"])
        assert ("frame" in data.attrs) == (frame is not None), name
        assert frame is None or text(data.attrs["frame"]) == frame, (name, data.attrs["frame"])
        assert data.size == 0 or data.fletcher32, name


def attributes(group, names):
    assert set(group.attrs) == set(names), (group.name, sorted(set(group.attrs) ^ set(names)))


def flags(count):
    """flags/ of a demonstration or a plan."""
    return {**{f"flags/{name}": ((count,), "S", "", None) for name in ("code", "response", "subject", "unit", "text")},
            **{f"flags/{name}": ((count,), "f", "s", None) for name in ("begin_s", "end_s")},
            **{f"flags/{name}": ((count,), "f", "unit of the row", None) for name in ("value", "limit")}}


def assumptions(count):
    """assumptions/ of a file, a demonstration or a plan."""
    return {f"assumptions/{name}": ((count,), "S", "", None) for name in ("kind", "subject", "value")}
