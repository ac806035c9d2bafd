#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>

namespace morphe::store {

/// Returns the HDF5 type of a double in memory.
inline hid_t memory_type(double) { return H5T_NATIVE_DOUBLE; }
/// Returns the HDF5 type of a 32-bit integer in memory.
inline hid_t memory_type(std::int32_t) { return H5T_NATIVE_INT32; }
/// Returns the HDF5 type of a byte in memory.
inline hid_t memory_type(std::uint8_t) { return H5T_NATIVE_UINT8; }

/// Returns true if a link of a group points into another file.
inline bool is_external_link(hid_t group, const std::string& name) {
  H5L_info_t link{};
  return H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) >= 0 &&
         link.type == H5L_TYPE_EXTERNAL;
}

}  // namespace morphe::store
