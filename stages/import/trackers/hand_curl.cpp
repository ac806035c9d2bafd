#include "stages/import/trackers/hand_curl.hpp"

#include <cmath>

namespace morphe::imports {

// With f from the wrist to the middle knuckle and a from the little knuckle to that of the index, f
// x a points out of the back of a right hand and out of the palm of a left one; fingers curl
// towards the palm.
double finger_curl_m(const Array2D<Vec3>& keypoints) {
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < keypoints.rows; ++row) {
    const Vec3 along = keypoints(row, 9) - keypoints(row, 0);
    const Vec3 across = keypoints(row, 5) - keypoints(row, 17);
    const Vec3 back = along.cross(across).normalized();
    for (const std::size_t knuckle : {5U, 9U, 13U, 17U}) {
      const double out = (keypoints(row, knuckle + 3) - keypoints(row, knuckle)).dot(back);
      if (std::isnan(out)) continue;
      sum += out;
      ++count;
    }
  }
  return count > 0 ? sum / count : kUnknown;
}

}  // namespace morphe::imports
