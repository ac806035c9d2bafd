#include "core/files/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace morphe::files {

std::string encode_base64(std::string_view bytes) {
  constexpr std::size_t kBlock_bytes = 3U << 20U;  // an int, and divisible by 3: no padding
  std::string text;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kBlock_bytes))) {
    const std::string_view part = bytes.substr(0, kBlock_bytes);
    std::string coded((part.size() + 2) / 3 * 4 + 1, '\0');  // including a terminating zero
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(coded.data()),
                                       reinterpret_cast<const unsigned char*>(part.data()),
                                       static_cast<int>(part.size()));
    text.append(coded, 0, length);
  }
  return text;
}

}  // namespace morphe::files
