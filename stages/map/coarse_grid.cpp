#include "stages/map/coarse_grid.hpp"

#include <algorithm>
#include <cmath>

#include "stages/map/constants.hpp"

namespace morphe::map {

std::vector<std::size_t> coarse_frames(const std::vector<double>& time, double step_s) {
  const std::size_t last = time.size() - 1;
  const double span_s = time.back() - time.front();
  const auto steps = std::min<std::size_t>(
      last, std::max<std::size_t>(kMinFrames - 1, std::lround(span_s / step_s)));
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k <= steps; ++k) {
    frames.push_back(std::lround(static_cast<double>(k * last) / static_cast<double>(steps)));
  }
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

MappingProblem problem_at_frames(const MappingProblem& problem,
                                 const std::vector<std::size_t>& frames) {
  MappingProblem part{problem.robot,
                      problem.objective,
                      problem.clearance,
                      problem.wrist_motion,
                      problem.world,
                      {},
                      {},
                      problem.reference};
  for (const std::size_t f : frames) {
    part.time.push_back(problem.time[f]);
    part.goals.push_back(problem.goals[f]);
  }
  return part;
}

JointRows interpolate(const JointRows& coarse, const std::vector<std::size_t>& frames) {
  const std::size_t origin = frames.front();
  JointRows fine(frames.back() - origin + 1, coarse.cols());
  const auto row = [&](std::size_t k) { return coarse.row(k); };
  const auto slope = [&](std::size_t k) -> Eigen::RowVectorXd {
    const std::size_t previous = k == 0 ? 0 : k - 1, next = std::min(k + 1, frames.size() - 1);
    return (row(next) - row(previous)) / static_cast<double>(frames[next] - frames[previous]);
  };
  fine.row(0) = row(0);
  for (int k = 0; k + 1 < std::ssize(frames); ++k) {
    const double span = static_cast<double>(frames[k + 1] - frames[k]);
    const Eigen::RowVectorXd leaving = span * slope(k), arriving = span * slope(k + 1);
    for (std::size_t f = frames[k]; f <= frames[k + 1]; ++f) {
      const double u = static_cast<double>(f - frames[k]) / span, v = 1 - u;
      fine.row(f - origin) = v * v * ((1 + 2 * u) * row(k) + u * leaving) +
                             u * u * ((1 + 2 * v) * row(k + 1) - v * arriving);
    }
  }
  return fine;
}

JointRows rows_at(const JointRows& q, const std::vector<std::size_t>& frames) {
  JointRows rows(frames.size(), q.cols());
  for (int k = 0; k < std::ssize(frames); ++k) rows.row(k) = q.row(frames[k]);
  return rows;
}

solve::MovementOptions fine_grid_options(solve::MovementOptions coarse) {
  coarse.max_iterations = std::max(2, coarse.max_iterations / kFineIterationsDivisor);
  coarse.relative_tolerance *= kFineToleranceFactor;
  return coarse;
}

}  // namespace morphe::map
