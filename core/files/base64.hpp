#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

/// Encodes bytes by RFC 4648, with padding, without line breaks.
std::string encode_base64(std::string_view bytes);

}  // namespace morphe::files
