#include "pipeline/run/diff.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/store/hdf5_file.hpp"
#include "core/store/plan_file.hpp"
#include "pipeline/run/config_changes.hpp"
#include "pipeline/run/element_location.hpp"

namespace morphe::run {
namespace {

bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) ||
         std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::string text_of(const store::Hdf5Value& value) {
  constexpr std::size_t kMaxTextLength = 60;
  const std::string text = value.is_text ? fmt::format("{}", fmt::join(value.texts, ","))
                                         : fmt::format("{}", fmt::join(value.numbers, ","));
  return text.size() > kMaxTextLength || text.find('\n') != std::string::npos ? "different text"
                                                                              : "'" + text + "'";
}

/// Compares the numbers of two datasets of equal shape. Sets the largest difference and a sentence
/// on values that are NaN in only one of them. Returns the index of the largest difference, or 0.
std::size_t compare_numbers(const store::Hdf5Value& a, const store::Hdf5Value& b,
                            Difference& found) {
  std::size_t one_sided = 0, index = 0;
  for (std::size_t i = 0; i < a.numbers.size(); ++i) {
    const double x = a.numbers[i], y = b.numbers[i];
    if (same_bits(x, y)) continue;
    if (std::isnan(x) != std::isnan(y)) {
      ++one_sided;
    } else if (const double gap = std::abs(x - y); !found.max_abs || gap > *found.max_abs) {
      found.max_abs = gap;
      found.first = x;
      found.second = y;
      index = i;
    }
  }
  if (one_sided > 0)
    found.change = fmt::format("{} values are NaN in only one of the files", one_sided);
  return index;
}

class Comparison {
 public:
  explicit Comparison(ColumnNames names) : names_(std::move(names)) {}
  DiffReport report;

  void compare_files(const store::Hdf5Group& a, const store::Hdf5Group& b) {
    compare_attributes(a, b, ".", "");
    visit_union(a, b, [&](const std::string& name, bool in_a, bool in_b) {
      if (name != "plans") return compare_member(a, b, name, in_a, in_b, name);
      compare_all_plans(a.open(name), b.open(name));
    });
  }

 private:
  void compare_all_plans(const store::Hdf5Group& a, const store::Hdf5Group& b) {
    visit_union(a, b, [&](const std::string& demonstration, bool in_a, bool in_b) {
      if (in_a && in_b) {
        const store::Hdf5Group of_a = a.open(demonstration), of_b = b.open(demonstration);
        visit_union(of_a, of_b, [&](const std::string& movement, bool plan_in_a, bool plan_in_b) {
          begin_plan(demonstration, movement);
          compare_member(of_a, of_b, movement, plan_in_a, plan_in_b, "");
        });
      } else {
        const store::Hdf5Group only = (in_a ? a : b).open(demonstration);
        only.each_child([&](const std::string& movement) {
          begin_plan(demonstration, movement);
          add("", in_a ? "only in the first" : "only in the second");
        });
      }
    });
    plan_.clear();
  }

  void begin_plan(const std::string& demonstration, const std::string& movement) {
    plan_ = demonstration + "/" + movement;
    ++report.plans;
  }

  /// Visits the names of the first group in their order, then those that only the second has.
  template <class Visit>
  static void visit_union(const store::Hdf5Group& a, const store::Hdf5Group& b,
                          const Visit& visit) {
    a.each_child([&](const std::string& name) { visit(name, true, b.has(name)); });
    b.each_child([&](const std::string& name) {
      if (!a.has(name)) visit(name, false, true);
    });
  }

  void compare_member(const store::Hdf5Group& a, const store::Hdf5Group& b, const std::string& name,
                      bool in_a, bool in_b, const std::string& path) {
    if (!in_a || !in_b) return add(path, in_a ? "only in the first" : "only in the second");
    const bool group = a.is_group(name);
    if (group != b.is_group(name)) return add(path, "a group in only one of the files");
    if (!group) {
      const store::Hdf5Value first = a.value(name);
      compare_values(first, b.value(name), path, [&](std::size_t index, Difference& found) {
        if (has_unit(a, name)) found.unit = a.value_of_attribute("unit", name.c_str()).texts.at(0);
        if (!plan_.empty())
          found.location = element_location(a, name, path, first.dims, index, names_);
      });
      compare_attributes(a, b, name.c_str(), path + "/");
      return;
    }
    const store::Hdf5Group of_a = a.open(name), of_b = b.open(name);
    const std::string below = path.empty() ? "" : path + "/";
    compare_attributes(of_a, of_b, ".", below);
    visit_union(of_a, of_b, [&](const std::string& member, bool member_in_a, bool member_in_b) {
      compare_member(of_a, of_b, member, member_in_a, member_in_b, below + member);
    });
  }

  void compare_attributes(const store::Hdf5Group& a, const store::Hdf5Group& b, const char* object,
                          const std::string& below) {
    const std::vector<std::string> of_a = a.attributes(object), of_b = b.attributes(object);
    std::vector<std::string> names;
    std::set_union(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(names));
    for (const std::string& name : names) {
      const std::string path = below + "@" + name;
      if (!std::binary_search(of_a.begin(), of_a.end(), name)) {
        add(path, "only in the second");
      } else if (!std::binary_search(of_b.begin(), of_b.end(), name)) {
        add(path, "only in the first");
      } else {
        compare_values(
            a.value_of_attribute(name, object), b.value_of_attribute(name, object), path,
            [&](std::size_t, Difference& found) { found.unit = unit_of_attribute(name); });
      }
    }
  }

  static bool has_unit(const store::Hdf5Group& group, const std::string& dataset) {
    const std::vector<std::string> names = group.attributes(dataset.c_str());
    return std::binary_search(names.begin(), names.end(), "unit") &&
           group.value_of_attribute("unit", dataset.c_str()).is_text;
  }

  /// Compares two values. `add_location(index, found)` adds unit and location of the difference.
  template <class AddLocation>
  void compare_values(const store::Hdf5Value& a, const store::Hdf5Value& b, const std::string& path,
                      const AddLocation& add_location) {
    if (a.is_text != b.is_text) return add(path, "texts in only one of the files");
    if (a.dims != b.dims)
      return add(path,
                 fmt::format("shape [{}] -> [{}]", fmt::join(a.dims, ","), fmt::join(b.dims, ",")));
    if (a.is_text) {
      if (a.texts == b.texts) return;
      if (plan_.empty() && path == "@config")
        return add(path,
                   fmt::format("{}", fmt::join(config_changes(a.texts[0], b.texts[0]), ", ")));
      return add(path, fmt::format("{} -> {}", text_of(a), text_of(b)));
    }
    Difference found;
    found.plan = plan_;
    found.dataset = path;
    const std::size_t index = compare_numbers(a, b, found);
    if (found.max_abs) add_location(index, found);
    if (found.max_abs || !found.change.empty()) report.differences.push_back(std::move(found));
  }

  void add(const std::string& dataset, const std::string& change) {
    report.differences.push_back({plan_, dataset, {}, "", "", 0, 0, change});
  }

  ColumnNames names_;
  std::string plan_;
};

}  // namespace

DiffReport diff_files(const std::filesystem::path& a, const std::filesystem::path& b) {
  const store::PlanReader check_a(a), check_b(b);  // throw unless the files are plans.h5
  const store::Hdf5File first = store::Hdf5File::open(a), second = store::Hdf5File::open(b);
  Comparison comparison(column_names(first.root()));
  comparison.compare_files(first.root(), second.root());
  return std::move(comparison.report);
}

}  // namespace morphe::run
