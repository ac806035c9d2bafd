#include "stages/import/trackers/hand_curl.hpp"

#include <cmath>

namespace morphe::imports {

double finger_curl_m(const Array2D<Vec3>& keypoints) {
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < keypoints.rows; ++row) {
    const Vec3 along = keypoints(row, 9) - keypoints(row, 0);
    const Vec3 across = keypoints(row, 5) - keypoints(row, 17);
    const Vec3 back = along.cross(across).normalized();
    for (const int knuckle : {5, 9, 13, 17}) {
      const double curl = (keypoints(row, knuckle + 3) - keypoints(row, knuckle)).dot(back);
      if (std::isnan(curl)) continue;
      sum += curl;
      ++count;
    }
  }
  return count > 0 ? sum / count : kUnknown;
}

}  // namespace morphe::imports
