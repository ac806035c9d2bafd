#include "pipeline/study/human_poses.hpp"

#include <algorithm>
#include <cmath>

#include "stages/import/import.hpp"
#include "stages/reconstruct/mirror.hpp"
#include "stages/reconstruct/reconstruct.hpp"
#include "stages/segment/segment.hpp"

namespace morphe::study {
namespace {

/// Returns the number of frames of a clock that correspond to a step of `step_s`.
std::ptrdiff_t stride(const std::vector<double>& time, double step_s) {
  if (time.size() < 2) return 1;
  const double frame_s = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  return std::max(1L, std::lround(step_s / frame_s));
}

template <class Use>
void for_each_motion(const std::filesystem::path& manifest, const Use& use) {
  imports::ImportRequest request;
  request.paths = {manifest};
  imports::import_recordings(request, [&](Demonstration&& demonstration) {
    use(demonstration, reconstruct::reconstruct(demonstration, {}, {}));
  });
}

}  // namespace

std::vector<HumanPoses> arm_poses(const std::filesystem::path& manifest,
                                  const human::ArmLengths& lengths, double step_s) {
  std::vector<HumanPoses> all;
  for_each_motion(manifest, [&](const Demonstration& demonstration, const HumanMotion& motion) {
    for (const Movement& movement :
         segment::segment(motion, {}, reconstruct::objects_on_side(demonstration, Side::right),
                          demonstration.task)) {
      HumanPoses poses;
      const std::ptrdiff_t every = stride(motion.time, step_s);
      for (std::ptrdiff_t i = 0; i < std::ssize(motion.time); i += every) {
        if (motion.time[i] < movement.begin_s || motion.time[i] > movement.end_s) continue;
        const Vec3 upper_arm = motion.elbow[i] - motion.shoulder[i];
        const Vec3 forearm = motion.wrist[i] - motion.elbow[i];
        if (!is_known(upper_arm) || !is_known(forearm) || !is_known(motion.wrist_orientation[i]))
          continue;
        HumanPose pose;
        pose.time = motion.time[i];
        pose.elbow = lengths.upper_arm * upper_arm.normalized();
        pose.wrist = pose.elbow + lengths.forearm * forearm.normalized();
        pose.hand = motion.wrist_orientation[i];
        for (int f = 0; f < std::ssize(pose.tip); ++f)
          pose.tip[f] = pose.wrist + motion.tip(i, f) - motion.wrist[i];
        poses.push_back(pose);
      }
      if (!poses.empty()) all.push_back(std::move(poses));
    }
  });
  return all;
}

std::vector<HumanPoses> hand_poses(const std::filesystem::path& manifest,
                                   const human::HandSize& size, double step_s) {
  std::vector<HumanPoses> all;
  const RobotModel hand = human::human_hand(size);
  std::vector<Pose> frames;
  for_each_motion(manifest, [&](const Demonstration&, const HumanMotion& motion) {
    HumanPoses poses;
    const std::ptrdiff_t every = stride(motion.time, step_s);
    for (Eigen::Index i = 0; i < motion.hand_angles.rows(); i += every) {
      const JointVector row = motion.hand_angles.row(i).transpose();
      if (!row.allFinite()) continue;
      human::HandAngles angles;
      std::copy(row.begin(), row.end(), angles.joint.begin());
      HumanPose pose;
      pose.time = motion.time[i];
      pose.wrist = Vec3::Zero();
      pose.hand = Quat::Identity();
      pose.tip = human::hand_points(hand, angles, frames).tip;
      poses.push_back(pose);
    }
    if (!poses.empty()) all.push_back(std::move(poses));
  });
  return all;
}

}  // namespace morphe::study
