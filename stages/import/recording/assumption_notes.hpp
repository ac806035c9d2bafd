#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/motion/assumption.hpp"

namespace morphe::imports {

// Parts of import notes that tell of an assumption. The code that writes such a note uses them.
inline constexpr std::string_view kAxesAssumed = "axes not in the file; assumed";
inline constexpr std::string_view kFacesScreen = "the subject is assumed to face into the screen";
inline constexpr std::string_view kUnitAssumed = "unit not in the file; assumed";
inline constexpr std::string_view kTimeUnitAssumed = "not in the file; assumed";
inline constexpr std::string_view kRightHandAssumed = "right hand assumed";
inline constexpr std::string_view kHandReaches = "hand reaches: ";
inline constexpr std::string_view kHandCurls = "judged by the curl of its fingers";
inline constexpr std::string_view kStaticTrialChosen = ", chosen from";
inline constexpr std::string_view kNoStaticTrialEstimate = "no static trial: joint centres";
inline constexpr std::string_view kSensorsAtJoints = "the sensors are assumed to be at the joints";
inline constexpr std::string_view kGloveZero = "the zero of the glove is used";
inline constexpr std::string_view kNamesMapped = "names mapped by";
inline constexpr std::string_view kFacesY = "so that the person faces Y";

/// Returns an assumption for each note that tells of one, with the note as its value.
std::vector<Assumption> assumptions_in(const std::vector<std::string>& notes);

}  // namespace morphe::imports
