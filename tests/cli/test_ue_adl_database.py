"""The script for the whole UE_ADLdatabase, on the part of it that is shipped, sorted as the database
is."""
import json
import shutil
import subprocess
import sys

from support import MORPHE, RECORDINGS, SOURCE, CommandCase, main


class Database(CommandCase):
    def run_script(self, *arguments):
        return subprocess.run([sys.executable, SOURCE / "tests/bench/ue_adl_database.py", MORPHE, *arguments],
                              capture_output=True, text=True)

    def test_segmentation_against_the_windows_of_the_authors(self):
        database, rows = self.folder / "database", self.folder / "rows.json"
        (database / "ADL001").mkdir(parents=True)
        (database / "ADL003_angles").mkdir()  # the database has such a folder beside the people's
        for file in RECORDINGS.glob("ADL001*.csv"):
            named = file.name.replace("ADL001DR2angles", "ADL001_DR2angles")
            shutil.copy(file, database / "ADL001" / named)
        result = self.run_script(database, "--out", self.folder / "out", "--json", rows, "--jobs", "1")
        self.assertEqual(result.returncode, 0, result.stderr)
        everyone = json.loads(rows.read_text())
        self.assertEqual(list(everyone), ["ADL001", "all"])
        person = everyone["ADL001"]
        self.assertEqual((person["trials"], person["no movement"], person["windows"]), (3, 0, 3))
        self.assertLess(person["begin ms"], 50)
        self.assertLess(person["end ms"], 50)
        self.assertEqual(person["executable"], 3)
        self.assertIn("ADL001", result.stdout)
        self.assertNotIn("skipped: " + str(database / "ADL001/ADL001_DR2angles.csv") + ": not readable as a recording",
                         result.stderr)

    def test_no_such_folder(self):
        result = self.run_script(self.folder, "--out", self.folder / "out")
        self.assertEqual(result.returncode, 1)
        self.assertIn("no folder is called ADL*", result.stderr)


if __name__ == "__main__":
    main()
