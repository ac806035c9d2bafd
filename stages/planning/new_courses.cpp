#include "stages/planning/new_courses.hpp"

#include <utility>

#include "pipeline/math/seed.hpp"
#include "stages/planning/firmness.hpp"

namespace morphe::planning {

NewCourses::NewCourses(const map::MappingProblem& whole, const map::MapOptions& options,
                       const std::vector<Hold>& holds, std::size_t searches, std::uint64_t seed)
    : problem_(as_firm(whole, {100})),
      options_(options),
      holds_(holds),
      searches_(searches),
      seed_(seed) {}

std::optional<JointPath> NewCourses::operator()(bool nearer) {
  nearer_ = nearer_ || nearer;
  if (next_hold_ < holds_.size()) {
    const Hold& hold = holds_[next_hold_++];
    return path_of(map::course_through(problem_, hold.frame, hold.q, options_).q);
  }
  if (next_ == courses_.size()) {
    if (searched_ == searches_ || !nearer_) return std::nullopt;
    nearer_ = false;
    courses_ =
        map::search_movement(problem_, options_, math::seed_from(seed_, "search", ++searched_));
    next_ = 0;
  }
  return path_of(map::smooth_movement(problem_, courses_[next_++].q, options_).q);
}

JointPath NewCourses::path_of(JointRows q) const {
  return {std::move(q), std::vector<Origin>(problem_.frames(), Origin::resolved), problem_.time};
}

}  // namespace morphe::planning
