#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/side.hpp"

namespace morphe::imports {

/// The side of a joint's or bone's end on which a point is.
enum class PointSide : std::uint8_t { unstated, lateral, medial, radial, ulnar };

/// What the letters and words of a name state about sides.
struct NameSide {
  std::optional<Side> body;  ///< of the person
  PointSide joint = PointSide::unstated;
};

/// Returns the side of each name, judged by all names of a file: a final L beside the same name
/// with a final M is lateral, and that one medial, unless the name with R exists too; R beside U is
/// radial, and ulnar; the same holds for first letters. Other letters L and R, and words (left,
/// rechts), are the side of the body.
std::vector<NameSide> sides_of_names(const std::vector<std::string>& names);

/// Returns the words, in small letters, that mean a side in any of the known languages.
const std::vector<std::string_view>& side_words(Side side);

}  // namespace morphe::imports
