#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// The meaning of a word in a recorded name.
enum class BodyWord : std::uint8_t {
  left,
  right,
  upper,
  lower,
  arm,
  upper_arm,
  forearm,
  leg,
  thigh,
  shin,
  shoulder,
  scapula,
  clavicle,
  elbow,
  epicondyle,
  lateral,
  medial,
  wrist,
  styloid,
  radial,
  ulnar,
  hand,
  finger,
  thumb,
  index,
  middle,
  ring,
  little,
  tip,
  mcp,
  pip,
  dip,
  ip,
  cmc,
  proximal,
  intermediate,
  distal,
  metacarpal,
  hip,
  pelvis,
  head,
  neck,
  trunk,
  knee,
  ankle,
  foot,
  toe,
  twist,
  filler
};

/// The fingers' words in the order of kFingerNames.
inline constexpr BodyWord kFingerWords[] = {BodyWord::thumb, BodyWord::index, BodyWord::middle,
                                            BodyWord::ring, BodyWord::little};

/// A parsed name: "mixamorig:RightHandIndex3_end" is {right, hand, index, tip}, 3.
struct RecordedWords {
  std::vector<BodyWord> words;    ///< known words, in order
  std::vector<int> numbers;       ///< numbers, in order
  bool has_unknown_word = false;  ///< true if it contains letters that are not a known word

  /// Returns true if the name contains this word.
  bool has(BodyWord word) const;
};

/// Splits a name at punctuation, capitals and digits (without the prefix "SUBJECT:"), and the
/// remaining letters into words of several languages and their usual abbreviations ("RELB",
/// "upperarm_l", "右ひじ").
RecordedWords parse_recorded_name(std::string_view name);

}  // namespace morphe::imports
