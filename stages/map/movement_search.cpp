#include "stages/map/movement_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/math/seed.hpp"
#include "stages/map/coarse_grid.hpp"
#include "stages/map/frame_search.hpp"
#include "stages/map/rounded_problem.hpp"
#include "stages/map/splice.hpp"
#include "stages/map/twins.hpp"
#include "stages/map/whole_movement.hpp"

namespace morphe::map {
namespace {

using Eigen::Index;

constexpr int kFollow = 5;  ///< evaluations at a frame that is followed

/// Warm-started solves from a key frame to both ends, as exact as what is spliced and smoothed has
/// to be.
Way follow(const MappingProblem& problem, std::size_t key, const JointVector& q,
           solve::MinimiseOptions options, MappingScratch& scratch) {
  options = limited(options, kFollow);
  options.relative_value = std::max(options.relative_value, 1e-5);
  const double share = mean_step(problem.time) / kReferenceStep;
  Way way{key, JointRows(static_cast<Index>(problem.frames()), q.size()),
          std::vector<double>(problem.frames())};
  const auto solve = [&](std::size_t frame, const JointVector& start) {
    const solve::Minimum found = solve_frame(problem, frame, start, options, scratch);
    way.q.row(static_cast<Index>(frame)) = found.x.transpose();
    way.value[frame] = share * found.value;
  };
  solve(key, q);
  const auto near = [&](std::size_t frame) -> JointVector {
    return way.q.row(static_cast<Index>(frame)).transpose();
  };
  for (std::size_t f = key; f + 1 < problem.frames(); ++f) solve(f + 1, near(f));
  for (std::size_t f = key; f > 0; --f) solve(f - 1, near(f));
  return way;
}

/// The same postures all along, or twins of them.
bool same_course(const Twins& twins, const JointRows& a, const JointRows& b) {
  for (Index f = 0; f < a.rows(); ++f) {
    if (!alike(twins, a.row(f).transpose(), b.row(f).transpose(), kSame)) return false;
  }
  return true;
}

/// Iterations after which the jumps are gone and a sequence shows what it is worth, and how many of
/// the best are smoothed to the end: the others wait for repair, which changes them anyway.
constexpr int kLook = 7;
constexpr std::size_t kSmoothed = 2;
constexpr double kComparing = 10;  ///< times the share of their value that the last steps gain

solve::MovementOptions limited(solve::MovementOptions options, int iterations) {
  options.iterations = std::min(options.iterations, iterations);
  return options;
}

/// All frames of the problem smoothed at once.
Course minimise_course(const MappingProblem& problem, const JointRows& start,
                       const MovementCost& cost, const solve::MovementOptions& options) {
  std::vector<MappingScratch> scratch;
  const solve::MovementMinimum found =
      solve::minimise_movement(whole_movement(problem, cost, scratch), start, options);
  return {found.q, found.value};
}

/// A course on the coarse grid, settled there and then refined to every frame.
Course settle(const MappingProblem& problem, const MappingProblem& coarse,
              const std::vector<std::size_t>& frames, const JointRows& start,
              const MapOptions& options) {
  const Course settled = minimise_course(coarse, start, options.movement_cost, options.movement);
  return minimise_course(problem, interpolate(settled.q, frames), options.movement_cost,
                         for_all_frames(options.movement));
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
  const std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const RoundedProblem coarse(on_frames(problem, frames));
  return settle(problem, coarse.problem, frames, rows_at(start, frames), options);
}

std::vector<Course> search_movement(const MappingProblem& problem, const MapOptions& options,
                                    std::uint64_t seed) {
  const std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const RoundedProblem rounded(on_frames(problem, frames));
  const MappingProblem& coarse = rounded.problem;
  MappingScratch scratch;

  const Twins twins = find_twins(coarse);
  std::vector<Way> ways;
  std::vector<bool> stopped;  // by a limit that a twin may not meet
  const auto on_known_way = [&](std::size_t key, const JointVector& q) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const JointVector passed = ways[w].q.row(static_cast<Index>(key)).transpose();
      const bool same =
          stopped[w] ? (passed - q).cwiseAbs().maxCoeff() < kSame : alike(twins, passed, q, kSame);
      if (same) return true;
    }
    return false;
  };
  for (int k = 0; k < options.key_frames; ++k) {
    const auto last = static_cast<double>(coarse.frames() - 1);
    const double position = options.key_frames == 1 ? last : last * k / (options.key_frames - 1);
    const auto key = static_cast<std::size_t>(std::lround(position));
    for (const solve::Minimum& start :
         search_frame(coarse, key, options.starts, options.candidates, quick(options.solver),
                      math::seed_from(seed, "key frame", static_cast<std::size_t>(k)), scratch)) {
      for (const JointVector& twin : first_twins(twins, start.x)) {
        if (on_known_way(key, twin)) continue;
        ways.push_back(follow(coarse, key, twin, options.solver, scratch));
        stopped.push_back(meets_limit(twins, ways.back().q));
        if (!stopped.back()) break;
      }
    }
  }
  std::vector<JointRows> sequences =
      splice(ways, difference_weights(*problem.robot, coarse.time, options.movement_cost));
  if (sequences.size() > static_cast<std::size_t>(options.candidates)) {
    sequences.resize(static_cast<std::size_t>(options.candidates));
  }
  std::vector<Course> courses;
  for (const JointRows& sequence : sequences) {
    add_if_new(
        twins, courses,
        minimise_course(coarse, sequence, options.movement_cost, limited(options.movement, kLook)));
  }
  by_value(courses);
  solve::MovementOptions comparing = options.movement;
  comparing.relative_value *= kComparing;
  for (std::size_t k = 0; k < std::min(kSmoothed, courses.size()); ++k) {
    courses[k] = minimise_course(coarse, courses[k].q, options.movement_cost, comparing);
  }
  by_value(courses);
  courses.front() = settle(problem, coarse, frames, courses.front().q, options);
  for (std::size_t k = 1; k < courses.size(); ++k) {
    courses[k].q = interpolate(courses[k].q, frames);
  }
  return courses;
}

Course course_through(const MappingProblem& problem, std::size_t frame, const JointVector& posture,
                      const MapOptions& options) {
  std::vector<std::size_t> frames = coarse_frames(problem.time, options.coarse_step_s);
  const auto place = std::ranges::lower_bound(frames, frame);
  const auto key = static_cast<std::size_t>(place - frames.begin());
  if (*place != frame) frames.insert(place, frame);
  const RoundedProblem coarse(on_frames(problem, frames));
  MappingScratch scratch;
  const Way followed = follow(coarse.problem, key, posture, options.solver, scratch);
  return settle(problem, coarse.problem, frames, followed.q, options);
}

}  // namespace morphe::map
