#pragma once

#include <hdf5.h>

#include <cstdint>

namespace morphe::store {

/// How HDF5 calls a C++ number.
inline hid_t memory_type(double) { return H5T_NATIVE_DOUBLE; }
inline hid_t memory_type(std::int32_t) { return H5T_NATIVE_INT32; }
inline hid_t memory_type(std::uint8_t) { return H5T_NATIVE_UINT8; }

}  // namespace morphe::store
