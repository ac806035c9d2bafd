#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Rotation from a skeleton's own axes into the world, read off the skeleton itself:
///   up     the file axis within 15 degrees of root -> middle of the shoulders at rest; it must
///   also
///          be the one that the recorded trunk is nearest to on average
///   right  the file axis within 15 degrees of left -> right shoulder at rest (hips if there are no
///          shoulders: right_hip, left_hip)
/// Which way the subject faces in the recording is not its business (facing.hpp). What it took goes
/// into `reports`. `rest` [joints] and `body.position` in the
/// file's axes, the first joint the root. InputError "FILE: axes: …" that asks for them where the
/// skeleton does not say it: names missing, not near an axis, rest and recording of two minds,
/// shoulders above each other in the first frame.
Eigen::Matrix3d world_from_skeleton(const BodyStream& body, const std::vector<Vec3>& rest,
                                    const std::string& file, std::vector<std::string>& reports);

}  // namespace morphe::imports
