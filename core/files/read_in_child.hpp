#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace morphe::files {

/// Reads a file in a child process of its own, which is confined (confine.hpp) and gives nothing
/// back: what a library of others does with a file that was made to hurt, crash or go on without
/// end, is found out there. Why the file is not to be read, "" if `read` came to its end or threw
/// InputError, which is for the file's reader to say. Processor time is bounded by 10 s and 1 s a
/// megabyte of the file, memory by 1 GiB and 32 times the file.
std::string fault_in_child(const std::filesystem::path& file, const std::function<void()>& read);

}  // namespace morphe::files
