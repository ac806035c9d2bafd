#pragma once

#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// RecordingFormat is the contract of the two functions of each format.

/// Returns true for the first bytes of a file of Vicon's CSV.
bool recognises_vicon_csv(std::string_view head);
/// Reads a file of Vicon's CSV.
Demonstration read_vicon_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of TRC.
bool recognises_trc(std::string_view head);
/// Reads a file of TRC.
Demonstration read_trc(const RecordingFiles& files);

/// Returns true for the first bytes of a file of C3D.
bool recognises_c3d(std::string_view head);
/// Reads a file of C3D.
Demonstration read_c3d(const RecordingFiles& files);

/// Returns true for the first bytes of a file of Polhemus Liberty sensors and a CyberGlove.
bool recognises_liberty_csv(std::string_view head);
/// Reads a file of Polhemus Liberty sensors and a CyberGlove.
Demonstration read_liberty_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of Adroit demonstrations.
bool recognises_adroit_csv(std::string_view head);
/// Reads a file of Adroit demonstrations.
Demonstration read_adroit_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of BVH.
bool recognises_bvh(std::string_view head);
/// Reads a file of BVH.
Demonstration read_bvh(const RecordingFiles& files);

/// Returns true for the first bytes of a file of OpenSim's joint coordinates.
bool recognises_mot(std::string_view head);
/// Reads a file of OpenSim's joint coordinates.
Demonstration read_mot(const RecordingFiles& files);

/// Returns true for the first bytes of a file of Qualisys Track Manager's TSV.
bool recognises_qualisys_tsv(std::string_view head);
/// Reads a file of Qualisys Track Manager's TSV.
Demonstration read_qualisys_tsv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of points as text.
bool recognises_point_csv(std::string_view head);
/// Reads a file of points as text.
Demonstration read_point_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of 21 hand keypoints as text.
bool recognises_keypoints_csv(std::string_view head);
/// Reads a file of 21 hand keypoints as text.
Demonstration read_keypoints_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of OptiTrack's CSV.
bool recognises_optitrack_csv(std::string_view head);
/// Reads a file of OptiTrack's CSV.
Demonstration read_optitrack_csv(const RecordingFiles& files);

}  // namespace morphe::imports
