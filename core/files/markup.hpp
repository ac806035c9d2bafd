#pragma once

#include <string>
#include <string_view>

namespace morphe::files {

/// Escapes & < > " in text for XML; removes control characters other than line feed and tab.
std::string escape_xml(std::string_view text);

/// Returns the beginning of an SVG of this size [pixels], to be completed by content and "</svg>".
std::string svg_header(double width, double height, int font_size);

}  // namespace morphe::files
