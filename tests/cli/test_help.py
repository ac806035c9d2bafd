"""What the program says to who does not know it: examples that work, words that were meant, what the
shell completes, the manual page, and whether everything is there. It takes more than 10 s: all examples of all commands
are run."""
import os
import re
import shutil
import subprocess
import unittest

import h5py

from support import MORPHE, QUICK, REFERENCE, SOURCE, CommandCase, main, morphe, shared_run


def subcommands(*command):
    return re.findall(r"^  (\w+) ", morphe(*command, "--help").stdout.partition("Subcommands:")[2], re.M)


COMMANDS = subcommands()
# The order in which the examples find what they need: those of others use the results of `run`. What
# searches for long is made short: it is the command line that is tried here.
ORDER = [name for command in sorted(COMMANDS, key="run".__ne__) for name in (command, *(f"{command} {inner}" for inner in subcommands(command)))]
SHORT = [word for key in ("map.starts=1", "map.key_frames=1", "map.candidates=1", "map.coarse_step_s=0.2", "map.reach_search_starts=1",
                          "repair.mapping_searches=0") for word in ("--set", key)]
SHORTER = {"run": SHORT, "simulate": ["--load-directions", "none"], "place": [*SHORT, "--movements", 1, "--candidates", 8, "--refine", 2, "--plan", 1]}
PARSED_ONLY = ("study",)  # tests/cli/test_study.py runs studies


def examples(command):
    """Joined where --help broke a line."""
    return re.findall(r"^  morphe (.*)$", morphe(*command.split(), "--help").stdout.partition("Examples:")[2], re.M)


class Examples(CommandCase):
    def test_every_command_has_some(self):
        for command in COMMANDS:
            self.assertTrue(examples(command), f"{command} has no example")

    def test_they_work(self):
        for shared in ("configs", "datasets"):
            os.symlink(SOURCE / shared, self.folder / shared)
        (self.folder / "outputs").mkdir()
        for command in ORDER:
            if command in PARSED_ONLY:
                continue
            for example in examples(command):
                words = example.split()
                shorter = SHORTER.get(words[0], ()) if "--from" not in words else ()
                done = morphe(*words, *shorter, cwd=self.folder)
                self.assertEqual(done.returncode, 0, f"morphe {example}\n{done.stderr}")


class Meant(CommandCase):
    def said(self, *arguments):
        result = morphe(*arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        return result.stderr

    def test_commands(self):
        self.assertEqual(self.said("rnu"), "unknown command 'rnu'; did you mean 'run'?\n"
                         "See morphe --help.\n")
        self.assertIn("did you mean 'synthesize'?", self.said("synthesise", "x"))
        self.assertIn("unknown command 'frobnicate'; available: ", self.said("frobnicate"))

    def test_options(self):
        self.assertEqual(self.said("run", "c.yaml", "--out", "o", "--jbos", "3"),
                         "run: unknown option --jbos; did you mean '--jobs'?\n"
                         "See morphe run --help.\n")
        said = self.said("run", "--outt", "o", "--freshly=1", "--nonsense")
        self.assertIn("--outt; did you mean '--out'?\n", said)
        self.assertIn("--nonsense\n", said)

    def test_options_that_were_renamed(self):
        """Those that CHANGELOG.md names, each at the commands that it names."""
        self.assertEqual(self.said("run", "c.yaml", "--out", "o", "--static=s.csv"),
                         "run: unknown option --static; it is now called '--static-trial'\n"
                         "See morphe run --help.\n")
        above, tried = "", 0
        for row in re.findall(r"^  \|(.*)\|$", (SOURCE / "CHANGELOG.md").read_text(), re.M):
            commands, *names = row.split("|")
            above = commands.replace("`", "").strip() or above
            if len(names) != 2:
                continue
            old, new = (re.findall("`(--[a-z-]+)`", column) for column in names)
            for command in ["simulate"] if above == "command line" else above.split(", "):
                for was, now in zip(old, new):
                    self.assertIn(f"{command}: unknown option {was}; it is now called '{now}'\n", self.said(command, was, "1"))
                    tried += 1
        self.assertEqual(tried, 18)

    def test_values(self):
        for value, hint in (("stored", "; it is now called 'planned'"), ("nearrest", "; did you mean 'nearest'?"),
                            ("frobnicate", "")):
            self.assertEqual(self.said("simulate", "plans.h5", "--out", "o", "--contacts", value),
                             f"--contacts: must be planned or nearest, not '{value}'{hint}\n"
                             "Run with --help for more information.\n")

    def test_files(self):
        config = self.folder / "pipeline.yaml"
        config.write_text("robot: {file: pa01.yaml}\n")
        (self.folder / "pa10.yaml").write_text("name: x\n")
        said = self.said("run", "pipelin.yaml", "--out", "o", "--dataset", "x.h5")
        self.assertIn("pipelin.yaml: cannot be read; did you mean 'pipeline.yaml'?", said)
        self.assertIn("pa01.yaml: cannot be read; did you mean ", self.said("run", config, "--out", "o"))
        self.assertFalse((self.folder / "o").exists())

    def test_folders(self):
        (self.folder / "first").mkdir()
        for command in ("list", "verify", "report", "explain"):
            self.assertIn(f"{self.folder}/frist: cannot be read; did you mean '{self.folder}/first'?\n",
                          self.said(command, self.folder / "frist", *["--out", "o"] * (command == "report")))

    def test_a_number_of_threads(self):
        for command in (("verify", "p.h5"), ("run", "c.yaml", "--out", "o"), ("study", "c.yaml", "--out", "o"),
                        ("place", "c.yaml"), ("synthesize", "c.yaml", "--out", "o"), ("simulate", "p.h5", "--out", "o")):
            for jobs, message in (("-1", "must be at least 0 and at most 10000, not '-1'"), ("abc", "must be a whole number, not 'abc'"),
                                  ("1e3", "must be a whole number, not '1e3'"), ("3.5", "must be a whole number, not '3.5'"),
                                  ("99999999999", "must be at most 2147483647, not '99999999999'"), ("", "must not be empty")):
                said = self.said(*command, "--jobs", jobs)
                self.assertIn(f"--jobs: {message}\n", said, command)

    def test_every_number_and_every_flag(self):
        """Those of all commands, from --help: what is no number is named, and a flag takes no value."""
        tried = 0
        for command in [*COMMANDS, "robot setup"]:
            text = morphe(*command.split(), "--help").stdout
            for option, kind in re.findall(r"^  (--[a-z-]+) ((?:INT|UINT|FLOAT)(?: x \d)?)", text, re.M):
                count = int(kind.partition(" x ")[2] or 1)
                for value in ("abc", "nan", "")[:3 if count == 1 else 2]:
                    values = [value] * count
                    self.assertRegex(self.said(*command.split(), option, *values), rf"{option}: must (not )?be ", value)
                tried += 1
            for flag in re.findall(r"^  (--[a-z-]+)  ", text, re.M):
                self.assertIn(f"{flag}: takes no value, not '3'\n", self.said(*command.split(), f"{flag}=3"))
                tried += 1
        self.assertGreater(tried, 60)

    def test_options_given_twice(self):
        self.assertEqual(self.said("run", "c.yaml", "--out", "a", "--out", "b"),
                         "run: --out is given more than once\nSee morphe run --help.\n")
        self.assertEqual(self.said("--frobnicate").splitlines()[1], "See morphe --help.")

    def test_empty_values(self):
        for words in (["explain", "plans.h5", ""], ["list", ""], ["list", "p", "--sort", ""], ["list", "p", "--only", ""], ["run", "c", "--out", ""]):
            self.assertIn(": must not be empty\n", self.said(*words))

    def test_measures(self):
        self.assertIn("; did you mean 'duration'?", self.said("list", "p.h5", "--sort", "duratoin"))

    def test_shipped_names(self):
        self.assertIn("pa10_dlr_hit2: cannot be read; did you mean 'configs/pipelines/pa10_dlr_hit2.yaml'?\n", self.said("run", "pa10_dlr_hit2", "--out", "o"))
        self.assertIn("pa10: cannot be read; did you mean 'configs/robots/pa10.yaml'?\n", self.said("robot", "pa10"))
        self.assertIn("ue-adl: cannot be read; did you mean 'datasets/ue-adl'?\n", self.said("import", "ue-adl", "--out", "o.h5"))
        (self.folder / "first").mkdir()
        (self.folder / "first/plans.h5").write_text("")
        self.assertIn("did you mean 'first/plans.h5'?", self.said("list", "first/plans"))
        for command in (["import", "first/plan.h5", "--out", "o.h5"], ["inspect", "first/plan.h5"], ["verify", "first/plans.h5", "--dataset", "first/plan.h5"]):
            self.assertIn("first/plan.h5: cannot be read; did you mean 'first/plans.h5'?\n", self.said(*command))

    def test_keys_all_at_once(self):
        config = self.folder / "c.yaml"
        config.write_text("robto: {file: x}\nmap:\n  strats: 3\n  starts: many\n  mode: humanlik\nsede: 2\ncheck: {required_clearanc: 1}\n")
        self.assertEqual(self.said("run", config, "--out", "o").splitlines(), [
            f"{config}:1: robot: is missing; is 'robto' a misspelling of it?",
            f"{config}:5: map.mode: must be humanlike, joint_to_joint, inverse_kinematics or fingertip_only, not 'humanlik'",
            f"{config}:4: map.starts: must be a whole number, not 'many'",
            f"{config}:1: robto: unknown key; did you mean 'robot'?",
            f"{config}:3: map.strats: unknown key; did you mean 'starts'?",
            f"{config}:6: sede: unknown key; did you mean 'seed'?",
            f"{config}:7: check.required_clearanc: unknown key; did you mean 'required_clearance'?"])

    def test_keys_of_a_robot_all_at_once(self):
        robot = self.folder / "r.yaml"
        robot.write_text((SOURCE / "configs/robots/pa10.yaml").read_text()
                         .replace("chains:", "chians:").replace("tips:", "tisp:"))
        said = self.said("robot", robot)
        self.assertIn("chians: unknown key; did you mean 'chains'?\n", said)
        self.assertIn("tisp: unknown key; did you mean 'tips'?\n", said)

    def test_studies_and_schemas(self):
        study = self.folder / "s.yaml"
        study.write_text("study: retim\n")
        self.assertIn("s.yaml:1: study: unknown study 'retim'; did you mean 'retime'?",
                      self.said("study", study, "--out", "o"))
        self.assertIn("did you mean 'robot'?", self.said("schema", "robto"))


class Completed(CommandCase):
    SCRIPTS = SOURCE / "pipeline/commands/completion"

    def offered(self, *words):
        return self.succeeds("--complete", *words, cwd=self.folder).stdout.split()

    def complete(self, line, path=os.environ["PATH"]):
        """What bash would offer after a tab at the end of the line."""
        script = (f'source "{self.SCRIPTS}/morphe.bash"\n'
                  'read -ra COMP_WORDS <<<"$LINE"\n[[ $LINE == *" " ]] && COMP_WORDS+=("")\n'
                  'COMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_morphe\nprintf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, cwd=self.folder,
                              env={**os.environ, "LINE": line, "PATH": f"{MORPHE.parent}:{path}"})
        self.assertEqual(done.stderr, "")
        return done.stdout.split()

    def test_commands_options_and_files(self):
        (self.folder / "results").mkdir()
        (self.folder / "reached.yaml").write_text("")
        self.assertEqual(sorted(self.complete("morphe ")), sorted(COMMANDS))
        self.assertEqual(self.complete("morphe re"), ["report"])
        self.assertEqual(self.complete("morphe run --s"), ["--set", "--shard", "--sort", "--static-trial", "--strict"])
        self.assertEqual(self.complete("morphe robot s"), ["setup"])
        self.assertEqual(sorted(self.complete("morphe run re")), ["reached.yaml", "results"])
        self.assertEqual(sorted(self.complete("morphe run --out re")), ["reached.yaml", "results"])

    def test_every_listed_word_of_every_option(self):
        """Whatever --help shows in braces is offered, in each manner of writing the option."""
        tried = 0
        for command in [*COMMANDS, "robot setup"]:
            for option, words in re.findall(r"^  (--[a-z-]+) \S*\{(.*?)\}", morphe(*command.split(), "--help").stdout, re.M):
                words = sorted(words.split(","))
                self.assertEqual(sorted(self.offered(*command.split(), option, "")), words)
                self.assertEqual(sorted(self.offered(*command.split(), option, "=", "")), words)
                self.assertEqual(self.offered(*command.split(), f"{option}={words[0]}")[0], f"{option}={words[0]}")
                tried += 1
        self.assertGreater(tried, 10)

    def test_values(self):
        self.assertEqual(self.offered("list", "x", "--only", "exe"), ["executable"])
        self.assertIn("goal_in_collision", self.offered("list", "--only", ""))
        self.assertEqual(self.offered("diff", "--sort", "dur"), ["duration", "duration_ratio"])
        self.assertEqual(self.offered("report", "--worst", "3", "tip"), ["tip_error_grasp", "tip_error_max"])
        self.assertEqual(self.offered("schema", "sy"), ["synthetic"])
        self.assertEqual(self.offered("run", "c.yaml", "--set", "map.key"), ["map.key_frames="])
        self.assertEqual(self.offered("run", "--set", "map.mode=h"), ["map.mode=humanlike"])
        self.assertEqual(self.offered("import", "--unit", "c"), ["cm"])
        self.assertEqual(self.offered("export", "f", "--group", "a"), ["all", "arm"])
        for none in (["list", "nowhere.h5", "--only", "ADL"], ["run", "--out", "x"], ["run", "--nonsense", "x"], ["frobnicate", ""]):
            self.assertEqual(self.offered(*none), [])

    def test_shipped_files(self):
        self.assertEqual(self.offered("robot", "conf"), ["configs/"])
        self.assertEqual(self.offered("robot", "configs/ro"), ["configs/robots/"])
        self.assertEqual(self.offered("run", "x.yaml", "--dataset", "datasets/ue"), ["datasets/ue-adl/"])
        robots = self.offered("robot", "configs/robots/pa10")
        self.assertIn("configs/robots/pa10_dlr_hit2.yaml", robots)
        self.assertEqual(sorted(robots), sorted(f"configs/robots/{file.name}" for file in (SOURCE / "configs/robots").glob("pa10*")))
        self.assertEqual(self.offered("list", "conf"), [])
        (self.folder / "configs").mkdir()
        self.assertEqual(self.offered("robot", "conf"), [], "the shell offers the user's own")

    def test_plans_of_the_file_on_the_line(self):
        plans = shared_run(REFERENCE, *QUICK, dataset="two recordings") / "out"
        with h5py.File(plans / "plans.h5") as file:
            names = list(file["plans"])
        self.assertEqual(self.offered("explain", plans, names[0]), [names[0], f"{names[0]}/000"])
        self.assertEqual(self.offered("list", plans, "--only", names[1]), [names[1], f"{names[1]}/000"])
        self.assertEqual(self.offered("report", plans / "plans.h5", "--plans", f"{names[0]}/"), [f"{names[0]}/000"])

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish(self):
        done = subprocess.run(["fish", "--no-config", "-c", f'source {self.SCRIPTS}/morphe.fish; complete -C "morphe list x --only exe"; complete -C "morphe re"'],
                              capture_output=True, text=True, cwd=self.folder, env={**os.environ, "HOME": str(self.folder), "PATH": f"{MORPHE.parent}:{os.environ['PATH']}"})
        self.assertEqual(done.stdout.split(), ["executable", "report"], done.stderr)

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh(self):
        """In a terminal of its own: zsh completes nowhere else."""
        (self.folder / "_morphe").symlink_to(self.SCRIPTS / "_morphe")
        script = f"""
            zmodload zsh/zpty
            zpty z zsh -f -i
            zpty -w z 'PS1=; fpath=({self.folder} $fpath); autoload -U compinit; compinit -u -D; PATH={MORPHE.parent}:$PATH; echo RE''ADY'
            zpty -r z text '*READY*'
            zpty -n -w z $'morphe list x --only exec\\t'
            zpty -r z text '*executable*' && print offered"""
        done = subprocess.run(["zsh", "-f", "-c", script], capture_output=True, text=True, cwd=self.folder, timeout=60,
                              env={**os.environ, "HOME": str(self.folder), "TERM": "dumb"})
        self.assertEqual(done.stdout, "offered\n", done.stderr)


class Manual(CommandCase):
    def test_it_has_all_that_help_has(self):
        page = self.succeeds("--man").stdout
        plain = re.sub(r"\\f.|\\:", "", page).replace("\\-", "-")
        for command in [*COMMANDS, "robot setup"]:
            section = re.search(rf"^\.SS morphe {command}$(.*?)(?=^\.S[SH] )", plain, re.M | re.S)[1]
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", morphe(*command.split(), "--help").stdout, re.M):
                self.assertRegex(section, rf"(?m)^(--?[\w-]+, )*{option}(,| |$)", command)
            for example in examples(command):
                self.assertIn(example, section)

    @unittest.skipUnless(shutil.which("man"), "no man")
    def test_man_shows_it_without_a_warning(self):
        page = self.folder / "morphe.1"
        page.write_text(self.succeeds("--man").stdout)
        shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page], capture_output=True, text=True,
                               env={**os.environ, "LC_ALL": "C.UTF-8", "MANROFFSEQ": "", "MANWIDTH": "80"})
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))


class Doctor(CommandCase):
    def test_all_is_well_here(self):
        report = self.json_of("doctor")
        self.assertTrue(report["ok"])
        found = {one["name"]: one for one in report["checks"]}
        self.assertEqual(found["version"]["detail"], morphe("--version").stdout.strip())
        self.assertIn("HDF5", found["built with"]["detail"])
        self.assertRegex(found["cores"]["detail"], r"^\d+ cores?")
        self.assertIn(" version ", self.succeeds("doctor", cwd=self.folder).stdout)
        self.assertEqual(os.listdir(self.folder), [])

    def test_the_shipped_files_are_found_where_they_are(self):
        for place in (SOURCE, self.folder):
            found = {one["name"]: one for one in self.json_of_in(place)["checks"]}
            self.assertEqual(found["shipped files"]["status"], "ok", place)
            self.assertIn(str(SOURCE / "configs"), found["shipped files"]["detail"])

    def json_of_in(self, folder):
        import json
        return json.loads(morphe("doctor", "--json", cwd=folder).stdout)

    def test_a_folder_that_cannot_be_written(self):
        result = morphe("doctor", cwd="/proc")
        self.assertEqual(result.returncode, 1)
        self.assertIn("ERROR   this folder", result.stdout)
        self.assertIn("-> work in a folder with write permission", result.stdout)


if __name__ == "__main__":
    main()
