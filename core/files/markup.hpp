#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

/// Text as XML may hold it, in an attribute too: & < > " as entities, control characters left
/// out.
std::string xml_escaped(std::string_view text);

/// The beginning of a drawing [pixels] on white, to be ended by "</svg>\n".
std::string svg_begin(double width, double height, int font_size);

}  // namespace morphe::files
