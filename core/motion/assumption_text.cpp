#include "core/motion/assumption_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "core/motion/bounding_box.hpp"
#include "core/motion/count_with_noun.hpp"

namespace morphe {
namespace {

std::string shape_phrase(const SceneObject& object) {
  const Vec3 size_mm = 1e3 * bounding_box(object, Pose::Identity()).sizes();
  return fmt::format("{} of {:.0f} x {:.0f} x {:.0f} mm", name_of(object.shape), size_mm.x(),
                     size_mm.y(), size_mm.z());
}

std::string object_value(const SceneObject& object) {
  if (object.name == kTableName) return "height from the lowest fingertips";
  if (object.pose_origin != ObjectOrigin::inferred)
    return fmt::format("{}: its shape was not recorded; taken as a {}", object.name,
                       shape_phrase(object));
  const std::string place = object.name + ": place from thumb and index at the grasp";
  if (object.shape_origin != ObjectOrigin::inferred) return place;
  return fmt::format("{}, {} from their distance and height", place, shape_phrase(object));
}

/// Returns the heading of a kind, as it is printed.
std::string heading(AssumptionKind kind) {
  std::string text(name_of(kind));
  std::ranges::replace(text, '_', ' ');
  return text;
}

std::string line(const std::string& head, const std::string& text) {
  return fmt::format("  {:<13} {}\n", head, text);
}

std::vector<Assumption> of_kind(const std::vector<Assumption>& assumptions, AssumptionKind kind) {
  std::vector<Assumption> found;
  std::ranges::copy_if(assumptions, std::back_inserter(found),
                       [&](const Assumption& each) { return each.kind == kind; });
  return found;
}

/// Appends an item to a list, unless the list has it.
void add_item(const std::string& item, std::vector<std::string>& list) {
  if (std::ranges::find(list, item) == list.end()) list.push_back(item);
}

}  // namespace

std::vector<Assumption> object_assumptions(const Plan& plan) {
  std::vector<Assumption> found;
  for (const SceneObject& object : plan.scene.objects) {
    const bool table = object.name == kTableName, target = object.name == plan.movement.target;
    const std::string subject(table    ? name_of(Knowable::table)
                              : target ? name_of(Knowable::target)
                                       : "object");
    const bool inferred_shape = object.shape_origin == ObjectOrigin::inferred && !table;
    if (object.pose_origin == ObjectOrigin::inferred || inferred_shape) {
      found.push_back({AssumptionKind::inferred, subject, object_value(object)});
    } else if (object.pose_origin == ObjectOrigin::unknown && (table || target)) {
      found.push_back({AssumptionKind::assumed, subject,
                       object.name + ": the file does not say whether it was recorded, configured "
                                     "or inferred"});
    }
  }
  return found;
}

std::vector<Assumption> plan_assumptions(const Plan& plan) {
  std::vector<Assumption> all = plan.recording_assumptions;
  std::ranges::move(object_assumptions(plan), std::back_inserter(all));
  return all;
}

std::vector<Assumption> all_assumptions(const PlanFileHeader& header, const Plan& plan) {
  std::vector<Assumption> all = plan_assumptions(plan);
  all.insert(all.end(), header.assumptions.begin(), header.assumptions.end());
  std::ranges::stable_sort(all, {}, &Assumption::kind);
  return all;
}

std::string phrase(const Assumption& assumption) {
  if (assumption.kind == AssumptionKind::set_by_hand)
    return fmt::format("{}={}", assumption.subject, assumption.value);
  return fmt::format("{}: {}", assumption.subject, assumption.value);
}

void AssumptionTally::add(const std::vector<Assumption>& assumptions) {
  std::set<std::ptrdiff_t> seen;
  for (const Assumption& each : assumptions) {
    auto same = std::ranges::find_if(counted, [&](const auto& entry) {
      return entry.first.kind == each.kind && entry.first.subject == each.subject;
    });
    if (same == counted.end()) same = counted.insert(same, {each, 0});
    if (seen.insert(same - counted.begin()).second) ++same->second;
  }
}

std::string subject_lines(const std::vector<Assumption>& of_file, const AssumptionTally& of_plans,
                          int plan_count) {
  std::string text;
  for (std::size_t k = 0; k < enum_count<AssumptionKind>(); ++k) {
    const auto kind = static_cast<AssumptionKind>(k);
    std::vector<std::string> list;
    for (const auto& [each, count] : of_plans.counted) {
      if (each.kind != kind) continue;
      add_item(count == plan_count
                   ? each.subject
                   : fmt::format("{} ({} of {})", each.subject, count,
                                 count_with_noun(static_cast<std::size_t>(plan_count), "plan")),
               list);
    }
    for (const Assumption& each : of_kind(of_file, kind))
      add_item(kind == AssumptionKind::set_by_hand ? phrase(each) : each.subject, list);
    if (!list.empty()) text += line(heading(kind), fmt::format("{}", fmt::join(list, ", ")));
  }
  return text;
}

std::string assumption_lines(const std::vector<Assumption>& assumptions) {
  std::string text;
  for (std::size_t k = 0; k < enum_count<AssumptionKind>(); ++k) {
    const auto kind = static_cast<AssumptionKind>(k);
    std::string head = heading(kind);
    for (const Assumption& each : of_kind(assumptions, kind)) {
      text += line(head, phrase(each));
      head.clear();
    }
  }
  return text;
}

std::string clearance_phrase(const Certificate& certificate) {
  std::string text;
  for (const KindClearance& each : certificate.clearance_by_kind)
    text +=
        fmt::format("{}{} {:.2f} mm ({}, {} at {:.2f} s)", text.empty() ? "" : ", ",
                    name_of(each.kind), 1e3 * each.clearance, each.first, each.second, each.time_s);
  return text;
}

std::string certified_line(const Plan& plan) {
  if (!plan.has_trajectory()) return line("certified", "no trajectory, hence no certificate");
  return line(
      "certified",
      "limits, collisions and distances of the tips from their goals, along the stored curve "
      "and between its samples");
}

}  // namespace morphe
