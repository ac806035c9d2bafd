#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

/// Escapes text for XML, including attributes: & < > " become entities, control characters are
/// removed.
std::string escape_xml(std::string_view text);

/// Returns the beginning of an SVG drawing [pixels] on white, to be completed by "</svg>
/// ".
std::string svg_header(double width, double height, int font_size);

}  // namespace morphe::files
