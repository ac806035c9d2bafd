// A term of one's own in the objective, without building Morphe: joints stay near the middle of
// their ranges. The config says how much it weighs, and so does the plans.h5.
//
//   own_term CONFIG RECORDINGS PLANS.h5 WEIGHT
//   own_term configs/pipelines/pa10_dlr_hit2.yaml datasets/ue-adl/recordings.yaml plans.h5 0.05
#include <cmath>
#include <cstdio>
#include <morphe/morphe.hpp>
#include <string>

/// r_j = (q_j - middle_j) / half the range_j: 0 in the middle, 1 at a limit.
class RangeMiddle : public morphe::ResidualTerm {
 public:
  std::string name() const override { return "range_middle"; }

  void residuals(const morphe::ResidualInput& posture, morphe::JointVector& r,
                 morphe::JointRows& jacobian) const override {
    const morphe::JointVector half = (posture.robot.upper - posture.robot.lower) / 2;
    r = (posture.q - posture.robot.lower).cwiseQuotient(half).array() - 1;
    jacobian = half.cwiseInverse().asDiagonal();
  }
};

int main(int argc, char** argv) try {
  if (argc != 5) {
    std::fprintf(stderr, "usage: own_term CONFIG RECORDINGS PLANS.h5 WEIGHT\n");
    return 2;
  }
  const std::string terms =
      "map.custom_terms=[{name: range_middle, weight: " + std::string(argv[4]) + "}]";
  const morphe::Pipeline pipeline(argv[1], {terms}, {std::make_shared<RangeMiddle>()});

  const std::filesystem::path plans = argv[3];
  const std::filesystem::path imported = plans.parent_path() / "demonstrations.h5";
  morphe::import_recordings(argv[2], imported);
  const morphe::store::DemonstrationReader demonstrations(imported);
  morphe::store::PlanWriter writer(plans, pipeline.header(imported), pipeline.robot());
  const morphe::RobotModel& robot = pipeline.robot();
  for (const std::string& name : demonstrations.names()) {
    for (const morphe::Plan& plan : pipeline.plan(demonstrations.read(name))) {
      const morphe::JointRows& q = plan.mapped.position;
      double sum = 0;
      for (Eigen::Index f = 0; f < q.rows(); ++f) {
        for (Eigen::Index j = 0; j < q.cols(); ++j) {
          sum += std::pow(
              (2 * q(f, j) - robot.lower[j] - robot.upper[j]) / (robot.upper[j] - robot.lower[j]),
              2);
        }
      }
      std::printf("%s/%03d: %s, %.6f of half a range from the middle\n", name.c_str(),
                  plan.movement.index, plan.executable() ? "executable" : plan.detail.c_str(),
                  std::sqrt(sum / static_cast<double>(q.size())));
      writer.add(plan);
    }
  }
  writer.finish();
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
