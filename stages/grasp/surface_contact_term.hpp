#pragma once

#include <string>
#include <vector>

#include "core/collision/distance.hpp"
#include "core/motion/residual_term.hpp"
#include "core/robot/robot.hpp"
#include "stages/grasp/desired_contact.hpp"

namespace morphe::grasp {

/// Contacts whose points are free to slide along the target's surface: a term of the posture at the
/// grasp. With x the centre of a pad's sphere, r its radius, m the direction of its middle, d(x)
/// the distance of x from the surface, n(x) the inward normal at the surface point nearest to x,
/// and c where x would be if the pad touched the point that the person touched, the residuals of a
/// contact are
///   sqrt(kGapWeight) (d(x) - r),
///   sqrt(kPadDirectionWeight) (m - n(x)),
///   sqrt(kGapWeight) max(0, |x - c| - kMaxSlide_m),
/// the last one 0 if no person touched (a finger that closes by itself).
/// The distance from the desired point is not part of it: the objective's goals of the tips are.
class SurfaceContactTerm final : public ResidualTerm {
 public:
  /// `target` must outlive the term; `base_from_target` is its pose at the grasp.
  SurfaceContactTerm(const robot::Robot& robot, std::vector<DesiredContact> contacts,
                     const collision::Solid& target, const Pose& base_from_target);

  /// Returns "surface contact".
  std::string name() const override { return "surface contact"; }
  /// Sets the residuals [5 contacts] and their Jacobian. The normal's derivative is a central
  /// difference over kNormalStep_m, so that it is also useful on a mesh.
  void residuals(const ResidualInput& input, JointVector& r, JointRows& jacobian) const override;

 private:
  const robot::Robot& robot_;
  std::vector<DesiredContact> contacts_;
  std::vector<Vec3> demonstrated_centre_;  ///< c, in the target's frame [m]
  const collision::Solid& target_;
  Pose base_from_target_;
};

}  // namespace morphe::grasp
