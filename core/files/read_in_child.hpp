#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace morphe::files {

/// Reads a file in a separate, confined child process (sandbox.hpp) that returns no data, to find
/// out whether a third-party library crashes or does not terminate on a maliciously crafted file.
/// Returns the reason why the file must not be read, or "" if `read` returned or threw InputError,
/// which the file's reader will report. Processor time is limited to 10 s plus 1 s per megabyte of
/// the file, memory to 1 GiB plus 32 times the file size. A shortage that is not the file's fault
/// is thrown: std::system_error without a process, std::bad_alloc if this process may take less
/// memory than that.
std::string child_read_error(const std::filesystem::path& file, const std::function<void()>& read);
/// Does the same for a file of this size, on the disk or in memory.
std::string child_read_error(std::uintmax_t file_bytes, const std::function<void()>& read);

}  // namespace morphe::files
