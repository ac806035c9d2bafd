#include <algorithm>
#include <cmath>
#include <string>

#include "stages/verify/requirements.hpp"

namespace morphe::verify {
namespace {

template <class T>
bool contains(const std::vector<T>& values, const T& value) {
  return std::ranges::find(values, value) != values.end();
}

bool is_configured(const PlanRequest& request, const std::string& name) {
  return std::ranges::any_of(
      request.bodies, [&](const PlanRequest::Body& body) { return body.object.name == name; });
}

/// Returns true if an object may have its origins. The recording itself is not in the file, so that
/// an object that is not the config's may call itself recorded.
bool is_possible(const SceneObject& object, const Plan& plan, const PlanRequest& request) {
  if (object.pose_origin == ObjectOrigin::unknown || object.shape_origin == ObjectOrigin::unknown)
    return false;
  if (is_configured(request, object.name))
    return object.pose_origin == ObjectOrigin::configured &&
           object.shape_origin == ObjectOrigin::configured;
  return object.pose_origin != ObjectOrigin::inferred || object.name == "table" ||
         object.name == plan.movement.target;
}

bool lacks_kinds(const Plan& plan) {
  return plan.certificate.clearance_by_kind.empty() && !std::isnan(plan.certificate.clearance);
}

}  // namespace

bool lacks_origins_and_kinds(const Plan& plan) {
  const bool any_origin = std::ranges::any_of(plan.scene.objects, [](const SceneObject& object) {
    return object.pose_origin != ObjectOrigin::unknown ||
           object.shape_origin != ObjectOrigin::unknown;
  });
  return lacks_kinds(plan) && !any_origin;
}

void verify_origins(const Plan& plan, const PlanRequest& request, ViolationLog& violations) {
  if (lacks_origins_and_kinds(plan)) return;
  if (lacks_kinds(plan)) violations.note_plan("config", "clearance_by_kind", 0, 1);
  for (const SceneObject& object : plan.scene.objects) {
    if (!is_possible(object, plan, request))
      violations.note_plan("config", object.name + "/origin", kUnknown, kUnknown);
    const bool table = object.name == "table", target = object.name == plan.movement.target;
    const bool inferred = object.pose_origin == ObjectOrigin::inferred ||
                          (!table && object.shape_origin == ObjectOrigin::inferred);
    const bool forbidden = (table && contains(request.must_be_known, Knowable::table)) ||
                           (target && contains(request.must_be_known, Knowable::target));
    if (inferred && forbidden)
      violations.note_plan("config", "must_be_known/" + object.name, kUnknown, kUnknown);
  }
  for (const Assumption& each : plan.recording_assumptions) {
    const bool forbidden = std::ranges::any_of(
        request.must_be_known, [&](Knowable known) { return each.subject == name_of(known); });
    if (forbidden)
      violations.note_plan("config", "must_be_known/" + each.subject, kUnknown, kUnknown);
  }
}

void verify_assumptions(const std::vector<Assumption>& stored,
                        const std::vector<Assumption>& request, ViolationLog& violations) {
  for (const Assumption& each : request) {
    if (!contains(stored, each))
      violations.note_plan("assumption", each.subject + " is missing", kUnknown, kUnknown);
  }
  for (const Assumption& each : stored) {
    if (!contains(request, each))
      violations.note_plan("assumption", each.subject, kUnknown, kUnknown);
  }
}

}  // namespace morphe::verify
