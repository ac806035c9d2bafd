#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/motion/human_motion.hpp"

namespace morphe {

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
/// by name). The file does not say where in the recording it begins: it is laid where its elbow
/// flexion agrees best (least rms), and the other angles are compared there. Elbow flexion is the
/// angle between upper arm and forearm; forearm pronation and the shoulder's angles are those of
/// `motion.arm_angles`, whose signs are turned to the file's. Angles that were not rebuilt are left
/// out. InputError for a file that is not of this kind.
std::vector<AngleAgreement> compare_with_angle_file(const HumanMotion& motion,
                                                    const std::filesystem::path& file);

}  // namespace morphe
