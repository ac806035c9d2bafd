#include "core/store/hdf5_signature.hpp"

#include <fstream>
#include <string_view>
#include <system_error>

namespace morphe::store {

bool has_hdf5_signature(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::ifstream stream(file, std::ios::binary);
  char first[8] = {};
  stream.read(first, sizeof first);
  return std::string_view(first, sizeof first) == "\x89HDF\r\n\x1a\n";
}

}  // namespace morphe::store
