#include "stages/import/audit/label_digits.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/rigid.hpp"
#include "core/math/statistics.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/guess/recorded_points.hpp"
#include "stages/import/recording/arm_names.hpp"

namespace morphe::imports {
namespace {

std::vector<std::size_t> columns_of_part(const std::vector<std::string>& names,
                                         const std::string& part) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (body_part(names[k]).starts_with(part)) columns.push_back(k);
  }
  return columns;
}

/// Returns by how much the index tip is farther from the forearm than the thumb's [m].
double reach_margin(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                    const DigitMarkers& digits) {
  std::vector<double> margins;
  for (std::size_t i = begin; i < end; ++i) {
    std::vector<Vec3> points;
    for (const std::size_t column : digits.forearm) points.push_back(position(i, column));
    const Vec3 forearm = mean_of(points);
    const double margin_m =
        (position(i, digits.index) - forearm).norm() - (position(i, digits.thumb) - forearm).norm();
    if (std::isfinite(margin_m)) margins.push_back(margin_m);
  }
  return math::median(std::move(margins));
}

/// Returns by how much the tips are nearer to their own places in the static trial [m].
double static_margin(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                     const DigitMarkers& digits) {
  if (!digits.hand || end <= begin) return kUnknown;
  const Array2D<Vec3> frames = sample_frames(position, begin, end, kSampledFrames);
  const Permutation recorded = identity_permutation(position.cols);
  std::vector<double> margins;
  for (std::size_t i = 0; i < frames.rows; ++i) {
    const Pose world_from_static = math::fit_rigid_transform(
        digits.hand->shape, cluster_points(frames, i, *digits.hand, recorded));
    const Vec3 thumb = world_from_static * digits.static_thumb,
               index = world_from_static * digits.static_index;
    const Vec3 &named_thumb = frames(i, digits.thumb), &named_index = frames(i, digits.index);
    const double own_m = (named_thumb - thumb).norm() + (named_index - index).norm();
    const double exchanged_m = (named_thumb - index).norm() + (named_index - thumb).norm();
    if (std::isfinite(exchanged_m - own_m)) margins.push_back(exchanged_m - own_m);
  }
  return math::median(std::move(margins));
}

DigitOrder order_by(double margin_m, double min_margin_m) {
  return margin_m > min_margin_m    ? DigitOrder::own
         : margin_m < -min_margin_m ? DigitOrder::exchanged
                                    : DigitOrder::unknown;
}

bool sees_both(const Array2D<Vec3>& position, std::size_t frame, const DigitMarkers& digits) {
  return is_known(position(frame, digits.thumb)) && is_known(position(frame, digits.index));
}

}  // namespace

std::optional<DigitMarkers> digit_markers(const MarkerStream& markers,
                                          const std::optional<MarkerStream>& static_trial,
                                          const std::vector<RigidCluster>& clusters,
                                          const std::string& side) {
  const auto thumb = columns_of_part(markers.names, side + " thumb tip");
  const auto index = columns_of_part(markers.names, side + " index tip");
  if (thumb.size() != 1 || index.size() != 1) return std::nullopt;
  DigitMarkers digits{thumb[0], index[0], columns_of_part(markers.names, side + " forearm"),
                      {},       {},       {}};
  if (digits.forearm.empty()) digits.forearm = columns_of_part(markers.names, side + " wrist,");
  const auto hand = std::ranges::find(clusters, side + " hand", &RigidCluster::part);
  if (!static_trial || hand == clusters.end() || hand->shape.empty()) return digits;
  digits.static_thumb = median_of_part(*static_trial, side + " thumb tip");
  digits.static_index = median_of_part(*static_trial, side + " index tip");
  const Vec3 forearm = median_of_part(*static_trial, side + " forearm");
  const double reach_m =
      (digits.static_index - forearm).norm() - (digits.static_thumb - forearm).norm();
  const bool usable = is_known(digits.static_thumb) && is_known(digits.static_index) &&
                      order_by(reach_m, kMinReachMargin_m) != DigitOrder::exchanged;
  if (usable) digits.hand = *hand;
  return digits;
}

std::optional<DigitMarkers> digit_joints(const std::vector<std::string>& names,
                                         const std::string& side) {
  const auto thumb = columns_of_part(names, side + " thumb"),
             index = columns_of_part(names, side + " index");
  const auto is_tip = [&](const auto& columns) {
    return columns.size() == 1 && body_part(names[columns[0]]).ends_with(" tip");
  };
  if (!is_tip(thumb) || !is_tip(index)) return std::nullopt;
  DigitMarkers digits{thumb[0], index[0], columns_of_part(names, side + " elbow"), {}, {}, {}};
  const auto wrist = columns_of_part(names, side + " wrist");
  digits.forearm.insert(digits.forearm.end(), wrist.begin(), wrist.end());
  return digits;
}

DigitOrder digit_order(const Array2D<Vec3>& position, std::size_t begin, std::size_t end,
                       const DigitMarkers& digits) {
  const DigitOrder by_reach =
      order_by(reach_margin(position, begin, end, digits), kMinReachMargin_m);
  const DigitOrder by_static =
      order_by(static_margin(position, begin, end, digits), kMinStaticMargin_m);
  if (by_reach == DigitOrder::unknown) return by_static;
  const bool contradicted = by_static != DigitOrder::unknown && by_static != by_reach;
  return contradicted ? DigitOrder::unknown : by_reach;
}

std::vector<std::size_t> digit_parts(const Array2D<Vec3>& position, const DigitMarkers& digits) {
  std::vector<std::size_t> begins = {0};
  for (std::size_t i = 1; i < position.rows; ++i) {
    if (sees_both(position, i, digits) && !sees_both(position, i - 1, digits)) begins.push_back(i);
  }
  return begins;
}

}  // namespace morphe::imports
