// What a plans.h5 holds: for each plan its status, how long the trajectory takes, what it keeps
// clear by, and where the joints are at the grasp. Further fields: core/motion/plan.hpp.
//
//   read_plans PLANS.h5
#include <cstdio>
#include <morphe/morphe.hpp>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: read_plans PLANS.h5\n");
    return 2;
  }
  const morphe::store::PlanReader file(argv[1]);
  const morphe::RobotModel& robot = file.robot();
  std::printf("%s, %zu joints, written by %s\n", robot.name.c_str(), robot.joints(),
              file.header().software.c_str());
  for (std::size_t k = 0; k < file.size(); ++k) {
    const morphe::Plan plan = file.read(k);  // one at a time: a file may hold very many
    std::printf("%s: ", file.plan_paths()[k].c_str());
    if (!plan.has_trajectory()) {
      std::printf("%s: %s\n", std::string(name_of(plan.reason)).c_str(), plan.detail.c_str());
      continue;
    }
    std::printf("%zu samples, %.3f s, %.2f mm clear\n", plan.trajectory.samples(),
                plan.trajectory.time.back(), 1000 * plan.certificate.clearance);
    if (plan.grasp.sample < 0) continue;
    for (std::size_t joint = 0; joint < robot.joints(); ++joint) {
      std::printf("  %s %.6f rad\n", robot.joint_names[joint].c_str(),
                  plan.trajectory.position(plan.grasp.sample, static_cast<Eigen::Index>(joint)));
    }
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
