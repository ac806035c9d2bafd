#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/recording_flag.hpp"

namespace morphe::imports {

/// A statement that would remove a doubt, which only the user can make.
struct AuditQuestion {
  std::string key;    ///< "axes", "unit", "rate", "hand" or "static_trial"
  std::string value;  ///< the likely answer; "" if the recording does not tell
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
  std::string file;  ///< for messages
  bool axes_given = false, unit_given = false, rate_given = false, hand_given = false;
  std::vector<FlagCode> accepted = {};  ///< doubts that the user has answered
};

}  // namespace morphe::imports
