#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morphe::imports {

/// What a word of a recorded name means.
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

/// In the order of kFingerNames.
inline constexpr BodyWord kFingerWords[] = {BodyWord::thumb, BodyWord::index, BodyWord::middle,
                                            BodyWord::ring, BodyWord::little};

/// A recorded name taken apart: "mixamorig:RightHandIndex3_end" is {right, hand, index, tip}, 3.
struct RecordedWords {
  std::vector<BodyWord> words;
  std::vector<int> numbers;
  bool strange = false;  ///< holds letters that are none of the words

  bool has(BodyWord word) const;
};

/// Takes a name apart at signs, capitals and digits ("SUBJECT:" before it aside), and what is left
/// into words, those of several languages and their usual short forms ("RELB", "upperarm_l",
/// "右ひじ").
RecordedWords recorded_words_of(std::string_view name);

}  // namespace morphe::imports
