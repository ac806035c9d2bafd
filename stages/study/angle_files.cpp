#include "stages/study/angle_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pipeline/motion/input_error.hpp"
#include "stages/import/csv.hpp"

namespace morphe {
namespace {

constexpr double kStep_s = 0.01;
using Angles = std::vector<double>;  // [rad]

Angles read_column(const CsvText& csv, const std::string& name) {
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

Angles elbow_flexion(const HumanMotion& motion) {
  Angles angles;
  for (std::size_t i = 0; i < motion.time.size(); ++i) {
    const Vec3 upper = motion.elbow[i] - motion.shoulder[i],
               fore = motion.wrist[i] - motion.elbow[i];
    angles.push_back(std::atan2(upper.cross(fore).norm(), upper.dot(fore)));
  }
  return angles;
}

Angles arm_angle(const HumanMotion& motion, Eigen::Index joint) {
  Angles angles;
  for (Eigen::Index i = 0; i < motion.arm_angles.rows(); ++i) {
    angles.push_back(motion.arm_angles(i, joint));
  }
  return angles;
}

/// `theirs` laid on `ours` from frame `begin` on.
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
  result.correlation = covariance / std::sqrt(var_a * var_b);
  result.offset_rad = (a - b) / n;
  result.rms_rad = std::sqrt(std::max(0.0, var_a + var_b - 2 * covariance));
  result.lag_s = static_cast<double>(begin) * kStep_s;
  return result;
}

/// The same angle under another sign: whichever agrees better.
AngleAgreement either_sign(Angles ours, const Angles& theirs, std::size_t begin) {
  const AngleAgreement plain = agreement(ours, theirs, begin);
  for (double& angle : ours) angle = -angle;
  const AngleAgreement turned = agreement(ours, theirs, begin);
  return turned.correlation > plain.correlation ? turned : plain;
}

}  // namespace

std::vector<AngleAgreement> compare_with_angle_file(const HumanMotion& motion,
                                                    const std::filesystem::path& file) {
  const CsvText csv = read_csv(file);
  const Angles theirs = read_column(csv, "elbow flexion-extension");
  const Angles ours = elbow_flexion(motion);
  if (theirs.size() > ours.size()) {
    throw InputError(fmt::format("{}: is longer than the recording", file.string()));
  }
  AngleAgreement elbow;
  std::size_t begin = 0;
  for (std::size_t at = 0; at + theirs.size() <= ours.size(); ++at) {
    const AngleAgreement here = agreement(ours, theirs, at);
    if (here.n < theirs.size() || !(elbow.n == 0 || here.rms_rad < elbow.rms_rad)) continue;
    elbow = here;
    begin = at;
  }
  elbow.angle = "elbow flexion";
  std::vector<AngleAgreement> all = {elbow};
  const struct {
    const char* angle;
    Eigen::Index joint;
    const char* column;
  } others[] = {{"shoulder flexion", 0, "Shoulder flexion-extension"},
                {"shoulder abduction", 1, "Shoulder horiz abd-adduction"},
                {"shoulder internal rotation", 2, "Shoulder internal-external rotation"},
                {"forearm pronation", 4, "forearm pronation-supination"}};
  for (const auto& other : others) {
    AngleAgreement found =
        either_sign(arm_angle(motion, other.joint), read_column(csv, other.column), begin);
    found.angle = other.angle;
    if (found.n > 0) all.push_back(std::move(found));
  }
  return all;
}

}  // namespace morphe
