#include "core/store/input_bounds.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "core/store/consistency.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

using testing::HasSubstr;

TEST(Workable, WhatWouldTakeForeverIsNamedWithItsPlace) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::pair<const char*, std::function<void(Demonstration&)>> faults[] = {
      {"markers/time: row 2: must be greater",
       [](Demonstration& d) { d.streams.markers->time[1] = d.streams.markers->time[0]; }},
      {"markers/time: row 1: -inf is not a possible time",
       [=](Demonstration& d) { d.streams.markers->time[0] = -inf; }},
      {"sensors/time: row 2: nan is not a possible time",
       [](Demonstration& d) { d.streams.sensors->time[1] = kUnknown; }},
      {"rows per second; at most",
       [](Demonstration& d) {
         for (std::size_t i = 0; i < d.streams.markers->time.size(); ++i)
           d.streams.markers->time[i] = 1e-300 * static_cast<double>(i);
       }},
      {"the streams span", [](Demonstration& d) { d.streams.hand->time.back() = 1e9; }},
      {"markers/position: row 1: a point is not a possible position",
       [=](Demonstration& d) { d.streams.markers->position.values[0].x() = inf; }},
      {"sensors/orientation: row 1: a rotation is not a unit quaternion",
       [](Demonstration& d) { d.streams.sensors->orientation.values[0].coeffs().setZero(); }},
      {"/time: row 2: must be greater",
       [](Demonstration& d) {
         for (SceneObject& o : d.objects)
           if (o.time.size() > 1) std::swap(o.time[0], o.time[1]);
       }},
      {"/position: row 1: is not a possible position",
       [](Demonstration& d) { d.objects[0].position[0].setConstant(kUnknown); }},
      {"/position: row 1: is not a possible position",
       [](Demonstration& d) { d.objects[0].position[0].y() = kUnknown; }},
      {"/position: row 1: is not a possible position",
       [](Demonstration& d) { d.objects[0].position[0].z() = kUnknown; }},
      {"/orientation: row 1: is not a rotation",
       [](Demonstration& d) { d.objects[0].orientation[0].coeffs().setZero(); }},
      {"is not a possible size",
       [](Demonstration& d) {
         for (SceneObject& o : d.objects)
           if (!o.size.empty()) o.size[0] = -o.size[0];
       }},
      {"@forearm: -1 m is not a possible length of a body segment",
       [](Demonstration& d) { d.forearm = -1; }},
  };
  Demonstration good = full_demonstration("one");
  ASSERT_EQ(inconsistency(good), "");
  for (const auto& [expected, spoil] : faults) {
    Demonstration bad = good;
    spoil(bad);
    EXPECT_THAT(inconsistency(bad), HasSubstr(expected));
  }
}

TEST(Workable, NamesWithControlCharactersAndNamesTwice) {
  Demonstration one = full_demonstration("one");
  one.objects[0].name = "cup\x1b[31m";
  EXPECT_THAT(inconsistency(one), HasSubstr("objects/cup\\u001b[31m: is not a valid name"));
  one = full_demonstration("one");
  one.objects.push_back(one.objects[0]);
  EXPECT_THAT(inconsistency(one), HasSubstr("the name appears twice"));
  one = full_demonstration("one");
  one.subject = "a\nb";
  EXPECT_EQ(inconsistency(one), "@subject: contains control characters: 'a\\u000ab'");
}

}  // namespace
}  // namespace morphe::store
