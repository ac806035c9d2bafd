#include "stages/import/formats/c3d_quantities.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

constexpr std::string_view kQuantities[] = {"ANGLES",  "FORCES",    "MOMENTS",  "POWERS",
                                            "SCALARS", "REACTIONS", "ENERGIES", "TORQUES"};

std::string without_subject(const std::string& label) {
  return label.substr(label.rfind(':') + 1);  // npos + 1 is 0
}

}  // namespace

std::vector<std::string> listed_quantities(const C3dParameters& parameters,
                                           const std::vector<std::string>& labels) {
  std::map<std::string, std::string> listed;  // parameter by name
  for (const std::string_view quantity : kQuantities) {
    const std::string first = fmt::format("POINT:{}", quantity);
    std::string key = first;
    for (int more = 2; parameters.has(key); ++more) {
      for (const std::string& name : parameters.texts(key)) {
        if (!name.empty()) listed.emplace(without_subject(name), first);
      }
      key = fmt::format("{}{}", first, more);
    }
  }
  std::vector<std::string> quantities;
  for (const std::string& label : labels) {
    const auto entry = listed.find(without_subject(label));
    quantities.push_back(entry == listed.end() ? "" : entry->second);
  }
  return quantities;
}

void remove_quantities(const C3dParameters& parameters, const std::vector<std::string>& quantities,
                       C3dPoints& points) {
  std::vector<std::string> removed, kept;
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    (quantities[k].empty() ? kept : removed).push_back(points.labels[k]);
    if (quantities[k].empty()) columns.push_back(k);
  }
  if (removed.empty()) return;
  std::set<std::string> lists(quantities.begin(), quantities.end());
  lists.erase("");
  if (kept.empty())
    parameters.fail("POINT:LABELS",
                    fmt::format("no point is a place: all are in {}", fmt::join(lists, ", ")));
  Array2D<Vec3> position(points.position.rows, columns.size(), unknown_point());
  for (std::size_t i = 0; i < position.rows; ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      position(i, k) = points.position(i, columns[k]);
  }
  points.position = std::move(position);
  points.labels = std::move(kept);
  add_note(points.import_notes, "points skipped, no places according to {}: {}",
           fmt::join(lists, ", "), fmt::join(removed, ", "));
}

}  // namespace morphe::imports
