#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::study {

/// The agreement of one of Morphe's joint angles with the same angle of another software.
struct AngleAgreement {
  std::string angle;  ///< name of the angle in Morphe
  double correlation = kUnknown;
  double rms_rad = kUnknown;     ///< root mean square of the difference after its mean is removed
  double offset_rad = kUnknown;  ///< mean difference, which arises from two definitions of zero
  double lag_s = 0;              ///< time from the motion's first frame to the file's first row
  int n = 0;                     ///< number of compared rows; below 10, the rest is unknown
};

/// Compares the angles of a recording, reconstructed as `motion`, with a ue-adl `*angles.csv`
/// (degrees, a row every 10 ms, cut to the movement, columns by name). The file does not contain
/// its start time in the recording. It is aligned so that its "Finger Velocity" correlates best
/// with the speed of our index tip, which does not depend on the angles. If the tip is not seen
/// throughout, the file is aligned to the least rms of the elbow flexion.
///
/// The first results are the reconstructed angles: "elbow flexion", the angle between upper arm and
/// forearm, and the angles of shoulder and forearm in `motion.arm_angles`, with their signs adapted
/// to the file. The other results, "by the file's definition", are rotations of the marker clusters
/// (cluster_angles.hpp), which differ from those of the bones: skin follows the rotation of the arm
/// only in part, and seven angles do not represent the carrying angle of the elbow. Angles that
/// cannot be computed are left out. Throws InputError for a file that is not of this kind.
std::vector<AngleAgreement> compare_with_angle_file(const Demonstration& demonstration,
                                                    const HumanMotion& motion,
                                                    const reconstruct::ReconstructOptions& options,
                                                    const std::filesystem::path& file);

}  // namespace morphe::study
