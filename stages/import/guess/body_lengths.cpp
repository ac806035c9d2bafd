#include "stages/import/guess/body_lengths.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/math/statistics.hpp"

namespace morphe::imports {
namespace {

struct LengthCollector {
  const RecordedPoints& points;
  std::vector<BodyLength> lengths = {};

  void add(const char* name, const std::string& from, const std::string& to, double usual_m) {
    const double length = math::median_distance(mean_track(points, from), mean_track(points, to));
    if (length > 0) lengths.push_back({name, length, usual_m});
  }
};

}  // namespace

std::vector<BodyLength> body_lengths(const RecordedPoints& points) {
  LengthCollector body{points};
  body.add("shoulders", "left shoulder", "right shoulder", 0.36);
  for (const std::string side : {"right ", "left "}) {
    body.add("upper arm", side + "shoulder", side + "elbow", 0.29);
    body.add("forearm", side + "elbow", side + "wrist", 0.26);
    body.add("hand", side + "wrist", side + "middle tip", 0.18);
    body.add("hand", side + "wrist", side + "index tip", 0.17);
    body.add("upper arm to forearm", side + "upper arm", side + "forearm", 0.25);
    body.add("forearm to hand", side + "forearm", side + "hand", 0.2);
    body.add("hand to index tip", side + "hand", side + "index tip", 0.12);
    for (const std::string finger : {"index", "middle", "ring"})
      body.add("finger", side + finger + " mcp", side + finger + " tip", 0.09);
  }
  return body.lengths;
}

std::vector<BodyLength> palm_lengths(const RecordedPoints& points) {
  LengthCollector palms{points};
  for (const std::string side : {"right ", "left "}) {
    palms.add("palm", side + "wrist", side + "index mcp", 0.095);
    palms.add("palm", side + "wrist", side + "middle mcp", 0.095);
  }
  return palms.lengths;
}

double relative_size(const std::vector<BodyLength>& lengths) {
  double log_sum = 0;
  for (const BodyLength& length : lengths) log_sum += std::log(length.ratio());
  return std::exp(log_sum / static_cast<double>(lengths.size()));
}

std::string length_text(double metres) {
  return metres < 0.995 ? fmt::format("{:.0f} mm", 1000 * metres) : fmt::format("{:.2f} m", metres);
}

}  // namespace morphe::imports
