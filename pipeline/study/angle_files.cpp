#include "pipeline/study/angle_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/files/csv.hpp"
#include "core/motion/input_error.hpp"
#include "pipeline/study/cluster_angles.hpp"

namespace morphe::study {
namespace {

constexpr double kFileStep_s = 0.01;
constexpr const char* kElbow = "elbow flexion-extension";
constexpr const char* kPronation = "forearm pronation-supination";
constexpr const char* kHorizontal = "Shoulder horiz abd-adduction";
constexpr const char* kFlexion = "Shoulder flexion-extension";
constexpr const char* kRotation = "Shoulder internal-external rotation";
using Angles = std::vector<double>;  // [rad], one every kFileStep_s

Angles read_column(const files::CsvText& csv, const std::string& name) {
  const auto header = csv.cells(1);
  const auto found = std::find(header.begin(), header.end(), name);
  if (found == header.end()) csv.fail(1, name, "the column is missing");
  const auto column = static_cast<std::size_t>(found - header.begin());
  Angles angles;
  for (std::size_t line = 2; line <= csv.lines.size(); ++line) {
    const auto cells = csv.cells(line);
    if (column >= cells.size()) csv.fail(line, name, "the row ends before this column");
    angles.push_back(csv.number(line, name, cells[column]) * std::numbers::pi / 180);
  }
  return angles;
}

/// Resamples values to the time step of the file, from the first frame on; NaN next to unseen
/// frames.
Angles resample(const std::vector<double>& time, const std::vector<double>& values) {
  Angles result;
  std::size_t i = 0;
  for (std::size_t step = 0; values.size() > 1; ++step) {
    constexpr double kTimeTolerance_s = 1e-9;
    const double t = time.front() + static_cast<double>(step) * kFileStep_s;
    if (t > time.back() + kTimeTolerance_s) break;
    while (i + 2 < time.size() && time[i + 1] <= t + kTimeTolerance_s) ++i;
    const double share = std::clamp((t - time[i]) / (time[i + 1] - time[i]), 0.0, 1.0);
    if (share < kTimeTolerance_s) {
      result.push_back(values[i]);
    } else if (share > 1 - kTimeTolerance_s) {
      result.push_back(values[i + 1]);
    } else {
      result.push_back((1 - share) * values[i] + share * values[i + 1]);
    }
  }
  return result;
}

std::vector<double> elbow_flexion(const HumanMotion& motion) {
  std::vector<double> angles;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const Vec3 upper = motion.elbow[i] - motion.shoulder[i],
               fore = motion.wrist[i] - motion.elbow[i];
    angles.push_back(std::atan2(upper.cross(fore).norm(), upper.dot(fore)));
  }
  return angles;
}

/// Computes the speed of the index tip by central differences; the ends repeat their neighbours.
std::vector<double> index_speed(const HumanMotion& motion) {
  constexpr std::size_t kIndex = 1;
  std::vector<double> speed;
  const std::size_t n = motion.time.size();
  for (std::size_t i = 0; i < n && n > 2; ++i) {
    const std::size_t k = std::clamp<std::size_t>(i, 1, n - 2);
    speed.push_back((motion.tip(k + 1, kIndex) - motion.tip(k - 1, kIndex)).norm() /
                    (motion.time[k + 1] - motion.time[k - 1]));
  }
  return speed;
}

std::vector<double> arm_angle(const HumanMotion& motion, Eigen::Index joint) {
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < motion.arm_angles.rows(); ++i) {
    angles.push_back(motion.arm_angles(i, joint));
  }
  return angles;
}

/// Computes the agreement of `theirs` with `ours` if it begins at frame `begin`.
AngleAgreement agreement(const Angles& ours, const Angles& theirs, std::size_t begin) {
  AngleAgreement result;
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < theirs.size() && begin + i < ours.size(); ++i) {
    const double x = ours[begin + i], y = theirs[i];
    if (!std::isfinite(x)) continue;
    a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
    ++result.n;
  }
  if (result.n < 10) return result;
  const double n = static_cast<double>(result.n);
  const double var_a = aa / n - a * a / n / n, var_b = bb / n - b * b / n / n;
  const double covariance = ab / n - a * b / n / n;
  if (var_a > 0 && var_b > 0) result.correlation = covariance / std::sqrt(var_a * var_b);
  result.offset_rad = (a - b) / n;
  result.rms_rad = std::sqrt(std::max(0.0, var_a + var_b - 2 * covariance));
  result.lag_s = static_cast<double>(begin) * kFileStep_s;
  return result;
}

/// Computes the agreement for both signs of our angle and returns the better one.
AngleAgreement compare_either_sign(Angles ours, const Angles& theirs, std::size_t begin) {
  const AngleAgreement plain = agreement(ours, theirs, begin);
  for (double& angle : ours) angle = -angle;
  const AngleAgreement turned = agreement(ours, theirs, begin);
  return turned.correlation > plain.correlation ? turned : plain;
}

/// Finds the frame at which the file begins: every sample of it can be compared, and the agreement
/// is `better` than at any other frame.
template <class Better>
std::optional<std::size_t> best_alignment(const Angles& ours, const Angles& theirs,
                                          const Better& better) {
  std::optional<std::size_t> place;
  AngleAgreement best;
  for (std::size_t at = 0; at + theirs.size() <= ours.size(); ++at) {
    const AngleAgreement here = agreement(ours, theirs, at);
    if (here.n < theirs.size() || (place && !better(here, best))) continue;
    best = here;
    place = at;
  }
  return place;
}

std::size_t find_alignment(const files::CsvText& csv, const HumanMotion& motion,
                           const Angles& elbow) {
  const auto by_speed = best_alignment(
      resample(motion.time, index_speed(motion)), read_column(csv, "Finger Velocity"),
      [](const auto& a, const auto& b) { return a.correlation > b.correlation; });
  if (by_speed) return *by_speed;
  return best_alignment(elbow, read_column(csv, kElbow),
                        [](const auto& a, const auto& b) { return a.rms_rad < b.rms_rad; })
      .value_or(0);
}

}  // namespace

std::vector<AngleAgreement> compare_with_angle_file(const Demonstration& demonstration,
                                                    const HumanMotion& motion,
                                                    const reconstruct::ReconstructOptions& options,
                                                    const std::filesystem::path& file) {
  const files::CsvText csv = files::read_csv(file);
  const Angles elbow = resample(motion.time, elbow_flexion(motion));
  if (read_column(csv, kElbow).size() > elbow.size()) {
    throw InputError(fmt::format("{}: has more rows than the recording", file.string()));
  }
  const std::size_t begin = find_alignment(csv, motion, elbow);
  std::vector<AngleAgreement> all;
  const auto add = [&](const std::string& angle, AngleAgreement found) {
    found.angle = angle;
    if (found.n > 0) all.push_back(std::move(found));
  };
  add("elbow flexion", agreement(elbow, read_column(csv, kElbow), begin));
  const struct {
    const char* angle;
    Eigen::Index joint;
    const char* column;
  } rebuilt[] = {{"shoulder flexion", 0, kFlexion},
                 {"shoulder abduction", 1, kHorizontal},
                 {"shoulder internal rotation", 2, kRotation},
                 {"forearm pronation", 4, kPronation}};
  for (const auto& one : rebuilt) {
    add(one.angle, compare_either_sign(resample(motion.time, arm_angle(motion, one.joint)),
                                       read_column(csv, one.column), begin));
  }
  const ClusterAngles clusters = cluster_angles(demonstration, options);
  const struct {
    const std::vector<double>& angle;
    const char* column;
  } defined[] = {{clusters.horizontal, kHorizontal},
                 {clusters.flexion, kFlexion},
                 {clusters.rotation, kRotation},
                 {clusters.elbow, kElbow},
                 {clusters.pronation, kPronation}};
  for (const auto& one : defined) {
    add(fmt::format("{} by the file's definition", one.column),
        agreement(resample(motion.time, one.angle), read_column(csv, one.column), begin));
  }
  return all;
}

}  // namespace morphe::study
