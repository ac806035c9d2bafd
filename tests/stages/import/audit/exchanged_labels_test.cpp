#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/math/random_stream.hpp"
#include "stages/import/audit/checks.hpp"
#include "tests/stages/import/shipped_recordings.hpp"

namespace morphe::imports {
namespace {

using testing::IsEmpty;

/// The markers of an arm and a hand in the ue-adl trials.
std::vector<std::string> arm_markers(char side) {
  std::vector<std::string> names;
  for (const char* part : {"UAR1", "UAR2", "UAR3", "UAR4", "LAR1", "LAR2", "LAR3", "LAR4", "HAN1",
                           "HAN2", "HAN3", "HAN4", "THUM", "FTP"})
    names.push_back(side + std::string(part));
  return names;
}

/// Keeps every `step`-th frame of the markers.
Demonstration thinned(Demonstration recording, std::size_t step) {
  MarkerStream& markers = *recording.streams.markers;
  const MarkerStream all = markers;
  markers.time.clear();
  markers.position = {(all.time.size() + step - 1) / step, all.names.size(), unknown_point()};
  for (std::size_t i = 0; i < all.time.size(); i += step) {
    for (std::size_t k = 0; k < all.names.size(); ++k)
      markers.position(markers.time.size(), k) = all.position(i, k);
    markers.time.push_back(all.time[i]);
  }
  return recording;
}

const std::vector<Demonstration>& trials() {
  static const std::vector<Demonstration> all = [] {
    std::vector<Demonstration> thin;
    for (const Demonstration& trial : shipped_recordings("ue-adl"))
      thin.push_back(thinned(trial, 3));
    return thin;
  }();
  return all;
}

const Demonstration& trial(const std::string& name) {
  return *std::ranges::find(trials(), name, &Demonstration::name);
}

std::size_t marker_column(const MarkerStream& markers, const std::string& name) {
  return std::ranges::find(markers.names, name) - markers.names.begin();
}

void exchange(MarkerStream& markers, const std::string& a, const std::string& b,
              std::size_t begin = 0, std::size_t end = static_cast<std::size_t>(-1)) {
  const std::size_t first = marker_column(markers, a), second = marker_column(markers, b);
  for (std::size_t i = begin; i < std::min(end, markers.time.size()); ++i)
    std::swap(markers.position(i, first), markers.position(i, second));
}

void hide(MarkerStream& markers, const std::string& name, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i)
    markers.position(i, marker_column(markers, name)) = unknown_point();
}

Demonstration mended(Demonstration recording) {
  for (const Doubt& doubt : check_labels(recording, {})) {
    if (doubt.mend) doubt.mend(recording);
  }
  return recording;
}

bool same_points(const Demonstration& a, const Demonstration& b) {
  return std::ranges::equal(a.streams.markers->position.values, b.streams.markers->position.values,
                            [](const Vec3& p, const Vec3& q) {
                              return is_known(p) == is_known(q) && (!is_known(p) || p == q);
                            });
}

/// Returns the exchanges of two markers of an arm, from a frame on, that are not undone.
std::vector<std::string> missed_exchanges(const Demonstration& truth, char side,
                                          std::size_t begin) {
  std::vector<std::string> missed;
  const std::vector<std::string> names = arm_markers(side);
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a + 1; b < names.size(); ++b) {
      Demonstration damaged = truth;
      exchange(*damaged.streams.markers, names[a], names[b], begin);
      if (!same_points(mended(std::move(damaged)), truth))
        missed.push_back(names[a] + " " + names[b]);
    }
  }
  return missed;
}

TEST(ExchangedLabels, NoneInTheShippedTrialsWithAnyStaticTrialOrWithout) {
  for (Demonstration recording : trials()) {
    EXPECT_THAT(check_labels(recording, {}), IsEmpty()) << recording.name;
    for (const char* other : {"ADL001DR2", "ADL004DR2", "ADL006DR2"}) {
      recording.calibration = trial(other).calibration;
      EXPECT_THAT(check_labels(recording, {}), IsEmpty()) << recording.name << " " << other;
    }
    recording.calibration = {};
    EXPECT_THAT(check_labels(recording, {}), IsEmpty()) << recording.name;
  }
}

TEST(ExchangedLabels, EveryPairOfTheWholeRecordingIsMended) {
  EXPECT_THAT(missed_exchanges(trial("ADL001FR1"), 'R', 0), IsEmpty());
}

TEST(ExchangedLabels, EveryPairFromATimeOnIsMended) {
  EXPECT_THAT(missed_exchanges(trial("ADL004DR2"), 'R', 60), IsEmpty());
  EXPECT_THAT(missed_exchanges(trial("ADL001AR1"), 'L', 100), IsEmpty());
}

TEST(ExchangedLabels, PairsOfPartsAreMendedWithoutAStaticTrial) {
  Demonstration truth = trial("ADL004DR2");
  truth.calibration = {};
  // Which of the four of a cluster is which is a matter of names then.
  for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{{"RUAR1", "RLAR1"},
                                                                             {"RLAR4", "RHAN1"},
                                                                             {"RUAR3", "RHAN4"},
                                                                             {"RTHUM", "RFTP"},
                                                                             {"RTHUM", "RHAN2"},
                                                                             {"RFTP", "RHAN3"},
                                                                             {"RTHUM", "RUAR2"},
                                                                             {"RFTP", "RLAR2"}}) {
    Demonstration damaged = truth;
    exchange(*damaged.streams.markers, a, b);
    EXPECT_TRUE(same_points(mended(std::move(damaged)), truth)) << a << " " << b;
  }
}

TEST(ExchangedLabels, MoreThanTwoAreMended) {
  const Demonstration& truth = trial("ADL001DR2");
  Demonstration cycle = truth;
  exchange(*cycle.streams.markers, "RLAR1", "RLAR4");
  exchange(*cycle.streams.markers, "RLAR4", "RHAN4");
  EXPECT_TRUE(same_points(mended(std::move(cycle)), truth));
  // Half a turn of a forearm's four markers fits to 2 mm; the elbow would be 100 mm away.
  Demonstration turned = truth;
  exchange(*turned.streams.markers, "RLAR1", "RLAR2");
  exchange(*turned.streams.markers, "RLAR3", "RLAR4");
  EXPECT_TRUE(same_points(mended(std::move(turned)), truth));
}

TEST(ExchangedLabels, OfAnIntervalAndDuringGapsAreMended) {
  const Demonstration& trial_of_drink = trial("ADL001DR2");
  Demonstration interval = trial_of_drink;
  exchange(*interval.streams.markers, "RTHUM", "RLAR2", 100, 120);
  EXPECT_TRUE(same_points(mended(std::move(interval)), trial_of_drink));
  Demonstration truth = trial_of_drink;
  hide(*truth.streams.markers, "RHAN1", 80, 100);
  hide(*truth.streams.markers, "RLAR3", 80, 100);
  Demonstration hidden = truth;
  exchange(*hidden.streams.markers, "RHAN1", "RLAR3", 90);
  EXPECT_TRUE(same_points(mended(std::move(hidden)), truth));
  Demonstration digits = trial_of_drink;
  hide(*digits.streams.markers, "RTHUM", 80, 100);
  hide(*digits.streams.markers, "RFTP", 80, 100);
  truth = digits;
  exchange(*digits.streams.markers, "RTHUM", "RFTP", 90);
  EXPECT_TRUE(same_points(mended(std::move(digits)), truth));
}

TEST(ExchangedLabels, TremblingMarkersAreMendedAndNotInvented) {
  Demonstration truth = trial("ADL006DR2");
  math::RandomStream random(7, "trembling markers");
  for (Vec3& point : truth.streams.markers->position.values)
    point += 0.002 * random.normal_vector3();
  EXPECT_THAT(check_labels(truth, {}), IsEmpty());
  Demonstration damaged = truth;
  exchange(*damaged.streams.markers, "RHAN1", "RHAN2");
  exchange(*damaged.streams.markers, "RUAR1", "RFTP", 70);
  EXPECT_TRUE(same_points(mended(std::move(damaged)), truth));
}

TEST(ExchangedLabels, TheFlagSaysWhichAndWhen) {
  Demonstration damaged = trial("ADL004DR2");
  MarkerStream& markers = *damaged.streams.markers;
  exchange(markers, "RTHUM", "RFTP", 50);
  exchange(markers, "RHAN1", "RHAN2");
  const std::vector<Doubt> doubts = check_labels(damaged, {});
  ASSERT_EQ(doubts.size(), 2);
  const RecordingFlag &whole = doubts[0].flag, &digits = doubts[1].flag;
  EXPECT_EQ(whole.code, FlagCode::exchanged_markers);
  EXPECT_EQ(whole.text, "RHAN1 and RHAN2 exchanged in the whole recording");
  EXPECT_TRUE(std::isnan(whole.begin_s));
  EXPECT_NEAR(whole.value, 0.052, 0.003);  // the distance of these two in the static trial
  EXPECT_EQ(digits.code, FlagCode::exchanged_digits);
  EXPECT_EQ(digits.text, "RTHUM and RFTP exchanged from 1.50 s");
  EXPECT_DOUBLE_EQ(digits.begin_s, markers.time[50]);
  EXPECT_DOUBLE_EQ(digits.end_s, markers.time.back());
}

TEST(ExchangedLabels, JointsOfASkeletonThatChangePlacesAreMended) {
  BodyStream skeleton;
  skeleton.names = {"right_thumb_tip", "right_index_tip"};
  skeleton.position = {100, 2, unknown_point()};
  skeleton.orientation = {100, 2, Quat::Identity()};
  for (std::size_t i = 0; i < 100; ++i) {
    skeleton.time.push_back(static_cast<double>(i) / 60);
    const double x_m = 0.2 * skeleton.time.back();
    const bool exchanged = i >= 40;
    skeleton.position(i, exchanged ? 1 : 0) = {x_m, 0, 0};
    skeleton.position(i, exchanged ? 0 : 1) = {x_m, 0.07, 0};
    skeleton.orientation(i, exchanged ? 0 : 1) = Quat(0, 1, 0, 0);
  }
  Demonstration recording;
  recording.streams.skeleton = skeleton;
  const std::vector<Doubt> doubts = check_labels(recording, {});
  ASSERT_EQ(doubts.size(), 1);
  EXPECT_EQ(doubts[0].flag.text, "right_thumb_tip and right_index_tip exchanged from 0.67 s");
  doubts[0].mend(recording);
  for (std::size_t i = 0; i < 100; ++i) {
    EXPECT_DOUBLE_EQ(recording.streams.skeleton->position(i, 0).y(), 0);
    EXPECT_DOUBLE_EQ(recording.streams.skeleton->orientation(i, 1).x(), 1);
  }
}

}  // namespace
}  // namespace morphe::imports
