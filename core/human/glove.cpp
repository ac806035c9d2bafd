#include "core/human/glove.hpp"

namespace morphe::human {
namespace {

/// A sensor and the joint (index in kHandAngleNames) whose angle it measures.
struct MeasuredJoint {
  int sensor, joint;
};
constexpr MeasuredJoint kAbsoluteSensors[] = {
    {0, 0},  {3, 1},  {1, 2},   {2, 3},   {4, 5},   {5, 6},   {6, 7},   {7, 9},
    {8, 10}, {9, 11}, {11, 13}, {12, 14}, {13, 15}, {15, 17}, {16, 18}, {17, 19}};
constexpr int kMiddleIndexAb = 10, kRingMiddleAb = 14, kPinkieRingAb = 18, kPalmArchSensor = 19,
              kWristPitch = 20, kWristYaw = 21;
constexpr int kIndexAb = 4, kMiddleAb = 8, kRingAb = 12, kLittleAb = 16;

}  // namespace

GloveReading decode_glove(const GloveAngles& glove) {
  GloveReading reading;
  auto& joint = reading.hand.joint;
  for (const auto& [sensor, k] : kAbsoluteSensors) joint[k] = glove[sensor];
  joint[kMiddleAb] = 0;
  joint[kIndexAb] = joint[kMiddleAb] + glove[kMiddleIndexAb];
  joint[kRingAb] = joint[kMiddleAb] - glove[kRingMiddleAb];
  joint[kLittleAb] = joint[kRingAb] - glove[kPinkieRingAb];
  reading.hand.palm_arch = glove[kPalmArchSensor];
  reading.wrist_flexion = glove[kWristPitch];
  reading.wrist_radial_deviation = glove[kWristYaw];
  return reading;
}

GloveAngles encode_glove(const GloveReading& reading) {
  GloveAngles glove{};
  const auto& joint = reading.hand.joint;
  for (const auto& [sensor, k] : kAbsoluteSensors) glove[sensor] = joint[k];
  glove[kMiddleIndexAb] = joint[kIndexAb] - joint[kMiddleAb];
  glove[kRingMiddleAb] = joint[kMiddleAb] - joint[kRingAb];
  glove[kPinkieRingAb] = joint[kRingAb] - joint[kLittleAb];
  glove[kPalmArchSensor] = reading.hand.palm_arch;
  glove[kWristPitch] = reading.wrist_flexion;
  glove[kWristYaw] = reading.wrist_radial_deviation;
  return glove;
}

}  // namespace morphe::human
