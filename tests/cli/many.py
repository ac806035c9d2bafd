"""A dataset of many short recordings and a config that plans each in some hundredths of a second: an
arm without a hand, a search of one start. What the tests of whole runs share."""
import json
import signal
import subprocess
import tempfile
import unittest
from pathlib import Path

from support import MORPHE, SOURCE, CommandCase, morphe, sha256, temporary_folder

CONFIG = f"""\
robot: {{file: {SOURCE}/configs/robots/pa10.yaml}}
scene: {{table: {{infer: false}}, target: {{infer: false}}}}
placement:
  rotation:
    - {{axis: y, angle: 105 deg}}
    - {{axis: z, angle: 90 deg}}
  shoulder_offset: [0.10, -0.30, 0.30]
reconstruct: {{rate_hz: 50}}
map: {{key_frames: 1, starts: 1, candidates: 1, reach_search_starts: 1, coarse_step_s: 0.2}}
"""
SYNTHETIC = """\
movements: {movements_per_recording: [1, 2]}
sensors: {rate_hz: 60, calibration_s: 0.5}
glove: {rate_hz: 30}
"""
COUNT = 12


class ManyCase(CommandCase):
    """The dataset, the config, and the bytes of an undisturbed run on one thread."""

    @classmethod
    def setUpClass(cls):
        holder = temporary_folder()
        cls.addClassCleanup(holder.cleanup)
        cls.base = Path(holder.name).resolve()
        (cls.base / "synthetic.yaml").write_text(SYNTHETIC)
        cls.config = cls.base / "config.yaml"
        cls.config.write_text(CONFIG)
        cls.dataset = cls.base / "many.h5"
        made = morphe("synthesize", cls.base / "synthetic.yaml", "--out", cls.dataset, "--count", COUNT)
        assert made.returncode == 0, made.stderr
        cls.plain = cls.base / "plain"
        ran = morphe(*cls.command(cls.plain, "--jobs", 1))
        assert ran.returncode == 0, ran.stderr
        cls.bytes = sha256(cls.plain / "plans.h5")

    @classmethod
    def command(cls, out, *arguments, dataset=None):
        return ["run", cls.config, "--dataset", dataset or cls.dataset, "--out", out, *arguments]

    def setUp(self):
        super().setUp()
        self.out = self.folder / "out"

    def run_json(self, *arguments, dataset=None, out=None):
        return self.json_of(*self.command(out or self.out, *arguments, dataset=dataset))

    def start(self, *arguments, dataset=None):
        """A run of its own, once it has finished a demonstration."""
        process = subprocess.Popen(
            [MORPHE, *map(str, self.command(self.out, "--jobs", 1, *arguments, dataset=dataset))],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        self.addCleanup(self.end, process)
        first = process.stderr.readline()
        self.assertTrue(first.startswith("[1/"), first)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.communicate()

    def same_bytes(self, out=None):
        self.assertEqual(sha256((out or self.out) / "plans.h5"), self.bytes)
