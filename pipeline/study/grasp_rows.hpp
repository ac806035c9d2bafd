#pragma once

#include <vector>

#include "pipeline/study/grasp_measures.hpp"
#include "pipeline/study/grasp_options.hpp"
#include "pipeline/study/study.hpp"

namespace morphe::study {

/// A movement planned with contacts as goals and with plain fingertip goals.
struct GraspPair {
  GraspScore contacts, fingertips;
  std::size_t asked = 0;  ///< contacts that its demonstration asks for, if it runs with contacts
};

/// The rows of one hand of a set (docs/steps/study.md says what each is). Contacts and penetration
/// are those of all plans that run, ratios those of movements that are executable both ways.
void add_grasp_rows(const GraspStudyOptions& options, const Case& of,
                    const std::vector<GraspPair>& pairs, StudyResult& result);

}  // namespace morphe::study
