#include "pipeline/planning/re_solve.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/planning/firmness.hpp"
#include "stages/map/resolve_path.hpp"

namespace morphe::planning {
namespace {

using repair::Checked;
using repair::Made;
using repair::Rung;

constexpr double kSoonSeen = 100;  ///< whether a path gets free is: values this much less exactly

/// `exactly`: twice the iterations, to the values that the options ask for.
Rung re_solved(const ReSolving& solving, std::string name, const Firmness& firmness,
               bool exactly = false) {
  const auto make = [solving, firmness, exactly](const Checked& best) {
    Made made{best};
    const bool tips_alone = std::ranges::none_of(best.findings, is_collision, &Finding::cause);
    if (tips_alone && firmness.band_share == 1) {
      made.ended = "not tried: no collision to keep clear of";
      return made;
    }
    map::MapOptions options = solving.options;
    if (exactly) options.movement.iterations *= 2;
    if (!exactly) options.movement.relative_value *= kSoonSeen;
    made.checked.path =
        map::resolve_path(as_firm(solving.whole, firmness), best.path, best.findings, options);
    made.checked.findings = solving.check(made.checked.path);
    return made;
  };
  return {std::move(name), make};
}

/// Several rungs as one.
Rung one_of(std::string name, std::vector<Rung> rungs) {
  return {std::move(name),
          [rungs = std::move(rungs)](const Checked& best) { return repair::climb(rungs, best); }};
}

}  // namespace

Rung gently(const ReSolving& solving) {
  return one_of("re-solve gently", {re_solved(solving, "clearance 10 times as heavy", {10}),
                                    re_solved(solving, "100 times", {100})});
}

Rung firmly(const ReSolving& solving) {
  return one_of("re-solve firmly", {re_solved(solving, "clearance 1000 times as heavy", {1000}),
                                    re_solved(solving, "10000 times, just free", {10000, 0.2}),
                                    re_solved(solving, "tips and freedom alone", kFirmest, true)});
}

}  // namespace morphe::planning
