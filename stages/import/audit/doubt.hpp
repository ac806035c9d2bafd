#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/recording_flag.hpp"
#include "stages/import/guess/convention_guess.hpp"

namespace morphe::imports {

/// A statement that would remove a doubt, which only the user can make.
struct AuditQuestion {
  std::string key;  ///< "axes", "unit", "rate", "hand" or "static_trial"
  /// The likely answer; "" if the recording does not tell. Of axes, those of the world that point
  /// right, forward and up.
  std::string value;
  std::string reason = {};  ///< of the answer, half a sentence; "" for the text of the flag
  Confidence confidence = Confidence::sure;  ///< in the answer
};

/// What a check found.
struct Doubt {
  RecordingFlag flag;  ///< its response is set by the audit
  /// Changes the recording such that the doubt is gone; empty if the right change is not certain.
  std::function<void(Demonstration&)> mend = {};
  /// Set if the recording cannot be used before the user has answered.
  std::optional<AuditQuestion> question = {};
};

/// What the user stated about a recording.
struct AuditInput {
  std::string file = {};  ///< for messages
  bool axes_given = false, unit_given = false, rate_given = false, hand_given = false;
  std::vector<FlagCode> accepted = {};  ///< doubts that the user has answered
  /// Returns the answer to propose for a doubt's question, such as the recorded axes in place of
  /// those in the world, with its reason; nothing if no answer removes the doubt, which is then
  /// only flagged. Without this function, the value of the question is proposed.
  std::function<std::optional<Guess>(const Doubt&)> answer = {};
};

}  // namespace morphe::imports
