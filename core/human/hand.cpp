#include "core/human/hand.hpp"

#include <algorithm>
#include <cassert>
#include <string>

#include "core/robot/forward_kinematics.hpp"
#include "core/robot/hand_proportions.hpp"

namespace morphe::human {
namespace {

constexpr int kPalmArch = kHandAngleCount;  ///< the joint after kHandAngleNames
/// Rotation of each finger's metacarpal relative to palm_arch.
constexpr std::array<double, kFingerCount> kArchShare = {0, 0, 0, 20.0 / 28, 1};

Pose translation(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

/// Adds frames, joints and tips to a hand.
struct Builder {
  RobotModel hand;

  /// Adds a frame and returns its index.
  int frame(std::string name, int parent, const Pose& transform, const Vec3& axis, int joint,
            double ratio = 1) {
    hand.frames.push_back({std::move(name), parent, transform, axis, joint, ratio, 0});
    return static_cast<int>(std::ssize(hand.frames)) - 1;
  }
  /// Adds the next joint of kHandAngleNames and returns the index of its frame.
  int joint(int parent, const Pose& transform, const Vec3& axis, double lower, double upper) {
    const int k = static_cast<int>(std::ssize(hand.joint_names));
    hand.joint_names.emplace_back(kHandAngleNames[k]);
    hand.lower[k] = lower;
    hand.upper[k] = upper;
    return frame(kHandAngleNames[k], parent, transform, axis, k);
  }
  void tip(int finger, int middle_frame, int last_frame, double distal_length) {
    const std::string name = kFingerNames[finger];
    hand.tips.push_back({name + "_tip", last_frame, translation(0, 0, distal_length), finger});
    hand.joint_centres.push_back({middle_frame, name});
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
  b.hand.lower = b.hand.upper = JointVector::Zero(kPalmArch + 1);
  b.hand.velocity = b.hand.acceleration = b.hand.jerk =
      JointVector::Constant(kPalmArch + 1, kInfinity);
  const int palm = b.frame("hand", -1, Pose::Identity(), Vec3::UnitZ(), -1);

  const robot::ThumbProportions& t = robot::kThumbProportions;
  const auto thumb = [&](int parent, const Pose& transform, const Vec3& axis, int k) {
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

  for (int finger = 1; finger < std::ssize(kFingerNames); ++finger) {
    const robot::FingerProportions& f = robot::kFingerProportions[finger - 1];
    const auto joint = [&](int parent, const Pose& transform, const Vec3& axis, int k) {
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
  Eigen::Matrix<double, kPalmArch + 1, 1> q;
  std::ranges::copy(angles.joint, q.data());
  q[kPalmArch] = angles.palm_arch;
  robot::forward_kinematics(hand, Eigen::Map<const JointVector>(q.data(), q.size()), frames);
  HandPoints points;
  for (int finger = 0; finger < std::ssize(kFingerNames); ++finger) {
    const RobotModel::Tip& tip = hand.tips[finger];
    const Pose& last = frames[tip.frame];
    points.tip[finger] = last * tip.transform.translation();
    points.tip_orientation[finger] = Quat(last.linear());
    points.middle_joint[finger] = frames[hand.joint_centres[finger].frame].translation();
  }
  return points;
}

}  // namespace morphe::human
