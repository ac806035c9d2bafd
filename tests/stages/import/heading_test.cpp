#include "stages/import/guess/heading.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "stages/import/guess/rotate_demonstration.hpp"
#include "stages/import/import.hpp"
#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::imports {
namespace {

using testing::Contains;
using testing::HasSubstr;

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most = a.size() == b.size() ? 0 : kInfinity;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (is_known(a[i]) || is_known(b[i])) most = std::max(most, (a[i] - b[i]).norm());
  }
  return most;
}

double farthest(const std::vector<Quat>& a, const std::vector<Quat>& b) {
  double most = a.size() == b.size() ? 0 : kInfinity;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (is_known(a[i]) || is_known(b[i])) most = std::max(most, angle_between(a[i], b[i]));
  }
  return most;
}

double farthest(const std::optional<BodyStream>& a, const std::optional<BodyStream>& b) {
  if (!a || !b) return a || b ? kInfinity : 0;
  return std::max(farthest(a->position.values, b->position.values),
                  farthest(a->orientation.values, b->orientation.values));
}

/// Of everything that has a place.
double farthest(const Demonstration& a, const Demonstration& b) {
  double most = std::max(farthest(a.streams.sensors, b.streams.sensors),
                         farthest(a.streams.skeleton, b.streams.skeleton));
  for (const auto& [one, other] :
       {std::pair(&a.streams, &b.streams), {&a.calibration, &b.calibration}}) {
    if (one->markers) {
      most =
          std::max(most, farthest(one->markers->position.values, other->markers->position.values));
    }
  }
  if (a.streams.hand) {
    most =
        std::max(most, farthest(a.streams.hand->position.values, b.streams.hand->position.values));
  }
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    most = std::max({most, farthest(a.objects[k].position, b.objects[k].position),
                     farthest(a.objects[k].orientation, b.objects[k].orientation)});
  }
  return most;
}

// Where a laboratory lays its axes changes nothing: quarter turns, and some that are none.
TEST(Facing, AllShippedRecordingsTurnedByAnyAngleAreTheSame) {
  constexpr std::array kDegrees = {90.0, 180.0, 270.0, 13.7, 61.2, 118.9, -33.3, -77.1, -101.5};
  std::size_t count = 0;
  for (const char* folder : {"ue-adl", "adroit-dapg", "pyomeca", "kineticstoolkit",
                             "cmu-iclone-bvh", "cmu-native", "pybvh", "dex-retargeting"}) {
    for (const Demonstration& recorded : shipped_recordings(folder)) {
      Demonstration expected = recorded;
      align_heading({}, expected);
      for (const double degrees : kDegrees) {
        Demonstration turned = recorded;
        rotate_about_vertical(turned, degrees * kRadPerDegree);
        align_heading({}, turned);
        EXPECT_LT(farthest(expected, turned), 1e-9) << recorded.name << " by " << degrees;
      }
      ++count;
    }
  }
  EXPECT_GE(count, 15U);
}

/// Points that stand still, three seconds of them.
Demonstration standing(const std::vector<std::pair<std::string, Vec3>>& points) {
  Demonstration d;
  MarkerStream& markers = d.streams.markers.emplace();
  markers.position = Array2D<Vec3>(300, points.size(), unknown_point());
  for (const auto& [name, point] : points) markers.names.push_back(name);
  for (std::size_t i = 0; i < 300; ++i) {
    markers.time.push_back(0.01 * static_cast<double>(i));
    for (std::size_t k = 0; k < points.size(); ++k) markers.position(i, k) = points[k].second;
  }
  return d;
}

double turn_of(const Demonstration& d) {
  const auto facing = estimate_heading(recorded_points(d.streams, d.hand), d.hand);
  return facing ? facing->yaw_rad / kRadPerDegree : kUnknown;
}

TEST(Facing, IsWhereShouldersAndChestSay) {
  const Demonstration forward =
      standing({{"RSHO1", {0.2, 0, 1.4}}, {"LSHO1", {-0.2, 0, 1.4}}, {"STRN", {0, 0.08, 1.36}}});
  EXPECT_NEAR(turn_of(forward), 0, 1e-9);
  EXPECT_NEAR(turn_of(standing({{"RSHO1", {0, 0.2, 1.4}}, {"LSHO1", {0, -0.2, 1.4}}})), -90, 1e-9);
  EXPECT_NEAR(std::abs(turn_of(standing({{"RSHO1", {-0.2, 0, 1.4}}, {"LSHO1", {0.2, 0, 1.4}}}))),
              180, 1e-9);
  EXPECT_NEAR(turn_of(standing({{"C7", {0, 0, 1.4}}, {"CLAV", {-0.1, 0, 1.38}}})), -90, 1e-9);
  EXPECT_NEAR(turn_of(standing({{"RASI", {0.1, 0.1, 1}}, {"LASI", {-0.1, -0.1, 1}}})), -45, 1e-9);
  EXPECT_TRUE(std::isnan(turn_of(standing({{"A", {0, 0, 1}}, {"B", {0, 1, 1}}}))));
}

/// pyomeca's person: the line of the iliac spines and that from T10 to the breastbone, measured in
/// the file, say 18 degrees; only the right shoulder was recorded.
TEST(Facing, OneShoulderAloneLiesBesideTheChest) {
  for (const Demonstration& box : shipped_recordings("pyomeca")) {
    if (!box.streams.markers) continue;
    EXPECT_NEAR(turn_of(box), -17.5, 4) << box.name;
  }
}

TEST(Facing, NamesOfSidesThatAreSwappedAreNoticed) {
  Demonstration d = standing({{"RSHO1", {-0.2, 0, 1.4}},
                              {"LSHO1", {0.2, 0, 1.4}},
                              {"C7", {0, -0.1, 1.4}},
                              {"STRN", {0, 0.08, 1.36}},
                              {"CLAV", {0, 0.07, 1.38}}});
  const std::vector<Vec3> before = d.streams.markers->position.values;
  align_heading({}, d);
  EXPECT_EQ(d.streams.markers->position.values, before);
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("contradict each other")));
}

TEST(Facing, GivenAxesYieldToTheTrunkAlone) {
  const auto arm = [] {
    return standing({{"right_shoulder", {0, 0, 1.4}},
                     {"right_elbow", {0, -0.1, 1.1}},
                     {"right_wrist", {0.25, -0.1, 1.1}}});
  };
  Demonstration kept = arm(), turned = arm();
  align_heading({"x y z", "", {}}, kept);
  EXPECT_EQ(farthest(kept, arm()), 0);
  align_heading({}, turned);
  EXPECT_GT(farthest(turned, arm()), 0.1);
  EXPECT_THAT(turned.import_notes, Contains(HasSubstr("a guess from the arm only")));
  Demonstration person = standing({{"RSHO1", {-0.2, 0, 1.4}}, {"LSHO1", {0.2, 0, 1.4}}});
  align_heading({"x y z", "", {}}, person);
  EXPECT_THAT(person.import_notes, Contains(HasSubstr("180 degrees away")));
  Demonstration as_it_is = standing({{"RSHO1", {-0.2, 0, 1.4}}, {"LSHO1", {0.2, 0, 1.4}}});
  Conventions by_axes;
  by_axes.forward = ForwardSource::recorded;
  align_heading(by_axes, as_it_is);
  EXPECT_LT(as_it_is.streams.markers->position(0, 0).x(), 0);
}

TEST(Facing, WhoTurnsRoundFacesWhereTheRecordingBegins) {
  Demonstration d = standing({{"RSHO1", {0.2, 0, 1.4}}, {"LSHO1", {-0.2, 0, 1.4}}});
  MarkerStream& markers = *d.streams.markers;
  for (std::size_t i = 120; i < 300; ++i) {
    for (std::size_t k = 0; k < 2; ++k) markers.position(i, k).x() *= -1;
  }
  EXPECT_NEAR(turn_of(d), 0, 1e-9);
  align_heading({}, d);
  EXPECT_THAT(d.import_notes, Contains(HasSubstr("turns later")));
}

/// One person in one sitting, whose shoulders turn by up to 9 degrees in two of the three reaches.
TEST(Facing, ReachesDoNotTurnThePersonWhoSits) {
  std::vector<double> turns;
  for (const Demonstration& trial : shipped_recordings("ue-adl")) {
    if (trial.name.starts_with("ADL001")) turns.push_back(turn_of(trial));
  }
  ASSERT_EQ(turns.size(), 3U);
  const auto [least, most] = std::ranges::minmax(turns);
  EXPECT_LT(most - least, 2);
}

/// What an arm or a hand tells, where the trunk is known to face Y.
TEST(Facing, AnArmAloneAndAHandAlone) {
  for (Demonstration& trial : shipped_recordings("ue-adl")) {
    const double by_trunk = turn_of(trial);
    MarkerStream& markers = *trial.streams.markers;
    for (std::size_t k = 0; k < markers.names.size(); ++k) {
      const std::string part = markers.names[k].substr(0, 4);
      if (part == "RSHO" || part == "RUAR" || part == "RLAR" || part == "RHAN") continue;
      for (std::size_t i = 0; i < markers.time.size(); ++i) {
        markers.position(i, k) = unknown_point();
      }
    }
    EXPECT_NEAR(turn_of(trial), by_trunk, 15) << trial.name;
  }
  // Every recording begins in front of the same door.
  for (const Demonstration& door : shipped_recordings("adroit-dapg")) {
    EXPECT_NEAR(turn_of(door), 0, 8) << door.name;
  }
}

TEST(Facing, AnObjectOfMarkersLiesTheSameHoweverTheRoomWasTurned) {
  const auto box = [](const std::string& axes) {
    ImportRequest request;
    const std::filesystem::path source = MORPHE_SOURCE_DIR;
    std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "turned_box.yaml";
    std::ofstream(file) << "axes: " << axes << "\nrecordings:\n  - {file: "
                        << (source / "datasets/pyomeca/markers.csv").string()
                        << ", names: " << (source / "configs/names/pyomeca_subjects.yaml").string()
                        << ", format: vicon-csv, objects: [{name: box, markers: ['boite:*']}]}\n";
    request.paths = {file};
    Demonstration read;
    import_recordings(request, [&](Demonstration&& d) { read = std::move(d); });
    return read.objects.at(0);
  };
  const SceneObject as_is = box("y -x z"), turned = box("-x -y z");
  EXPECT_LT(farthest(as_is.position, turned.position), 1e-9);
  EXPECT_LT(farthest(as_is.orientation, turned.orientation), 1e-7);
}

TEST(TurnDemonstration, TakesAllThatHasAPlaceWithIt) {
  Demonstration d = standing({{"A", {1, 0, 0.5}}});
  d.calibration = d.streams;
  SceneObject& cup = d.objects.emplace_back();
  cup.position = {{0, 1, 0}};
  cup.orientation = {Quat::Identity()};
  HandStream& tips = d.streams.hand.emplace();
  tips.position = Array2D<Vec3>(1, 5, Vec3(1, 1, 1));
  rotate_about_vertical(d, 90 * kRadPerDegree);
  EXPECT_LT((d.streams.markers->position(0, 0) - Vec3(0, 1, 0.5)).norm(), 1e-15);
  EXPECT_LT((d.calibration.markers->position(299, 0) - Vec3(0, 1, 0.5)).norm(), 1e-15);
  EXPECT_LT((cup.position[0] - Vec3(-1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((cup.orientation[0] * Vec3::UnitX() - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_LT((tips.position(0, 4) - Vec3(-1, 1, 1)).norm(), 1e-15);
  tips.kind = HandKind::keypoints;
  rotate_about_vertical(d, 90 * kRadPerDegree);
  EXPECT_LT((tips.position(0, 4) - Vec3(-1, 1, 1)).norm(), 1e-15);
}

}  // namespace
}  // namespace morphe::imports
