#pragma once

namespace morphe::commands {

/// From here on what is written to stdout and stderr is shown as files::printable() has it, but for
/// line ends, tabs and the status line's own clearing of a line. Writing never fails: what stderr
/// does not take is lost, and stdout is asked at the end. Descriptors 0 to 2 are open, so that no
/// file gets one of them. Once, before anything is printed.
void guard_standard_streams();

/// The exit code of a command that ended with `code`: 2, with a message, if stdout did not take
/// everything. Nothing is said where a reader left, as `head` does.
int after_standard_output(int code);

}  // namespace morphe::commands
