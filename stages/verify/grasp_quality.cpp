#include "stages/verify/grasp_quality.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/finger_jacobian.hpp"
#include "stages/verify/grasp_config.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/wrench_bounds.hpp"

namespace morphe::verify {
namespace {

constexpr double kMaxContactGap_m = 0.002, kQualityTolerance = 1e-6;
// gap between the bounds of epsilon
constexpr double kEpsilonGapRatio = 0.05, kMinEpsilonGap = 1e-3;
// Excess of a required force over the needed one: relative, and of the weight at 1 N.
constexpr double kForceExcessRatio = 0.05, kMinForceExcess = 2e-3;

/// Returns the centre of mass of the volume that a mesh encloses, or the origin for the other
/// shapes.
Vec3 centre_of_mass(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double six_volumes = 0, reach = 0;
  Vec3 sum = Vec3::Zero();
  for (const Eigen::Vector3i& triangle : object.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = object.vertices[triangle[k]];
    const double six = corners.determinant();
    six_volumes += six;
    sum += six / 4 * corners.rowwise().sum();
    reach = std::max(reach, corners.col(0).norm());
  }
  constexpr double kMinVolumeRatio = 1e-6;  // of the cube that contains the mesh
  return std::abs(six_volumes) > 6 * kMinVolumeRatio * reach * reach * reach
             ? Vec3(sum / six_volumes)
             : Vec3::Zero();
}

double reach_of(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return bounding_radius(object);
  double reach = 0;
  for (const Vec3& vertex : object.vertices) reach = std::max(reach, (vertex - centre).norm());
  return reach;
}

class GraspQualityVerifier {
 public:
  GraspQualityVerifier(const RobotModel& robot, const Plan& plan, const std::string& config,
                       ViolationCollector& runs)
      : robot_(robot),
        plan_(plan),
        config_(config),
        runs_(runs),
        target_(*find_object(plan.scene.objects, plan.movement.target)) {}

  void run() {
    const bool usable = verify_inputs() && verify_centre_and_scale();
    const std::vector<std::size_t> touching = touching_contacts(plan_.grasp);
    if (touching.size() < 2) return verify_no_figures();
    if (!usable) return;
    WrenchSet pressing;
    for (const std::size_t row : touching) {
      const PadContact& contact = plan_.grasp.contacts[row];
      pressing.contacts.push_back(contact_wrench_basis(
          (contact.point - stored_.centre_of_mass) / stored_.characteristic_length,
          contact.normal.normalized(), stored_.friction_coefficient,
          stored_.torsional_friction / stored_.characteristic_length));
    }
    verify_epsilon(pressing);
    pressing.individually_bounded = true;
    // The centre of mass is the reference point of torques; its velocity is the twist's linear
    // part.
    verify_required_force("required_force_worst", stored_.required_force_worst, pressing,
                          [](const Vector6& u) { return u.head<3>().norm(); });
    verify_gravity_force(pressing);
    verify_available_force(touching);
  }

 private:
  void note(const char* subject, double value, double limit) {
    runs_.note_plan("quality", subject, value, limit);
  }

  bool verify_inputs() {
    bool usable = true;
    const auto judge = [&](const char* name, double value) {
      const double stated = grasp_config_value(config_, name).value_or(value);
      if (!(value >= 0 && std::isfinite(value))) {
        note(name, value, 0);
        usable = false;
      } else if (std::abs(value - stated) > 1e-9 * std::abs(stated)) {
        note(name, value, stated);
      }
    };
    judge("friction_coefficient", stored_.friction_coefficient);
    judge("torsional_friction", stored_.torsional_friction);
    judge("mass", stored_.mass);
    return usable;
  }

  bool verify_centre_and_scale() {
    const Vec3 centre = centre_of_mass(target_);
    const double off = (stored_.centre_of_mass - centre).norm(), reach = reach_of(target_, centre);
    if (!(off <= kQualityTolerance)) note("centre_of_mass", off, kQualityTolerance);
    if (!(std::abs(stored_.characteristic_length - reach) <= kQualityTolerance))
      note("characteristic_length", stored_.characteristic_length, reach);
    return is_known(stored_.centre_of_mass) && stored_.characteristic_length > 0 &&
           std::isfinite(stored_.characteristic_length);
  }

  void verify_no_figures() {
    const std::pair<const char*, double> figures[] = {
        {"epsilon_lower", stored_.epsilon_lower},
        {"epsilon_upper", stored_.epsilon_upper},
        {"required_force_worst", stored_.required_force_worst},
        {"required_force_gravity", stored_.required_force_gravity},
        {"available_force", stored_.available_force}};
    for (const auto& [name, value] : figures) {
      if (!std::isnan(value)) note(name, value, kUnknown);
    }
  }

  void verify_epsilon(const WrenchSet& pressing) {
    const double lower = stored_.epsilon_lower, upper = stored_.epsilon_upper;
    const Bounds own = epsilon_bounds(pressing, {lower, upper});
    if (!(lower <= own.upper + kQualityTolerance)) note("epsilon_lower", lower, own.upper);
    if (!(upper >= own.lower - kQualityTolerance)) note("epsilon_upper", upper, own.lower);
    const double most =
        std::max(kMinEpsilonGap, kEpsilonGapRatio * std::min(std::abs(lower), std::abs(upper))) +
        1e-9;
    if (!(upper - lower >= 0 && upper - lower <= most)) note("epsilon", upper - lower, most);
  }

  /// Verifies a required normal force [N] against the weight that is supported at 1 N.
  void verify_required_force(const char* name, double newtons, const WrenchSet& pressing,
                             const Gauge& g) {
    const double weight = kGravity_m_s2 * stored_.mass;
    const double said = std::isinf(newtons) && newtons > 0 ? 0 : weight / newtons;
    const bool number = newtons > 0;
    const Bounds borne = least_ratio_bounds(pressing, g, {said, said});
    if (!number || !(said <= borne.upper + kQualityTolerance)) {
      note(name, newtons, weight / borne.upper);
    } else if (said <
               std::min(borne.lower / (1 + kForceExcessRatio), borne.lower - kMinForceExcess)) {
      note(name, newtons, weight / borne.lower);
    }
  }

  void verify_gravity_force(const WrenchSet& pressing) {
    if (!seen_frame(
            plan_.reference_frames.base_from_world)) {  // the direction of gravity is unknown
      if (!std::isnan(stored_.required_force_gravity))
        note("required_force_gravity", stored_.required_force_gravity, kUnknown);
      return;
    }
    const auto sample = static_cast<std::size_t>(plan_.grasp.sample);
    const Pose base_from_object =
        recorded_pose(target_, plan_.trajectory.demonstration_time[sample]);
    const Vec3 up = base_from_object.linear().transpose() *
                    plan_.reference_frames.base_from_world.linear().col(2);
    verify_required_force("required_force_gravity", stored_.required_force_gravity, pressing,
                          [&](const Vector6& u) { return std::max(0.0, up.dot(u.head<3>())); });
  }

  static bool seen_frame(const Pose& pose) { return pose.matrix().allFinite(); }

  void verify_available_force(const std::vector<std::size_t>& touching) {
    const std::optional<double> torque = grasp_config_value(config_, "max_joint_torque");
    if (!torque) return;
    const Grasp& grasp = plan_.grasp;
    const auto sample = static_cast<std::size_t>(grasp.sample);
    const Pose base_from_object =
        recorded_pose(target_, plan_.trajectory.demonstration_time[sample]);
    double most = 0;
    for (const std::size_t row : touching) {
      const PadContact& contact = grasp.contacts[row];
      const auto tip = std::ranges::find(robot_.tips, contact.tip, &RobotModel::Tip::name);
      const Vec3 normal = base_from_object.linear() * contact.normal;
      const Eigen::Matrix3Xd levers = finger_jacobian(robot_, grasp.grasp_posture, tip->frame,
                                                      base_from_object * contact.point);
      most = std::max(most, (normal.transpose() * levers).cwiseAbs().maxCoeff());
    }
    const double given = *torque / most;
    if (!(std::abs(stored_.available_force - given) <= kQualityTolerance * given))
      note("available_force", stored_.available_force, given);
  }

  const RobotModel& robot_;
  const Plan& plan_;
  const std::string& config_;
  ViolationCollector& runs_;
  const SceneObject& target_;
  const GraspQuality& stored_ = plan_.grasp.quality;
};

}  // namespace

std::vector<std::size_t> touching_contacts(const Grasp& grasp) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    if (grasp.contacts[k].signed_distance <= kMaxContactGap_m) rows.push_back(k);
  }
  return rows;
}

void verify_grasp_quality(const RobotModel& robot, const Plan& plan, const std::string& config,
                          ViolationCollector& runs) {
  GraspQualityVerifier(robot, plan, config, runs).run();
}

}  // namespace morphe::verify
