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

/// A recording on disk and the files that belong to it.
struct RecordingFiles {
  std::filesystem::path file;          ///< the recording
  std::filesystem::path static_trial;  ///< static trial or calibration pose; may be empty
  /// Separate files of a glove, beside the two; may be empty.
  std::filesystem::path glove, glove_static_trial;
  std::filesystem::path glove_calibration;      ///< YAML, for raw counts; may be empty
  std::map<std::string, std::string> name_map;  ///< recorded marker or joint name -> name used here
  Side hand = Side::right;                      ///< the recorded hand
  Conventions conventions;                      ///< conventions that are not in the file itself
};

/// A recording format. `recognises` tests the first bytes of a file (without a UTF-8 mark). `read`
/// fills the streams, the calibration, the objects and other data of the file (such as the
/// subject), in the world frame and in metres, and lists its assumptions and repairs in
/// `import_notes`. It throws InputError for a violation of the format, and UnresolvedConvention for
/// axes, a unit or a rate that neither the file nor `conventions` gives, or that is implausible:
/// unresolved_import.hpp asks for all of them at once.
struct RecordingFormat {
  std::string name;                           ///< one of import_format_names()
  bool (*recognises)(std::string_view head);  ///< true for the first bytes of a file of this format
  Demonstration (*read)(const RecordingFiles& files);  ///< reads a recording of this format
};

}  // namespace morphe::imports
