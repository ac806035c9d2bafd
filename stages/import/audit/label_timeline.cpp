#include "stages/import/audit/label_timeline.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/math/rigid.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/label_chain.hpp"
#include "stages/import/audit/label_digits.hpp"

namespace morphe::imports {
namespace {

void permute_row(Array2D<Vec3>& position, std::size_t row, const Permutation& source) {
  const auto begin = position.values.begin() + static_cast<std::ptrdiff_t>(row * position.cols);
  const std::vector<Vec3> recorded(begin, begin + static_cast<std::ptrdiff_t>(position.cols));
  for (std::size_t k = 0; k < position.cols; ++k) position(row, k) = recorded[source[k]];
}

Array2D<Vec3> permuted(Array2D<Vec3> position, const Permutation& source) {
  for (std::size_t i = 0; i < position.rows; ++i) permute_row(position, i, source);
  return position;
}

Permutation inverse(const Permutation& source) {
  Permutation result(source.size());
  for (std::size_t k = 0; k < source.size(); ++k) result[source[k]] = k;
  return result;
}

Permutation exchange_of(std::size_t size, std::size_t a, std::size_t b) {
  Permutation source = identity_permutation(size);
  std::swap(source[a], source[b]);
  return source;
}

std::vector<DigitMarkers> hands_of(const MarkerStream& markers,
                                   const std::optional<MarkerStream>& static_trial,
                                   const LabelModel& model) {
  std::vector<DigitMarkers> hands;
  for (const char* side : {"right", "left"}) {
    if (auto digits = digit_markers(markers, static_trial, model.clusters, side))
      hands.push_back(std::move(*digits));
  }
  return hands;
}

/// Returns how badly the recording fits the names of one of its parts [m].
double naming_cost(const Array2D<Vec3>& frames, const LabelModel& model,
                   const std::vector<DigitMarkers>& hands) {
  double cost_m = label_cost(frames, model, identity_permutation(frames.cols));
  for (const DigitMarkers& digits : hands) {
    if (digit_order(frames, 0, frames.rows, digits) == DigitOrder::exchanged)
      cost_m += kExchangedDigitsCost_m;
  }
  return cost_m;
}

/// Gives all tracks the names of the part whose names fit best; of those that fit alike, the first
/// that lasts, as names are given at the beginning and lost in motion.
void choose_names(const LabelModel& model, const std::vector<DigitMarkers>& hands,
                  LabelTimeline& timeline) {
  if (timeline.parts.size() < 2) return;
  const Array2D<Vec3> frames =
      sample_frames(timeline.tracks, 0, timeline.tracks.rows, kSampledFrames);
  std::map<Permutation, std::size_t> frame_counts;
  for (std::size_t p = 0; p < timeline.parts.size(); ++p)
    frame_counts[timeline.parts[p].source] += timeline.end_of(p) - timeline.parts[p].begin;
  std::map<Permutation, double> costs;
  double least_m = kInfinity;
  for (const auto& [source, count] : frame_counts) {
    if (static_cast<double>(count) < kMinNamedShare * static_cast<double>(timeline.tracks.rows))
      continue;
    costs[source] = naming_cost(permuted(frames, inverse(source)), model, hands);
    least_m = std::min(least_m, costs[source]);
  }
  const auto best = std::ranges::find_if(timeline.parts, [&](const LabelPart& part) {
    const auto cost = costs.find(part.source);
    return cost != costs.end() && cost->second <= least_m + kSameCost_m;
  });
  if (best != timeline.parts.end()) {
    const Permutation names = inverse(best->source);
    timeline.relabel(0, timeline.tracks.rows, names);
  }
}

/// Frames of a recording, from `begin` to before `end`.
struct FrameRange {
  std::size_t begin = 0, end = 0;
};

/// Returns the RMS error of a cluster in one frame [m]; NaN if it shows fewer than three markers.
double frame_misfit(const Array2D<Vec3>& tracks, std::size_t frame, const RigidCluster& cluster,
                    const Permutation& source) {
  const std::vector<Vec3> points = cluster_points(tracks, frame, cluster, source);
  return math::rigid_residual(math::fit_rigid_transform(cluster.shape, points), cluster.shape,
                              points);
}

/// Returns the frames in a row in which a cluster does not fit its shape, each time that it does
/// not.
std::vector<FrameRange> misfitting_frames(const Array2D<Vec3>& tracks,
                                          const RigidCluster& cluster) {
  const Permutation own = identity_permutation(tracks.cols);
  std::vector<FrameRange> ranges;
  bool misfits = false;
  for (std::size_t i = 0; i < tracks.rows; ++i) {
    const double error_m = frame_misfit(tracks, i, cluster, own);
    if (!std::isfinite(error_m)) continue;
    if (error_m > kMaxFrameMisfit_m) {
      if (!misfits) ranges.push_back({i, i});
      ranges.back().end = i + 1;
    }
    misfits = error_m > kMaxFrameMisfit_m;
  }
  std::erase_if(ranges, [](FrameRange range) { return range.end - range.begin < kMinMisfitRun; });
  return ranges;
}

/// Returns true if a track that `source` moves is hidden in the frame, and the clusters do not fit
/// their own tracks better than those of `source`.
bool may_be_moved(const Array2D<Vec3>& tracks, std::size_t frame, const LabelModel& model,
                  const Permutation& source) {
  bool hidden = false;
  for (std::size_t k = 0; k < source.size(); ++k)
    hidden = hidden || (source[k] != k && !is_known(tracks(frame, k)));
  const Permutation own = identity_permutation(tracks.cols);
  return hidden && std::ranges::none_of(model.clusters, [&](const RigidCluster& cluster) {
           return frame_misfit(tracks, frame, cluster, source) >
                  frame_misfit(tracks, frame, cluster, own) + kSameCost_m;
         });
}

bool has_gap(const Array2D<Vec3>& tracks, const RigidCluster& cluster) {
  for (std::size_t i = 0; i < tracks.rows; ++i) {
    for (const std::size_t k : cluster.columns) {
      if (!is_known(tracks(i, k))) return true;
    }
  }
  return false;
}

/// Relabels the frames after gaps in which a cluster does not fit.
void relabel_after_gaps(LabelModel model, LabelTimeline& timeline) {
  const Array2D<Vec3> frames =
      sample_frames(timeline.tracks, 0, timeline.tracks.rows, kSampledFrames);
  for (RigidCluster& cluster : model.clusters) {
    if (cluster.shape.empty()) cluster = with_recorded_shape(frames, std::move(cluster));
  }
  std::erase_if(model.clusters, [](const RigidCluster& c) { return c.shape.empty(); });
  model.joints.clear();
  const Permutation own = identity_permutation(frames.cols);
  const std::size_t frame_count = timeline.tracks.rows;
  for (const RigidCluster& cluster : model.clusters) {
    if (!has_gap(timeline.tracks, cluster)) continue;
    if (!(cluster_misfit(frames, cluster, own).error_m <= kMaxMisfit_m)) continue;
    for (FrameRange range : misfitting_frames(timeline.tracks, cluster)) {
      const Permutation source = find_relabelling(
          sample_frames(timeline.tracks, range.begin, range.end, kSampledFrames), model);
      if (source == own) continue;
      while (range.end < frame_count && may_be_moved(timeline.tracks, range.end, model, source))
        ++range.end;
      timeline.relabel(range.begin, range.end, source);
    }
  }
}

/// Gives parts of the arms that carry each other's names their own.
void relabel_parts(const std::vector<std::string>& names, LabelTimeline& timeline) {
  const std::size_t rows = timeline.tracks.rows;
  const Array2D<Vec3> frames = sample_frames(timeline.tracks, 0, rows, kSampledFrames);
  const Permutation source = shortest_chain(frames, names);
  if (source != identity_permutation(source.size())) timeline.relabel(0, rows, source);
}

void relabel_digits(const DigitMarkers& digits, LabelTimeline& timeline) {
  const Array2D<Vec3>& tracks = timeline.tracks;
  const Permutation exchanged = exchange_of(tracks.cols, digits.thumb, digits.index);
  const DigitOrder whole = digit_order(tracks, 0, tracks.rows, digits);
  const std::vector<std::size_t> begins = digit_parts(tracks, digits);
  for (std::size_t p = 0; p < begins.size(); ++p) {
    const std::size_t end = p + 1 < begins.size() ? begins[p + 1] : tracks.rows;
    DigitOrder order = digit_order(tracks, begins[p], end, digits);
    if (order == DigitOrder::unknown) order = whole;
    if (order == DigitOrder::exchanged) timeline.relabel(begins[p], end, exchanged);
  }
}

}  // namespace

std::size_t LabelTimeline::end_of(std::size_t part) const {
  return part + 1 < parts.size() ? parts[part + 1].begin : tracks.rows;
}

void LabelTimeline::relabel(std::size_t begin, std::size_t end, const Permutation& source) {
  for (const std::size_t frame : {begin, end}) {
    const auto after = std::ranges::upper_bound(parts, frame, {}, &LabelPart::begin);
    if (frame < tracks.rows && (after - 1)->begin != frame)
      parts.insert(after, {frame, (after - 1)->source});
  }
  for (LabelPart& part : parts) {
    if (part.begin >= begin && part.begin < end) part.source = compose(part.source, source);
  }
  for (std::size_t i = begin; i < end; ++i) permute_row(tracks, i, source);
}

LabelTimeline continued_tracks(const std::vector<double>& time, const Array2D<Vec3>& position) {
  const std::vector<Exchange> exchanges = find_exchanges(time, position);
  LabelTimeline timeline{undo_exchanges(exchanges, position),
                         {{0, identity_permutation(position.cols)}}};
  for (const Exchange& exchange : exchanges)
    timeline.parts.push_back({exchange.frame, exchange.source});
  return timeline;
}

LabelTimeline find_joint_labels(const std::vector<double>& time, const Array2D<Vec3>& position,
                                const std::vector<std::string>& names) {
  LabelTimeline timeline = continued_tracks(time, position);
  if (position.rows == 0) return timeline;
  relabel_parts(names, timeline);
  for (const char* side : {"right", "left"}) {
    if (const auto digits = digit_joints(names, side)) relabel_digits(*digits, timeline);
  }
  return timeline;
}

LabelTimeline find_labels(const MarkerStream& markers,
                          const std::optional<MarkerStream>& static_trial) {
  LabelTimeline timeline = continued_tracks(markers.time, markers.position);
  const LabelModel model = label_model(markers, static_trial);
  const std::vector<DigitMarkers> hands = hands_of(markers, static_trial, model);
  choose_names(model, hands, timeline);
  const std::size_t rows = timeline.tracks.rows;
  if (rows == 0) return timeline;
  relabel_parts(markers.names, timeline);
  relabel_after_gaps(model, timeline);
  const Permutation whole =
      find_relabelling(sample_frames(timeline.tracks, 0, rows, kSampledFrames), model);
  if (whole != identity_permutation(whole.size())) {
    timeline.relabel(0, rows, whole);
    relabel_after_gaps(model, timeline);
  }
  for (const DigitMarkers& digits : hands) relabel_digits(digits, timeline);
  return timeline;
}

}  // namespace morphe::imports
