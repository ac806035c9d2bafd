#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// The header of a .npy file: magic, version, length and a Python dictionary with three keys.
struct NpyHeader {
  char kind = 'f';            ///< b, i, u, f, U or S
  std::size_t item_size = 8;  ///< bytes of one value
  bool big_endian = false, fortran_order = false;
  std::vector<std::size_t> shape;
  std::size_t count = 1;        ///< product of shape
  std::size_t data_offset = 0;  ///< offset of the values in the file
};

/// Throws an error about the array: `what` follows its name, as in "is not a .npy file".
using NpyErrorHandler = std::function<void(const std::string& what)>;

/// Parses the header of a .npy file. Types that Morphe does not read (objects, structures, complex
/// numbers, dates) and a shape that exceeds the file are errors.
NpyHeader read_npy_header(std::string_view bytes, const NpyErrorHandler& fail);

}  // namespace morphe::files
