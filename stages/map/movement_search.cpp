#include "stages/map/movement_search.hpp"

#include <algorithm>
#include <cmath>

#include "stages/map/frame_search.hpp"

namespace morphe {
namespace {

using Eigen::Index;

/// Frames of an evenly spaced grid that holds the first and the last frame.
std::vector<std::size_t> coarse_frames(const std::vector<double>& time, double step_s) {
  const std::size_t last = time.size() - 1;
  const double span_s = time.back() - time.front();
  const auto steps = std::min<std::size_t>(
      last, std::max<std::size_t>(4, static_cast<std::size_t>(std::lround(span_s / step_s))));
  std::vector<std::size_t> frames;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double position = static_cast<double>(k * last) / static_cast<double>(steps);
    frames.push_back(static_cast<std::size_t>(std::lround(position)));
  }
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

MappingProblem on_frames(const MappingProblem& problem, const std::vector<std::size_t>& frames) {
  MappingProblem coarse = problem;
  coarse.time.clear();
  coarse.goals.clear();
  for (const std::size_t f : frames) {
    coarse.time.push_back(problem.time[f]);
    coarse.goals.push_back(problem.goals[f]);
  }
  return coarse;
}

/// Warm-started solves from a key frame to both ends, as exact as a start of smooth_movement() has
/// to be.
JointRows follow(const MappingProblem& problem, std::size_t key, const JointVector& q,
                 MinimiseOptions options, MappingScratch& scratch) {
  options.relative_value = std::max(options.relative_value, 1e-5);
  JointRows rows(static_cast<Index>(problem.frames()), q.size());
  rows.row(static_cast<Index>(key)) = q.transpose();
  const auto step = [&](std::size_t from, std::size_t to) {
    const JointVector start = rows.row(static_cast<Index>(from)).transpose();
    rows.row(static_cast<Index>(to)) =
        solve_frame(problem, to, start, options, scratch).x.transpose();
  };
  for (std::size_t f = key; f + 1 < problem.frames(); ++f) step(f, f + 1);
  for (std::size_t f = key; f > 0; --f) step(f, f - 1);
  return rows;
}

JointRows interpolate(const JointRows& coarse, const std::vector<std::size_t>& frames) {
  JointRows fine(static_cast<Index>(frames.back() + 1), coarse.cols());
  for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
    const double span = static_cast<double>(frames[k + 1] - frames[k]);
    for (std::size_t f = frames[k]; f <= frames[k + 1]; ++f) {
      const double share = static_cast<double>(f - frames[k]) / span;
      fine.row(static_cast<Index>(f)) = (1 - share) * coarse.row(static_cast<Index>(k)) +
                                        share * coarse.row(static_cast<Index>(k + 1));
    }
  }
  return fine;
}

constexpr double kSame = 0.05;  ///< nearer in every joint: the same [rad]

bool same_course(const JointRows& a, const JointRows& b) {
  return (a - b).cwiseAbs().maxCoeff() < kSame;
}

void by_value(std::vector<Course>& courses) {
  std::stable_sort(courses.begin(), courses.end(),
                   [](const Course& a, const Course& b) { return a.value < b.value; });
}

void add_if_new(std::vector<Course>& courses, Course course) {
  for (Course& known : courses) {
    if (!same_course(known.q, course.q)) continue;
    if (course.value < known.value) known = std::move(course);
    return;
  }
  courses.push_back(std::move(course));
}

}  // namespace

Course smooth_movement(const MappingProblem& problem, const JointRows& start,
                       const MapOptions& options) {
  const RobotTable& robot = *problem.robot;
  MovementProblem movement;
  movement.frames = problem.frames();
  movement.lower = robot.lower;
  movement.upper = robot.upper;
  movement.difference_weight = difference_weights(robot, problem.time, options.movement_cost);
  // A coarser grid has fewer frames: each stands for more time, in both sums alike.
  const double share = mean_step(problem.time) / kReferenceStep;
  std::vector<MappingScratch> scratch(problem.frames());
  movement.frame_model = [&](std::size_t frame, const JointVector& q, Quadratic& model) {
    add_frame(problem, frame, q, scratch[frame], model, Curvature::exact);
    model.value *= share;
    model.gradient *= share;
    model.hessian *= share;
  };
  const MovementMinimum found = minimise_movement(movement, start, options.movement);
  return {found.q, found.value};
}

std::vector<Course> search_movement(const MappingProblem& problem, const MapOptions& options,
                                    std::uint64_t seed) {
  const std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const MappingProblem coarse = on_frames(problem, frames);
  MappingScratch scratch;

  std::vector<JointRows> ways;
  const auto on_known_way = [&](std::size_t key, const JointVector& q) {
    const auto passes = [&](const JointRows& way) {
      return (way.row(static_cast<Index>(key)) - q.transpose()).cwiseAbs().maxCoeff() < kSame;
    };
    return std::ranges::any_of(ways, passes);
  };
  std::vector<Course> followed;
  for (int k = 0; k < options.key_frames; ++k) {
    const auto last = static_cast<double>(coarse.frames() - 1);
    const double position = options.key_frames == 1 ? last : last * k / (options.key_frames - 1);
    const auto key = static_cast<std::size_t>(std::lround(position));
    for (const Minimum& start :
         search_frame(coarse, key, options.starts, options.candidates, options.solver,
                      seed + static_cast<std::uint64_t>(k), scratch)) {
      if (on_known_way(key, start.x)) continue;
      ways.push_back(follow(coarse, key, start.x, options.solver, scratch));
      MapOptions once = options;
      once.movement.iterations = 4;  // enough to rank: the jumps go, the basin shows
      add_if_new(followed, smooth_movement(coarse, ways.back(), once));
    }
  }
  by_value(followed);
  if (followed.size() > static_cast<std::size_t>(options.candidates)) {
    followed.resize(static_cast<std::size_t>(options.candidates));
  }

  std::vector<Course> courses;
  for (const Course& course : followed) {
    add_if_new(courses, smooth_movement(coarse, course.q, options));
  }
  by_value(courses);
  for (Course& course : courses) course.q = interpolate(course.q, frames);
  courses.front() = smooth_movement(problem, courses.front().q, options);
  return courses;
}

Course course_through(const MappingProblem& problem, std::size_t frame, const JointVector& posture,
                      const MapOptions& options) {
  std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const auto place = std::ranges::lower_bound(frames, frame);
  const auto key = static_cast<std::size_t>(place - frames.begin());
  if (*place != frame) frames.insert(place, frame);
  const MappingProblem coarse = on_frames(problem, frames);
  MappingScratch scratch;
  const JointRows followed = follow(coarse, key, posture, options.solver, scratch);
  const Course smoothed = smooth_movement(coarse, followed, options);
  return smooth_movement(problem, interpolate(smoothed.q, frames), options);
}

}  // namespace morphe
