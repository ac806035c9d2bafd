#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::study {

/// The agreement of one of Morphe's joint angles with the same angle of another software.
struct AngleAgreement {
  /// Morphe's name of the angle.
  std::string angle;
  /// The correlation of the two angles.
  double correlation = kUnknown;
  /// Root mean square of the difference after its mean is removed [rad].
  double rms_rad = kUnknown;
  /// The mean difference, which arises from two definitions of zero [rad].
  double offset_rad = kUnknown;
  /// Time in the recording at which the file begins [s].
  double lag_s = 0;
  /// Number of compared samples.
  std::size_t n = 0;
};

/// Compares a recording with a ue-adl `*angles.csv` (degrees, a row every 10 ms, cut to the
/// movement, columns by name). The file does not contain its start time in the recording. It is
/// aligned so that its "Finger Velocity" correlates best with the speed of our index tip, which
/// does not depend on any of the angles; if the tip is not seen throughout, it is aligned so that
/// our elbow flexion agrees best (least rms).
///
/// The first results are the reconstructed angles: "elbow flexion", the angle between upper arm and
/// forearm, and the angles of shoulder and forearm in `motion.arm_angles`, with their signs adapted
/// to the file. The other results, "by the file's definition", are rotations of the marker clusters
/// (see cluster_angles.hpp). They differ from the rotations of the bones because skin follows the
/// rotation of upper arm and forearm only in part, and because seven angles do not represent the
/// carrying angle of the elbow. Angles that cannot be computed are left out. Throws InputError for
/// a file that is not of this kind.
std::vector<AngleAgreement> compare_with_angle_file(const Demonstration& demonstration,
                                                    const HumanMotion& motion,
                                                    const reconstruct::ReconstructOptions& options,
                                                    const std::filesystem::path& file);

}  // namespace morphe::study
