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
      " (small)",
      ": due to the placement of the base",
      ": due to the robot's size",
      ": due to the wrist's way (hand, palm or a detour)",
      ": due to the hand",
      ": due to the placement or the robot's size",
      ": due to weights or solver"};
  return kWords.at(static_cast<std::size_t>(cause));
}

/// Returns "upper arm 10.3 degrees off, 9.8 at least with this wrist: due to …", "" if unknown.
std::string figure_text(const char* name, const PostureFigure& figure, const char* mark,
                        bool has_least) {
  if (std::isnan(figure.driven)) return "";
  const std::string least = has_least ? fmt::format(", {}{:.1f} at least with this wrist", mark,
                                                    figure.least / kRadPerDegree)
                                      : "";
  return fmt::format("{} {}{:.1f} degrees from the person's{}{}", name, mark,
                     figure.driven / kRadPerDegree, least, words_of(figure.cause));
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
  return fmt::format("palm {:.1f} degrees from the person's{}{}",
                     posture.palm.driven / kRadPerDegree, least, words_of(posture.palm.cause));
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

std::vector<std::string> wrist_lines(const Plan& plan, const WristOffset& wrist) {
  if (std::isnan(wrist.rms)) return {};
  std::vector<std::string> lines{
      fmt::format("{:.0f} mm (RMS) from where both links would have the person's directions",
                  kMillimetresPerMetre * wrist.rms),
      fmt::format("{:.0f} mm with the base moved by {}, without regard to reach and obstacles",
                  kMillimetresPerMetre * wrist.after_shift, shift_text(plan, wrist.base_shift))};
  if (!std::isnan(wrist.best_scale))
    lines.push_back(
        fmt::format("{:.0f} mm with links {:.2f} times as long, too ({:.0f} and {:.0f} mm instead "
                    "of {:.0f} and "
                    "{:.0f})",
                    kMillimetresPerMetre * wrist.after_scale, wrist.best_scale,
                    kMillimetresPerMetre * wrist.best_scale * wrist.upper_arm,
                    kMillimetresPerMetre * wrist.best_scale * wrist.forearm,
                    kMillimetresPerMetre * wrist.upper_arm, kMillimetresPerMetre * wrist.forearm));
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
