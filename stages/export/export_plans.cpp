#include "stages/export/export_plans.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "pipeline/files/part_file.hpp"
#include "pipeline/motion/input_error.hpp"
#include "pipeline/store/plan_file.hpp"
#include "stages/export/robomimic.hpp"
#include "stages/export/ros_trajectory.hpp"
#include "stages/export/trajectory_csv.hpp"

namespace morphe::exports {
namespace {

/// What no controller may be given, whatever the file calls it; "" if it may.
std::string what_is_wrong(const Trajectory& t) {
  if (t.samples() < 2) return "the trajectory has fewer than two samples";
  if (!t.position.allFinite() || !t.velocity.allFinite() || !t.acceleration.allFinite()) {
    return "the trajectory holds what is no number";
  }
  for (std::size_t i = 0; i < t.samples(); ++i) {
    const bool later = i == 0 ? std::isfinite(t.time[0]) : t.time[i] > t.time[i - 1];
    if (!later || !std::isfinite(t.time[i])) return "the trajectory's time does not increase";
    if (!(static_cast<std::size_t>(t.phase[i]) < count_of<PhaseKind>()))
      return "the trajectory holds unknown phases";
  }
  return "";
}

/// "" if a plan can be exported.
std::string why_not(const Plan& plan) {
  if (!plan.executable()) return fmt::format("{}: {}", name_of(plan.reason), plan.detail);
  if (const std::string wrong = what_is_wrong(plan.trajectory); !wrong.empty()) return wrong;
  for (const Trajectory* way : {&plan.approach, &plan.retreat}) {
    const std::string wrong = way->samples() > 0 ? what_is_wrong(*way) : "";
    if (!wrong.empty()) return (way == &plan.approach ? "approach: " : "retreat: ") + wrong;
  }
  return "";
}

void export_texts(const store::PlanReader& reader, const std::filesystem::path& folder,
                  const char* ending, std::string (*text_of)(const RobotTable&, const Trajectory&),
                  ExportReport& report) {
  const auto write = [&](const Plan& plan, const char* what, const Trajectory& trajectory) {
    const std::string name =
        fmt::format("{}_{:03}{}{}", plan.demonstration, plan.movement.index, what, ending);
    files::write_whole(folder / name, text_of(reader.robot(), trajectory));
    report.files.push_back(name);
  };
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const Plan plan = reader.read(i);
    if (const std::string why = why_not(plan); !why.empty()) {
      report.left_out.push_back({reader.plan_paths()[i], why});
      continue;
    }
    write(plan, "", plan.trajectory);
    if (plan.approach.samples() > 0) write(plan, "_approach", plan.approach);
    if (plan.retreat.samples() > 0) write(plan, "_retreat", plan.retreat);
  }
}

void export_robomimic(const store::PlanReader& reader, const std::filesystem::path& folder,
                      ExportReport& report) {
  // Twice through the file: whether all have a target must be known before the first is written.
  std::vector<std::size_t> chosen;
  bool target = true;
  double rate_hz = 0;
  for (std::size_t i = 0; i < reader.size(); ++i) {
    const Plan plan = reader.read(i);
    if (const std::string why = why_not(plan); !why.empty()) {
      report.left_out.push_back({reader.plan_paths()[i], why});
      continue;
    }
    const Trajectory& t = plan.trajectory;
    if (chosen.empty())
      rate_hz = static_cast<double>(t.samples() - 1) / (t.time.back() - t.time[0]);
    target = target && plan.grasp.sample >= 0;
    chosen.push_back(i);
  }
  if (chosen.empty()) return;
  const std::string name = "robomimic.hdf5";
  RobomimicWriter writer(folder / name,
                         robomimic_header(reader.robot(), std::round(1e6 * rate_hz) / 1e6));
  for (const std::size_t i : chosen) {
    writer.add(robomimic_demo(reader.robot(), reader.read(i), target));
  }
  writer.finish();
  report.files.push_back(name);
}

}  // namespace

std::vector<std::string> export_format_names() { return {"csv", "ros", "robomimic"}; }

ExportReport export_plans(const std::filesystem::path& plans, const std::string& format,
                          const std::filesystem::path& folder) {
  const store::PlanReader reader(plans);
  ExportReport report;
  if (format == "csv") export_texts(reader, folder, ".csv", trajectory_csv, report);
  if (format == "ros") export_texts(reader, folder, ".yaml", ros_trajectory, report);
  if (format == "robomimic") export_robomimic(reader, folder, report);
  return report;
}

}  // namespace morphe::exports
