#pragma once

#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::imports {

/// Returns the rotation from a skeleton's own axes to the world, determined from the skeleton:
///   up     the axis within 15 degrees of root -> middle of the shoulders in the rest skeleton; it
///          must also be the axis nearest to the mean direction of the trunk in the recording
///   right  the axis within 15 degrees of left -> right shoulder in the rest skeleton; if these
///          coincide, of left -> right hip
/// The axes are added to `reports`. heading.hpp determines the heading of the subject. `rest` has
/// the joints' positions in the rest skeleton. It and `body.position` are in the file's axes; the
/// first joint is the root. Throws UnresolvedConvention "axes" if no joints are named as shoulders,
/// directions are not near an axis, rest and recording contradict each other, or the shoulders are
/// not level in the first frame.
Eigen::Matrix3d world_from_skeleton(const BodyStream& body, const std::vector<Vec3>& rest,
                                    const std::string& file, std::vector<std::string>& reports);

}  // namespace morphe::imports
