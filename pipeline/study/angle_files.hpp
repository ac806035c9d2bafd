#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"
#include "core/motion/human_motion.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::study {

/// One of our angles against the same one of somebody else.
struct AngleAgreement {
  std::string angle;  ///< our name
  double correlation = kNotSeen;
  double rms_rad = kNotSeen;     ///< of the difference, its mean removed
  double offset_rad = kNotSeen;  ///< that mean: two definitions of zero
  double lag_s = 0;              ///< where in the recording the file begins
  std::size_t n = 0;             ///< samples compared
};

/// Compares with a ue-adl `*angles.csv` (degrees, a row every 10 ms, cut to the movement, columns
/// by name). The file does not say where in the recording it begins: it is laid where its "Finger
/// Velocity" correlates best with the speed of our index tip, which no angle has a part in; where
/// our elbow flexion agrees best (least rms) if the tip is not seen throughout.
///
/// First what was rebuilt: "elbow flexion", the angle between upper arm and forearm, and shoulder
/// and forearm as `motion.arm_angles` has them, whose signs are turned to the file's. Then, "by the
/// file's definition", the turns of the marker clusters (see cluster_angles.hpp), which differ from
/// those of the bones: skin follows the rotation of upper arm and forearm in part only, and seven
/// angles know no carrying angle of the elbow. Angles that could not be had are left out.
/// InputError for a file that is not of this kind.
std::vector<AngleAgreement> compare_with_angle_file(const Demonstration& demonstration,
                                                    const HumanMotion& motion,
                                                    const reconstruct::ReconstructOptions& options,
                                                    const std::filesystem::path& file);

}  // namespace morphe::study
