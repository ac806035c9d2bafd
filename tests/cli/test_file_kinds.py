"""A file that is no recording is named, by every command that takes recordings, with the way to the
recording."""
import pickle
import zipfile

from support import RECORDINGS, REFERENCE, SOURCE, CommandCase, main, morphe

POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1234567\n"


class FileKinds(CommandCase):
    def put(self, name, content):
        file = self.folder / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file

    def expect(self, file, *mentioned):
        run = ("run", REFERENCE, "--dataset", file, "--out", self.folder / "run")
        for command in (("import", file, "--out", self.folder / "x.h5"), ("inspect", file), run):
            result = morphe(*command)
            self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
            for word in (str(file), *mentioned):
                self.assertIn(word, result.stderr)

    def test_pointer_of_git_lfs(self):
        self.expect(self.put("trial.bvh", POINTER), "is a Git LFS pointer", "git lfs pull")

    def test_pointer_in_a_folder_is_a_recording_that_is_missed(self):
        lab = self.folder / "lab"
        lab.mkdir()
        (lab / "drink.csv").write_bytes((RECORDINGS / "ADL001DR2.csv").read_bytes())
        (lab / "comb.csv").write_text(POINTER)
        result = morphe("import", lab, "--out", self.folder / "lab.h5")
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn("comb.csv: is a Git LFS pointer", result.stdout + result.stderr)

    def test_empty_file(self):
        self.expect(self.put("trial.csv", ""), "is empty")

    def test_workbook_and_archive(self):
        for name, member, word in (("trial.xlsx", "xl/workbook.xml", "an Excel workbook"),
                                   ("trial.zip", "trial.csv", "a zip archive")):
            with zipfile.ZipFile(self.folder / name, "w") as archive:
                archive.writestr(member, "a,b\n")
            self.expect(self.folder / name, word)

    def test_pickle_and_json(self):
        for protocol in (2, 3, 4, 5):
            self.expect(self.put("hand.pkl", pickle.dumps({"joints": [0.0] * 63}, protocol)), "is a Python pickle")
        self.expect(self.put("hand.json", '{"joints": []}'), "is a JSON file")

    def test_robot(self):
        self.expect(SOURCE / "configs/robots/urdf/panda.urdf", "is a robot description")

    def test_demonstrations_that_were_imported(self):
        file = self.folder / "d.h5"
        self.assertEqual(morphe("import", RECORDINGS / "ADL001DR2.csv", "--out", file).returncode, 0)
        result = morphe("import", file, "--out", self.folder / "x.h5")
        self.refuses(result, file, "is a demonstrations.h5, already imported")


if __name__ == "__main__":
    main()
