#pragma once

#include <filesystem>

namespace morphe::store {

/// Reads everything that an HDF5 file holds in a confined child process first
/// (files/read_in_child.hpp): the HDF5 library crashes on some files that were made for it, and
/// does not come to an end on others. InputError for such a file; whatever else is wrong with one
/// its reader says, also if it is none, or no HDF5. To be called before other threads use HDF5.
void expect_harmless(const std::filesystem::path& file);

}  // namespace morphe::store
