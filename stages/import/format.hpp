#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/motion/demonstration.hpp"

namespace morphe {

/// One recording on disk and what belongs to it.
struct RecordingFiles {
  std::filesystem::path file;
  std::filesystem::path static_trial;          ///< empty = none
  std::map<std::string, std::string> renamed;  ///< recorded marker name -> name used here
};

/// A recording format: `recognises` judges the first bytes of a file, `read` fills the streams,
/// the calibration and the objects (and the subject, if the file names one).
struct RecordingFormat {
  std::string name;
  bool (*recognises)(std::string_view head);
  Demonstration (*read)(const RecordingFiles& files);
};

/// Every format there is: one line each, in the order in which they are tried.
const std::vector<RecordingFormat>& recording_formats();

bool recognises_vicon_csv(std::string_view head);
Demonstration read_vicon_csv(const RecordingFiles& files);

bool recognises_adroit_csv(std::string_view head);
Demonstration read_adroit_csv(const RecordingFiles& files);

}  // namespace morphe
