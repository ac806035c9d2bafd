#include "pipeline/commands/posture_json.hpp"

#include <cmath>

namespace morphe::commands {
namespace {

using PostureJson = nlohmann::ordered_json;

PostureJson figure_json(const explain::PostureFigure& figure) {
  return {{"driven", figure.driven}, {"least", figure.least}, {"cause", name_of(figure.cause)}};
}

PostureJson wrist_json(const explain::WristOffset& wrist) {
  const Vec3& shift = wrist.base_shift;
  return {{"rms", wrist.rms},
          {"base_shift", {shift.x(), shift.y(), shift.z()}},
          {"after_shift", wrist.after_shift},
          {"upper_arm", wrist.upper_arm},
          {"forearm", wrist.forearm},
          {"best_scale", wrist.best_scale},
          {"after_scale", wrist.after_scale}};
}

}  // namespace

nlohmann::ordered_json posture_json(const explain::PostureSummary& posture) {
  if (std::isnan(posture.upper_arm.driven) && std::isnan(posture.palm.driven)) return nullptr;
  return {{"elbow_circle", posture.has_elbow_circle},
          {"upper_arm", figure_json(posture.upper_arm)},
          {"forearm", figure_json(posture.forearm)},
          {"swivel", figure_json(posture.swivel)},
          {"palm", figure_json(posture.palm)},
          {"palm_of_fingers", posture.palm_floor.hand_alone},
          {"wrist_offset", wrist_json(posture.wrist)}};
}

}  // namespace morphe::commands
