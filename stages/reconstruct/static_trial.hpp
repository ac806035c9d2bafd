#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// The mean positions of the markers in a static trial.
class StaticTrial {
 public:
  /// Computes the mean positions of a trial, if there is one.
  explicit StaticTrial(const std::optional<MarkerStream>& trial);

  /// Returns true if there is a static trial.
  bool available() const { return given_; }
  /// Returns the mean position [m], unseen if the marker was never seen. A marker that moved is
  /// reported once.
  Vec3 at(const std::string& marker, std::vector<std::string>& problems);

 private:
  struct Marker {
    Vec3 mean;
    double moved_m = 0;
  };
  bool given_ = false;
  std::map<std::string, Marker> markers_;
};

}  // namespace morphe::reconstruct
