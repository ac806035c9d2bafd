#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "stages/import/import.hpp"
#include "stages/reconstruct/reconstruct.hpp"

namespace morphe::reconstruct {
namespace {

const std::filesystem::path kDatasets = std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets";

struct Trial {
  Demonstration demonstration;
  HumanMotion motion;
};

std::vector<Trial> read_trials(const std::string& folder) {
  std::vector<Trial> trials;
  imports::ImportRequest request;
  request.paths = {kDatasets / folder / "recordings.yaml"};
  imports::import_recordings(request, [&](Demonstration&& d) {
    HumanMotion motion = reconstruct(d, {}, {});
    trials.push_back({std::move(d), std::move(motion)});
  });
  return trials;
}

/// Elbow flexion from the straight arm [deg].
std::vector<double> elbow_flexion(const HumanMotion& motion) {
  std::vector<double> degrees;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const Vec3 up = (motion.elbow[i] - motion.shoulder[i]).normalized();
    const Vec3 fore = (motion.wrist[i] - motion.elbow[i]).normalized();
    degrees.push_back(std::acos(up.dot(fore)) * 180 / std::numbers::pi);
  }
  return degrees;
}

/// Column 8 ("elbow flexion-extension") of the authors' own angles [deg].
std::vector<double> published_flexion(const std::string& name) {
  std::ifstream stream(kDatasets / "ue-adl" / (name + "angles.csv"));
  std::vector<double> degrees;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::stringstream cells(line);
    std::string cell;
    for (int c = 0; c < 8; ++c) std::getline(cells, cell, ',');
    degrees.push_back(std::stod(cell));
  }
  return degrees;
}

struct Agreement {
  double correlation = -1, bias = 0, rms = 0;  // rms about the bias
};

/// Best agreement over where the trimmed reference may begin.
Agreement best_agreement(const std::vector<double>& ours, const std::vector<double>& reference) {
  Agreement best;
  const double n = static_cast<double>(reference.size());
  for (std::size_t shift = 0; shift + reference.size() <= ours.size(); ++shift) {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
      const double x = ours[shift + i], y = reference[i];
      a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
    }
    const double var_a = aa / n - a * a / n / n, var_b = bb / n - b * b / n / n;
    const double cov = ab / n - a * b / n / n;
    const double correlation = cov / std::sqrt(var_a * var_b);
    if (correlation <= best.correlation) continue;
    best = {correlation, (a - b) / n, std::sqrt(std::max(0.0, var_a + var_b - 2 * cov))};
  }
  return best;
}

std::string millimetres(const Vec3& p) {
  return fmt::format("({:.0f} {:.0f} {:.0f})", 1000 * p.x(), 1000 * p.y(), 1000 * p.z());
}

TEST(RealTrials, EverythingIsSeenAndBonesKeepTheirLength) {
  // Static trials: RGTH to the middle of the epicondyles, measured with a script of its own.
  const double upper_arm[] = {0.27359, 0.26127, 0.27378, 0.27359, 0.27359};
  const auto trials = read_trials("ue-adl");
  ASSERT_EQ(trials.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const HumanMotion& motion = trials[k].motion;
    // A pronated hand on a nearly straight arm: the elbow's carrying angle, which seven angles
    // lack.
    for (const std::string& problem : motion.reconstruction_notes) {
      EXPECT_TRUE(k >= 3 && problem.starts_with("arm angles")) << problem;
    }
    double shortest = 1, longest = 0;
    for (std::size_t i = 0; i < motion.time.size(); ++i) {
      EXPECT_NEAR((motion.elbow[i] - motion.shoulder[i]).norm(), upper_arm[k], 1e-4);
      const double forearm = (motion.wrist[i] - motion.elbow[i]).norm();
      shortest = std::min(shortest, forearm);
      longest = std::max(longest, forearm);
      EXPECT_TRUE(is_known(motion.tip(i, 0)) && is_known(motion.tip(i, 1)));
      EXPECT_TRUE(is_known(motion.wrist_orientation[i]));
    }
    fmt::print("{}: forearm {:.1f} to {:.1f} mm", trials[k].demonstration.name, 1000 * shortest,
               1000 * longest);
    for (const Residual& r : motion.residuals) {
      fmt::print("; {} {:.1f} (max {:.1f}) mm", r.name, 1000 * r.rms_m, 1000 * r.max_m);
    }
    fmt::print("\n");
    EXPECT_LT(longest - shortest, 1e-6);
  }
}

TEST(RealTrials, ElbowFlexesAsTheAuthorsSay) {
  for (const Trial& trial : read_trials("ue-adl")) {
    const Agreement agreement =
        best_agreement(elbow_flexion(trial.motion), published_flexion(trial.demonstration.name));
    fmt::print("{}: correlation {:.4f}, bias {:.1f} deg, rms about it {:.2f} deg\n",
               trial.demonstration.name, agreement.correlation, agreement.bias, agreement.rms);
    // Their zero is another posture, hence a constant difference.
    EXPECT_GT(agreement.correlation, 0.99);
    EXPECT_LT(agreement.rms, 5);
  }
}

TEST(RealTrials, GraspLiesInFrontOfThePalm) {
  const std::size_t grasp_frame[] = {173, 130, 123};
  const std::size_t start_frame[] = {67, 40, 40};
  const auto trials = read_trials("ue-adl");
  for (std::size_t k = 0; k < 3; ++k) {
    const HumanMotion& motion = trials[k].motion;
    for (const std::size_t frame : {start_frame[k], grasp_frame[k]}) {
      const std::size_t i = frame - 1;
      fmt::print("{} frame {}: shoulder {} elbow {} wrist {} thumb {} index {} opening {:.1f}\n",
                 trials[k].demonstration.name, frame, millimetres(motion.shoulder[i]),
                 millimetres(motion.elbow[i]), millimetres(motion.wrist[i]),
                 millimetres(motion.tip(i, 0)), millimetres(motion.tip(i, 1)),
                 1000 * (motion.tip(i, 0) - motion.tip(i, 1)).norm());
    }
    const std::size_t i = grasp_frame[k] - 1;
    const Vec3 held = (motion.tip(i, 0) + motion.tip(i, 1)) / 2;
    const Vec3 in_hand = motion.wrist_orientation[i].inverse() * (held - motion.wrist[i]);
    EXPECT_GT(in_hand.x(), 0.03);  // out of the palm
    EXPECT_GT(in_hand.y(), 0.0);   // on the thumb's side
    EXPECT_GT(in_hand.z(), 0.07);  // towards the fingers
    const double opening = (motion.tip(i, 0) - motion.tip(i, 1)).norm();
    EXPECT_GT(opening, 0.080);  // a cup between the pads
    EXPECT_LT(opening, 0.105);
  }
}

}  // namespace
}  // namespace morphe::reconstruct
