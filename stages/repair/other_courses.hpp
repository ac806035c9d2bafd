#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stages/repair/ladder.hpp"

namespace morphe::repair {

/// Other courses through the whole movement, one after the other: other ways to hold the same goals
/// (a goal set), for a path whose end is bad or that leads nowhere. The most promising first; none:
/// there is no further one. `nearer`: the last one became the best.
using NextCourse = std::function<std::optional<JointPath>(bool nearer)>;

/// What was still wrong with each course of a movement that was tried.
using CourseEnds = std::vector<std::vector<Finding>>;

/// The rung that tries other courses, each of them changed by `rungs`: it makes the first one that
/// is free, or the best of them and the path when there are no more, or when four fail where the
/// best does: with the worst of its findings, at the same time and about as much or more. `ends`,
/// which all such rungs of a movement share, must outlive it.
Rung other_courses(std::string name, std::vector<Rung> rungs, Check check, NextCourse courses,
                   CourseEnds& ends);

}  // namespace morphe::repair
