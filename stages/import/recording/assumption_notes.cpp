#include "stages/import/recording/assumption_notes.hpp"

namespace morphe::imports {
namespace {

/// A part of notes, and what they assume. The first one that a note has decides.
struct Telltale {
  std::string_view part;
  AssumptionKind kind;
  std::string_view subject;
};

constexpr AssumptionKind kInferred = AssumptionKind::inferred;
constexpr AssumptionKind kAssumed = AssumptionKind::assumed;

constexpr Telltale kTelltales[] = {
    {kAxesAssumed, kAssumed, name_of(Knowable::axes)},
    {kFacesScreen, kAssumed, name_of(Knowable::axes)},
    {kUnitAssumed, kAssumed, name_of(Knowable::unit)},
    {kTimeUnitAssumed, kAssumed, name_of(Knowable::rate)},
    {kRightHandAssumed, kAssumed, name_of(Knowable::side)},
    {kHandReaches, kInferred, name_of(Knowable::side)},
    {kHandCurls, kInferred, name_of(Knowable::side)},
    {kStaticTrialChosen, kInferred, name_of(Knowable::static_trial)},
    {kNoStaticTrialEstimate, kInferred, "joint_centres"},
    {kSensorsAtJoints, kAssumed, "sensor_placement"},
    {kGloveZero, kAssumed, "glove_calibration"},
    {kNamesMapped, kInferred, "names"},
    {kFacesY, kInferred, "heading"},
};

}  // namespace

std::vector<Assumption> assumptions_in(const std::vector<std::string>& notes) {
  std::vector<Assumption> found;
  for (const std::string& note : notes) {
    for (const auto& [part, kind, subject] : kTelltales) {
      if (note.find(part) == std::string::npos) continue;
      found.push_back({kind, std::string(subject), note});
      break;
    }
  }
  return found;
}

}  // namespace morphe::imports
