#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/motion/demonstration.hpp"

namespace morphe::reconstruct {

/// Where each marker stood in a static trial, on average.
class StaticTrial {
 public:
  explicit StaticTrial(const std::optional<MarkerStream>& trial);

  bool given() const { return given_; }
  /// Mean position [m], unseen if it never was. One that did not keep still is said once.
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
