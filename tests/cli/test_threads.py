"""Threads that the system does not permit: an error about --jobs, or fewer of them; never an abort."""
import resource
import subprocess

from many import ManyCase
from support import MORPHE, main


class Threads(ManyCase):
    def limited(self, *arguments, megabytes):
        """The program with so much address space, of which each thread's stack takes 8 MB."""
        def limit():
            resource.setrlimit(resource.RLIMIT_STACK, (8 << 20, 8 << 20))
            resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        return subprocess.run([MORPHE, *map(str, arguments)], preexec_fn=limit, capture_output=True, text=True)

    def test_a_number_that_cannot_be_started(self):
        out = self.folder / "out"
        for command in (("verify", self.plain), self.command(out), ("simulate", self.plain, "--out", out),
                        ("synthesize", self.base / "synthetic.yaml", "--out", self.folder / "s.h5")):
            result = self.limited(*command, "--jobs", 400, megabytes=2000)
            if "has no MuJoCo" in result.stderr:
                continue
            self.refuses(result, "--jobs 400", "can be started", "ulimit")

    def test_without_a_number_those_that_can_be_started_do(self):
        self.assertEqual(self.limited("verify", self.plain, megabytes=2000).stdout, self.succeeds("verify", self.plain).stdout)

    def test_a_thread_that_cannot_be_started_later_is_no_abort(self):
        """TBB starts threads when there is work for them; what they and the reader need by then may be more."""
        for megabytes in range(200, 400, 50):
            result = self.limited("verify", self.plain, "--jobs", 8, megabytes=megabytes)
            self.assertNotIn("terminate called", result.stderr, megabytes)
            if "pthread_create" in result.stderr:
                self.assertEqual(result.returncode, 2)
                self.assertIn("--jobs", result.stderr)


if __name__ == "__main__":
    main()
