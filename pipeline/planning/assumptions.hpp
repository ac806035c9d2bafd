#pragma once

#include <string>
#include <vector>

#include "core/motion/assumption.hpp"
#include "core/motion/outcome.hpp"
#include "core/motion/plan.hpp"

namespace morphe::planning {

struct PipelineConfig;

/// Returns what all plans of a config rest on: `of_robot`, which its description states; friction,
/// mass and stiffness of the grasp; tolerances that exceed their defaults; `settings` ("a.b=value")
/// given by hand; and what no step looks at.
std::vector<Assumption> config_assumptions(const PipelineConfig& config,
                                           const std::vector<Assumption>& of_robot,
                                           const std::vector<std::string>& settings);

/// Returns a sentence about the first assumption of a subject that must be known, with the way to
/// answer it; "" if there is none.
std::string forbidden_assumption(const std::vector<Knowable>& must_be_known,
                                 const std::vector<Assumption>& assumptions);

/// Returns `not_known` if the recording of a plan or the scene around it is assumed although it
/// must be known.
PlanningFailure refused_assumption(const std::vector<Knowable>& must_be_known, const Plan& begun,
                                   const Scene& scene);

}  // namespace morphe::planning
