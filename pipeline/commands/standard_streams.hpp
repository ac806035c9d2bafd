#pragma once

namespace morphe::commands {

/// Redirects stdout and stderr such that their text is escaped by files::make_printable(), except
/// for line ends, tabs and the control sequence that clears the status line. Writing never fails:
/// text that stderr does not accept is lost, and errors of stdout are reported at the end.
/// Descriptors 0 to 2 are opened, so that no file is given one of them. To be called once, before
/// any output.
void guard_standard_streams();

/// Flushes stdout and returns the exit code of a command that ended with `code`: 2, with a message,
/// if stdout did not accept all of the text. There is no message if the reader closed the pipe, as
/// `head` does.
int flush_standard_output(int code);

}  // namespace morphe::commands
