#pragma once

#include <filesystem>

namespace morphe::store {

/// Whether a file begins as HDF5 files do; not if it cannot be read.
bool has_hdf5_signature(const std::filesystem::path& file);

}  // namespace morphe::store
