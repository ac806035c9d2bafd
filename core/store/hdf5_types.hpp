#pragma once

#include <hdf5.h>

#include <cstdint>
#include <string>

namespace morphe::store {

/// How HDF5 calls a C++ number.
inline hid_t memory_type(double) { return H5T_NATIVE_DOUBLE; }
inline hid_t memory_type(std::int32_t) { return H5T_NATIVE_INT32; }
inline hid_t memory_type(std::uint8_t) { return H5T_NATIVE_UINT8; }

/// Whether a link of a group is one into another file.
inline bool leads_outside(hid_t group, const std::string& name) {
  H5L_info_t link{};
  return H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) >= 0 &&
         link.type == H5L_TYPE_EXTERNAL;
}

}  // namespace morphe::store
