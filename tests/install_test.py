#!/usr/bin/python3
"""What gets installed works for those who have nothing else: the program, the library with the
project that docs/library.md shows, and examples/. Everything lands in a folder that goes again.
`tree` takes more than 10 s: the compiler is most of it, with five examples for two processors.

  install_test.py BUILD CXX tree    what `cmake --install` puts into a prefix; the examples, for any
                                    processor and for this one, with the address sanitizer
  install_test.py BUILD CXX deb     the Debian package, unpacked into a root of its own
                                    (exit 77: this machine has no dpkg)
"""
import gzip
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

import h5py
import numpy as np

import symbols_test

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77
CONFIG = "configs/pipelines/pa10_dlr_hit2.yaml"
RECORDINGS = "datasets/ue-adl/recordings.yaml"
VERSION = re.search(r"^project\(morphe VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
SANITIZER = "-O1 -g1 -fsanitize=address -fno-omit-frame-pointer"
# Run by CMake in a project of others: what each of its programs includes is compiled once.
PRECOMPILED = """\
function(precompile)
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  list(POP_FRONT targets first)
  target_precompile_headers(${first} PRIVATE <morphe/morphe.hpp>)
  foreach(target IN LISTS targets)
    target_precompile_headers(${target} REUSE_FROM ${first})
  endforeach()
endfunction()
cmake_language(DEFER CALL precompile)
"""
SHARED = ("-DEIGEN_MAX_ALIGN_BYTES=16", "-DEIGEN_MALLOC_ALREADY_ALIGNED=0")


def run(*command, exit_code=0, **more):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, **more)
    if done.returncode != exit_code:
        raise AssertionError(f"{command}: exit {done.returncode}\n{done.stdout[-8000:]}")
    return done.stdout


def blocks(page, language):
    return re.findall(rf"^```{language}\n(.*?)^```$", (ROOT / page).read_text(encoding="utf-8"), re.M | re.S)


class Installed(unittest.TestCase):
    """A folder for all tests of a class: `prefix` with what was installed, `elsewhere` to work in."""

    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory(prefix="morphe_install_")
        cls.addClassCleanup(holder.cleanup)
        cls.folder = pathlib.Path(holder.name).resolve()
        cls.elsewhere = cls.folder / "elsewhere"
        cls.elsewhere.mkdir()
        # CMake leaves a list of what it installed in the build.
        manifest = BUILD / "install_manifest.txt"
        if not manifest.exists():
            cls.addClassCleanup(manifest.unlink, missing_ok=True)
        cls.install()
        # What the program of the build writes, from where the sources are.
        cls.reference = shared_run(REFERENCE, "--json") / "out/plans.h5"

    @classmethod
    def build(cls, source, name, flags="-O2", *options):
        out = cls.folder / name
        run("cmake", "-S", source, "-B", out, f"-DCMAKE_PREFIX_PATH={cls.prefix}", f"-DCMAKE_CXX_COMPILER={CXX}",
            "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror {flags}", *options)
        run("cmake", "--build", out, "--parallel")
        return out

    @classmethod
    def build_outside_project(cls):
        """The page's project: its two files are its first two blocks."""
        source = cls.folder / "outside"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(blocks("docs/library.md", "cmake")[0])
        (source / "main.cpp").write_text(blocks("docs/library.md", "cpp")[0])
        return cls.build(source, "outside_build") / "mine"

    def same_bytes(self, file):
        self.assertEqual(file.read_bytes(), self.reference.read_bytes())

    def check_program(self):
        program = self.prefix / "bin/morphe"
        self.assertEqual(run(program, "--version", cwd=self.elsewhere).strip(), f"morphe {VERSION}")
        run(program, "run", CONFIG, "--out", "by_program", cwd=self.elsewhere)
        self.same_bytes(self.elsewhere / "by_program/plans.h5")
        near = str(CONFIG).replace("pa10", "pa1O")
        refused = run(program, "run", near, "--out", "none", cwd=self.elsewhere, exit_code=2)
        self.assertTrue(refused.startswith(f"{self.prefix}/share/morphe/{near}: cannot be read"), refused)
        self.assertIn(f"did you mean '{self.prefix}/share/morphe/{CONFIG}'?", refused)

    def check_what_shells_and_readers_find(self):
        for path in ("man/man1/morphe.1.gz", "bash-completion/completions/morphe", "zsh/vendor-completions/_morphe",
                     "fish/vendor_completions.d/morphe.fish", "doc/morphe/README.md", "doc/morphe/docs/tour.md", "doc/morphe/copyright"):
            self.assertTrue((self.prefix / "share" / path).is_file(), path)
        with gzip.open(self.prefix / "share/man/man1/morphe.1.gz", "rt", encoding="utf-8") as page:
            self.assertEqual(page.read(), run(self.prefix / "bin/morphe", "--man"))

    def check_python(self):
        """The reader that was installed, not that of the sources."""
        packages = self.prefix / "lib/python3/dist-packages"
        said = run(sys.executable, "-B", "-c", "import morphe, sys; print(morphe.__file__); print(len(morphe.Plans(sys.argv[1])))",
                   self.reference, cwd=self.elsewhere, env={"PYTHONPATH": str(packages)})
        self.assertEqual(said.split(), [f"{packages}/morphe/__init__.py", "5"])
        self.assertEqual({file.suffix for file in (packages / "morphe").iterdir()}, {".py", ".typed"})

    def check_outside_project(self):
        program = self.build_outside_project()
        folder = self.elsewhere / "outside"
        folder.mkdir()
        run(program, cwd=folder)
        self.same_bytes(folder / "plans.h5")

    def check_symbols(self, folder):
        found, files = symbols_test.check(folder)
        self.assertEqual(found, [])
        self.assertGreater(files, 0)


class Tree(Installed):
    @classmethod
    def install(cls):
        cls.prefix = cls.folder / "prefix"
        run("cmake", "--install", BUILD, "--prefix", cls.prefix)

    def test_the_program_finds_what_is_shipped(self):
        self.check_program()

    def test_shells_and_readers_find_theirs(self):
        self.check_what_shells_and_readers_find()

    def test_python_reads_the_plans(self):
        self.check_python()

    def test_the_project_of_the_page_writes_the_same_plans(self):
        self.assertLessEqual(sum(len(blocks("docs/library.md", language)[0].splitlines())
                                 for language in ("cmake", "cpp")), 20)
        self.check_outside_project()
        with h5py.File(self.elsewhere / "outside/plans.h5") as file:
            self.assertEqual(file.attrs["software"].decode(), f"morphe {VERSION}")
            built_with = file.attrs["built_with"].decode()
        number = run(CXX, "-dumpfullversion" if built_with.startswith("GNU") else "-dumpversion").strip()
        self.assertIn(f" {number}, Eigen3 ", built_with)
        self.assertRegex(built_with, r"HDF5 1[\d.]+, NLopt 2[\d.]+, OMPL 1[\d.]+, .*, glibc 2[\d.]+$")

    def test_nothing_of_ours_is_asked_of_others_flags(self):
        targets = "".join(file.read_text() for file in self.prefix.rglob("MorpheTargets*.cmake"))
        for definition in SHARED:
            self.assertIn(definition.removeprefix("-D"), targets)
        self.assertNotIn("INTERFACE_COMPILE_OPTIONS", targets)
        self.assertNotRegex(targets, rf'[\s";]{re.escape(str(ROOT))}[/";]')

    def test_what_headers_declare_is_in_the_library(self):
        declared = re.compile(r"^(?!MORPHE_EXPORT|inline|constexpr|template|static_assert|using)\w[^;{]*\([^;{]*;", re.M)
        self.assertTrue(declared.search("int hidden(int a,\n           int b);"))
        for header in (self.prefix / "include/morphe").rglob("*.hpp"):
            with self.subTest(header.name):
                self.assertEqual(declared.findall(re.sub("//.*", "", header.read_text())), [])

    def test_one_version(self):
        self.assertIn(f'set(PACKAGE_VERSION "{VERSION}")',
                      next(self.prefix.rglob("MorpheConfigVersion.cmake")).read_text())
        self.assertTrue(next(self.prefix.rglob(f"libmorphe.so.{VERSION}")))
        self.assertIn(f"version: {VERSION}\n", (ROOT / "CITATION.cff").read_text())

    def test_another_alignment_or_heap_is_refused(self):
        command = [CXX, "-std=c++20", "-fsyntax-only", "-x", "c++", "-", "-isystem", self.prefix / "include",
                   "-isystem", self.prefix / "include/morphe", "-isystem", EIGEN]
        source = "#include <morphe/morphe.hpp>\n"
        run(*command, *SHARED, input=source)
        for wrong in (["-DEIGEN_MAX_ALIGN_BYTES=32", SHARED[1]], [SHARED[0], "-DEIGEN_MALLOC_ALREADY_ALIGNED=1"]):
            self.assertIn(" ".join(SHARED), run(*command, *wrong, input=source, exit_code=1))

    def setUp(self):
        # clang's sanitizer is a package of its own.
        if "sanitizer" not in self.id():
            return
        probe = subprocess.run([CXX, *SANITIZER.split(), "-x", "c++", "-", "-o", self.folder / "probe"],
                               input="int main() {}", capture_output=True, text=True)
        if probe.returncode != 0:
            self.skipTest(f"{CXX} has no address sanitizer here")

    def test_examples_under_the_address_sanitizer(self):
        self.check_examples(self.build(ROOT / "examples", "plain", SANITIZER))

    def test_examples_for_this_processor_under_the_address_sanitizer(self):
        # The other build proves that every example includes what it uses.
        (self.folder / "precompiled.cmake").write_text(PRECOMPILED)
        self.check_examples(self.build(ROOT / "examples", "native", f"{SANITIZER} -march=native",
                                       f"-DCMAKE_PROJECT_INCLUDE={self.folder}/precompiled.cmake"))

    def check_examples(self, built):
        self.check_symbols(built)
        folder = self.elsewhere / built.name
        folder.mkdir()
        plans = folder / "plans.h5"

        def example(name, *arguments, **more):
            return run(built / name, *arguments, cwd=folder, **more)

        with self.subTest("plan_recording"):
            said = example("plan_recording", CONFIG, RECORDINGS, plans)
            self.assertEqual(said.count(": executable\n"), 5, said)
            self.same_bytes(plans)
            example("plan_recording", "none.yaml", RECORDINGS, folder / "none.h5", exit_code=2)
        with self.subTest("read_plans"):
            self.check_what_was_read(example("read_plans", plans), plans)
        with self.subTest("verify_plans"):
            self.assertEqual(example("verify_plans", plans), "5 executable, 0 infeasible, 0 violations\n")
            with h5py.File(plans, "r+") as file:
                file["plans/ADL001DR2/000/trajectory/position"][5, 0] += 0.5
            said = example("verify_plans", plans, exit_code=1)
            self.assertIn("ADL001DR2/000 at ", said)
        with self.subTest("robot_from_urdf"):
            self.check_robot(example("robot_from_urdf"))
        with self.subTest("own_term"):
            self.check_own_term(example, folder)

    def check_own_term(self, example, folder):
        def distances(weight):
            said = example("own_term", CONFIG, RECORDINGS, folder / f"{weight}.h5", weight)
            return [float(x) for x in re.findall(r": executable, (\S+) of half a range", said)]

        without, with_term = distances("0"), distances("0.05")
        self.assertEqual((len(without), len(with_term)), (5, 5))
        for before, after in zip(without, with_term):
            self.assertLess(after, before)
        with h5py.File(folder / "0.h5") as ours, h5py.File(self.reference) as reference:
            path = "plans/ADL001DR2/000/path/position"
            self.assertEqual(ours[path][()].tobytes(), reference[path][()].tobytes())
        with h5py.File(folder / "0.05.h5") as file:
            config = file.attrs["config"].decode()
        self.assertIn("range_middle", config)
        # The program itself brings no terms, and says so.
        (folder / "with_term.yaml").write_text(f"extends: {ROOT / CONFIG}\nmap:\n  custom_terms: [{{name: range_middle, weight: 1}}]\n")
        said = run(self.prefix / "bin/morphe", "run", "with_term.yaml", "--out", "none", cwd=folder, exit_code=2)
        self.assertIn("with_term.yaml:3: map.custom_terms: this program has no term 'range_middle'", said)

    def check_what_was_read(self, said, plans):
        grasps = 0
        with h5py.File(plans) as file:
            names = file["robot/joint_names"].asstr()[()]
            for demonstration in file["plans"]:
                plan = file["plans"][demonstration]["000"]
                trajectory = plan["trajectory"]
                self.assertIn(f"{demonstration}/000: {len(trajectory['time'])} samples, "
                              f"{trajectory['time'][-1]:.3f} s, {1000 * plan['certificate'].attrs['clearance']:.2f} mm", said)
                if "grasp" not in plan:  # a reach for nothing
                    continue
                grasps += 1
                for name, angle in zip(names, trajectory["position"][plan["grasp"].attrs["sample"]]):
                    self.assertIn(f"  {name} {angle:.6f} rad\n", said)
        self.assertEqual(grasps, 3)

    def check_robot(self, said):
        """The product of the URDF's own transforms."""
        urdf = xml.parse(ROOT / "datasets/motionbenchmaker/panda_spherized.urdf").getroot()
        joints = {joint.find("child").get("link"): joint for joint in urdf.findall("joint")}
        pose, link = np.eye(4), "panda_grasptarget"
        while link in joints:
            joint = joints[link]
            origin, axis = joint.find("origin"), joint.find("axis")
            step = np.eye(4)
            if origin is not None:
                roll, pitch, yaw = numbers(origin, "rpy")
                step[:3, :3] = turn([0, 0, 1], yaw) @ turn([0, 1, 0], pitch) @ turn([1, 0, 0], roll)
                step[:3, 3] = numbers(origin, "xyz")
            if joint.get("type") == "revolute":
                limit = joint.find("limit")
                low, high = float(limit.get("lower")), float(limit.get("upper"))
                self.assertIn(f"{joint.get('name')} {low:.6f} … {high:.6f} rad, "
                              f"at most {float(limit.get('velocity')):.3f} rad/s\n", said)
                turned = np.eye(4)
                turned[:3, :3] = turn(numbers(axis, "xyz"), (low + high) / 2)
                step = step @ turned
            pose, link = step @ pose, joint.find("parent").get("link")
        tip = np.array([float(x) for x in re.search(r"^grasp (\S+) (\S+) (\S+) m$", said, re.M).groups()])
        self.assertLess(np.abs(tip - pose[:3, 3]).max(), 2e-6)


def numbers(element, name):
    return np.array([float(x) for x in element.get(name, "0 0 0").split()])


def turn(axis, angle):
    """Rodrigues' formula."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


class Deb(Installed):
    @classmethod
    def install(cls):
        out, root = cls.folder / "package", cls.folder / "root"
        run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", out)
        (cls.package,) = out.glob("*.deb")
        run("dpkg-deb", "--extract", cls.package, root)
        cls.prefix = root / "usr"

    def test_the_program_finds_what_is_shipped(self):
        self.check_program()

    def test_shells_and_readers_find_theirs(self):
        self.check_what_shells_and_readers_find()

    def test_python_reads_the_plans(self):
        self.check_python()

    def test_the_project_of_the_page_writes_the_same_plans(self):
        self.check_outside_project()

    def test_shows_nothing_of_eigen(self):
        self.check_symbols(self.prefix)

    def test_what_it_says_of_itself(self):
        fields = dict(re.findall(r"^(\S+): (.*)$", run("dpkg-deb", "--field", self.package), re.M))
        self.assertEqual(fields["Package"], "morphe")
        self.assertEqual(fields["Version"].partition("-")[0], VERSION)
        needed = [re.match(r"\S+", name)[0] for name in fields["Depends"].split(", ")]
        for library in ("libc6", "libompl", "libfcl", "libhdf5", "libnlopt"):
            self.assertTrue(any(name.startswith(library) for name in needed), needed)
        run("dpkg-query", "--show", *needed)  # they are names of packages

    def test_cpack_says_what_it_lacks(self):
        blind = [word for where in ("CMAKE_SYSTEM_PATH", "SYSTEM_ENVIRONMENT_PATH") for word in ("-D", f"CMAKE_FIND_USE_{where}=NO")]
        said = run("cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", self.folder / "none", *blind, exit_code=1)
        self.assertIn("apt-get install dpkg-dev file", " ".join(said.split()))


if __name__ == "__main__":
    BUILD, CXX, what = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
    sys.argv.insert(1, BUILD / "morphe")  # support.py takes it from there
    sys.path.insert(0, str(ROOT / "tests/cli"))
    from support import REFERENCE, shared_run
    EIGEN = re.search(r"^Eigen3_DIR:\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(), re.M)[1]
    EIGEN = next(folder / "include/eigen3" for folder in pathlib.Path(EIGEN).parents
                 if (folder / "include/eigen3").is_dir())
    if what == "deb" and not (shutil.which("dpkg-deb") and shutil.which("dpkg-shlibdeps")):
        print("SKIPPED: no dpkg-deb and dpkg-shlibdeps here, so no package for Debian")
        sys.exit(SKIPPED)
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Tree if what == "tree" else Deb)
    sys.exit(not unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful())
