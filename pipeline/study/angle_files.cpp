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
  const std::ptrdiff_t column = std::ranges::find(header, name) - header.begin();
  if (column == std::ssize(header)) csv.fail(1, name, "the column is missing");
  Angles angles;
  for (int line = 2; line <= std::ssize(csv.lines); ++line) {
    const auto cells = csv.cells(line);
    if (column >= std::ssize(cells)) csv.fail(line, name, "the row ends before this column");
    angles.push_back(csv.number(line, name, cells[column]) * std::numbers::pi / 180);
  }
  return angles;
}

/// Resamples to the time step of the file, from the first frame on; NaN next to unseen frames.
Angles resample(const std::vector<double>& time, const std::vector<double>& values) {
  Angles result;
  int i = 0;
  for (int step = 0; values.size() > 1; ++step) {
    constexpr double kTimeTolerance_s = 1e-9;
    const double time_s = time.front() + step * kFileStep_s;
    if (time_s > time.back() + kTimeTolerance_s) break;
    while (i + 2 < std::ssize(time) && time[i + 1] <= time_s + kTimeTolerance_s) ++i;
    const double share = std::clamp((time_s - time[i]) / (time[i + 1] - time[i]), 0.0, 1.0);
    if (share < kTimeTolerance_s)
      result.push_back(values[i]);
    else if (share > 1 - kTimeTolerance_s)
      result.push_back(values[i + 1]);
    else
      result.push_back((1 - share) * values[i] + share * values[i + 1]);
  }
  return result;
}

std::vector<double> elbow_flexion(const HumanMotion& motion) {
  std::vector<double> angles;
  for (int i = 0; i < std::ssize(motion.time); ++i) {
    const Vec3 upper_arm = motion.elbow[i] - motion.shoulder[i];
    const Vec3 forearm = motion.wrist[i] - motion.elbow[i];
    angles.push_back(std::atan2(upper_arm.cross(forearm).norm(), upper_arm.dot(forearm)));
  }
  return angles;
}

/// Computes the speed of the index tip by central differences; the ends repeat their neighbours.
std::vector<double> index_speed(const HumanMotion& motion) {
  std::vector<double> speed;
  const std::ptrdiff_t n = std::ssize(motion.time);
  for (std::ptrdiff_t i = 0; i < n && n > 2; ++i) {
    const std::ptrdiff_t k = std::clamp<std::ptrdiff_t>(i, 1, n - 2);
    speed.push_back((motion.tip(k + 1, kIndex) - motion.tip(k - 1, kIndex)).norm() /
                    (motion.time[k + 1] - motion.time[k - 1]));
  }
  return speed;
}

/// Computes the agreement if `theirs` begins at index `begin` of `ours`.
AngleAgreement agreement(const Angles& ours, const Angles& theirs, std::ptrdiff_t begin) {
  AngleAgreement result;
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
  for (int i = 0; i < std::ssize(theirs) && begin + i < std::ssize(ours); ++i) {
    const double x = ours[begin + i], y = theirs[i];
    if (!std::isfinite(x)) continue;
    a += x, b += y, aa += x * x, bb += y * y, ab += x * y;
    ++result.n;
  }
  if (result.n < 10) return result;
  const double n = result.n;
  const double var_a = aa / n - a * a / n / n, var_b = bb / n - b * b / n / n;
  const double covariance = ab / n - a * b / n / n;
  if (var_a > 0 && var_b > 0) result.correlation = covariance / std::sqrt(var_a * var_b);
  result.offset_rad = (a - b) / n;
  result.rms_rad = std::sqrt(std::max(0.0, var_a + var_b - 2 * covariance));
  result.lag_s = static_cast<double>(begin) * kFileStep_s;
  return result;
}

/// Computes the agreement for both signs of our angle and returns the better one.
AngleAgreement compare_either_sign(Angles ours, const Angles& theirs, std::ptrdiff_t begin) {
  const AngleAgreement same_sign = agreement(ours, theirs, begin);
  for (double& angle : ours) angle = -angle;
  const AngleAgreement negated = agreement(ours, theirs, begin);
  return negated.correlation > same_sign.correlation ? negated : same_sign;
}

/// Returns the index of `ours` at which `theirs` agrees best, among those from which every row can
/// be compared; empty if there is no such index.
template <class Better>
std::optional<std::ptrdiff_t> best_alignment(const Angles& ours, const Angles& theirs,
                                             const Better& better) {
  std::optional<std::ptrdiff_t> best_begin;
  AngleAgreement best;
  for (std::ptrdiff_t begin = 0; begin + std::ssize(theirs) <= std::ssize(ours); ++begin) {
    const AngleAgreement candidate = agreement(ours, theirs, begin);
    if (candidate.n < std::ssize(theirs) || (best_begin && !better(candidate, best))) continue;
    best = candidate;
    best_begin = begin;
  }
  return best_begin;
}

std::ptrdiff_t find_alignment(const files::CsvText& csv, const HumanMotion& motion,
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
  if (read_column(csv, kElbow).size() > elbow.size())
    throw InputError(fmt::format("{}: has more rows than the recording", file.string()));
  const std::ptrdiff_t begin = find_alignment(csv, motion, elbow);
  std::vector<AngleAgreement> all;
  const auto add = [&](const std::string& angle, AngleAgreement compared) {
    compared.angle = angle;
    if (compared.n > 0) all.push_back(std::move(compared));
  };
  add("elbow flexion", agreement(elbow, read_column(csv, kElbow), begin));
  const struct {
    const char* angle;
    Eigen::Index joint;
    const char* column;
  } reconstructed[] = {{"shoulder flexion", 0, kFlexion},
                       {"shoulder abduction", 1, kHorizontal},
                       {"shoulder internal rotation", 2, kRotation},
                       {"forearm pronation", 4, kPronation}};
  for (const auto& [angle, joint, column] : reconstructed) {
    std::vector<double> ours;
    for (const auto& angles : motion.arm_angles.rowwise()) ours.push_back(angles[joint]);
    add(angle, compare_either_sign(resample(motion.time, ours), read_column(csv, column), begin));
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
  for (const auto& [angle, column] : defined)
    add(fmt::format("{} by the file's definition", column),
        agreement(resample(motion.time, angle), read_column(csv, column), begin));
  return all;
}

}  // namespace morphe::study
