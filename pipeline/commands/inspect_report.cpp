#include "pipeline/commands/inspect_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stages/import/audit/movement_checks.hpp"
#include "stages/reconstruct/human_limits.hpp"
#include "stages/reconstruct/mirror.hpp"

namespace morphe::commands {
namespace {

double known_share(const std::vector<Vec3>& points) {
  const auto count = std::ranges::count_if(points, [](const Vec3& p) { return is_known(p); });
  return points.empty() ? 0 : static_cast<double>(count) / static_cast<double>(points.size());
}

void inspect_reconstruction(const HumanMotion& motion, Inspection& inspection) {
  inspection.reconstructed_shares = {{"shoulder", known_share(motion.shoulder)},
                                     {"elbow", known_share(motion.elbow)},
                                     {"wrist", known_share(motion.wrist)}};
  for (std::size_t finger = 0; finger < kFingerCount && motion.tip.rows > 0; ++finger) {
    std::vector<Vec3> tip;
    for (std::size_t i = 0; i < motion.tip.rows; ++i) tip.push_back(motion.tip(i, finger));
    inspection.reconstructed_shares.emplace_back(fmt::format("{} tip", kFingerNames[finger]),
                                                 known_share(tip));
  }
  std::vector<std::string> tips;
  for (const auto& [point, share] : inspection.reconstructed_shares) {
    if (share > 0) continue;
    if (point == "shoulder") {
      inspection.missing.push_back("the shoulder: no movement can be planned");
    } else if (point == "elbow") {
      inspection.missing.push_back("the elbow: humanlikeness cannot be evaluated");
    } else if (point == "wrist") {
      inspection.missing.push_back(
          "the wrist: movements of the arm cannot be distinguished from movements of the fingers");
    } else {
      tips.push_back(point.substr(0, point.find(' ')));
    }
  }
  if (tips.size() == kFingerCount) {
    inspection.missing.push_back("all fingertips: no movement can be planned");
  } else if (!tips.empty()) {
    inspection.missing.push_back(
        fmt::format("fingertips {}: these fingers of the robot take their natural posture",
                    fmt::join(tips, ", ")));
  }
}

/// Returns the reason with the codes that plans.h5 has, "" if the movement can be planned.
std::string find_unusable_reason(const HumanMotion& motion, const Movement& movement,
                                 const reconstruct::HumanOptions& human) {
  if (const PlanningFailure failure = reconstruct::check_human_limits(motion, human))
    return fmt::format("{}: {}", name_of(failure.reason), failure.detail);
  bool shoulder = false, tip = false;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (motion.time[i] < movement.begin_s || motion.time[i] > movement.end_s) continue;
    shoulder = shoulder || is_known(motion.shoulder[i]);
    for (std::size_t f = 0; f < motion.tip.cols; ++f) tip = tip || is_known(motion.tip(i, f));
  }
  return !shoulder ? "no_shoulder: the shoulder is missing in this movement"
         : !tip    ? "no_goal: all fingertips are missing in this movement"
                   : "";
}

}  // namespace

std::size_t Inspection::count_usable() const {
  return std::ranges::count_if(movements,
                               [](const MovementReport& m) { return m.unusable_reason.empty(); });
}

Inspection inspect(const Demonstration& demonstration, const InspectOptions& options) {
  const HumanMotion motion =
      reconstruct::reconstruct(demonstration, options.reconstruct, options.human);
  Inspection result;
  result.name = demonstration.name;
  result.subject = demonstration.subject;
  result.task = demonstration.task;
  result.hand = demonstration.hand;
  result.streams = report_streams(demonstration.streams);
  result.survey =
      imports::summarise_points(imports::recorded_points(demonstration.streams, result.hand));
  result.survey.file = demonstration.name;
  result.survey.unit = "m";
  result.calibration = report_streams(demonstration.calibration);
  result.duration_s = longest_duration_s(result.streams);
  for (const SceneObject& object : demonstration.objects) result.objects.push_back(object.name);
  inspect_reconstruction(motion, result);
  result.residuals = motion.residuals;
  result.estimated = motion.estimated;
  Demonstration on_right_side = demonstration;
  on_right_side.objects = reconstruct::objects_on_side(demonstration, Side::right);
  for (Movement& movement :
       segment::segment(motion, options.segment, on_right_side.objects, demonstration.task)) {
    std::string unusable = find_unusable_reason(motion, movement, options.human);
    const imports::AuditedMovement audited{on_right_side, motion, movement};
    const std::vector<RecordingFlag> all = imports::audit_movement(audited, options.audit);
    const RecordingFlag* refused = imports::refused_flag(all, options.audit);
    if (unusable.empty() && refused)
      unusable = fmt::format("{}: {}", name_of(Reason::doubtful_recording), refused->text);
    std::vector<RecordingFlag> own = imports::check_movement(audited, options.audit);
    result.movements.push_back({std::move(movement), std::move(unusable), std::move(own)});
  }
  result.flags = demonstration.flags;
  result.import_notes = demonstration.import_notes;
  result.problems = motion.reconstruction_notes;
  if (result.movements.empty()) result.problems.push_back("no movement found");
  return result;
}

}  // namespace morphe::commands
