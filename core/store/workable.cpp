#include "core/store/workable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace morphe::store {
namespace {

constexpr double kMostRate_hz = 1e5, kLongest_s = 6 * 3600.0, kLatest_s = 1e12;
constexpr double kFarthest_m = 1e6, kLargest_m = 1e4, kLongestBone_m = 3;
constexpr double kLeastNorm = 0.5, kMostNorm = 2;

bool in_reach(const Vec3& point) { return point.cwiseAbs().maxCoeff() <= kFarthest_m; }
bool is_rotation(const Quat& q) {
  const double norm = q.norm();
  return norm >= kLeastNorm && norm <= kMostNorm;
}
bool was_seen(const Vec3& point) { return !point.array().isNaN().any(); }
bool was_seen(const Quat& q) { return !q.coeffs().array().isNaN().any(); }

/// Keeps the first fault; the streams' times are looked at together in the end.
class Look {
 public:
  void require(bool holds, const std::string& place, const std::string& message) {
    if (!holds && fault_.empty()) fault_ = fmt::format("{}: {}", place, message);
  }

  void time(const std::string& path, const std::vector<double>& time) {
    for (std::size_t i = 0; i < time.size(); ++i) {
      if (std::abs(time[i]) <= kLatest_s && (i == 0 || time[i] > time[i - 1])) continue;
      require(false, path + "time",
              std::abs(time[i]) <= kLatest_s
                  ? fmt::format("row {}: does not follow the row before", i + 1)
                  : fmt::format("row {}: {} is no time", i + 1, time[i]));
      return;
    }
    if (time.size() < 2) return;
    const double rate_hz = static_cast<double>(time.size() - 1) / (time.back() - time.front());
    require(rate_hz <= kMostRate_hz, path + "time",
            fmt::format("{:.4g} rows a second: more than {:.0f} cannot be", rate_hz, kMostRate_hz));
  }

  void span(const std::string& path, const std::vector<double>& time) {
    if (time.empty() || !fault_.empty()) return;
    first_s_ = std::fmin(first_s_, time.front());
    last_s_ = std::fmax(last_s_, time.back());
    require(last_s_ - first_s_ <= kLongest_s, path + "time",
            fmt::format("the streams span {:.6g} s: more than {:.0f} are not worked on",
                        last_s_ - first_s_, kLongest_s));
  }

  void streams(const Streams& s, const std::string& path) {
    first_s_ = last_s_ = kNotSeen;
    if (s.markers) {
      times(path + "markers/", s.markers->time);
      points(path + "markers/", s.markers->position);
    }
    if (s.sensors) bodies(path + "sensors/", *s.sensors);
    if (s.skeleton) bodies(path + "skeleton/", *s.skeleton);
    if (s.arm_angles) times(path + "arm_angles/", s.arm_angles->time);
    if (s.hand) {
      times(path + "hand/", s.hand->time);
      points(path + "hand/", s.hand->position);
    }
  }

  void object(const SceneObject& o) {
    const std::string path = fmt::format("objects/{}/", o.name);
    time(path, o.time);
    for (std::size_t i = 0; i < o.position.size(); ++i)
      require(in_reach(o.position[i]), path + "position",
              fmt::format("row {}: is no place", i + 1));
    for (std::size_t i = 0; i < o.orientation.size(); ++i)
      require(is_rotation(o.orientation[i]), path + "orientation",
              fmt::format("row {}: is no rotation", i + 1));
    for (const double length : o.size)
      require(length > 0 && length <= kLargest_m, path + "@size",
              fmt::format("{} m is no size", length));
    for (const Vec3& vertex : o.vertices)
      require(in_reach(vertex), path + "vertices", "one is no place");
  }

  void bone(const char* name, const std::optional<double>& length_m) {
    require(!length_m || (*length_m > 0 && *length_m <= kLongestBone_m), fmt::format("@{}", name),
            fmt::format("{} m is no length of a person", length_m.value_or(0)));
  }

  const std::string& fault() const { return fault_; }

 private:
  static bool good(const Vec3& point) { return in_reach(point); }
  static bool good(const Quat& q) { return is_rotation(q); }
  static const char* complaint(const Vec3&) { return "a point is no place"; }
  static const char* complaint(const Quat&) { return "a rotation is none"; }

  template <class T>
  void rows(const std::string& place, const Table<T>& table) {
    const auto wrong = std::ranges::find_if(
        table.values, [](const T& value) { return was_seen(value) && !good(value); });
    if (wrong == table.values.end()) return;
    require(false, place,
            fmt::format("row {}: {}",
                        static_cast<std::size_t>(wrong - table.values.begin()) / table.cols + 1,
                        complaint(*wrong)));
  }

  void times(const std::string& path, const std::vector<double>& time) {
    this->time(path, time);
    span(path, time);
  }
  void points(const std::string& path, const Table<Vec3>& table) { rows(path + "position", table); }
  void bodies(const std::string& path, const BodyStream& bodies) {
    times(path, bodies.time);
    points(path, bodies.position);
    rows(path + "orientation", bodies.orientation);
  }

  std::string fault_;
  double first_s_ = kNotSeen, last_s_ = kNotSeen;
};

}  // namespace

std::string why_unworkable(const Demonstration& d) {
  Look look;
  look.streams(d.streams, "");
  look.streams(d.calibration, "calibration/");
  for (const SceneObject& object : d.objects) look.object(object);
  look.bone("upper_arm", d.upper_arm);
  look.bone("forearm", d.forearm);
  look.bone("hand_length", d.hand_length);
  look.bone("hand_breadth", d.hand_breadth);
  for (const Label& label : d.labels)
    look.require(!(std::abs(label.begin_s) > kLatest_s) && !(std::abs(label.end_s) > kLatest_s),
                 "labels", "one has no time");
  return look.fault();
}

}  // namespace morphe::store
