#pragma once

#include <vector>

#include "pipeline/study/grasp_measures.hpp"
#include "pipeline/study/grasp_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// The scores of a movement planned with contacts as goals and with plain fingertip goals.
struct GraspComparison {
  /// The scores of the two plans.
  GraspScore contacts, fingertips;
  /// Number of contacts that the demonstration requires, if the plan with contacts has a
  /// trajectory.
  std::size_t demonstrated_contacts = 0;
};

/// Adds the rows of one hand of a set (docs/steps/study.md describes them). Contacts and
/// penetration are taken over all plans with a trajectory, ratios over movements that are
/// executable in both variants.
void add_grasp_rows(const GraspStudyOptions& options, const Case& of,
                    const std::vector<GraspComparison>& pairs, StudyResult& result);

}  // namespace morphe::study
