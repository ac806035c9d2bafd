#pragma once

#include <cstdint>

namespace morphe::files {

/// Takes from this process, for good, what reading a file does not need: processor time beyond
/// `seconds` (SIGXCPU ends it), memory beyond `bytes`, core files, and, where the kernel filters
/// system calls, all but reading: it can write nothing, start nothing and talk to nobody.
void confine_to_reading(std::uint64_t seconds, std::uint64_t bytes);

}  // namespace morphe::files
