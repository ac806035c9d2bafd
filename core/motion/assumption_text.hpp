#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/motion/assumption.hpp"
#include "core/motion/plan.hpp"

namespace morphe {

/// Returns the assumptions about the objects of a plan's scene, by their origins.
MORPHE_EXPORT std::vector<Assumption> object_assumptions(const Plan& plan);
/// Returns the assumptions of one plan, apart from those of its file: of recording and objects.
MORPHE_EXPORT std::vector<Assumption> plan_assumptions(const Plan& plan);
/// Returns the assumptions of a plan and of its file, ordered by kind.
MORPHE_EXPORT std::vector<Assumption> all_assumptions(const PlanFileHeader& header,
                                                      const Plan& plan);

/// Returns an assumption as a phrase: "limits: pa10: …", or "map.starts=64" for a setting.
MORPHE_EXPORT std::string phrase(const Assumption& assumption);

/// The assumptions of many plans, counted by kind and subject. Of several values, the first one
/// stands for all.
struct AssumptionTally {
  std::vector<std::pair<Assumption, int>> counted;  ///< with the number of plans

  /// Adds the assumptions of a plan.
  void add(const std::vector<Assumption>& assumptions);
};

/// Returns one line for each kind with the subjects of its assumptions, and the number of plans if
/// these are not all; "" without assumptions.
MORPHE_EXPORT std::string subject_lines(const std::vector<Assumption>& of_file,
                                        const AssumptionTally& of_plans, int plan_count);
/// Returns one line for each assumption, with the kind in front of the first of its kind.
MORPHE_EXPORT std::string assumption_lines(const std::vector<Assumption>& assumptions);

/// Returns the clearances by kind as one phrase: "self 3.3 mm (a, b at 1.20 s), table 12.1 mm …".
MORPHE_EXPORT std::string clearance_phrase(const Certificate& certificate);

/// Returns one line on what the certificate of an executable plan holds for, or on its absence.
MORPHE_EXPORT std::string certified_line(const Plan& plan);

}  // namespace morphe
