#pragma once

#include <optional>
#include <vector>

#include "pipeline/setup/joint_centres.hpp"

namespace morphe::setup {

/// The roles of the moving frames from the base to a hand, or to the end of an arm.
struct Arm {
  std::vector<int> trunk;   ///< before the shoulder: waist, lift, mobile base
  std::vector<int> frames;  ///< of the arm, from the shoulder on
  std::vector<int> shoulder;
  int elbow = -1;
  ArmCentres centres;
  std::vector<int> other_elbows;  ///< frames that would fit as well
};

/// Frames that a person named, -1 = to be found.
struct ArmAnswers {
  int first = -1;  ///< the first frame of the arm
  int elbow = -1;
};

/// Finds the arm on a path of moving frames by its proportions, from the end inwards:
///   elbow     the last hinge that folds two bones whose lengths differ by at most a factor of 3.3,
///             where a bone is the distance of the shoulder or the wrist from its axis, which no
///             other joint changes
///   shoulder  the axes right before the elbow: a lift parallel to the elbow's and the pan before
///             it; or the axis that twists the upper arm, which passes the elbow, and one or two
///             before it
///   wrist     the axes beyond the elbow (wrist_centre())
///   trunk     all others, and all up to the last sliding joint before the elbow
/// Complete shoulders, wrists that axes define, joints called elbow, and shoulders without joints
/// called waist or torso are preferred, in this order. `end` is a point at the end of the path, if
/// known. Returns nullopt if no hinge fits.
std::optional<Arm> find_arm(const Kinematics& robot, const std::vector<int>& path,
                            const std::optional<Vec3>& end, const ArmAnswers& answers);

/// Returns the frames of a path before the last one that carries another limb: a branch with at
/// least three further joints, as that of a second arm. They belong to the trunk.
int trunk_length(const Kinematics& robot, const std::vector<int>& path);

}  // namespace morphe::setup
