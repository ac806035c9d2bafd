#pragma once

namespace morphe::commands {

/// Redirects stdout and stderr such that their text is escaped by files::make_printable(), except
/// for line ends, tabs and the control sequence that clears the status line. Writing never fails:
/// text that stderr does not accept is lost; flush_standard_output() reports errors of stdout.
/// Opens closed descriptors 0 to 2, so that no file gets one. To be called once, before any output.
void guard_standard_streams();

/// Flushes stdout. Returns the exit code of a command that ended with `code`: `code`, or 2 if
/// stdout did not accept all of the text. Prints a message then, unless the reader closed the pipe.
int flush_standard_output(int code);

}  // namespace morphe::commands
