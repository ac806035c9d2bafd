#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/setup/capsules.hpp"
#include "pipeline/setup/find_allowed_links.hpp"

namespace morphe::setup {

/// Fits the capsules of links again whose shapes are clear of each other at rest, but whose
/// capsules are not: with up to `budget` capsules that stay nearer to their own link than to the
/// other. Pairs whose capsules are still not clear afterwards remain checked all the same.
/// `pairs` and `bodies` are those of judge_pairs().
void clear_covers(const Kinematics& robot, const LinkShapes& shapes, const LinkBodies& bodies,
                  const std::vector<LinkPair>& pairs, int budget, std::vector<LinkCapsules>& links);

/// Returns a sentence on each pair that remains checked although its capsules overlap at rest,
/// which loses postures near it, on those that are excused, and on excuses without shapes.
std::vector<std::string> pairs_to_check(const RobotModel& robot, const std::vector<LinkPair>& pairs,
                                        const std::function<std::string(int)>& name_of_frame);

}  // namespace morphe::setup
