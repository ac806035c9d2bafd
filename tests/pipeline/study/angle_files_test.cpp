#include "pipeline/study/angle_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "core/motion/input_error.hpp"
#include "stages/import/import.hpp"

namespace morphe::study {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

const std::filesystem::path kTrials =
    std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets" / "ue-adl";
constexpr double kDegree = std::numbers::pi / 180;

TEST(AngleFiles, RebuiltAnglesFollowTheAuthorsOwn) {
  // First frame by the peak of the fingertip's speed, found with a script of its own.
  const double begin_s[] = {0.64, 0.32, 0.30, 0.60, 0.84};
  imports::ImportRequest request;
  request.paths = {kTrials / "recordings.yaml"};
  request.conventions.forward =
      imports::ForwardSource::recorded;  // their angles are about its axes
  std::size_t trial = 0;
  imports::import_recordings(request, [&](Demonstration&& d) {
    const HumanMotion motion = reconstruct::reconstruct(d, {}, {});
    const auto all = compare_with_angle_file(d, motion, {}, kTrials / (d.name + "angles.csv"));
    ASSERT_EQ(all.size(), 10u);
    for (const AngleAgreement& one : all) {
      fmt::print("{} {}: r {:.4f}, rms {:.2f}, offset {:.1f} degrees\n", d.name, one.angle,
                 one.correlation, one.rms_rad / kDegree, one.offset_rad / kDegree);
      EXPECT_NEAR(one.lag_s, begin_s[trial], 0.0101);
      const bool defined = one.angle.ends_with("by the file's definition");
      if (one.angle == "elbow flexion") {
        EXPECT_GT(one.correlation, 0.99);
        EXPECT_LT(one.rms_rad, 4 * kDegree);
      } else if (defined) {
        EXPECT_GT(one.correlation, one.angle.starts_with("forearm") ? 0.985 : 0.998);
        EXPECT_LT(one.rms_rad, (one.angle.starts_with("Shoulder") ? 0.5 : 2) * kDegree);
        EXPECT_LT(std::abs(one.offset_rad), 4 * kDegree);
      }
    }
    ++trial;
  });
  EXPECT_EQ(trial, 5u);
}

TEST(AngleFiles, RefusesWhatIsNoAngleFile) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "angles.csv";
  std::ofstream(file) << "elbow flexion-extension\n1\n";
  HumanMotion motion;
  for (int i = 0; i < 3; ++i) {
    motion.time.push_back(0.01 * i);
    motion.shoulder.push_back(Vec3::Zero());
    motion.elbow.push_back(Vec3::UnitX());
    motion.wrist.push_back(Vec3::UnitY());
  }
  motion.tip = Array2D<Vec3>(3, kFingerCount, unknown_point());
  const auto compare = [&] { compare_with_angle_file({}, motion, {}, file); };
  EXPECT_THAT(compare, ThrowsMessage<InputError>(
                           StrEq(file.string() + ":1: Finger Velocity: the column is missing")));
  std::ofstream(file) << "Finger Velocity,elbow flexion-extension\n1,1\n1,1\n1,1\n1,1\n";
  EXPECT_THAT(compare, ThrowsMessage<InputError>(
                           StrEq(file.string() + ": has more rows than the recording")));
}

}  // namespace
}  // namespace morphe::study
