#pragma once

#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// The formats of motion capture systems and tables, as RecordingFormat describes the two functions.

bool recognises_vicon_csv(std::string_view head);
Demonstration read_vicon_csv(const RecordingFiles& files);

bool recognises_trc(std::string_view head);
Demonstration read_trc(const RecordingFiles& files);

bool recognises_c3d(std::string_view head);
Demonstration read_c3d(const RecordingFiles& files);

bool recognises_liberty_csv(std::string_view head);
Demonstration read_liberty_csv(const RecordingFiles& files);

bool recognises_adroit_csv(std::string_view head);
Demonstration read_adroit_csv(const RecordingFiles& files);

bool recognises_bvh(std::string_view head);
Demonstration read_bvh(const RecordingFiles& files);

bool recognises_mot(std::string_view head);
Demonstration read_mot(const RecordingFiles& files);

bool recognises_qualisys_tsv(std::string_view head);
Demonstration read_qualisys_tsv(const RecordingFiles& files);

bool recognises_point_csv(std::string_view head);
Demonstration read_point_csv(const RecordingFiles& files);

bool recognises_keypoints_csv(std::string_view head);
Demonstration read_keypoints_csv(const RecordingFiles& files);

bool recognises_optitrack_csv(std::string_view head);
Demonstration read_optitrack_csv(const RecordingFiles& files);

}  // namespace morphe::imports
