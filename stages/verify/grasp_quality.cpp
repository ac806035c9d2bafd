#include "stages/verify/grasp_quality.hpp"

#include <algorithm>
#include <cmath>

#include "stages/verify/finger_levers.hpp"
#include "stages/verify/separation.hpp"
#include "stages/verify/stated_grasp.hpp"
#include "stages/verify/wrench_bounds.hpp"

namespace morphe::verify {
namespace {

constexpr double kTouches_m = 0.002, kRounded = 1e-6;
constexpr double kGravity = 9.81;                        // [m/s^2]
constexpr double kGap = 0.05, kLeastGap = 1e-3;          // of the bounds of epsilon
constexpr double kTooMuch = 0.05, kLeastTooMuch = 2e-3;  // newtons asked for beyond what is needed

/// Of what a mesh encloses; of the other shapes it is their origin.
Vec3 centre_of(const SceneObject& object) {
  if (object.shape != Shape::mesh) return Vec3::Zero();
  double six_volumes = 0, reach = 0;
  Vec3 sum = Vec3::Zero();
  for (const Eigen::Vector3i& triangle : object.triangles) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
      corners.col(k) = object.vertices[static_cast<std::size_t>(triangle[k])];
    const double six = corners.determinant();
    six_volumes += six;
    sum += six / 4 * corners.rowwise().sum();
    reach = std::max(reach, corners.col(0).norm());
  }
  constexpr double kFlat = 1e-6;  // of the cube that holds it
  return std::abs(six_volumes) > 6 * kFlat * reach * reach * reach ? Vec3(sum / six_volumes)
                                                                   : Vec3::Zero();
}

double reach_of(const SceneObject& object, const Vec3& centre) {
  if (object.shape != Shape::mesh) return bounding_radius(object);
  double reach = 0;
  for (const Vec3& vertex : object.vertices) reach = std::max(reach, (vertex - centre).norm());
  return reach;
}

class QualityJudge {
 public:
  QualityJudge(const RobotTable& robot, const Plan& plan, const std::string& config,
               ViolationRuns& runs)
      : robot_(robot),
        plan_(plan),
        config_(config),
        runs_(runs),
        target_(*object_named(plan.scene.objects, plan.movement.target)) {}

  void run() {
    const bool usable = judge_given_numbers() && judge_shape();
    const std::vector<std::size_t> touching = contacts_that_touch(plan_.grasp);
    if (touching.size() < 2) return judge_nothing();
    if (!usable) return;
    Pressing pressing;
    for (const std::size_t row : touching) {
      const PadContact& contact = plan_.grasp.contacts[row];
      pressing.contacts.push_back(pressing_of((contact.point - said_.centre) / said_.torque_scale,
                                              contact.normal.normalized(), said_.friction,
                                              said_.torsion / said_.torque_scale));
    }
    judge_epsilon(pressing);
    pressing.each = true;
    // The centre of mass is what torques are about: it moves as fast as a twist's linear part.
    judge_needed("needed_worst", said_.needed_worst, pressing,
                 [](const Vector6& u) { return u.head<3>().norm(); });
    judge_down(pressing);
    judge_given(touching);
  }

 private:
  void note(const char* subject, double value, double limit) {
    runs_.note_plan("quality", subject, value, limit);
  }

  bool judge_given_numbers() {
    bool usable = true;
    const auto judge = [&](const char* name, double value) {
      const double stated = stated_for_grasp(config_, name).value_or(value);
      if (!(value >= 0 && std::isfinite(value))) {
        note(name, value, 0);
        usable = false;
      } else if (std::abs(value - stated) > 1e-9 * std::abs(stated)) {
        note(name, value, stated);
      }
    };
    judge("friction", said_.friction);
    judge("torsion", said_.torsion);
    judge("mass", said_.mass);
    return usable;
  }

  bool judge_shape() {
    const Vec3 centre = centre_of(target_);
    const double off = (said_.centre - centre).norm(), reach = reach_of(target_, centre);
    if (!(off <= kRounded)) note("centre", off, kRounded);
    if (!(std::abs(said_.torque_scale - reach) <= kRounded))
      note("torque_scale", said_.torque_scale, reach);
    return seen(said_.centre) && said_.torque_scale > 0 && std::isfinite(said_.torque_scale);
  }

  void judge_nothing() {
    const std::pair<const char*, double> figures[] = {{"epsilon_lower", said_.epsilon_lower},
                                                      {"epsilon_upper", said_.epsilon_upper},
                                                      {"needed_worst", said_.needed_worst},
                                                      {"needed_down", said_.needed_down},
                                                      {"given", said_.given}};
    for (const auto& [name, value] : figures) {
      if (!std::isnan(value)) note(name, value, kNotSeen);
    }
  }

  void judge_epsilon(const Pressing& pressing) {
    const double lower = said_.epsilon_lower, upper = said_.epsilon_upper;
    const Between own = epsilon_between(pressing, {lower, upper});
    if (!(lower <= own.upper + kRounded)) note("epsilon_lower", lower, own.upper);
    if (!(upper >= own.lower - kRounded)) note("epsilon_upper", upper, own.lower);
    const double most =
        std::max(kLeastGap, kGap * std::min(std::abs(lower), std::abs(upper))) + 1e-9;
    if (!(upper - lower >= 0 && upper - lower <= most)) note("epsilon", upper - lower, most);
  }

  /// Newtons that are said to be enough, against the weight that is borne at 1 N.
  void judge_needed(const char* name, double newtons, const Pressing& pressing, const Doing& g) {
    const double weight = kGravity * said_.mass;
    const double said = std::isinf(newtons) && newtons > 0 ? 0 : weight / newtons;
    const bool number = newtons > 0;
    const Between borne = ratio_between(pressing, g, {said, said});
    if (!number || !(said <= borne.upper + kRounded)) {
      note(name, newtons, weight / borne.upper);
    } else if (said < std::min(borne.lower / (1 + kTooMuch), borne.lower - kLeastTooMuch)) {
      note(name, newtons, weight / borne.lower);
    }
  }

  void judge_down(const Pressing& pressing) {
    if (!seen_frame(plan_.world.base_from_world)) {  // nobody knows where down is
      if (!std::isnan(said_.needed_down)) note("needed_down", said_.needed_down, kNotSeen);
      return;
    }
    const auto sample = static_cast<std::size_t>(plan_.grasp.sample);
    const Pose base_from_object =
        recorded_pose(target_, plan_.trajectory.demonstration_time[sample]);
    const Vec3 up =
        base_from_object.linear().transpose() * plan_.world.base_from_world.linear().col(2);
    judge_needed("needed_down", said_.needed_down, pressing,
                 [&](const Vector6& u) { return std::max(0.0, up.dot(u.head<3>())); });
  }

  static bool seen_frame(const Pose& pose) { return pose.matrix().allFinite(); }

  void judge_given(const std::vector<std::size_t>& touching) {
    const std::optional<double> torque = stated_for_grasp(config_, "joint_torque");
    if (!torque) return;
    const Grasp& grasp = plan_.grasp;
    const auto sample = static_cast<std::size_t>(grasp.sample);
    const Pose base_from_object =
        recorded_pose(target_, plan_.trajectory.demonstration_time[sample]);
    double most = 0;
    for (const std::size_t row : touching) {
      const PadContact& contact = grasp.contacts[row];
      const auto tip = std::ranges::find(robot_.tips, contact.tip, &RobotTable::Tip::name);
      const Vec3 normal = base_from_object.linear() * contact.normal;
      const Eigen::Matrix3Xd levers =
          finger_levers(robot_, grasp.hand_posture, tip->frame, base_from_object * contact.point);
      most = std::max(most, (normal.transpose() * levers).cwiseAbs().maxCoeff());
    }
    const double given = *torque / most;
    if (!(std::abs(said_.given - given) <= kRounded * given)) note("given", said_.given, given);
  }

  const RobotTable& robot_;
  const Plan& plan_;
  const std::string& config_;
  ViolationRuns& runs_;
  const SceneObject& target_;
  const GraspQuality& said_ = plan_.grasp.quality;
};

}  // namespace

std::vector<std::size_t> contacts_that_touch(const Grasp& grasp) {
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < grasp.contacts.size(); ++k) {
    if (grasp.contacts[k].gap <= kTouches_m) rows.push_back(k);
  }
  return rows;
}

void judge_grasp_quality(const RobotTable& robot, const Plan& plan, const std::string& config,
                         ViolationRuns& runs) {
  QualityJudge(robot, plan, config, runs).run();
}

}  // namespace morphe::verify
