#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "stages/reconstruct/cluster.hpp"
#include "stages/reconstruct/streams.hpp"

namespace morphe {
namespace {

constexpr std::size_t kThumb = 0, kIndex = 1;

/// The static trial: where each marker stood, and what is wrong with those that are asked for.
class StaticTrial {
 public:
  StaticTrial(const std::optional<MarkerStream>& trial, std::vector<std::string>& problems)
      : given_(trial.has_value()), problems_(problems) {
    if (!given_) problems.push_back("no static trial: joint centres are unknown");
    for (std::size_t k = 0; given_ && k < trial->names.size(); ++k) add(*trial, k);
  }

  bool given() const { return given_; }
  /// Mean position [m], unseen if it never was.
  Vec3 operator()(const std::string& name) const {
    constexpr double kStill = 0.010;  // breathing and drift of the quiet trials: 1 to 5 mm
    const auto found = markers_.find(name);
    if (found == markers_.end()) {
      if (given_) problems_.push_back(fmt::format("static trial: {} is missing", name));
      return unseen_point();
    }
    if (found->second.moved_m > kStill) {
      problems_.push_back(
          fmt::format("static trial: {} moves by {:.1f} mm", name, 1000 * found->second.moved_m));
    }
    return found->second.mean;
  }

 private:
  struct Marker {
    Vec3 mean;
    double moved_m;
  };

  void add(const MarkerStream& trial, std::size_t k) {
    Vec3 sum = Vec3::Zero(), low = Vec3::Constant(1e9), high = -low;
    int count = 0;
    for (std::size_t i = 0; i < trial.position.rows; ++i) {
      const Vec3& point = trial.position(i, k);
      if (!seen(point)) continue;
      sum += point;
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
      ++count;
    }
    if (count > 0) markers_[trial.names[k]] = {sum / count, (high - low).norm()};
  }

  bool given_;
  std::map<std::string, Marker> markers_;
  std::vector<std::string>& problems_;
};

std::vector<Vec3> track_of(const MarkerStream& markers, const std::string& name) {
  std::vector<Vec3> track(markers.time.size(), unseen_point());
  const auto found = std::find(markers.names.begin(), markers.names.end(), name);
  if (found == markers.names.end()) return track;
  const auto k = static_cast<std::size_t>(found - markers.names.begin());
  for (std::size_t i = 0; i < track.size(); ++i) track[i] = markers.position(i, k);
  return track;
}

bool never_seen(const std::vector<Vec3>& points) {
  return std::none_of(points.begin(), points.end(), [](const Vec3& p) { return seen(p); });
}

void note_unseen(const std::string& name, const std::vector<Vec3>& points,
                 std::vector<std::string>& problems) {
  const auto count = std::count_if(points.begin(), points.end(), [](auto& p) { return !seen(p); });
  if (count == 0) return;
  problems.push_back(fmt::format("{}: not seen in {} of {} frames", name, count, points.size()));
}

Residual residual_of(const std::string& name, const std::vector<double>& distances) {
  Residual residual{name, 0, 0};
  double sum = 0;
  int count = 0;
  for (const double distance : distances) {
    if (!std::isfinite(distance)) continue;
    sum += distance * distance;
    residual.max_m = std::max(residual.max_m, distance);
    ++count;
  }
  residual.rms_m = count == 0 ? kNotSeen : std::sqrt(sum / count);
  if (count == 0) residual.max_m = kNotSeen;
  return residual;
}

/// world_from_static of one four-marker cluster on the clock; NaN where it was not seen.
std::vector<Pose> cluster_motion(const MarkerStream& markers, const std::string& cluster,
                                 const StaticTrial& landmark, const Clock& clock,
                                 const ReconstructOptions& options, HumanMotion& motion) {
  std::vector<Vec3> still;
  std::vector<std::vector<Vec3>> tracks;
  for (int k = 1; k <= 4; ++k) {
    const std::string name = fmt::format("{}{}", cluster, k);
    still.push_back(landmark(name));
    tracks.push_back(track_of(markers, name));
  }
  complete_cluster(still, tracks);
  for (auto& track : tracks) track = on_clock(markers.time, track, clock, options);

  std::vector<Pose> poses;
  std::vector<double> misfit;
  std::vector<Vec3> origin;
  for (std::size_t i = 0; i < clock.count; ++i) {
    std::vector<Vec3> now;
    for (const auto& track : tracks) now.push_back(track[i]);
    poses.push_back(fit_rigid(still, now));
    origin.push_back(poses.back().translation());
    misfit.push_back(rigid_residual(poses.back(), still, now));
  }
  if (landmark.given()) {
    note_unseen(fmt::format("cluster {} (three of its markers needed)", cluster), origin,
                motion.problems);
  }
  // The trials' own static poses fit to 0.2-1.1 mm; another subject's forearm plate is off by 9.
  constexpr double kMisfit = 0.004;
  const Residual& fit =
      motion.residuals.emplace_back(residual_of(fmt::format("{} rigid fit", cluster), misfit));
  if (fit.rms_m > kMisfit) {
    motion.problems.push_back(fmt::format(
        "cluster {} does not fit the static trial (rms {:.1f} mm): moved, or not this subject's",
        cluster, 1000 * fit.rms_m));
  }
  return poses;
}

std::vector<Vec3> carry(const std::vector<Pose>& world_from_static, const Vec3& point) {
  std::vector<Vec3> carried;
  for (const Pose& pose : world_from_static) carried.push_back(pose * point);
  return carried;
}

/// Mean of two estimates of one joint centre. If one of them was never seen the other stands alone;
/// in a frame where just one is seen there is none, for switching would be a step of centimetres.
std::vector<Vec3> blended(const std::string& name, const std::vector<Vec3>& a,
                          const std::vector<Vec3>& b, std::vector<Residual>& residuals) {
  if (never_seen(a)) return b;
  if (never_seen(b)) return a;
  std::vector<Vec3> mean;
  std::vector<double> distance;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean.push_back((a[i] + b[i]) / 2);
    distance.push_back((a[i] - b[i]).norm());
  }
  residuals.push_back(residual_of(name, distance));
  return mean;
}

/// Hand frame in the static trial's world: z from the wrist to the finger base, y to the thumb's
/// side (from the ulnar to the radial styloid, made orthogonal), x = y × z out of a right palm.
Eigen::Matrix3d static_from_hand(const Vec3& wrist, const Vec3& finger_base, const Vec3& radial,
                                 const Vec3& ulnar) {
  const Vec3 z = (finger_base - wrist).normalized();
  const Vec3 across = radial - ulnar;
  const Vec3 y = (across - z * z.dot(across)).normalized();
  Eigen::Matrix3d frame;
  frame << y.cross(z), y, z;
  return frame;
}

/// From thumb to index marker in every frame. Where one of them is hidden the line turns with the
/// hand, from what it was in the hand's frame before the gap to what it is after; NaN where the
/// hand is not seen either.
std::vector<Vec3> line_of_tips(const std::vector<Vec3>& thumb, const std::vector<Vec3>& index,
                               const std::vector<Quat>& world_from_hand) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  const std::size_t n = thumb.size();
  std::vector<Vec3> line(n), in_hand(n, unseen_point());
  std::vector<std::size_t> before(n, kNone), after(n, kNone);
  std::size_t last = kNone;
  for (std::size_t i = 0; i < n; ++i) {
    line[i] = index[i] - thumb[i];
    if (seen(world_from_hand[i])) in_hand[i] = world_from_hand[i].conjugate() * line[i];
    if (seen(in_hand[i])) last = i;
    before[i] = last;
  }
  last = kNone;
  for (std::size_t i = n; i-- > 0;) {
    if (seen(in_hand[i])) last = i;
    after[i] = last;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = before[i] == kNone ? after[i] : before[i];
    const std::size_t b = after[i] == kNone ? before[i] : after[i];
    if (seen(line[i]) || a == kNone || !seen(world_from_hand[i])) continue;
    const double share = a == b ? 0 : static_cast<double>(i - a) / static_cast<double>(b - a);
    line[i] = world_from_hand[i] * Vec3((1 - share) * in_hand[a] + share * in_hand[b]);
  }
  return line;
}

/// Marker tracks of thumb and index moved onto the fingers' axes, each towards the other, at most
/// to the middle between them.
void set_tips(const std::vector<Vec3>& thumb, const std::vector<Vec3>& index,
              const ReconstructOptions& options, HumanMotion& motion) {
  if (never_seen(thumb) || never_seen(index)) {
    motion.problems.push_back("one tip alone: its marker is taken for the finger's axis");
    for (std::size_t i = 0; i < thumb.size(); ++i) {
      motion.tip(i, kThumb) = thumb[i];
      motion.tip(i, kIndex) = index[i];
    }
    return;
  }
  const double total = options.thumb_marker_to_axis_m + options.index_marker_to_axis_m;
  const std::vector<Vec3> line = line_of_tips(thumb, index, motion.wrist_orientation);
  for (std::size_t i = 0; i < thumb.size(); ++i) {
    const double distance = line[i].norm();
    // Without the line a tip stays NaN: on the nail it would be a step beside those on the axis.
    const Vec3 step = distance > total ? Vec3(line[i] / distance) : Vec3(line[i] / total);
    motion.tip(i, kThumb) = thumb[i] + options.thumb_marker_to_axis_m * step;
    motion.tip(i, kIndex) = index[i] - options.index_marker_to_axis_m * step;
  }
}

}  // namespace

HumanMotion motion_from_markers(const Demonstration& demonstration,
                                const ReconstructOptions& options) {
  const MarkerStream& markers = *demonstration.streams.markers;
  const Clock clock = clock_over({&markers.time}, options.rate_hz);
  HumanMotion motion = unseen_motion(clock);
  const StaticTrial landmark(demonstration.calibration.markers, motion.problems);

  const Vec3 shoulder = landmark("RGTH");
  const Vec3 elbow = (landmark("RLEP") + landmark("RMEP")) / 2;
  const Vec3 radial = landmark("RSPR"), ulnar = landmark("RSPU");
  const Vec3 wrist = (radial + ulnar) / 2;
  const auto upper_arm = cluster_motion(markers, "RUAR", landmark, clock, options, motion);
  const auto forearm = cluster_motion(markers, "RLAR", landmark, clock, options, motion);
  const auto hand = cluster_motion(markers, "RHAN", landmark, clock, options, motion);

  motion.shoulder = carry(upper_arm, shoulder);
  motion.elbow = blended("elbow, RUAR against RLAR", carry(upper_arm, elbow), carry(forearm, elbow),
                         motion.residuals);
  motion.wrist = blended("wrist, RLAR against RHAN", carry(forearm, wrist), carry(hand, wrist),
                         motion.residuals);
  const double length = (elbow - shoulder).norm();
  for (std::size_t i = 0; i < clock.count; ++i) {
    // A bone keeps its length: skin that slides under the clusters must not stretch it.
    if (seen(motion.shoulder[i])) {
      motion.elbow[i] =
          motion.shoulder[i] + length * (motion.elbow[i] - motion.shoulder[i]).normalized();
    }
  }
  const Eigen::Matrix3d hand_frame = static_from_hand(wrist, landmark("RFB"), radial, ulnar);
  for (std::size_t i = 0; i < clock.count; ++i) {
    const Eigen::Matrix3d world_from_hand = hand[i].linear() * hand_frame;
    if (!world_from_hand.allFinite()) continue;
    motion.wrist_orientation[i] = Quat(world_from_hand).normalized();
    if (i > 0 && seen(motion.wrist_orientation[i - 1]) &&
        motion.wrist_orientation[i].dot(motion.wrist_orientation[i - 1]) < 0) {
      motion.wrist_orientation[i].coeffs() *= -1;
    }
  }
  const auto thumb = on_clock(markers.time, track_of(markers, "RTHUM"), clock, options);
  const auto index = on_clock(markers.time, track_of(markers, "RFTP"), clock, options);
  note_unseen("RTHUM", thumb, motion.problems);
  note_unseen("RFTP", index, motion.problems);
  set_tips(thumb, index, options, motion);
  return motion;
}

}  // namespace morphe
