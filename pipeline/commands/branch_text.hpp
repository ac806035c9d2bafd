#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/motion/arm_branch.hpp"
#include "pipeline/commands/plan_row.hpp"

namespace morphe::commands {

/// Returns a branch as a phrase, "shoulder left, elbow up, wrist flipped", without its changes
/// along the path; "" without a branch.
std::string branch_phrase(const ArmBranch& branch);

/// Returns a line with the number of branches of a dataset and, if there are several, lines with
/// the plans of each, the most frequent first; "" if the robot has no branches. `counts` is the
/// number of plans of each phrase, `rows` are those to be named. Lines are wrapped at `width` (0:
/// never).
std::string branches_text(const std::string& robot, const std::map<std::string, int>& counts,
                          const std::vector<PlanRow>& rows, std::size_t width);

/// Adds a line to each row whose plan is not in the branch of most plans: "branch: wrist flipped ->
/// unflipped, unlike 4 of 5 plans". `counts` is as above; without a branch that has more plans than
/// every other, there is no such line.
void note_other_branches(const std::map<std::string, int>& counts, std::vector<PlanRow>& rows);

/// Returns the words in which two branches differ: "shoulder left -> right, wrist flipped ->
/// unflipped"; "" if they are equal or one is unknown.
std::string branch_change(const ArmBranch& first, const ArmBranch& second);

}  // namespace morphe::commands
