#pragma once

#include <cstdint>

namespace morphe::files {

/// Irrevocably restricts this process to reading files: processor time is limited to `seconds`
/// (SIGXCPU ends it), memory to `bytes`, core files are disabled, and, if the kernel filters system
/// calls, only reading is allowed: it cannot write, start processes or communicate.
void enter_read_sandbox(std::uint64_t seconds, std::uint64_t bytes);

}  // namespace morphe::files
