#pragma once

#include <cstdint>

namespace morphe::files {

/// Irrevocably confines this process for reading files: SIGXCPU ends it after `seconds` of
/// processor time, memory is limited to `bytes` (not with sanitizers), core files are disabled,
/// and, if the kernel filters system calls, it cannot write, start processes or communicate.
void enter_read_sandbox(std::uint64_t seconds, std::uint64_t bytes);

}  // namespace morphe::files
