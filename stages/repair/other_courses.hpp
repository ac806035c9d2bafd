#pragma once

#include <functional>
#include <optional>

#include "stages/repair/detour.hpp"

namespace morphe::repair {

/// Another course through the whole movement, searched with the whole scene in sight: other ways to
/// hold the same goals (a goal set), for a path whose end is bad or that leads nowhere. The most
/// humanlike first; none: there is no other. `nearer`: the last one became the best.
using NextCourse = std::function<std::optional<JointPath>(bool nearer)>;

/// The best of the path and of other courses, won back and led around collisions alike; the first
/// one that is free, or the best when there are no more, or when four end with the same findings.
Made other_courses(const Surroundings& around, const NextCourse& next, const Checked& from);

}  // namespace morphe::repair
