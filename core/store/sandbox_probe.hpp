#pragma once

#include <filesystem>

namespace morphe::store {

/// Reads the whole content of an HDF5 file in a confined child process (files/read_in_child.hpp),
/// because the HDF5 library crashes on some maliciously crafted files and does not terminate on
/// others. Throws InputError for such a file. Files that are missing or not HDF5, and other errors,
/// are left to the file's reader. Must be called before other threads use HDF5.
void probe_in_sandbox(const std::filesystem::path& file);

}  // namespace morphe::store
