#pragma once

#include <string_view>

#include "core/motion/demonstration.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {

// RecordingFormat is the contract of the two functions of each format.

/// Returns true for the first bytes of a file of Project Aria.
bool recognises_aria_csv(std::string_view head);
/// Reads a file of Project Aria.
Demonstration read_aria_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of HOT3D.
bool recognises_hot3d(std::string_view head);
/// Reads a file of HOT3D.
Demonstration read_hot3d(const RecordingFiles& files);

/// Returns true for the first bytes of a file of MVNX.
bool recognises_mvnx(std::string_view head);
/// Reads a file of MVNX.
Demonstration read_mvnx(const RecordingFiles& files);

/// Returns true for the first bytes of a file of Manus gloves.
bool recognises_manus_csv(std::string_view head);
/// Reads a file of Manus gloves.
Demonstration read_manus_csv(const RecordingFiles& files);

/// Returns true for the first bytes of a file of the recorder for Apple Vision Pro.
bool recognises_avp_jsonl(std::string_view head);
/// Reads a file of the recorder for Apple Vision Pro.
Demonstration read_avp_jsonl(const RecordingFiles& files);

/// Returns true for the first bytes of a file of avp_stream.
bool recognises_avp_npz(std::string_view head);
/// Reads a file of avp_stream.
Demonstration read_avp_npz(const RecordingFiles& files);

/// Returns true for the first bytes of a file of EgoDex.
bool recognises_egodex_hdf5(std::string_view head);
/// Reads a file of EgoDex.
Demonstration read_egodex_hdf5(const RecordingFiles& files);

}  // namespace morphe::imports
