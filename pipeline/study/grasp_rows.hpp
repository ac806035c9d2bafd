#pragma once

#include <vector>

#include "pipeline/study/grasp_measures.hpp"
#include "pipeline/study/grasp_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// The scores of a movement planned with contacts as goals and with plain fingertip goals.
struct GraspComparison {
  GraspScore contacts, fingertips;
  /// Number of demonstrated contacts; 0 if the plan with contacts has no trajectory.
  int demonstrated_contacts = 0;
};

/// Adds the rows of one hand of a set (docs/steps/study.md describes them). Contacts and
/// penetration are taken over all plans with a trajectory, ratios over movements that are
/// executable in both variants.
void add_grasp_rows(const GraspStudyOptions& options, const Case& condition,
                    const std::vector<GraspComparison>& pairs, StudyResult& result);

}  // namespace morphe::study
