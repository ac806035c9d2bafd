"""A program under a pseudo-terminal of its own, as a person sees it."""
import fcntl
import os
import pty
import select
import struct
import termios
import time

from support import MORPHE


class Terminal:
    """Runs `morphe`; standard output and error are one terminal, unless `stdout` is a descriptor."""

    def __init__(self, *arguments, stdout=None, columns=100, **environment):
        self.seen = ""
        self.process, self.master = pty.fork()
        if self.process == 0:
            fcntl.ioctl(2, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
            if stdout is not None:
                os.dup2(stdout, 1)
            os.environ.update({"TERM": "xterm", **environment})
            os.execv(MORPHE, ["morphe", *map(str, arguments)])

    def type(self, keys):
        os.write(self.master, keys.encode())

    def wait_for(self, text, timeout_s=60):
        """Seconds until it was printed, from now on."""
        begin, before = time.monotonic(), len(self.seen)
        while text not in self.seen[before:]:
            left_s = timeout_s - (time.monotonic() - begin)
            if left_s <= 0 or not self.read(left_s):
                raise AssertionError(f"{text!r} was not printed within {timeout_s} s: {self.seen!r}")
        return time.monotonic() - begin

    def read(self, timeout_s):
        ready, _, _ = select.select([self.master], [], [], timeout_s)
        try:
            more = os.read(self.master, 65536).decode() if ready else ""
        except OSError:  # the other end is closed
            return False
        self.seen += more
        return bool(more)

    def end(self, timeout_s=60):
        """(exit code or minus the signal, seconds until it ended); what it printed is in `seen`."""
        begin = time.monotonic()
        while self.read(max(0.0, timeout_s - (time.monotonic() - begin))):
            pass
        _, status = os.waitpid(self.process, 0)
        os.close(self.master)
        return os.waitstatus_to_exitcode(status), time.monotonic() - begin

    def lines(self):
        """What stands on the screen in the end: a line is rewritten from its beginning."""
        lines = []
        for line in self.seen.replace("\r\n", "\n").split("\n"):
            lines.append(line.rsplit("\r\x1b[K", 1)[-1])
        return lines
