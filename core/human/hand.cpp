#include "core/human/hand.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <string>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::human {
namespace {

/// The joint after kHandAngleNames.
constexpr int kPalmArch = static_cast<int>(kHandAngleCount);

/// Share of palm_arch that lowers each finger's metacarpal.
constexpr std::array<double, kFingerCount> kArchShare = {0, 0, 0, 20.0 / 28, 1};

Pose translation(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

struct Builder {
  RobotModel hand;

  int frame(std::string name, int parent, const Pose& transform, const Vec3& axis, int joint,
            double ratio = 1) {
    hand.frames.push_back({std::move(name), parent, transform, axis, joint, ratio, 0});
    return static_cast<int>(hand.frames.size()) - 1;
  }
  /// Adds the next joint of kHandAngleNames.
  int joint(int parent, const Pose& transform, const Vec3& axis, double lower, double upper) {
    const auto k = static_cast<Eigen::Index>(hand.joint_names.size());
    hand.joint_names.emplace_back(kHandAngleNames[k]);
    hand.lower[k] = lower;
    hand.upper[k] = upper;
    return frame(kHandAngleNames[k], parent, transform, axis, static_cast<int>(k));
  }
  void tip(std::size_t finger, int middle_joint, int last, double distal) {
    const std::string name = kFingerNames[finger];
    hand.tips.push_back({name + "_tip", last, translation(0, 0, distal), static_cast<int>(finger)});
    hand.joint_centres.push_back({middle_joint, name});
  }
};

}  // namespace

HandSize hand_size_of_stature(double stature_m) {
  constexpr double kLengthToStature = (0.110 + 0.111) / 2, kBreadthToLength = (0.457 + 0.432) / 2;
  const double length = kLengthToStature * stature_m;
  return {length, kBreadthToLength * length};
}

RobotModel human_hand(const HandSize& size) {
  const double hl = size.length, hb = size.breadth;
  const Vec3 abducting = -Vec3::UnitX(), flexing = Vec3::UnitY();
  Builder b;
  b.hand.name = "human hand";
  constexpr auto kJoints = static_cast<Eigen::Index>(kHandAngleCount + 1);
  b.hand.lower = b.hand.upper = JointVector::Zero(kJoints);
  b.hand.velocity = b.hand.acceleration = b.hand.jerk =
      JointVector::Constant(kJoints, std::numeric_limits<double>::infinity());
  const int palm = b.frame("hand", -1, Pose::Identity(), Vec3::UnitZ(), -1);

  const robot::ThumbProportions& t = robot::kThumbProportions;
  const auto thumb = [&](int parent, const Pose& transform, const Vec3& axis, std::size_t k) {
    return b.joint(parent, transform, axis, t.lower[k], t.upper[k]);
  };
  const int rotation = thumb(palm, translation(0, t.across * hb, t.along * hl), -Vec3::UnitZ(), 0);
  const Pose splayed(Eigen::AngleAxisd(t.splay, abducting));
  const int abduction = thumb(rotation, splayed, abducting, 1);
  // From here on x points out of the thumb's pad, which at zero is across the palm.
  const Pose pad(Eigen::AngleAxisd(-90 * kRadPerDegree, Vec3::UnitZ()));
  const int mcp = thumb(abduction, translation(0, 0, t.metacarpal * hl) * pad, flexing, 2);
  const int ip = thumb(mcp, translation(0, 0, t.proximal * hl), flexing, 3);
  b.tip(0, mcp, ip, t.distal * hl);

  for (std::size_t finger = 1; finger < kFingerCount; ++finger) {
    const robot::FingerProportions& f = robot::kFingerProportions[finger - 1];
    const auto joint = [&](int parent, const Pose& transform, const Vec3& axis, std::size_t k) {
      return b.joint(parent, transform, axis, f.lower[k], f.upper[k]);
    };
    int metacarpal = palm;
    if (kArchShare[finger] > 0) {
      metacarpal = b.frame(std::string(kFingerNames[finger]) + "_metacarpal", palm,
                           Pose::Identity(), flexing, kPalmArch, kArchShare[finger]);
    }
    const Pose fanned(Eigen::AngleAxisd(-f.splay, abducting));
    const int base =
        joint(metacarpal, translation(0, f.across * hb, f.along * hl) * fanned, abducting, 0);
    const int knuckle = joint(base, Pose::Identity(), flexing, 1);
    const int pip = joint(knuckle, translation(0, 0, f.proximal * hl), flexing, 2);
    const int dip = joint(pip, translation(0, 0, f.middle * hl), flexing, 3);
    b.tip(finger, pip, dip, f.distal * hl);
  }
  b.hand.joint_names.emplace_back("palm_arch");
  b.hand.upper[kPalmArch] = 28 * kRadPerDegree;
  return b.hand;
}

HandPoints hand_points(const RobotModel& hand, const HandAngles& angles,
                       std::vector<Pose>& frames) {
  assert(hand.joints() == kHandAngleCount + 1);
  Eigen::Matrix<double, static_cast<int>(kHandAngleCount) + 1, 1> q;
  std::copy(angles.joint.begin(), angles.joint.end(), q.data());
  q[kPalmArch] = angles.palm_arch;
  robot::forward_kinematics(hand, Eigen::Map<const JointVector>(q.data(), q.size()), frames);
  HandPoints points;
  for (std::size_t finger = 0; finger < kFingerCount; ++finger) {
    const RobotModel::Tip& tip = hand.tips[finger];
    const Pose& last = frames[tip.frame];
    points.tip[finger] = last * tip.transform.translation();
    points.tip_orientation[finger] = Quat(last.linear());
    points.middle_joint[finger] = frames[hand.joint_centres[finger].frame].translation();
  }
  return points;
}

}  // namespace morphe::human
