#include "stages/verify/grasp_quality.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/finger_jacobian.hpp"
#include "stages/verify/grasp_config.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/wrench_bounds.hpp"

namespace morphe::verify {
namespace {

constexpr double kQualityTolerance = 1e-6;
// The gap allowed between the stored bounds of epsilon.
constexpr double kEpsilonGapRatio = 0.05, kMinEpsilonGap = 1e-3;
// By how much the weight that a force supports may be underestimated: relative, and at 1 N.
constexpr double kForceExcessRatio = 0.05, kMinForceExcess = 2e-3;

/// Returns the centre of mass of the volume that a mesh encloses; the origin for other shapes.
Vec3 centre_of_mass(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double six_volumes = 0, radius = 0;
  Vec3 sum = Vec3::Zero();
  for (const Eigen::Vector3i& triangle : object.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = object.vertices[triangle[k]];
    const double six_volume = corners.determinant();
    six_volumes += six_volume;
    sum += six_volume / 4 * corners.rowwise().sum();
    radius = std::max(radius, corners.col(0).norm());
  }
  constexpr double kMinVolumeRatio = 1e-6;  // of a cube with the radius as its edge
  return std::abs(six_volumes) > 6 * kMinVolumeRatio * radius * radius * radius
             ? Vec3(sum / six_volumes)
             : Vec3::Zero();
}

double greatest_distance_from(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return bounding_radius(object);
  double radius = 0;
  for (const Vec3& vertex : object.vertices) radius = std::max(radius, (vertex - centre).norm());
  return radius;
}

class GraspQualityVerifier {
 public:
  GraspQualityVerifier(const RobotModel& robot, const Plan& plan, const std::string& config,
                       ViolationLog& violations)
      : robot_(robot),
        plan_(plan),
        config_(config),
        violations_(violations),
        target_(*find_object(plan.scene.objects, plan.movement.target)),
        base_from_object_(
            recorded_pose(target_, plan.trajectory.demonstration_time[plan.grasp.sample])) {}

  void run() {
    const bool usable = verify_inputs() && verify_centre_and_scale();
    const std::vector<int> touching = touching_contacts(plan_.grasp);
    if (touching.size() < 2) return verify_values_absent();
    if (!usable) return;
    WrenchSet wrenches;
    for (const int row : touching) {
      const PadContact& contact = plan_.grasp.contacts[row];
      wrenches.contact_bases.push_back(contact_wrench_basis(
          (contact.point - stored_.centre_of_mass) / stored_.characteristic_length,
          contact.normal.normalized(), stored_.friction_coefficient,
          stored_.torsional_friction / stored_.characteristic_length));
    }
    verify_epsilon(wrenches);
    wrenches.limits_each_force = true;
    // Torques refer to the centre of mass, so that its velocity is the twist's linear part.
    verify_required_force("required_force_worst", stored_.required_force_worst, wrenches,
                          [](const Vector6& u) { return u.head<3>().norm(); });
    verify_gravity_force(wrenches);
    verify_available_force(touching);
  }

 private:
  void note(const char* subject, double value, double limit) {
    violations_.note_plan("quality", subject, value, limit);
  }

  bool verify_inputs() {
    bool usable = true;
    const auto check = [&](const char* name, double value) {
      const double configured = grasp_config_value(config_, name).value_or(value);
      if (!(value >= 0 && std::isfinite(value))) {
        note(name, value, 0);
        usable = false;
      } else if (std::abs(value - configured) > 1e-9 * std::abs(configured)) {
        note(name, value, configured);
      }
    };
    check("friction_coefficient", stored_.friction_coefficient);
    check("torsional_friction", stored_.torsional_friction);
    check("mass", stored_.mass);
    return usable;
  }

  bool verify_centre_and_scale() {
    const Vec3 centre = centre_of_mass(target_);
    const double error = (stored_.centre_of_mass - centre).norm(),
                 radius = greatest_distance_from(target_, centre);
    if (!(error <= kQualityTolerance)) note("centre_of_mass", error, kQualityTolerance);
    if (!(std::abs(stored_.characteristic_length - radius) <= kQualityTolerance))
      note("characteristic_length", stored_.characteristic_length, radius);
    return is_known(stored_.centre_of_mass) && stored_.characteristic_length > 0 &&
           std::isfinite(stored_.characteristic_length);
  }

  void verify_values_absent() {
    const auto check = [&](const char* name, double value) {
      if (!std::isnan(value)) note(name, value, kUnknown);
    };
    check("epsilon_lower", stored_.epsilon_lower);
    check("epsilon_upper", stored_.epsilon_upper);
    check("required_force_worst", stored_.required_force_worst);
    check("required_force_gravity", stored_.required_force_gravity);
    check("available_force", stored_.available_force);
  }

  void verify_epsilon(const WrenchSet& wrenches) {
    const double lower = stored_.epsilon_lower, upper = stored_.epsilon_upper;
    const Bounds own = epsilon_bounds(wrenches, {lower, upper});
    if (!(lower <= own.upper + kQualityTolerance)) note("epsilon_lower", lower, own.upper);
    if (!(upper >= own.lower - kQualityTolerance)) note("epsilon_upper", upper, own.lower);
    const double relative_gap = kEpsilonGapRatio * std::min(std::abs(lower), std::abs(upper));
    const double gap = upper - lower, max_gap = std::max(kMinEpsilonGap, relative_gap) + 1e-9;
    if (!(gap >= 0 && gap <= max_gap)) note("epsilon", gap, max_gap);
  }

  /// Verifies a required normal force [N] by the weight that it claims forces of 1 N to support.
  void verify_required_force(const char* name, double force_n, const WrenchSet& wrenches,
                             const Gauge& g) {
    const double weight = kGravity_m_s2 * stored_.mass;
    const double claimed = std::isinf(force_n) && force_n > 0 ? 0 : weight / force_n;
    const Bounds supported = least_ratio_bounds(wrenches, g, {claimed, claimed});
    if (!(force_n > 0) || !(claimed <= supported.upper + kQualityTolerance)) {
      note(name, force_n, weight / supported.upper);
    } else if (claimed < std::min(supported.lower / (1 + kForceExcessRatio),
                                  supported.lower - kMinForceExcess)) {
      note(name, force_n, weight / supported.lower);
    }
  }

  void verify_gravity_force(const WrenchSet& wrenches) {
    const Pose& base_from_world = plan_.reference_frames.base_from_world;
    if (!base_from_world.matrix().allFinite()) {  // the direction of gravity is unknown
      if (!std::isnan(stored_.required_force_gravity))
        note("required_force_gravity", stored_.required_force_gravity, kUnknown);
      return;
    }
    const Vec3 up = base_from_object_.linear().transpose() * base_from_world.linear().col(2);
    verify_required_force("required_force_gravity", stored_.required_force_gravity, wrenches,
                          [&](const Vector6& u) { return std::max(0.0, up.dot(u.head<3>())); });
  }

  void verify_available_force(const std::vector<int>& touching) {
    const std::optional<double> torque = grasp_config_value(config_, "max_joint_torque");
    if (!torque) return;
    const Grasp& grasp = plan_.grasp;
    double max_arm_m = 0;
    for (const int row : touching) {
      const PadContact& contact = grasp.contacts[row];
      const auto tip = std::ranges::find(robot_.tips, contact.tip, &RobotModel::Tip::name);
      const Vec3 normal = base_from_object_.linear() * contact.normal;
      const Eigen::Matrix3Xd jacobian = finger_jacobian(robot_, grasp.grasp_posture, tip->frame,
                                                        base_from_object_ * contact.point);
      max_arm_m = std::max(max_arm_m, (normal.transpose() * jacobian).cwiseAbs().maxCoeff());
    }
    const double own = *torque / max_arm_m;
    if (!(std::abs(stored_.available_force - own) <= kQualityTolerance * own))
      note("available_force", stored_.available_force, own);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const std::string& config_;
  ViolationLog& violations_;
  const SceneObject& target_;
  const Pose base_from_object_;
  const GraspQuality& stored_ = plan_.grasp.quality;
};

}  // namespace

std::vector<int> touching_contacts(const Grasp& grasp) {
  std::vector<int> rows;
  for (int k = 0; k < std::ssize(grasp.contacts); ++k)
    if (grasp.contacts[k].state == ContactState::touching) rows.push_back(k);
  return rows;
}

void verify_grasp_quality(const RobotModel& robot, const Plan& plan, const std::string& config,
                          ViolationLog& violations) {
  GraspQualityVerifier(robot, plan, config, violations).run();
}

}  // namespace morphe::verify
