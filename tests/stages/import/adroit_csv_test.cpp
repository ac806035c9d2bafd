#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/motion/input_error.hpp"
#include "stages/import/formats/adroit_hand.hpp"
#include "stages/import/import.hpp"

namespace morphe::imports {
namespace {

const std::filesystem::path kManifest =
    std::filesystem::path(MORPHE_SOURCE_DIR) / "datasets/adroit-dapg/recordings.yaml";

AdroitAngles angles_at(const Demonstration& d, std::size_t row) {
  AdroitAngles angles{};
  for (std::size_t j = 0; j < kAdroitJointCount; ++j) {
    angles[j] =
        d.streams.arm_angles->angles(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j));
  }
  return angles;
}

/// What was recorded as "palm xyz", back from the wrist pose.
Vec3 palm_point(const Demonstration& d, std::size_t row) {
  const BodyStream& wrist = *d.streams.sensors;
  const Vec3 in_hand = adroit_palm_from_hand().transpose() * adroit_palm_point();
  return wrist.position(row, 0) + wrist.orientation(row, 0) * in_hand;
}

std::vector<Demonstration> read_all() {
  std::vector<Demonstration> all;
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {kManifest};
  import_recordings(request, [&](Demonstration&& d) { all.push_back(std::move(d)); });
  return all;
}

/// Where the slide must stand for a palm point that was seen: nearest along its axis.
double slide_under(const AdroitAngles& angles, const Vec3& palm_in_world) {
  const Vec3 axis = adroit_world_from_palm(angles, 1).translation() -
                    adroit_world_from_palm(angles, 0).translation();
  return axis.dot(palm_in_world - adroit_world_from_palm(angles, 0) * adroit_palm_point());
}

TEST(AdroitHand, ForearmChainFitsTheRecordedPalm) {
  double sum = 0, worst = 0;
  std::size_t rows = 0;
  for (const Demonstration& d : read_all()) {
    for (std::size_t i = 0; i < d.streams.sensors->time.size(); ++i) {
      const AdroitAngles q = angles_at(d, i);
      const Vec3 recorded = palm_point(d, i);
      const Vec3 modelled =
          adroit_world_from_palm(q, slide_under(q, recorded)) * adroit_palm_point();
      sum += (modelled - recorded).squaredNorm();
      worst = std::max(worst, (modelled - recorded).norm());
      ++rows;
    }
  }
  fmt::print("palm fit: {:.2f} mm RMS, {:.2f} mm at most\n",
             1000 * std::sqrt(sum / static_cast<double>(rows)), 1000 * worst);
  EXPECT_EQ(rows, 1298u);
  EXPECT_LT(std::sqrt(sum / static_cast<double>(rows)), 0.0015);
  EXPECT_LT(worst, 0.005);
}

TEST(AdroitHand, FlatAndBentFingersStandWhereSegmentsAddUp) {
  AdroitAngles q{};
  auto tips = adroit_fingertips(q);
  EXPECT_LT((tips[1] - Vec3(0.033, 0, 0.191)).norm(), 1e-12);
  EXPECT_LT((tips[2] - Vec3(0.011, 0, 0.195)).norm(), 1e-12);
  EXPECT_LT((tips[3] - Vec3(-0.011, 0, 0.191)).norm(), 1e-12);
  EXPECT_LT((tips[4] - Vec3(-0.034, 0, 0.184)).norm(), 1e-12);
  EXPECT_LT(
      (tips[0] - Vec3(0.034 + 0.0975 / std::sqrt(2), -0.009, 0.029 + 0.0975 / std::sqrt(2))).norm(),
      1e-12);
  q[6] = 1.5707963267948966;  // FFJ2, the knuckle: the finger points out of the palm, to -y
  EXPECT_LT((adroit_fingertips(q)[1] - Vec3(0.033, -0.096, 0.095)).norm(), 1e-12);
}

TEST(AdroitHand, HandFrameIsThumbSideAndOutOfThePalm) {
  const Eigen::Matrix3d palm_from_hand = adroit_palm_from_hand();
  EXPECT_NEAR(palm_from_hand.determinant(), 1, 1e-15);
  AdroitAngles q{};
  const Vec3 flat_index = palm_from_hand.transpose() * adroit_fingertips(q)[1];
  const Vec3 thumb = palm_from_hand.transpose() * adroit_fingertips(q)[0];
  q[6] = q[7] = q[8] = 0.7;
  const Vec3 bent_index = palm_from_hand.transpose() * adroit_fingertips(q)[1];
  EXPECT_GT(flat_index.z(), 0.15);
  EXPECT_GT(thumb.y(), flat_index.y());
  EXPECT_GT(bent_index.x(), flat_index.x() + 0.05);
}

TEST(AdroitCsv, GraspsTheHandleWithFingersOnThePalmSide) {
  const std::size_t grasp_row[] = {82, 73, 62, 84, 82};  // the latch begins to move
  const auto all = read_all();
  ASSERT_EQ(all.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const Demonstration& d = all[k];
    const std::size_t i = grasp_row[k];
    const BodyStream& wrist = *d.streams.sensors;
    const Vec3 handle = d.objects.at(0).position[i];
    std::string line = fmt::format("{}: tips to handle [mm]", d.name);
    for (std::size_t finger = 0; finger < 5; ++finger) {
      line += fmt::format(" {:.0f}", 1000 * (d.streams.hand->position(i, finger) - handle).norm());
      const Vec3 in_hand = wrist.orientation(i, 0).inverse() *
                           (d.streams.hand->position(i, finger) - wrist.position(i, 0));
      EXPECT_GT(in_hand.x(), 0.0) << finger;  // bent towards the palm's side
    }
    // The handle is a bar of which one point was recorded: contact is near that point, not on it.
    double nearest = 1;
    for (std::size_t row = i; row < i + 20; ++row) {
      for (std::size_t finger = 0; finger < 5; ++finger) {
        nearest = std::min(
            nearest,
            (d.streams.hand->position(row, finger) - d.objects.at(0).position[row]).norm());
      }
    }
    fmt::print("{}; nearest of the next 0.2 s {:.0f}\n", line, 1000 * nearest);
    EXPECT_GT(nearest, 0.015);
    EXPECT_LT(nearest, 0.042);
    // Forward is where the handle is, and the palm faces it.
    EXPECT_GT(handle.y(), wrist.position(0, 0).y() + 0.3);
    const Vec3 handle_in_hand = wrist.orientation(i, 0).inverse() * (handle - wrist.position(i, 0));
    EXPECT_GT(handle_in_hand.x(), 0.0);
    EXPECT_GT(handle_in_hand.z(), 0.05);
  }
}

/// A file made from chosen angles: what comes back is the chain's own pose.
TEST(AdroitCsv, ReadsBackASyntheticPose) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(-0.5, 0.5);
  AdroitAngles q{};
  for (double& value : q) value = std::round(angle(random) * 1e6) / 1e6;
  const double slide = 0.123;
  const Pose world_from_palm = adroit_world_from_palm(q, slide);
  const Vec3 palm = world_from_palm * adroit_palm_point();
  EXPECT_NEAR(slide_under(q, palm), slide, 1e-12);

  std::string header = "t_s", row = "0.5";
  for (std::size_t j = 0; j < kAdroitJointCount; ++j) {
    header += fmt::format(",{}", kAdroitJoints[j]);
    row += fmt::format(",{}", q[j]);
  }
  header += ",latch,door_hinge,palm_x,palm_y,palm_z,handle_x,handle_y,handle_z";
  row += fmt::format(",0,0,{},{},{},0.1,0.2,0.3", palm.x(), palm.y(), palm.z());
  const auto file = std::filesystem::path(testing::TempDir()) / "morphe_adroit_synthetic.csv";
  std::ofstream(file) << "# state\n" << header << "\n" << row << "\n";
  ImportRequest request;
  request.conventions.forward = ForwardSource::recorded;
  request.paths = {file};
  import_recordings(request, [&](Demonstration&& d) {
    EXPECT_LT((d.streams.sensors->position(0, 0) - world_from_palm.translation()).norm(), 1e-12);
    const Quat expected(world_from_palm.linear() * adroit_palm_from_hand());
    EXPECT_LT(angle_between(d.streams.sensors->orientation(0, 0), expected), 1e-7);
    for (std::size_t f = 0; f < 5; ++f) {
      EXPECT_LT((d.streams.hand->position(0, f) - world_from_palm * adroit_fingertips(q)[f]).norm(),
                1e-12);
    }
    EXPECT_EQ(d.streams.arm_angles->joints.size(), kAdroitJointCount);
    EXPECT_EQ(d.objects[0].position[0], Vec3(0.1, 0.2, 0.3));
    EXPECT_DOUBLE_EQ(d.streams.sensors->time[0], 0.5);
  });
  const auto error_of = [&](const std::string& text) -> std::string {
    std::ofstream(file) << text;
    try {
      import_recordings(request, [](Demonstration&&) {});
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
    return "no error";
  };
  std::string without = header;
  without.replace(without.find("THJ0"), 4, "THJ9");
  EXPECT_EQ(error_of(without + "\n" + row + "\n"), ":1: THJ0: the column is missing");
  EXPECT_EQ(error_of(header + "\n" + row + ",1\n"), ":2: the row has 37 cells, the header has 36");
  EXPECT_EQ(error_of(header + "\n" + row + "\n-" + row + "\n"),
            ":3: t_s: must be greater than in the previous row");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace morphe::imports
