#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {

/// A recording on disk and the files that belong to it.
struct RecordingFiles {
  std::filesystem::path file;                       ///< the recording
  std::filesystem::path static_trial;               ///< or calibration pose; may be empty
  std::filesystem::path glove, glove_static_trial;  ///< a glove's files for these two; may be empty
  std::filesystem::path glove_calibration;          ///< YAML, for raw counts; may be empty
  std::map<std::string, std::string> name_map;  ///< recorded marker or joint name -> Morphe's name
  Side hand = Side::right;                      ///< the recorded hand
  Conventions conventions;
};

/// A recording format. `recognises` tests the first bytes of a file, without a UTF-8 mark. `read`
/// fills streams, calibration, objects and other data of the file, in the world frame and in
/// metres, and lists its assumptions and repairs in `import_notes`. It throws InputError for a
/// violation of the format, UnresolvedConvention for missing or implausible conventions.
struct RecordingFormat {
  std::string name;  ///< one of import_format_names()
  bool (*recognises)(std::string_view head);
  Demonstration (*read)(const RecordingFiles& files);
  /// The keys of Conventions, such as "rate", that the reader does not need and does not use.
  std::vector<std::string> ignored_conventions = {};
};

}  // namespace morphe::imports
