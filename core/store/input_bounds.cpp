#include "core/store/input_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace morphe::store {
namespace {

constexpr double kMaxSampleRate_hz = 1e5, kMaxDuration_s = 6 * 3600.0, kMaxTime_s = 1e12;
constexpr double kMaxCoordinate_m = 1e6, kMaxObjectSize_m = 1e4, kMaxBodySegment_m = 3;
constexpr double kMinQuaternionNorm = 0.5, kMaxQuaternionNorm = 2;

bool is_possible(const Vec3& point) { return (point.array().abs() <= kMaxCoordinate_m).all(); }
bool is_possible(const Quat& q) {
  const double norm = q.norm();
  return norm >= kMinQuaternionNorm && norm <= kMaxQuaternionNorm;
}
bool was_seen(const Vec3& point) { return !point.array().isNaN().any(); }
bool was_seen(const Quat& q) { return !q.coeffs().array().isNaN().any(); }
const char* complaint(const Vec3&) { return "a point is not a possible position"; }
const char* complaint(const Quat&) { return "a rotation is not a unit quaternion"; }

/// Checks bounds and keeps the first violation.
class BoundsChecker {
 public:
  void require(bool holds, const std::string& place, const std::string& message) {
    if (!holds && fault_.empty()) fault_ = fmt::format("{}: {}", place, message);
  }

  void check_times(const std::string& path, const std::vector<double>& time) {
    for (int i = 0; i < std::ssize(time); ++i) {
      const bool possible = std::abs(time[i]) <= kMaxTime_s;
      if (possible && (i == 0 || time[i] > time[i - 1])) continue;
      require(false, path + "time",
              possible ? fmt::format("row {}: must be greater than in the previous row", i + 1)
                       : fmt::format("row {}: {} is not a possible time", i + 1, time[i]));
      return;
    }
    if (time.size() < 2) return;
    const double rate_hz = static_cast<double>(time.size() - 1) / (time.back() - time.front());
    require(rate_hz <= kMaxSampleRate_hz, path + "time",
            fmt::format("{:.4g} rows per second; at most {:.0f} are allowed", rate_hz,
                        kMaxSampleRate_hz));
  }

  void check_span(const std::string& path, const std::vector<double>& time) {
    if (time.empty() || !fault_.empty()) return;
    first_s_ = std::fmin(first_s_, time.front());
    last_s_ = std::fmax(last_s_, time.back());
    require(last_s_ - first_s_ <= kMaxDuration_s, path + "time",
            fmt::format("the streams span {:.6g} s; at most {:.0f} s are allowed",
                        last_s_ - first_s_, kMaxDuration_s));
  }

  void check_streams(const Streams& s, const std::string& path) {
    first_s_ = last_s_ = kUnknown;
    if (s.markers) {
      check_stream_times(path + "markers/", s.markers->time);
      check_points(path + "markers/", s.markers->position);
    }
    if (s.sensors) check_bodies(path + "sensors/", *s.sensors);
    if (s.skeleton) check_bodies(path + "skeleton/", *s.skeleton);
    if (s.arm_angles) check_stream_times(path + "arm_angles/", s.arm_angles->time);
    if (s.hand) {
      check_stream_times(path + "hand/", s.hand->time);
      check_points(path + "hand/", s.hand->position);
    }
  }

  void check_object(const SceneObject& o) {
    const std::string path = fmt::format("objects/{}/", o.name);
    check_times(path, o.time);
    for (int i = 0; i < std::ssize(o.position); ++i)
      require(is_possible(o.position[i]), path + "position",
              fmt::format("row {}: is not a possible position", i + 1));
    for (int i = 0; i < std::ssize(o.orientation); ++i)
      require(is_possible(o.orientation[i]), path + "orientation",
              fmt::format("row {}: is not a rotation", i + 1));
    for (const double length : o.size)
      require(length > 0 && length <= kMaxObjectSize_m, path + "@size",
              fmt::format("{} m is not a possible size", length));
    for (const Vec3& vertex : o.vertices)
      require(is_possible(vertex), path + "vertices", "a vertex is not a possible position");
  }

  void check_segment_length(const char* name, const std::optional<double>& length_m) {
    require(!length_m || (*length_m > 0 && *length_m <= kMaxBodySegment_m),
            fmt::format("@{}", name),
            fmt::format("{} m is not a possible length of a body segment", length_m.value_or(0)));
  }

  const std::string& fault() const { return fault_; }

 private:
  template <class T>
  void check_rows(const std::string& place, const Array2D<T>& table) {
    const auto wrong = std::ranges::find_if(
        table.values, [](const T& value) { return was_seen(value) && !is_possible(value); });
    if (wrong == table.values.end()) return;
    const std::size_t row = (wrong - table.values.begin()) / table.cols;
    require(false, place, fmt::format("row {}: {}", row + 1, complaint(*wrong)));
  }

  void check_stream_times(const std::string& path, const std::vector<double>& time) {
    check_times(path, time);
    check_span(path, time);
  }
  void check_points(const std::string& path, const Array2D<Vec3>& table) {
    check_rows(path + "position", table);
  }
  void check_bodies(const std::string& path, const BodyStream& bodies) {
    check_stream_times(path, bodies.time);
    check_points(path, bodies.position);
    check_rows(path + "orientation", bodies.orientation);
  }

  std::string fault_;
  double first_s_ = kUnknown, last_s_ = kUnknown;
};

}  // namespace

std::string bounds_violation(const Demonstration& d) {
  BoundsChecker checker;
  checker.check_streams(d.streams, "");
  checker.check_streams(d.calibration, "calibration/");
  for (const SceneObject& object : d.objects) checker.check_object(object);
  checker.check_segment_length("upper_arm", d.upper_arm);
  checker.check_segment_length("forearm", d.forearm);
  checker.check_segment_length("hand_length", d.hand_length);
  checker.check_segment_length("hand_breadth", d.hand_breadth);
  for (const Label& label : d.labels)
    checker.require(
        !(std::abs(label.begin_s) > kMaxTime_s) && !(std::abs(label.end_s) > kMaxTime_s), "labels",
        "a label has an impossible time");
  return checker.fault();
}

}  // namespace morphe::store
