#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "stages/map/map_options.hpp"
#include "stages/map/mapping_problem.hpp"
#include "stages/map/movement_search.hpp"
#include "stages/planning/dead_end.hpp"

namespace morphe::planning {

/// Other courses, one after the other, refined to every frame: those through the postures that hold
/// goals at which the path failed, then those of new searches, the best of each first. A search
/// waits until its first is asked for, and is the last if no course of it came nearer.
class NewCourses {
 public:
  NewCourses(const map::MappingProblem& whole, const map::MapOptions& options,
             const std::vector<Hold>& holds, std::size_t searches, std::uint64_t seed);

  std::optional<JointPath> operator()(bool nearer);

 private:
  JointPath path_of(JointRows q) const;

  map::MappingProblem problem_;
  const map::MapOptions& options_;
  const std::vector<Hold>& holds_;
  std::size_t next_hold_ = 0;
  std::size_t searches_, searched_ = 0;
  bool nearer_ = true;  ///< a course of the last search was the best so far
  std::uint64_t seed_;
  std::vector<map::Course> courses_;
  std::size_t next_ = 0;
};

}  // namespace morphe::planning
