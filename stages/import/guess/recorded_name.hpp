#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// The meaning of a word in a recorded name, whatever its language: `elbow` for "elb" and "coude".
// clang-format off
enum class BodyTerm : std::uint8_t {
  left, right, upper, lower,
  arm, upper_arm, forearm, shoulder, scapula, clavicle, elbow, epicondyle, lateral, medial,
  wrist, styloid, radial, ulnar, hand, finger, thumb, index, middle, ring, little,
  tip, mcp, pip, dip, ip, cmc, proximal, intermediate, distal, metacarpal,
  leg, thigh, shin, hip, pelvis, head, neck, trunk, knee, ankle, foot, toe,
  twist, quantity, filler
};
// clang-format on

/// The fingers' terms in the order of kFingerNames.
inline constexpr BodyTerm kFingerTerms[] = {BodyTerm::thumb, BodyTerm::index, BodyTerm::middle,
                                            BodyTerm::ring, BodyTerm::little};

/// A parsed name: "mixamorig:RightHandIndex3_end" is {right, hand, index, tip}, {3}.
struct RecordedName {
  std::vector<BodyTerm> terms;    ///< meanings of the known words, in order
  std::vector<int> numbers;       ///< in order; 0 for one of more than kMaxDigits digits
  bool has_unknown_word = false;  ///< true if it contains letters that are not known words

  bool has(BodyTerm term) const { return std::ranges::find(terms, term) != terms.end(); }
};

/// Parses a name without its prefix "SUBJECT:". It is split at punctuation, capitals and digits,
/// each piece then into known words of several languages and abbreviations ("RELB", "右ひじ").
RecordedName parse_recorded_name(std::string_view name);

}  // namespace morphe::imports
