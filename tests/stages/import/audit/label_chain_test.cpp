// Whole clusters of an arm that carry each other's names.
#include <gmock/gmock.h>

#include "stages/import/audit/checks.hpp"
#include "tests/stages/import/audit/table_trials.hpp"

namespace morphe::imports {
namespace {

/// Exchanges the markers of two clusters of four; those of the first get the places `order` of the
/// second.
void exchange_wholes(const std::string& a, const std::string& b, const std::vector<int>& order,
                     MarkerStream& markers) {
  const auto column_named = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(markers.names, name) - markers.names.begin());
  };
  const Array2D<Vec3> before = markers.position;
  for (int k = 0; k < 4; ++k) {
    const std::size_t to_a = column_named(a + std::to_string(k + 1)),
                      to_b = column_named(b + std::to_string(order[k] + 1));
    for (std::size_t i = 0; i < before.rows; ++i) {
      markers.position(i, to_a) = before(i, to_b);
      markers.position(i, to_b) = before(i, to_a);
    }
  }
}

/// Returns true if all points that are seen are where they were.
bool same_as(const Array2D<Vec3>& a, const Array2D<Vec3>& b) {
  return std::ranges::equal(a.values, b.values, [](const Vec3& p, const Vec3& q) {
    return is_known(p) == is_known(q) && (!is_known(p) || p == q);
  });
}

TEST(LabelChain, ClustersThatCarryEachOthersNamesGetTheirOwn) {
  const std::vector<std::vector<int>> orders = {{0, 1, 2, 3}, {2, 0, 3, 1}};
  for (const Demonstration& truth : table_trials()) {
    for (const auto& [a, b] : {std::pair{"RHAN", "RLAR"}, {"RUAR", "RLAR"}, {"RHAN", "LHAN"}}) {
      for (const std::vector<int>& order : orders) {
        Demonstration recording = truth;
        exchange_wholes(a, b, order, *recording.streams.markers);
        for (const Doubt& doubt : check_labels(recording, {})) doubt.mend(recording);
        EXPECT_TRUE(same_as(recording.streams.markers->position, truth.streams.markers->position))
            << truth.name << " " << a << " " << b << " " << order[0];
      }
    }
  }
}

TEST(LabelChain, WithoutAStaticTrialTheirPlacesTellThem) {
  for (Demonstration truth : table_trials()) {
    truth.calibration = {};
    Demonstration recording = truth;
    exchange_wholes("RHAN", "RLAR", {0, 1, 2, 3}, *recording.streams.markers);
    for (const Doubt& doubt : check_labels(recording, {})) doubt.mend(recording);
    EXPECT_TRUE(same_as(recording.streams.markers->position, truth.streams.markers->position))
        << truth.name;
  }
}

}  // namespace
}  // namespace morphe::imports
