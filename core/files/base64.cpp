#include "core/files/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace morphe::files {

std::string encode_base64(std::string_view bytes) {
  constexpr std::size_t kBlock_bytes = 3U << 20U;  // EVP_EncodeBlock takes lengths as int
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += kBlock_bytes) {
    const std::string_view part = bytes.substr(at, kBlock_bytes);
    std::string coded((part.size() + 2) / 3 * 4 + 1, '\0');  // including a terminating zero
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(coded.data()),
                                       reinterpret_cast<const unsigned char*>(part.data()),
                                       static_cast<int>(part.size()));
    text.append(coded, 0, length);
  }
  return text;
}

}  // namespace morphe::files
