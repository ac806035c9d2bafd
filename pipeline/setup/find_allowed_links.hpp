#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/motion/robot_model.hpp"

namespace morphe::setup {

/// Two frames whose capsules need not be checked against each other, and the reasons.
struct AllowedPair {
  int first = -1, second = -1;    ///< frames; -1 is the base
  double share = 0;               ///< share of the sampled postures in which they overlap
  double rest_penetration_m = 0;  ///< overlap at rest
};

/// Finds the pairs of frames with capsules whose collision should be allowed. Two frames overlap if
/// they are less than 1.5 mm apart, which is hardly compatible with a margin of 1 mm. A pair is
/// allowed if
///   - it overlaps in 95 % of 400 random postures of the joints between the frames, from a fixed
///     seed for each pair, which indicates that the frames overlap by design; or
///   - it has at most three joints between its frames and penetrates at rest by more than 4 mm; or
///   - one joint moves both frames, each in its own way, and they overlap in one of these postures,
///     for example the bars of a gripper, whose loop a URDF cuts open.
/// All others remain checked, because random postures without contact do not prove its absence.
/// Pairs that `robot` already allows are left out, such as neighbours.
std::vector<AllowedPair> find_allowed_links(const RobotModel& robot);

/// Returns the key `allowed_links` of a description with these pairs, "" if there are none.
std::string allowed_links_yaml(const std::vector<AllowedPair>& pairs,
                               const std::function<std::string(int)>& name_of_frame);

}  // namespace morphe::setup
