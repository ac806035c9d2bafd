#include "stages/simulate/mjcf_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "core/math/rotation.hpp"
#include "core/robot/tree.hpp"
#include "stages/simulate/mjcf_elements.hpp"

namespace morphe::simulate {
namespace {

template <class... Values>
void add(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

/// If a cylinder's axis is normal to a plane except for rounding errors, MuJoCo 2.2.2 computes its
/// lowest point from these errors, and may find no contact. A slightly tilted plane avoids this.
constexpr double kSupportTilt_rad = 1e-6;

class Writer {
 public:
  Writer(const SimulatedWorld& world, const Variation& variation, const SimulateOptions& options,
         Environment environment)
      : world_(world),
        robot_(*world.robot),
        objects_(world.scene->objects),
        variation_(variation),
        options_(options),
        with_environment_(environment == Environment::scene),
        children_(robot_.frames.size() + 1) {
    for (int f = 0; f < std::ssize(robot_.frames); ++f)
      children_[robot_.frames[f].parent + 1].push_back(f);
  }

  std::string text() {
    head();
    meshes();
    add(text_, "<worldbody>\n");
    if (world_.lifts_base) {
      add(text_,
          "<body name=\"base\">\n<joint name=\"base\" type=\"slide\" axis=\"{}\"/>\n"
          "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"0.01 0.01 0.01\"/>\n",
          numbers(world_.up));
    }
    capsules_of(-1);
    for (const int f : children_[0]) frame(f);
    if (world_.lifts_base) add(text_, "</body>\n");
    objects();
    target();
    add(text_, "</worldbody>\n");
    contacts();
    couplings();
    motors();
    return text_ + "</mujoco>\n";
  }

 private:
  void head() {
    const Vec3 gravity = with_environment_ ? Vec3(-kGravity_m_s2 * world_.up) : Vec3(Vec3::Zero());
    add(text_,
        "<mujoco>\n<compiler angle=\"radian\" inertiafromgeom=\"false\"/>\n"
        "<size njmax=\"700\" nconmax=\"100\"/>\n"
        "<option timestep=\"{:.17g}\" integrator=\"{}\" cone=\"elliptic\" impratio=\"{}\" "
        "noslip_iterations=\"{}\" gravity=\"{}\"/>\n",
        options_.step_s, options_.euler ? "Euler" : "implicit", kImpratio, kNoslipIterations,
        numbers(gravity));
  }

  void meshes() {
    add(text_, "<asset>\n");
    if (world_.target >= 0 && target_object().shape == Shape::mesh) {
      add(text_, "<mesh name=\"target\" vertex=\"");
      for (const Vec3& vertex : target_object().vertices) add(text_, "{} ", numbers(vertex));
      add(text_, "\"/>\n");
    }
    add(text_, "</asset>\n");
  }

  void capsules_of(int frame) {
    for (int k = 0; k < std::ssize(robot_.capsules); ++k)
      if (robot_.capsules[k].frame == frame) text_ += capsule_geom(robot_.capsules[k], k);
  }

  void frame(int f) {
    const RobotModel::Frame& frame = robot_.frames[f];
    add(text_, "<body name=\"f{}\" {}>\n", f, pose_attributes(frame.transform));
    if (frame.joint >= 0) joint(f);
    text_ += inertial(world_.inertias[f]);
    capsules_of(f);
    for (const int child : children_[f + 1]) this->frame(child);
    add(text_, "</body>\n");
  }

  void joint(int f) {
    const RobotModel::Frame& frame = robot_.frames[f];
    const Servo& servo = world_.servos[frame.joint];
    const double at_lower = frame.ratio * robot_.lower[frame.joint] + frame.offset;
    const double at_upper = frame.ratio * robot_.upper[frame.joint] + frame.offset;
    add(text_,
        "<joint name=\"f{}\" type=\"{}\" axis=\"{}\" limited=\"true\" range=\"{:.17g} {:.17g}\" "
        "armature=\"{:.17g}\" damping=\"{:.17g}\"/>\n",
        f, frame.prismatic ? "slide" : "hinge", numbers(frame.axis), std::min(at_lower, at_upper),
        std::max(at_lower, at_upper), servo.armature, servo.damping);
  }

  void objects() {
    if (!with_environment_) return;
    for (int k = 0; k < std::ssize(objects_); ++k) {
      if (!is_static_obstacle(world_, k)) continue;
      Pose pose = recorded_pose(objects_[k], objects_[k].time.front());
      if (world_.support && world_.support->object == k)
        pose.translation() += world_.support->raise_m * world_.up;
      text_ += object_geom(objects_[k], name_of_object(k), pose);
    }
    if (!world_.support) plane();
  }

  void plane() {
    Pose plane =
        make_pose(Vec3::Zero(), math::shortest_rotation(Vec3::UnitZ(), world_.up) *
                                    Quat(Eigen::AngleAxisd(kSupportTilt_rad, Vec3::UnitX())));
    plane.translation() =
        lowest_height(target_object(), variation_.base_from_target, world_.up) * world_.up;
    add(text_, "<geom name=\"support\" type=\"plane\" size=\"1 1 1\" {} {}/>\n",
        pose_attributes(plane), kGeomAttributes);
  }

  void target() {
    add(text_, "<body name=\"target\" {}>\n<freejoint/>\n",
        pose_attributes(variation_.base_from_target));
    text_ += inertial(target_inertia(target_object(), variation_.mass_kg));
    text_ += object_geom(target_object(), "target", Pose::Identity());
    for (int k = 0; k < foot_count(); ++k)
      add(text_, "<geom name=\"t{}\" type=\"sphere\" size=\"{}\" pos=\"{}\" {}/>\n", k,
          kFootRadius_m, numbers(world_.feet[k]), kGeomAttributes);
    add(text_, "</body>\n");
  }

  void pair(const std::string& first, const std::string& second, double friction) {
    add(text_,
        "<pair geom1=\"{}\" geom2=\"{}\" condim=\"6\" friction=\"{:.17g} {:.17g} {:.17g} {:.17g} "
        "{:.17g}\" solref=\"{}\" solimp=\"{}\"/>\n",
        first, second, friction, friction, variation_.torsional_friction_m, kRollingFriction_m,
        kRollingFriction_m, kContactSolref, kContactSolimp);
  }

  void contacts() {
    add(text_, "<contact>\n");
    const auto in_hand = [&](int k) {
      return robot_.capsules[k].frame >= 0 &&
             robot::is_in_subtree(robot_, robot_.capsules[k].frame, robot_.palm_frame);
    };
    for (int k = 0; k < std::ssize(robot_.capsules); ++k) {
      const std::string capsule = fmt::format("c{}", k);
      pair("target", capsule, variation_.friction);
      if (!in_hand(k)) continue;
      for (int other = k + 1; other < std::ssize(robot_.capsules); ++other)
        if (in_hand(other) && may_collide(k, other))
          pair(capsule, fmt::format("c{}", other), variation_.friction);
      for (int object = 0; with_environment_ && object < std::ssize(objects_); ++object)
        if (is_static_obstacle(world_, object))
          pair(name_of_object(object), capsule, kSupportFriction);
    }
    if (with_environment_) contacts_with_surroundings();
    add(text_, "</contact>\n");
  }

  void contacts_with_surroundings() {
    const SceneObject* const table = find_object(objects_, "table");
    for (int k = 0; k < std::ssize(objects_); ++k) {
      if (!is_static_obstacle(world_, k) || (!world_.support && &objects_[k] == table)) continue;
      pair(name_of_object(k), "target", kSupportFriction);
      for (int foot = 0; foot < foot_count(); ++foot)
        pair(name_of_object(k), fmt::format("t{}", foot), kSupportFriction);
    }
    if (!world_.support) pair("support", "target", kSupportFriction);
  }

  bool may_collide(int first, int second) const {
    const std::array<int, 2> pair{first, second};
    return robot::moving_frame_of(robot_, robot_.capsules[first].frame) !=
               robot::moving_frame_of(robot_, robot_.capsules[second].frame) &&
           std::ranges::count(robot_.allowed_collision_pairs, pair) == 0;
  }

  /// Writes the couplings of the frames f to the frame m with their joint's motor:
  ///   value_f = offset_f + ratio_f / ratio_m (value_m - offset_m).
  void couplings() {
    add(text_, "<equality>\n");
    const std::vector<int> motors = motor_frames(robot_);
    for (int f = 0; f < std::ssize(robot_.frames); ++f) {
      const RobotModel::Frame& frame = robot_.frames[f];
      if (frame.joint < 0 || motors[frame.joint] == f) continue;
      const int motor = motors[frame.joint];
      const RobotModel::Frame& driver = robot_.frames[motor];
      const double ratio = frame.ratio / driver.ratio;
      add(text_,
          "<joint joint1=\"f{}\" joint2=\"f{}\" polycoef=\"{:.17g} {:.17g} 0 0 0\" solref=\"{}\" "
          "solimp=\"{}\"/>\n",
          f, motor, frame.offset - ratio * driver.offset, ratio, kCouplingSolref, kCouplingSolimp);
    }
    add(text_, "</equality>\n");
  }

  void motors() {
    add(text_, "<actuator>\n");
    const std::vector<int> frames = motor_frames(robot_);
    for (int j = 0; j < std::ssize(frames); ++j) {
      const Servo& servo = world_.servos[j];
      add(text_,
          "<general name=\"m{}\" joint=\"f{}\" gaintype=\"fixed\" biastype=\"affine\" "
          "gainprm=\"{:.17g}\" biasprm=\"0 {:.17g} {:.17g}\" forcelimited=\"true\" "
          "forcerange=\"{:.17g} {:.17g}\"/>\n",
          j, frames[j], servo.stiffness, -servo.stiffness, -servo.velocity_gain,
          -servo.torque_limit, servo.torque_limit);
    }
    if (world_.lifts_base)
      add(text_,
          "<general name=\"base\" joint=\"base\" gaintype=\"fixed\" biastype=\"affine\" "
          "gainprm=\"{:g}\" biasprm=\"0 {:g} {:g}\"/>\n",
          kBaseStiffness, -kBaseStiffness, -kBaseVelocityGain);
    add(text_, "</actuator>\n");
  }

  int foot_count() const {
    return with_environment_ && world_.support ? static_cast<int>(world_.feet.size()) : 0;
  }
  const SceneObject& target_object() const { return objects_[world_.target]; }
  std::string name_of_object(int k) const { return fmt::format("o{}", k); }

  const SimulatedWorld& world_;
  const RobotModel& robot_;
  const std::vector<SceneObject>& objects_;
  const Variation& variation_;
  const SimulateOptions& options_;
  const bool with_environment_;
  std::vector<std::vector<int>> children_;  ///< [frames + 1] children of the base first
  std::string text_;
};

}  // namespace

bool is_static_obstacle(const SimulatedWorld& world, std::ptrdiff_t object) {
  const SceneObject& obstacle = world.scene->objects[object];
  return object != world.target && obstacle.shape != Shape::mesh && obstacle.time.size() == 1;
}

std::string mjcf_text(const SimulatedWorld& world, const Variation& variation,
                      const SimulateOptions& options, Environment environment) {
  return Writer(world, variation, options, environment).text();
}

}  // namespace morphe::simulate
