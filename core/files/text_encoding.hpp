#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

bool is_utf8(std::string_view text);
/// Text of the usual one-byte encoding of western Europe (ISO 8859-1) as UTF-8.
std::string utf8_from_latin1(std::string_view text);

}  // namespace morphe::files
