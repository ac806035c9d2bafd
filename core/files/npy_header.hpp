#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::files {

/// The head of a .npy file: magic, version, length and a Python dictionary of three keys.
struct NpyHeader {
  char kind = 'f';       ///< b, i, u, f, U or S
  std::size_t item = 8;  ///< bytes of one value
  bool big_endian = false;
  bool first_fastest = false;  ///< "fortran_order"
  std::vector<std::size_t> shape;
  std::size_t count = 1;  ///< product of shape
  std::size_t data = 0;   ///< where in the file the values begin
};

/// `fail` throws, with a sentence that says what is wrong.
using NpyFault = std::function<void(const std::string& what)>;

/// Of the bytes of a .npy. What Morphe does not read (objects, structures, complex numbers, dates)
/// and a shape that the file cannot hold are faults.
NpyHeader read_npy_header(std::string_view bytes, const NpyFault& fail);

}  // namespace morphe::files
