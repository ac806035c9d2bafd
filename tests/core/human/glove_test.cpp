#include "core/human/glove.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

namespace morphe::human {
namespace {

std::size_t sensor(const std::string& name) {
  return static_cast<std::size_t>(
      std::find(std::begin(kGloveSensors), std::end(kGloveSensors), name) -
      std::begin(kGloveSensors));
}
std::size_t joint(const std::string& name) {
  return static_cast<std::size_t>(
      std::find(std::begin(kHandAngleNames), std::end(kHandAngleNames), name) -
      std::begin(kHandAngleNames));
}

TEST(Glove, EachSensorMovesItsJoint) {
  const std::pair<const char*, const char*> direct[] = {{"ThumbRotate", "thumb_rotation"},
                                                        {"ThumbAb", "thumb_abduction"},
                                                        {"ThumbMPJ", "thumb_mcp"},
                                                        {"ThumbIJ", "thumb_ip"},
                                                        {"IndexMPJ", "index_mcp"},
                                                        {"IndexPIJ", "index_pip"},
                                                        {"IndexDIJ", "index_dip"},
                                                        {"MiddleMPJ", "middle_mcp"},
                                                        {"MiddlePIJ", "middle_pip"},
                                                        {"MiddleDIJ", "middle_dip"},
                                                        {"RingMPJ", "ring_mcp"},
                                                        {"RingPIJ", "ring_pip"},
                                                        {"RingDIJ", "ring_dip"},
                                                        {"PinkieMPJ", "little_mcp"},
                                                        {"PinkiePIJ", "little_pip"},
                                                        {"PinkieDIJ", "little_dip"},
                                                        {"MiddleIndexAb", "index_abduction"}};
  for (const auto& [from, to] : direct) {
    GloveAngles glove{};
    glove[sensor(from)] = 0.3;
    HandAngles hand = decode_glove(glove).hand;
    EXPECT_EQ(hand.joint[joint(to)], 0.3) << from;
    hand.joint[joint(to)] = 0;
    for (const double rest : hand.joint) EXPECT_EQ(rest, 0) << from;
  }
}

TEST(Glove, SpreadFingersGoAwayFromTheMiddleOne) {
  GloveAngles glove{};
  glove[sensor("RingMiddleAb")] = 0.2;
  glove[sensor("PinkieRingAb")] = 0.3;
  const GloveReading reading = decode_glove(glove);
  EXPECT_EQ(reading.hand.joint[joint("middle_abduction")], 0);
  EXPECT_DOUBLE_EQ(reading.hand.joint[joint("ring_abduction")], -0.2);
  EXPECT_DOUBLE_EQ(reading.hand.joint[joint("little_abduction")], -0.5);
  glove = {};
  glove[sensor("PalmArch")] = 0.1;
  glove[sensor("WristPitch")] = 0.2;
  glove[sensor("WristYaw")] = 0.4;
  EXPECT_EQ(decode_glove(glove).hand.palm_arch, 0.1);
  EXPECT_EQ(decode_glove(glove).wrist_flexion, 0.2);
  EXPECT_EQ(decode_glove(glove).wrist_radial_deviation, 0.4);
}

TEST(Glove, EncodingIsTheInverse) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 100; ++trial) {
    GloveAngles glove;
    for (double& angle : glove) angle = uniform(random);
    const GloveAngles again = encode_glove(decode_glove(glove));
    for (std::size_t k = 0; k < kGloveSensorCount; ++k) EXPECT_NEAR(again[k], glove[k], 1e-15);
    GloveReading reading;
    for (double& angle : reading.hand.joint) angle = uniform(random);
    reading.hand.joint[joint("middle_abduction")] = 0;
    const GloveReading back = decode_glove(encode_glove(reading));
    for (std::size_t k = 0; k < kHandAngleCount; ++k) {
      EXPECT_NEAR(back.hand.joint[k], reading.hand.joint[k], 1e-15);
    }
  }
}

}  // namespace
}  // namespace morphe::human
