"""make_seeds.py FOLDER: small files to begin from, FOLDER/TARGET/NAME, made of the shipped recordings
and of what the tests of the program write."""
import itertools
import json
import struct
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
DATA = SOURCE / "datasets"
# support.py looks for the program there; nothing here runs it.
sys.argv, ARGUMENTS = [sys.argv[0], "morphe"], sys.argv
sys.path.insert(0, str(SOURCE / "tests/cli"))
import recorded  # noqa: E402
import tracked_hands  # noqa: E402

MOST_BYTES = 30_000  # of a seed
LINES = 14           # of a table


def head(file):
    return "".join(open(file, encoding="utf-8-sig").readlines()[:LINES])[:MOST_BYTES].encode()


def a_hand():
    """Four frames of a hand that hangs still."""
    hand = object.__new__(tracked_hands.Hand)
    hand.time = np.arange(4) / 100
    hand.wrist = np.tile([0.2, 0.3, 0.9], (4, 1))
    hand.turn = np.tile(np.eye(3), (4, 1, 1))
    hand.palm = hand.turn @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])
    hand.angles = np.full((4, 32), 0.1)
    hand.in_palm = tracked_hands.fingers_in_palm(hand.angles)
    hand.joints = np.einsum("nij,nkj->nki", hand.palm, hand.in_palm) + hand.wrist[:, None]
    hand.tips = hand.joints[:, 4::4]
    hand.handle = np.tile([0.3, 0.4, 0.8], (4, 1))
    return hand


def bvh():
    """A skeleton with three of its frames."""
    lines = next((DATA / "pybvh").glob("*.bvh")).read_text().splitlines()
    motion = next(k for k, line in enumerate(lines) if line.startswith("MOTION"))
    return "\n".join(lines[:motion + 1] + ["Frames: 3"] + lines[motion + 2:motion + 6]).encode()


def clip():
    time = np.arange(3) / 30
    joints = np.random.default_rng(1).normal(size=(3, 21, 3)).astype("f4")
    with tempfile.NamedTemporaryFile(suffix=".npz") as file:
        np.savez(file, times=time, right_hand_joints=joints, object_cup_position=np.zeros((3, 3)))
        file.flush()
        return Path(file.name).read_bytes()


def tetrahedron():
    return [((0, 0, 0), (1, 0, 0), (0, 1, 0)), ((0, 0, 0), (1, 0, 0), (0, 0, 1)),
            ((0, 0, 0), (0, 1, 0), (0, 0, 1)), ((1, 0, 0), (0, 1, 0), (0, 0, 1))]


def meshes():
    text = "solid t\n" + "".join(
        "facet normal 0 0 1\nouter loop\n" + "".join("vertex %g %g %g\n" % p for p in t)
        + "endloop\nendfacet\n" for t in tetrahedron()) + "endsolid t\n"
    binary = b"\0" * 80 + struct.pack("<I", 4) + b"".join(
        struct.pack("<12fH", 0, 0, 1, *itertools.chain(*t), 0) for t in tetrahedron())
    yield "stl", "text", text.encode()
    yield "stl", "binary", binary
    yield "mesh-obj", "obj", b"o t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1/1 2/2 4/3\nf -1 -2 -3\nf 2 3 4\n"
    geometry = ('<source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>'
                '<accessor source="#a" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>'
                '<param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input '
                'semantic="POSITION" source="#p"/></vertices><triangles count="1"><input semantic="VERTEX" source="#v" '
                'offset="0"/><p>0 1 2</p></triangles>')
    yield "mesh-dae", "dae", (
        '<COLLADA version="1.4.1"><asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset><library_geometries>'
        f'<geometry id="g"><mesh>{geometry}</mesh></geometry></library_geometries><library_visual_scenes>'
        '<visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>'
        '<scene><instance_visual_scene url="#s"/></scene></COLLADA>').encode()
    yield "mesh-gltf", "gltf", json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + "A" * 48}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}]}).encode()


def texts():
    for name in ("configs/pipelines/pa10_dlr_hit2.yaml", "configs/scenes/post_on_the_table.yaml",
                 "datasets/pyomeca/recordings.yaml"):
        yield "yaml", Path(name).stem, (SOURCE / name).read_bytes()
    yield "yaml", "aliases", b"a: &a {b: 1, c: [x, 177 deg, .inf]}\nd: *a\n'e f': |\n  text\n"
    yield "set", "value", b"map.starts=4"
    yield "set", "list", b"map.natural_posture=[{joint: a, value: 10 deg}]"
    for name in ("pa10", "arm21", "dlr_hit2"):
        yield "robot", name, (SOURCE / f"configs/robots/{name}.yaml").read_bytes()
    yield "urdf", "panda", (DATA / "motionbenchmaker/panda_spherized.urdf").read_bytes()[:MOST_BYTES]
    yield "urdf", "two", (
        b'<robot name="r"><link name="a"><collision><origin xyz="0 0 1" rpy="0 0 1"/><geometry><cylinder radius="0.1" '
        b'length="1"/></geometry></collision></link><link name="b"/><joint name="j" type="revolute"><parent link="a"/>'
        b'<child link="b"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="2" effort="1"/><mimic joint="j" '
        b'multiplier="2"/></joint></robot>')
    for name in ("06_joints_in_one_body", "17_held_and_nonlinear", "19_fromto", "26_hand"):
        yield "mjcf", name, (SOURCE / f"tests/data/mjcf/{name}.xml").read_bytes()
    for name in ("box_panda/scene0001", "cage_panda/scene0002"):
        yield "moveit", Path(name).stem, (DATA / f"motionbenchmaker/{name}.yaml").read_bytes()
    for name in ("pyomeca", "kineticstoolkit", "ue-adl"):
        yield "manifest", name, (DATA / f"{name}/recordings.yaml").read_bytes()


def recordings():
    yield "vicon-csv", "csv", head(DATA / "ue-adl/ADL001AR1.csv")
    yield "trc", "trc", head(DATA / "pyomeca/markers.trc")
    yield "mot", "mot", head(DATA / "pyomeca/inverse_kin.mot")
    yield "adroit-csv", "csv", head(next((DATA / "adroit-dapg").glob("*.csv")))
    yield "optitrack-csv", "csv", head(DATA / "optitrack/cmu_take.csv")
    yield "aria-csv", "csv", head(next((DATA / "aria").rglob("hand_tracking_results*.csv")))
    yield "point-csv", "csv", head(DATA / "pyomeca/markers.csv")
    yield "bvh", "bvh", bvh()
    some = recorded.recorded_from_csv(DATA / "ue-adl/ADL001AR1.csv")
    few = recorded.Recorded(some.names[:6], some.position[:8, :6])
    yield "qualisys-tsv", "tsv", recorded.qualisys_tsv(few).encode()
    yield "c3d", "c3d", recorded.c3d_bytes(few, "mm", 100, 2)
    yield "clip-npz", "npz", clip()
    yield "keypoints-csv", "csv", (",".join(
        ["time_s"] + [f"{axis}{k}" for k in range(21) for axis in "xyz"]) + "\n"
        + "\n".join(",".join([str(t)] + ["0.1"] * 63) for t in (0, 0.1))).encode()
    yield "liberty-csv", "csv", (",".join(
        ["time_s"] + [f"{s}_{c}" for s in ("shoulder", "elbow", "wrist")
                      for c in ("x_m", "y_m", "z_m", "qw", "qx", "qy", "qz")]) + "\n"
        + "\n".join(",".join([str(t)] + ["0.1", "0.2", "0.3", "1", "0", "0", "0"] * 3) for t in (0, 0.1))).encode()
    hand = a_hand()
    for name in ("hot3d", "mvnx", "manus", "avp_jsonl", "avp_npz", "egodex"):
        with tempfile.TemporaryDirectory() as folder:
            file = getattr(tracked_hands, f"write_{name}")(hand, Path(folder))
            target = {"manus": "manus-csv", "egodex": "egodex-hdf5"}.get(name, name.replace("_", "-"))
            yield target, Path(file).suffix[1:], Path(file).read_bytes()


def stores():
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "d.h5"
        with h5py.File(file, "w") as h5:
            h5.attrs["format"] = "morphe-demonstrations"
            h5.attrs["version"] = np.int32(2)
            h5.create_group("demonstrations/a")
        yield "demonstrations", "empty", file.read_bytes()
        with h5py.File(file, "w") as h5:
            h5.attrs["format"] = "morphe-plans"
            h5.attrs["version"] = np.int32(2)
            h5.create_group("plans")
            h5.create_group("robot/frames")["parent"] = np.arange(3)
        yield "plans", "empty", file.read_bytes()
    yield "verify", "one", struct.pack("<Hd", 30, 0.5)
    yield "verify", "time", struct.pack("<HdHd", 20, 1e12, 40, float("nan"))
    yield "bytes", "attribute", struct.pack("<Q", 4) + b"name" + struct.pack("<Q", 5) + b"three"


def main():
    folder = Path(ARGUMENTS[1])
    found = itertools.chain(meshes(), texts(), (("import-" + t, n, b) for t, n, b in recordings()), stores())
    total = 0
    for target, name, data in found:
        (folder / target).mkdir(parents=True, exist_ok=True)
        (folder / target / name).write_bytes(data)
        total += len(data)
    assert total < 2_000_000, total


main()
