#include "pipeline/explain/posture_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "core/motion/arm_estimate.hpp"
#include "core/motion/finding_text.hpp"

namespace morphe::explain {
namespace {

std::string_view words_of(FigureCause cause) {
  constexpr std::array<std::string_view, enum_count<FigureCause>()> kWords{
      "",
      "",
      "the placement of the base",
      "the lengths of the robot's arm",
      "the robot's hand",
      "the palm's angle",
      "tips off their goals",
      "the wrist (hand, palm or tips)",
      "the placement or the robot's size",
      "weights or solver"};
  return kWords.at(static_cast<std::size_t>(cause));
}

std::string joined(const std::vector<FigureCause>& causes, const char* last) {
  std::string text;
  for (std::size_t k = 0; k < causes.size(); ++k)
    text += fmt::format("{}{}",
                        k == 0                  ? ""
                        : k + 1 < causes.size() ? ", "
                                                : last,
                        words_of(causes[k]));
  return text;
}

/// Returns ": due to weights or solver", with "together" and "not told apart" for several causes.
std::string causes_text(const FigureCauses& causes) {
  if (causes.all.front() == FigureCause::unknown) return "";
  if (causes.all.front() == FigureCause::small) return " (small)";
  std::string text = ": due to " + joined(causes.all, " and ");
  if (causes.all.size() > 1) text += " together";
  if (causes.instead.empty()) return text;
  return fmt::format("{}, not told apart from {}", text, joined(causes.instead, " and "));
}

/// Returns ", WORDS" with an angle, "" if it is unknown.
std::string angle_text(const char* words, const char* mark, double angle) {
  return std::isnan(angle) ? "" : fmt::format(", {}{:.1f} {}", mark, angle / kRadPerDegree, words);
}

/// Returns "upper arm 10.3 degrees from the person's, 9.8 at least with this wrist: due to …", ""
/// if unknown.
std::string figure_text(const char* name, const PostureFigure& figure, const char* mark,
                        bool has_least) {
  if (std::isnan(figure.driven)) return "";
  return fmt::format(
      "{} {}{:.1f} degrees from the person's{}{}{}", name, mark, figure.driven / kRadPerDegree,
      angle_text("at least with this wrist", mark, has_least ? figure.least : kUnknown),
      angle_text("with these tips and the best arm and palm", mark, figure.with_tips),
      causes_text(figure.causes));
}

std::string palm_text(const PostureSummary& posture) {
  if (std::isnan(posture.palm.driven)) return "";
  const PalmFloor& floor = posture.palm_floor;
  const std::string least =
      std::isnan(floor.driven)
          ? ""
          : fmt::format(
                ", at most {:.1f} needed for these tips, at most {:.1f} for the fingers alone",
                floor.whole_robot / kRadPerDegree, floor.hand_alone / kRadPerDegree);
  return fmt::format("palm {:.1f} degrees from the person's{}{}{}",
                     posture.palm.driven / kRadPerDegree, least,
                     angle_text("with the best arm and palm", "", posture.palm.with_tips),
                     causes_text(posture.palm.causes));
}

/// Returns the shift along the axes of the placement, or of the base if it is not known.
std::string shift_text(const Plan& plan, const Vec3& in_base) {
  const Pose& base_from_world = plan.reference_frames.base_from_world;
  const bool placed = is_known(base_from_world);
  const Vec3 mm = kMillimetresPerMetre *
                  (placed ? Vec3(base_from_world.linear().transpose() * in_base) : in_base);
  return fmt::format("({:+.0f}, {:+.0f}, {:+.0f}) mm along the {} axes", mm.x(), mm.y(), mm.z(),
                     placed ? "recording's" : "base's");
}

std::string mm(double metres) { return fmt::format("{:.0f} mm", kMillimetresPerMetre * metres); }

/// Returns what remains with a change, and with the base moved in addition.
std::string change_text(const WristOffset& wrist, unsigned change, const std::string& words) {
  return fmt::format("{} {}, {} with the base moved, too", mm(wrist.after[change]), words,
                     mm(wrist.after[change | kBaseChange]));
}

std::vector<std::string> wrist_lines(const Plan& plan, const WristOffset& wrist) {
  if (std::isnan(wrist.rms())) return {};
  std::vector<std::string> lines{
      fmt::format("{} (RMS) from where both links would have the person's directions; without "
                  "regard to reach and obstacles, that would be",
                  mm(wrist.rms())),
      fmt::format("{} with the base moved by {}", mm(wrist.after[kBaseChange]),
                  shift_text(plan, wrist.base_shift)),
      change_text(wrist, kLinksChange,
                  fmt::format("with links as long as the person's ({} and {} instead of {} and {})",
                              mm(wrist.human_upper_arm), mm(wrist.human_forearm),
                              mm(wrist.upper_arm), mm(wrist.forearm)))};
  if (!wrist.is_hand_known) {
    lines.push_back(change_text(wrist, kFingersChange, "with the wrist where the person's is"));
    return lines;
  }
  lines.push_back(change_text(wrist, kFingersChange, "with hand and fingers like the person's"));
  lines.push_back(change_text(wrist, kPalmChange, "with the palm turned as the person's"));
  lines.push_back(fmt::format(
      "{} (RMS) from the person's wrist; as vectors, {} by hand and fingers, {} by the palm's "
      "angle, {} by tips off their goals",
      mm(wrist.from_human), mm(wrist.fingers), mm(wrist.palm), mm(wrist.tips)));
  return lines;
}

std::string block(std::string_view step, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines)
    if (!line.empty()) text += fmt::format("  {:<13} {}\n", text.empty() ? step : "", line);
  return text;
}

}  // namespace

std::string posture_text(const Plan& plan, const PostureSummary& posture) {
  const char* mark = is_arm_estimated(plan.goals) ? "~" : "";
  const bool has_least = posture.has_elbow_circle;
  const double correlation = plan.certificate.wrist_speed_correlation;
  return block("posture",
               {figure_text("upper arm", posture.upper_arm, mark, has_least),
                figure_text("forearm", posture.forearm, mark, has_least),
                figure_text("swivel angle", posture.swivel, mark, has_least), palm_text(posture),
                std::isnan(correlation)
                    ? ""
                    : fmt::format("wrist speed r {:.2f} with the person's", correlation)}) +
         block("wrist", wrist_lines(plan, posture.wrist));
}

}  // namespace morphe::explain
