#include "core/files/base64.hpp"

#include <openssl/evp.h>

#include <algorithm>

namespace morphe::files {

std::string base64(std::string_view bytes) {
  constexpr std::size_t kAtOnce = 3U << 20U;  // its lengths are ints
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += kAtOnce) {
    const std::string_view part = bytes.substr(at, kAtOnce);
    std::string coded((part.size() + 2) / 3 * 4 + 1, '\0');  // it ends in a zero
    const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(coded.data()),
                                       reinterpret_cast<const unsigned char*>(part.data()),
                                       static_cast<int>(part.size()));
    text.append(coded, 0, static_cast<std::size_t>(length));
  }
  return text;
}

}  // namespace morphe::files
