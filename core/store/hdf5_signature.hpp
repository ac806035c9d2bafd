#pragma once

#include <filesystem>

namespace morphe::store {

/// Returns true if a file begins with the HDF5 signature; false if it cannot be read.
bool has_hdf5_signature(const std::filesystem::path& file);

}  // namespace morphe::store
