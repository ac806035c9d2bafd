#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// One recording on disk and what belongs to it.
struct RecordingFiles {
  std::filesystem::path file;
  std::filesystem::path static_trial;          ///< or calibration pose; empty = none
  std::filesystem::path glove, static_glove;   ///< of their own, beside the two; empty = none
  std::filesystem::path glove_calibration;     ///< YAML, for raw counts; empty = none
  std::map<std::string, std::string> renamed;  ///< recorded marker or joint name -> name used here
  Side hand = Side::right;                     ///< which one was recorded
  Conventions conventions;                     ///< what the file itself does not say
};

/// A recording format: `recognises` judges the first bytes of a file (without a UTF-8 mark), `read`
/// fills the streams, the calibration and the objects (and what else the file says: the subject),
/// in the world frame and in metres, and says in `reports` what it assumed or repaired. InputError
/// for what is not exactly what the format says, NotSaid for axes, a unit or a rate that neither
/// the file nor `conventions` gives, or that cannot be right: import_question.hpp asks for them all
/// at once.
struct RecordingFormat {
  std::string name;
  bool (*recognises)(std::string_view head);
  Demonstration (*read)(const RecordingFiles& files);
};

}  // namespace morphe::imports
