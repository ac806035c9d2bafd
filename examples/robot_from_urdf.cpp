// A robot from a description that names a URDF: its joints and limits, and where its tips stand
// when every joint is in the middle of its range. The shipped one is a Franka Panda; a description
// of your own is a page of YAML (docs/formats.md), which a pipeline then names:
// `robot.file=mine.yaml`.
//
//   robot_from_urdf [DESCRIPTION]
#include <cstdio>
#include <morphe/morphe.hpp>

/// base_from_frame of every frame, parents first.
std::vector<morphe::Pose> frame_poses(const morphe::RobotModel& robot,
                                      const morphe::JointVector& q) {
  std::vector<morphe::Pose> poses;
  for (const morphe::RobotModel::Frame& frame : robot.frames) {
    const double angle = frame.joint < 0 ? 0 : frame.ratio * q[frame.joint] + frame.offset;
    const morphe::Pose parent_from_frame = frame.transform * Eigen::AngleAxisd(angle, frame.axis);
    poses.push_back(frame.parent < 0
                        ? parent_from_frame
                        : poses[static_cast<std::size_t>(frame.parent)] * parent_from_frame);
  }
  return poses;
}

int main(int argc, char** argv) try {
  const morphe::RobotModel robot =
      morphe::load_robot(argc > 1 ? argv[1] : "datasets/motionbenchmaker/panda.yaml");
  const morphe::JointVector middle = (robot.lower + robot.upper) / 2;
  for (std::size_t k = 0; k < robot.joints(); ++k) {
    const auto joint = static_cast<Eigen::Index>(k);
    std::printf("%s %.6f … %.6f rad, at most %.3f rad/s\n", robot.joint_names[k].c_str(),
                robot.lower[joint], robot.upper[joint], robot.velocity[joint]);
  }
  const std::vector<morphe::Pose> poses = frame_poses(robot, middle);
  for (const morphe::RobotModel::Tip& tip : robot.tips) {
    const morphe::Pose base_from_tip = poses[static_cast<std::size_t>(tip.frame)] * tip.transform;
    const morphe::Vec3 position = base_from_tip.translation();
    std::printf("%s %.6f %.6f %.6f m\n", tip.name.c_str(), position.x(), position.y(),
                position.z());
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
