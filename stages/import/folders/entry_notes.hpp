#pragma once

#include <string_view>

namespace morphe::imports {

// The beginnings of notes of a ManifestEntry that the summary of an import counts.
inline constexpr std::string_view kNoStaticTrial = "no static trial found";
inline constexpr std::string_view kRightHandAssumed = "right hand assumed";
inline constexpr std::string_view kMovingStaticTrial = "named like a static trial";

}  // namespace morphe::imports
