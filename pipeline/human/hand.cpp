#include "pipeline/human/hand.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <string>

#include "pipeline/kinematics/forward.hpp"

namespace morphe {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kPalmArch = static_cast<int>(kHandAngles);  ///< the joint after kHandAngleNames

/// One finger by Buchholz's ratios: base across (to the thumb's side) to hand breadth, the rest to
/// hand length; `splay` turns it away from the thumb at zero abduction.
struct Finger {
  double across, along, proximal, middle, distal;
  double splay, arch_share;            ///< [rad], of palm_arch
  std::array<double, 4> lower, upper;  ///< abduction, MCP, PIP, DIP [degrees]
};
/// Limits as in the Anthropomorphism toolbox, which counts the abduction of ring and little finger
/// away from the thumb.
constexpr Finger kFingersOfBuchholz[] = {
    {0.251, 0.447, 0.245, 0.143, 0.097, 0, 0, {-13, 0, 0, -10}, {42, 80, 100, 90}},
    {0, 0.446, 0.266, 0.170, 0.108, 3 * kDegree, 0, {-13, 0, 0, -10}, {42, 80, 100, 90}},
    {-0.206,
     0.409,
     0.244,
     0.165,
     0.107,
     4 * kDegree,
     20.0 / 28,
     {-20, 0, 0, -20},
     {14, 80, 100, 90}},
    {-0.402, 0.368, 0.204, 0.117, 0.093, 8 * kDegree, 1, {-33, 0, 0, -30}, {19, 80, 100, 90}},
};

/// The thumb's rotation takes up two of the toolbox's three CMC joints: ±30 and 60 degrees.
constexpr double kThumbLower[] = {-30, -25, -15, -15}, kThumbUpper[] = {90, 35, 55, 80};
constexpr double kThumbSplay = 30 * kDegree;

Pose moved(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

struct Builder {
  RobotTable hand;

  int frame(std::string name, int parent, const Pose& transform, const Vec3& axis, int joint,
            double ratio = 1) {
    hand.frames.push_back({std::move(name), parent, transform, axis, joint, ratio, 0});
    return static_cast<int>(hand.frames.size()) - 1;
  }
  /// The next joint of kHandAngleNames.
  int joint(int parent, const Pose& transform, const Vec3& axis, double lower_deg,
            double upper_deg) {
    const auto k = static_cast<Eigen::Index>(hand.joint_names.size());
    hand.joint_names.emplace_back(kHandAngleNames[k]);
    hand.lower[k] = lower_deg * kDegree;
    hand.upper[k] = upper_deg * kDegree;
    return frame(kHandAngleNames[k], parent, transform, axis, static_cast<int>(k));
  }
  void tip(std::size_t finger, int middle_joint, int last, double distal) {
    const std::string name = kFingerNames[finger];
    hand.tips.push_back({name + "_tip", last, moved(0, 0, distal), static_cast<int>(finger)});
    hand.centres.push_back({middle_joint, name});
  }
};

}  // namespace

HandSize hand_size_of_stature(double stature_m) {
  constexpr double kLengthToStature = (0.110 + 0.111) / 2, kBreadthToLength = (0.457 + 0.432) / 2;
  const double length = kLengthToStature * stature_m;
  return {length, kBreadthToLength * length};
}

RobotTable human_hand(const HandSize& size) {
  const double hl = size.length, hb = size.breadth;
  const Vec3 abducting = -Vec3::UnitX(), flexing = Vec3::UnitY();
  Builder b;
  b.hand.name = "human hand";
  constexpr auto kJoints = static_cast<Eigen::Index>(kHandAngles + 1);
  b.hand.lower = b.hand.upper = JointVector::Zero(kJoints);
  b.hand.velocity = b.hand.acceleration = b.hand.jerk =
      JointVector::Constant(kJoints, std::numeric_limits<double>::infinity());
  const int palm = b.frame("hand", -1, Pose::Identity(), Vec3::UnitZ(), -1);

  const auto thumb = [&](int parent, const Pose& transform, const Vec3& axis, int k) {
    return b.joint(parent, transform, axis, kThumbLower[k], kThumbUpper[k]);
  };
  const int rotation = thumb(palm, moved(0, 0.196 * hb, 0.073 * hl), -Vec3::UnitZ(), 0);
  const Pose splayed(Eigen::AngleAxisd(kThumbSplay, abducting));
  const int abduction = thumb(rotation, splayed, abducting, 1);
  // From here on x points out of the thumb's pad: at zero across the palm.
  const Pose pad(Eigen::AngleAxisd(-90 * kDegree, Vec3::UnitZ()));
  const int mcp = thumb(abduction, moved(0, 0, 0.251 * hl) * pad, flexing, 2);
  const int ip = thumb(mcp, moved(0, 0, 0.196 * hl), flexing, 3);
  b.tip(0, mcp, ip, 0.158 * hl);

  for (std::size_t finger = 1; finger < kFingers; ++finger) {
    const Finger& f = kFingersOfBuchholz[finger - 1];
    const auto joint = [&](int parent, const Pose& transform, const Vec3& axis, std::size_t k) {
      return b.joint(parent, transform, axis, f.lower[k], f.upper[k]);
    };
    int metacarpal = palm;
    if (f.arch_share > 0) {
      metacarpal = b.frame(std::string(kFingerNames[finger]) + "_metacarpal", palm,
                           Pose::Identity(), flexing, kPalmArch, f.arch_share);
    }
    const Pose fanned(Eigen::AngleAxisd(-f.splay, abducting));
    const int base =
        joint(metacarpal, moved(0, f.across * hb, f.along * hl) * fanned, abducting, 0);
    const int knuckle = joint(base, Pose::Identity(), flexing, 1);
    const int pip = joint(knuckle, moved(0, 0, f.proximal * hl), flexing, 2);
    const int dip = joint(pip, moved(0, 0, f.middle * hl), flexing, 3);
    b.tip(finger, pip, dip, f.distal * hl);
  }
  b.hand.joint_names.emplace_back("palm_arch");
  b.hand.upper[kPalmArch] = 28 * kDegree;
  return b.hand;
}

HandPoints hand_points(const RobotTable& hand, const HandAngles& angles,
                       std::vector<Pose>& frames) {
  assert(hand.joints() == kHandAngles + 1);
  Eigen::Matrix<double, static_cast<int>(kHandAngles) + 1, 1> q;
  std::copy(angles.joint.begin(), angles.joint.end(), q.data());
  q[kPalmArch] = angles.palm_arch;
  forward(hand, Eigen::Map<const JointVector>(q.data(), q.size()), frames);
  HandPoints points;
  for (std::size_t finger = 0; finger < kFingers; ++finger) {
    const RobotTable::Tip& tip = hand.tips[finger];
    const Pose& last = frames[static_cast<std::size_t>(tip.frame)];
    points.tip[finger] = last * tip.transform.translation();
    points.tip_orientation[finger] = Quat(last.linear());
    points.middle_joint[finger] =
        frames[static_cast<std::size_t>(hand.centres[finger].frame)].translation();
  }
  return points;
}

}  // namespace morphe
