#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

/// RFC 4648, with padding, without line breaks.
std::string base64(std::string_view bytes);

}  // namespace morphe::files
