#pragma once

#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// The formats of headsets, gloves and suits, as RecordingFormat describes the two functions.

bool recognises_aria_csv(std::string_view head);
Demonstration read_aria_csv(const RecordingFiles& files);

bool recognises_hot3d(std::string_view head);
Demonstration read_hot3d(const RecordingFiles& files);

bool recognises_mvnx(std::string_view head);
Demonstration read_mvnx(const RecordingFiles& files);

bool recognises_manus_csv(std::string_view head);
Demonstration read_manus_csv(const RecordingFiles& files);

bool recognises_avp_jsonl(std::string_view head);
Demonstration read_avp_jsonl(const RecordingFiles& files);

bool recognises_avp_npz(std::string_view head);
Demonstration read_avp_npz(const RecordingFiles& files);

bool recognises_egodex_hdf5(std::string_view head);
Demonstration read_egodex_hdf5(const RecordingFiles& files);

}  // namespace morphe::imports
