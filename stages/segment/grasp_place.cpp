#include "stages/segment/grasp_place.hpp"

#include <algorithm>

#include "stages/segment/constants.hpp"

namespace morphe::segment {
namespace {

GraspPlace weigh_place(const HandRecord& hand, const std::vector<MovementUnit>& units, int next,
                       bool comes_home) {
  MovementUnit reach = units.front();
  for (int k = 1; k < next; ++k) merge_unit(hand.signals, hand.options, units[k], reach);
  GraspPlace place{next, find_come_back(hand.signals, hand.options, reach, units, next), {}};
  place.evidence = weigh_grasp(hand, reach, units, next, comes_home, place.come_back);
  return place;
}

}  // namespace

GraspPlace find_place(const HandRecord& hand, const std::vector<MovementUnit>& units, int departure,
                      bool comes_home) {
  GraspPlace best = weigh_place(hand, units, 1, comes_home);
  double strongest = 0, head = 0;
  const int places = std::max<int>(1, static_cast<int>(units.size()) - (comes_home ? 1 : 0));
  for (int next = 1; next <= places; ++next) {
    GraspPlace place = weigh_place(hand, units, next, comes_home);
    head = place.evidence.head = std::min(head, place.evidence.head);
    const double odds = place.evidence.log_odds() + kLaterPlace * std::abs(next - departure);
    if (odds <= strongest) continue;
    strongest = odds;
    best = place;
  }
  return best;
}

}  // namespace morphe::segment
