#include "pipeline/commands/posture_json.hpp"

#include <cmath>
#include <string>
#include <utility>

namespace morphe::commands {
namespace {

using PostureJson = nlohmann::ordered_json;

PostureJson names_json(const std::vector<explain::FigureCause>& causes) {
  PostureJson names = PostureJson::array();
  for (const explain::FigureCause cause : causes) names.push_back(name_of(cause));
  return names;
}

PostureJson figure_json(const explain::PostureFigure& figure) {
  return {{"driven", figure.driven},
          {"least", figure.least},
          {"with_tips", figure.with_tips},
          {"causes", names_json(figure.causes.all)},
          {"not_told_apart_from", names_json(figure.causes.instead)}};
}

PostureJson wrist_json(const explain::WristOffset& wrist) {
  using namespace explain;
  const Vec3& shift = wrist.base_shift;
  PostureJson after;
  for (const auto& [name, change] :
       {std::pair("base", kBaseChange), std::pair("links", kLinksChange),
        std::pair("hand", kFingersChange), std::pair("palm_angle", kPalmChange),
        std::pair("tips", kTipsChange)}) {
    after[name] = wrist.after[change];
    if (change != kBaseChange)
      after[std::string(name) + "_and_base"] = wrist.after[change | kBaseChange];
  }
  return {{"rms", wrist.rms()},
          {"after", after},
          {"base_shift", {shift.x(), shift.y(), shift.z()}},
          {"lengths", {wrist.upper_arm, wrist.forearm}},
          {"human_lengths", {wrist.human_upper_arm, wrist.human_forearm}},
          {"from_human", wrist.from_human},
          {"parts", {{"hand", wrist.fingers}, {"palm_angle", wrist.palm}, {"tips", wrist.tips}}}};
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
