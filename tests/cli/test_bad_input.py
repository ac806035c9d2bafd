"""Whatever is wrong with what a user gives: exit 2, one line that says where, and nothing left behind
or overwritten."""
import os
import shutil

import h5py

from support import RECORDINGS, SOURCE, CommandCase, line_of, main, morphe, replace

CONFIG = """\
dataset: {file: recordings.yaml}
robot: {file: robots/pa10_dlr_hit2.yaml}
seed: 1
scene:
  file: scenes/bowl.yaml
map:
  natural_posture:
    - {joint: middle_abduction}
    - {joint: ring_abduction}
"""
SCENE = """\
objects:
  - name: bowl
    shape: cylinder
    size: [0.05, 0.06]
    position: [0.5, 0.5, 0.1]
"""
MANIFEST = """\
format: vicon-csv
recordings:
  - {file: forward.csv, name: forward, upper_arm: 0.274, forearm: 0.254}
"""


class RunCase(CommandCase):
    """A folder with a config and all that it names; a test damages one thing."""

    def setUp(self):
        super().setUp()
        (self.folder / "scenes").mkdir()
        shutil.copytree(SOURCE / "configs/robots", self.folder / "robots")
        shutil.copy(RECORDINGS / "ADL001FR1.csv", self.folder / "forward.csv")
        self.config = self.folder / "config.yaml"
        self.scene = self.folder / "scenes/bowl.yaml"
        self.manifest = self.folder / "recordings.yaml"
        self.csv = self.folder / "forward.csv"
        self.robot = self.folder / "robots/pa10.yaml"
        for file, text in ((self.config, CONFIG), (self.scene, SCENE), (self.manifest, MANIFEST)):
            file.write_text(text)

    def run_refuses(self, beginning, *mentioned, arguments=()):
        """Into a folder that is not there, and into one that holds an older result."""
        new, old = self.folder / "results/new", self.folder / "old"
        old.mkdir(exist_ok=True)
        for name in ("plans.h5", "demonstrations.h5"):
            (old / name).write_text("an older result")
        for out in (new, old):
            result = morphe("run", self.config, "--out", out, "--fresh", *arguments)
            self.refuses(result, beginning, *mentioned)
        self.assertFalse(new.parent.exists(), "a folder is left behind")
        self.assertEqual(sorted(os.listdir(old)), ["demonstrations.h5", "plans.h5"])
        for name in ("plans.h5", "demonstrations.h5"):
            self.assertEqual((old / name).read_text(), "an older result")


class Configs(RunCase):
    def test_the_undamaged_config_loads(self):
        replace(self.manifest, r"(?s)recordings:.*", "recordings: []\n")
        self.succeeds("run", self.config, "--out", self.folder / "out")

    def at(self, needle):
        return f"{self.config}:{line_of(self.config, needle)}"

    def test_missing_file(self):
        self.config.unlink()
        self.run_refuses(self.config)

    def test_empty_file(self):
        self.config.write_text("")
        self.run_refuses(self.config)

    def test_unknown_key_at_the_top(self):
        self.config.write_text(CONFIG + "speed: 3\n")
        self.run_refuses(self.at("speed"), "speed: unknown key")

    def test_unknown_key_in_a_section(self):
        replace(self.config, "map:\n", "map:\n  tip_positoin: 3\n")
        self.run_refuses(self.at("positoin"), "map.tip_positoin: unknown key")

    def test_unknown_key_deep_inside(self):
        replace(self.config, "{joint: ring_abduction}", "{joint: ring_abduction, valu: 1}")
        self.run_refuses(self.at("valu"), "map.natural_posture[1].valu: unknown key")

    def test_key_that_stands_twice(self):
        self.config.write_text(CONFIG + "seed: 2\n")
        self.run_refuses(self.at("seed: 2"), "seed: the key appears twice")

    def test_bad_yaml(self):
        replace(self.config, "seed: 1", "seed: [1, 2")
        result = morphe("run", self.config, "--out", self.folder / "out")
        self.assertRegex(result.stderr, rf"^{self.config}:\d+: not valid YAML: .*\n$")
        self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_wrong_type(self):
        replace(self.config, "seed: 1", "seed: first")
        self.run_refuses(self.at("seed"), "seed: ", "'first'")

    def test_no_number(self):
        replace(self.config, "seed: 1", "seed: 1\ncheck: {required_clearance: .nan}")
        self.run_refuses(self.at("required_clearance"), "check.required_clearance: must be a number")

    def test_negative_weight(self):
        replace(self.config, "map:\n", "map:\n  tip_position: -1\n")
        self.run_refuses(self.at("tip_position"), "map.tip_position: must be at least 0 and at most 1e+09, not -1")

    def test_no_robot(self):
        replace(self.config, "robot: .*\n", "")
        self.run_refuses(f"{self.config}:1", "robot: is missing")

    def test_no_dataset(self):
        replace(self.config, "dataset: .*\n", "")
        self.run_refuses(self.config, "dataset: is missing")

    def test_dataset_that_is_not_there(self):
        self.manifest.unlink()
        self.run_refuses(self.manifest)

    def test_unknown_natural_joint(self):
        replace(self.config, "joint: ring_abduction", "joint: sixth_abduction")
        self.run_refuses(self.at("sixth"), "map.natural_posture[1].joint: ", "'sixth_abduction'")

    def test_unknown_joint_to_follow(self):
        replace(self.config, "ring_abduction}", "ring_abduction, follow: tail}")
        self.run_refuses(self.at("tail"), "map.natural_posture[1].follow: ", "'tail'")

    def test_set_an_unknown_key(self):
        self.run_refuses("--set map.speed", "map.speed: unknown key",
                         arguments=["--set", "map.speed=3"])

    def test_set_without_equals(self):
        self.run_refuses("--set seed", arguments=["--set", "seed"])

    def test_set_a_wrong_value(self):
        self.run_refuses("--set seed", "seed: ", "'first'", arguments=["--set", "seed=first"])

    def test_set_below_a_value(self):
        self.run_refuses("--set seed.first", arguments=["--set", "seed.first=1"])

    def test_set_no_robot(self):
        self.run_refuses(self.folder / "robots/none.yaml",
                         arguments=["--set", "robot.file=robots/none.yaml"])


class Robots(RunCase):
    def test_missing_file(self):
        replace(self.config, "pa10_dlr_hit2", "no_such_robot")
        self.run_refuses(self.folder / "robots/no_such_robot.yaml")

    def test_missing_part(self):
        self.robot.unlink()
        self.run_refuses(self.robot)

    def test_missing_limit(self):
        for limit in ("lower", "velocity", "jerk"):
            with self.subTest(limit):
                shutil.copy(SOURCE / "configs/robots/pa10.yaml", self.robot)
                replace(self.robot, rf", {limit}: [^,}}]*", "")
                self.refuses(morphe("run", self.config, "--out", self.folder / "out"),
                             f"{self.robot}:{line_of(self.robot, 'name: S1')}",
                             f"chains[0].joints[0].{limit}: is missing")
                self.assertFalse((self.folder / "out").exists())

    def test_limits_the_wrong_way_round(self):
        replace(self.robot, "lower: -177 deg", "lower: 178 deg")
        self.run_refuses(f"{self.robot}:{line_of(self.robot, 'name: S1')}", "chains[0].joints[0]")

    def test_unknown_key(self):
        replace(self.robot, "name: S1,", "name: S1, colour: red,")
        self.run_refuses(f"{self.robot}:{line_of(self.robot, 'name: S1')}",
                         "chains[0].joints[0].colour: unknown key")


class Scenes(RunCase):
    def at(self, needle):
        return f"{self.scene}:{line_of(self.scene, needle)}"

    def test_missing_file(self):
        self.scene.unlink()
        self.run_refuses(self.scene)

    def test_mesh_without_a_file(self):
        replace(self.scene, "cylinder", "mesh")
        self.run_refuses(self.at("name: bowl"), "objects[0]: file: required for a mesh")

    def with_mesh(self):
        replace(self.scene, "cylinder", "mesh")
        replace(self.scene, r"size: \[0\.05, 0\.06\]", "file: bowl.stl")

    def test_missing_mesh_file(self):
        self.with_mesh()
        self.run_refuses(self.at("file: bowl"), "objects[0].file: ", "bowl.stl cannot be read")

    def test_broken_mesh_file(self):
        self.with_mesh()
        (self.scene.parent / "bowl.stl").write_text("solid bowl\nfacet normal 0 0")
        self.run_refuses(self.at("file: bowl"), "objects[0].file: ", "bowl.stl")

    def test_negative_size(self):
        replace(self.scene, r"0\.06", "-0.06")
        self.run_refuses(self.at("size:"), "objects[0].size[1]: must be above 0 and at most 100 m, not -0.06")

    def test_wrong_number_of_sizes(self):
        replace(self.scene, r"\[0\.05, 0\.06\]", "[0.05]")
        self.run_refuses(self.at("size:"), "objects[0].size: a cylinder needs 2 numbers")

    def test_unknown_key(self):
        self.scene.write_text(SCENE + "    colour: red\n")
        self.run_refuses(self.at("colour"), "objects[0].colour: unknown key")

    def test_name_that_is_taken(self):
        replace(self.scene, "bowl", "cup")
        self.run_refuses(f"{self.scene}:1", "'cup' is already used")


class Recordings(RunCase):
    def edit_line(self, number, edit):
        lines = self.csv.read_text(encoding="utf-8-sig").splitlines()
        lines[number - 1] = edit(lines[number - 1])
        self.csv.write_text("\n".join(lines) + "\n")

    def test_missing_file(self):
        self.csv.unlink()
        self.run_refuses(self.csv)

    def test_missing_column_in_the_header(self):
        self.edit_line(4, lambda line: line.replace("Sub Frame,X,Y,Z", "Sub Frame,X,Y", 1))
        self.run_refuses(f"{self.csv}:4", "RSHO1.Z: the column is missing")

    def test_missing_column_in_a_row(self):
        self.edit_line(100, lambda line: ",".join(line.split(",")[:20]))
        self.run_refuses(f"{self.csv}:100", "the row has 20 cells")

    def test_no_number_in_a_cell(self):
        def edit(line):
            cells = line.split(",")
            cells[2] = "far"
            return ",".join(cells)
        self.edit_line(50, edit)
        self.run_refuses(f"{self.csv}:50", "RSHO1.X: must be a number, not 'far'")

    def test_unknown_format(self):
        self.csv.write_text("t,x,y\n0,1,2\n")
        replace(self.manifest, "format: vicon-csv\n", "")
        self.run_refuses(f"{self.csv}:1", "not recognised")

    def test_unknown_key_of_a_manifest(self):
        replace(self.manifest, "name: forward", "nickname: forward")
        self.run_refuses(f"{self.manifest}:{line_of(self.manifest, 'nickname')}",
                         "recordings[0].nickname: unknown key")

    def test_damaged_dataset(self):
        """Found while the run is under way: still nothing is left of it."""
        imported = self.folder / "imported.h5"
        self.succeeds("import", self.manifest, "--out", imported)
        where = "/demonstrations/forward/markers/position"
        with h5py.File(imported) as file:
            chunk = file[where].id.get_chunk_info(0)
        damaged = bytearray(imported.read_bytes())
        damaged[chunk.byte_offset + chunk.size // 2] ^= 0xFF
        imported.write_bytes(damaged)
        self.run_refuses(f"{imported}:{where}", arguments=["--dataset", imported, "--json"])

    def test_dataset_taken_away(self):
        imported = self.folder / "imported.h5"
        self.succeeds("import", self.manifest, "--out", imported)
        with h5py.File(imported, "r+") as file:
            del file["demonstrations/forward/markers/time"]
        self.run_refuses(f"{imported}:/demonstrations/forward/markers/time",
                         arguments=["--dataset", imported, "--json"])

    def test_dataset_of_another_version(self):
        imported = self.folder / "imported.h5"
        self.succeeds("import", self.manifest, "--out", imported)
        for version in (2, 99):
            with h5py.File(imported, "r+") as file:
                file.attrs["version"] = version
            self.run_refuses(f"{imported}:/", f"@version is {version}; this program reads only version 3",
                             arguments=["--dataset", imported, "--json"])


class Places(RunCase):
    """Where the result cannot be written."""

    def setUp(self):
        super().setUp()
        replace(self.manifest, r"(?s)recordings:.*", "recordings: []\n")

    def test_out_is_a_file(self):
        out = self.folder / "out"
        out.write_text("kept")
        self.refuses(morphe("run", self.config, "--out", out), out)
        self.assertEqual(out.read_text(), "kept")

    def test_out_is_empty(self):
        result = morphe("run", self.config, "--out", "")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertTrue(result.stderr.startswith("--out: must not be empty\n"), result.stderr)

    def test_out_lies_below_a_file(self):
        (self.folder / "file").write_text("kept")
        out = self.folder / "file/out"
        self.refuses(morphe("run", self.config, "--out", out), out)
        self.assertEqual((self.folder / "file").read_text(), "kept")

    def test_out_cannot_be_written(self):
        """/proc takes no new folders, not even from root; a read-only folder stops everybody else."""
        self.refuses(morphe("run", self.config, "--out", "/proc/morphe"), "/proc/morphe")
        if os.geteuid() != 0:
            locked = self.folder / "locked"
            locked.mkdir(mode=0o500)
            self.refuses(morphe("run", self.config, "--out", locked / "out"), locked / "out")

    def test_plans_is_a_folder_already(self):
        out = self.folder / "out"
        (out / "plans.h5/kept").mkdir(parents=True)
        self.refuses(morphe("run", self.config, "--out", out), out / "plans.h5")
        self.assertEqual(os.listdir(out / "plans.h5"), ["kept"])

    def test_import_into_a_folder_that_is_not_there(self):
        out = self.folder / "nowhere/all.h5"
        self.refuses(morphe("import", self.manifest, "--out", out), out)


class Usage(CommandCase):
    def refused_with_a_hint(self, *arguments, mentions):
        result = morphe(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertIn(mentions, result.stderr)
        self.assertIn("--help", result.stderr)

    def test_no_arguments(self):
        self.refused_with_a_hint(mentions="subcommand")

    def test_unknown_command(self):
        self.refused_with_a_hint("fly", mentions="fly")

    def test_unknown_option(self):
        for command in (["run", "config.yaml", "--out", "out"], ["inspect", "a.h5"],
                        ["verify", "a.h5"], ["import", "a.csv", "--out", "a.h5"]):
            with self.subTest(command[0]):
                self.refused_with_a_hint(*command, "--faster", mentions="--faster")

    def test_missing_arguments(self):
        for command in (["run"], ["inspect"], ["verify"], ["import"]):
            with self.subTest(command[0]):
                self.refused_with_a_hint(*command, mentions="required")

    def test_jobs_that_are_none(self):
        for jobs in ("-1", "1.5", "many"):
            with self.subTest(jobs):
                self.refused_with_a_hint("run", "config.yaml", "--out", "out", "--jobs", jobs,
                                         mentions="--jobs")

    def test_unknown_format(self):
        self.refused_with_a_hint("import", "a.csv", "--out", "a.h5", "--format", "pdf",
                                 mentions="--format")

    def test_help_of_everything(self):
        top = self.succeeds("--help").stdout
        for command in ("import", "inspect", "run", "verify"):
            with self.subTest(command):
                self.assertIn(command, top)
                self.assertIn("--help", self.succeeds(command, "--help").stdout)

    def test_version(self):
        self.assertRegex(self.succeeds("--version").stdout, r"^morphe \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    main()
