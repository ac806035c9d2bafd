#include "stages/map/movement_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "stages/map/frame_search.hpp"
#include "stages/map/twins.hpp"

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

constexpr double kSame = 0.1;  ///< nearer in every joint: the same [rad]

/// The same postures all along, or twins of them.
bool same_course(const Twins& twins, const JointRows& a, const JointRows& b) {
  for (Index f = 0; f < a.rows(); ++f) {
    if (!alike(twins, a.row(f).transpose(), b.row(f).transpose(), kSame)) return false;
  }
  return true;
}

/// Iterations that show what a way is worth: the jumps go, the basin shows; and then, how deep it
/// is.
constexpr int kFirstLook = 3, kSecondLook = 7;

MapOptions rough(MapOptions options, int iterations) {
  options.movement.iterations = std::min(options.movement.iterations, iterations);
  return options;
}

/// Twins that are worth following.
std::vector<JointVector> first_twins(const Twins& twins, const JointVector& q) {
  constexpr std::size_t kMost = 3;
  std::vector<JointVector> found = twins_of(twins, q);
  if (found.size() > kMost) found.resize(kMost);
  return found;
}

/// Whether a joint that differs among twins is stopped somewhere by its limit.
bool meets_limit(const Twins& twins, const JointRows& way) {
  return std::ranges::any_of(joints_of(twins), [&](Index j) {
    return way.col(j).minCoeff() <= twins.lower[j] || way.col(j).maxCoeff() >= twins.upper[j];
  });
}

void by_value(std::vector<Course>& courses) {
  std::stable_sort(courses.begin(), courses.end(),
                   [](const Course& a, const Course& b) { return a.value < b.value; });
}

void keep_best(std::vector<Course>& courses, int count) {
  by_value(courses);
  if (courses.size() > static_cast<std::size_t>(count)) {
    courses.resize(static_cast<std::size_t>(count));
  }
}

void add_if_new(const Twins& twins, std::vector<Course>& courses, Course course) {
  for (Course& known : courses) {
    if (!same_course(twins, known.q, course.q)) continue;
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

  const Twins twins = find_twins(coarse);
  struct Way {
    JointRows q;
    bool stopped;  ///< by a limit that a twin may not meet
  };
  std::vector<Way> ways;
  const auto on_known_way = [&](std::size_t key, const JointVector& q) {
    return std::ranges::any_of(ways, [&](const Way& way) {
      const JointVector passed = way.q.row(static_cast<Index>(key)).transpose();
      return way.stopped ? (passed - q).cwiseAbs().maxCoeff() < kSame
                         : alike(twins, passed, q, kSame);
    });
  };
  std::vector<Course> followed;
  for (int k = 0; k < options.key_frames; ++k) {
    const auto last = static_cast<double>(coarse.frames() - 1);
    const double position = options.key_frames == 1 ? last : last * k / (options.key_frames - 1);
    const auto key = static_cast<std::size_t>(std::lround(position));
    for (const Minimum& start :
         search_frame(coarse, key, options.starts, options.candidates, options.solver,
                      seed + static_cast<std::uint64_t>(k), scratch)) {
      for (const JointVector& twin : first_twins(twins, start.x)) {
        if (on_known_way(key, twin)) continue;
        JointRows way = follow(coarse, key, twin, options.solver, scratch);
        add_if_new(twins, followed, smooth_movement(coarse, way, rough(options, kFirstLook)));
        const bool stopped = meets_limit(twins, way);
        ways.push_back({std::move(way), stopped});
        if (!stopped) break;
      }
    }
  }
  keep_best(followed, 3 * options.candidates);
  std::vector<Course> courses;
  for (const Course& course : followed) {
    add_if_new(twins, courses, smooth_movement(coarse, course.q, rough(options, kSecondLook)));
  }
  keep_best(courses, options.candidates);
  followed = std::exchange(courses, {});
  for (const Course& course : followed) {
    add_if_new(twins, courses, smooth_movement(coarse, course.q, options));
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
