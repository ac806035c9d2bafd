#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Determines the rotation from a skeleton's own axes to the world from the skeleton itself:
///   up     the file axis within 15 degrees of root -> middle of the shoulders at rest; it must
///          also be the one nearest to the recorded trunk on average
///   right  the file axis within 15 degrees of left -> right shoulder at rest (hips if there are
///          no shoulders: right_hip, left_hip)
/// The heading of the subject in the recording is determined in heading.hpp. The axes used are
/// added to `reports`. `rest` [joints] and `body.position` are in the file's axes, the first joint
/// is the root. Throws InputError "FILE: axes: …" that asks for the axes if the skeleton does not
/// determine them: names missing, directions not near an axis, rest and recording contradictory, or
/// shoulders above each other in the first frame.
Eigen::Matrix3d world_from_skeleton(const BodyStream& body, const std::vector<Vec3>& rest,
                                    const std::string& file, std::vector<std::string>& reports);

}  // namespace morphe::imports
