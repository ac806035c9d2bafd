#pragma once

#include <algorithm>
#include <vector>

namespace morphe::verify {

/// Returns the index of the first item whose member has this value, -1 if there is no such item.
template <class Item, class Value, class Member>
int find_index(const std::vector<Item>& items, const Value& value, Member Item::*member) {
  const auto found = std::ranges::find(items, value, member);
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

}  // namespace morphe::verify
