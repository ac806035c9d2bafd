#include "stages/grasp/surface_contact_term.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stages/grasp/constants.hpp"
#include "stages/grasp/demonstrated_contacts.hpp"

namespace morphe::grasp {
namespace {

constexpr int kResidualsPerContact = 5;

/// Returns the derivative of the inward normal with respect to the point, [3, 3] [1/m].
Eigen::Matrix3d normal_derivative(const collision::Solid& solid, const Vec3& point) {
  Eigen::Matrix3d derivative;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 step = kNormalStep_m * Vec3::Unit(axis);
    derivative.col(axis) = (nearest_surface(solid, point + step).normal -
                            nearest_surface(solid, point - step).normal) /
                           (2 * kNormalStep_m);
  }
  return derivative;
}

}  // namespace

SurfaceContactTerm::SurfaceContactTerm(const robot::Robot& robot,
                                       std::vector<DesiredContact> contacts,
                                       const collision::Solid& target, const Pose& base_from_target)
    : robot_(robot),
      contacts_(std::move(contacts)),
      target_(target),
      base_from_target_(base_from_target) {
  for (const DesiredContact& contact : contacts_) {
    demonstrated_centre_.push_back(
        is_known(contact.demonstrated)
            ? project_contact(robot, target, contact.demonstrated, contact).centre
            : unknown_point());
  }
}

void SurfaceContactTerm::residuals(const ResidualInput& input, JointVector& r,
                                   JointRows& jacobian) const {
  const Eigen::Index rows = kResidualsPerContact * std::ssize(contacts_);
  r.setZero(rows);
  jacobian.setZero(rows, input.q.size());
  const double gap_root = std::sqrt(kGapWeight), turn_root = std::sqrt(kPadDirectionWeight);
  const Pose target_from_base = base_from_target_.inverse();
  for (int c = 0; c < std::ssize(contacts_); ++c) {
    const robot::Pad& pad = robot_.pads[contacts_[c].tip];
    const int frame = robot_.tips[contacts_[c].tip].frame;
    const Pose& base_from_tip = input.base_from_frame[frame];
    const Vec3 centre_in_base = base_from_tip * pad.centre;
    const Vec3 direction = base_from_tip.linear() * pad.direction;
    const Eigen::Matrix3Xd centre_slope = input.point_jacobian(frame, centre_in_base);
    const Eigen::Matrix3Xd direction_slope =
        input.point_jacobian(frame, centre_in_base + direction) - centre_slope;
    const Eigen::Matrix3Xd centre_slope_in_target = target_from_base.linear() * centre_slope;
    const Vec3 centre = target_from_base * centre_in_base;
    const SurfacePoint surface = nearest_surface(target_, centre);

    const Eigen::Index row = kResidualsPerContact * c;
    r[row] = gap_root * (surface.distance - pad.radius);
    jacobian.row(row) = -gap_root * surface.normal.transpose() * centre_slope_in_target;
    r.segment<3>(row + 1) = turn_root * (target_from_base.linear() * direction - surface.normal);
    jacobian.middleRows<3>(row + 1) =
        turn_root * (target_from_base.linear() * direction_slope -
                     normal_derivative(target_, centre) * centre_slope_in_target);
    if (!is_known(demonstrated_centre_[c])) continue;
    const Vec3 slide = centre - demonstrated_centre_[c];
    const double slide_m = slide.norm();
    if (slide_m <= kMaxSlide_m) continue;
    r[row + 4] = gap_root * (slide_m - kMaxSlide_m);
    jacobian.row(row + 4) = gap_root / slide_m * slide.transpose() * centre_slope_in_target;
  }
}

}  // namespace morphe::grasp
