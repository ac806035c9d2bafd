#include "stages/inspect_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace morphe {
namespace {

using IsSeen = std::function<bool(std::size_t row, std::size_t column)>;

StreamReport report_stream(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const IsSeen& is_seen) {
  StreamReport report;
  report.name = name;
  report.columns = columns.size();
  if (time.size() < 2) return report;
  report.begin_s = time.front();
  report.duration_s = time.back() - time.front();
  report.rate_hz = static_cast<double>(time.size() - 1) / report.duration_s;
  std::size_t there = 0;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    std::size_t here = 0;
    for (std::size_t row = 0; row < time.size(); ++row) {
      if (is_seen(row, column)) {
        ++here;
        continue;
      }
      const std::size_t first = row;
      while (row + 1 < time.size() && !is_seen(row + 1, column)) ++row;
      ++report.gaps;
      const double length_s = time[row] - time[first] + 1 / report.rate_hz;
      if (length_s <= report.longest_gap_s) continue;
      report.longest_gap_s = length_s;
      report.longest_gap_of = columns[column];
    }
    if (here == 0) report.unseen.push_back(columns[column]);
    there += here;
  }
  const std::size_t all = time.size() * columns.size();
  report.seen = all == 0 ? 0 : static_cast<double>(there) / static_cast<double>(all);
  return report;
}

StreamReport report_points(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const Table<Vec3>& points) {
  return report_stream(name, time, columns, [&](std::size_t row, std::size_t column) {
    return seen(points(row, column));
  });
}

StreamReport report_angles(const std::string& name, const std::vector<double>& time,
                           const std::vector<std::string>& columns, const JointRows& angles) {
  return report_stream(name, time, columns, [&](std::size_t row, std::size_t column) {
    return std::isfinite(angles(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
  });
}

const char* name_of(HandKind kind) {
  switch (kind) {
    case HandKind::glove:
      return "glove";
    case HandKind::joint_angles:
      return "hand angles";
    case HandKind::keypoints:
      return "keypoints";
    case HandKind::fingertips:
      return "fingertips";
  }
  return "";
}

std::vector<StreamReport> report_streams(const Streams& streams) {
  std::vector<StreamReport> reports;
  if (const auto& s = streams.markers) {
    reports.push_back(report_points("markers", s->time, s->names, s->position));
  }
  if (const auto& s = streams.sensors) {
    reports.push_back(report_points("sensors", s->time, s->names, s->position));
  }
  if (const auto& s = streams.skeleton) {
    reports.push_back(report_points("skeleton", s->time, s->names, s->position));
  }
  if (const auto& s = streams.arm_angles) {
    reports.push_back(report_angles("arm_angles", s->time, s->joints, s->angles));
  }
  if (const auto& s = streams.hand) {
    if (!s->names.empty()) {
      reports.push_back(report_angles(name_of(s->kind), s->time, s->names, s->angles));
    } else {
      std::vector<std::string> points;
      for (std::size_t k = 0; k < s->position.cols; ++k)
        points.push_back(fmt::format("point {}", k));
      reports.push_back(report_points(name_of(s->kind), s->time, points, s->position));
    }
  }
  return reports;
}

double share(const std::vector<Vec3>& points) {
  const auto count = std::ranges::count_if(points, [](const Vec3& p) { return seen(p); });
  return points.empty() ? 0 : static_cast<double>(count) / static_cast<double>(points.size());
}

void judge_rebuilt(const HumanMotion& motion, Inspection& inspection) {
  inspection.rebuilt = {{"shoulder", share(motion.shoulder)},
                        {"elbow", share(motion.elbow)},
                        {"wrist", share(motion.wrist)}};
  for (std::size_t finger = 0; finger < kFingers && motion.tip.rows > 0; ++finger) {
    std::vector<Vec3> tip;
    for (std::size_t i = 0; i < motion.tip.rows; ++i) tip.push_back(motion.tip(i, finger));
    inspection.rebuilt.emplace_back(fmt::format("{} tip", kFingerNames[finger]), share(tip));
  }
  std::vector<std::string> tips;
  for (const auto& [what, how_much] : inspection.rebuilt) {
    if (how_much > 0) continue;
    if (what == "shoulder") {
      inspection.missing.push_back("the shoulder: no movement can be planned");
    } else if (what == "elbow") {
      inspection.missing.push_back("the elbow: nothing to be humanlike to");
    } else if (what == "wrist") {
      inspection.missing.push_back("the wrist: no movement can be told from the fingers' own");
    } else {
      tips.push_back(what.substr(0, what.find(' ')));
    }
  }
  if (tips.size() == kFingers) {
    inspection.missing.push_back("all fingertips: no movement can be planned");
  } else if (!tips.empty()) {
    inspection.missing.push_back(
        fmt::format("fingertips {}: those fingers of the robot go to a natural posture",
                    fmt::join(tips, ", ")));
  }
}

/// Shares the reasons of plans.h5: no_shoulder and no_goal.
std::string why_unusable(const HumanMotion& motion, const Movement& movement) {
  bool shoulder = false, tip = false;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    if (motion.time[i] < movement.begin_s || motion.time[i] > movement.end_s) continue;
    shoulder = shoulder || seen(motion.shoulder[i]);
    for (std::size_t f = 0; f < motion.tip.cols; ++f) tip = tip || seen(motion.tip(i, f));
  }
  return !shoulder ? "no_shoulder: the shoulder was not seen in it"
         : !tip    ? "no_goal: no fingertip was seen in it"
                   : "";
}

}  // namespace

std::size_t Inspection::usable() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(movements, [](const MovementReport& m) { return m.unusable.empty(); }));
}

Inspection inspect(const Demonstration& demonstration, const InspectOptions& options) {
  const HumanMotion motion = reconstruct(demonstration, options.reconstruct, options.human);
  Inspection result;
  result.name = demonstration.name;
  result.subject = demonstration.subject;
  result.task = demonstration.task;
  result.hand = demonstration.hand;
  result.streams = report_streams(demonstration.streams);
  result.calibration = report_streams(demonstration.calibration);
  for (const StreamReport& stream : result.streams) {
    result.duration_s = std::max(result.duration_s, stream.duration_s);
  }
  for (const SceneObject& object : demonstration.objects) result.objects.push_back(object.name);
  judge_rebuilt(motion, result);
  result.residuals = motion.residuals;
  result.estimated = motion.estimated;
  for (Movement& movement : segment(motion, options.segment, demonstration.objects)) {
    std::string unusable = why_unusable(motion, movement);
    result.movements.push_back({std::move(movement), std::move(unusable)});
  }
  result.reports = demonstration.reports;
  result.problems = motion.problems;
  if (result.movements.empty()) result.problems.push_back("no movement was found in it");
  return result;
}

}  // namespace morphe
