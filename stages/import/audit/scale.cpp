#include <fmt/format.h>

#include "stages/import/audit/checks.hpp"
#include "stages/import/audit/constants.hpp"
#include "stages/import/audit/sampled_points.hpp"
#include "stages/import/guess/body_lengths.hpp"

namespace morphe::imports {
namespace {

Doubt wrong_length(const char* subject, double ratio, bool too_small, std::string text) {
  return {.flag = {.code = FlagCode::scale,
                   .subject = subject,
                   .value = ratio,
                   .limit = too_small ? kMinLengthRatio : kMaxLengthRatio,
                   .unit = "1",
                   .text = std::move(text)}};
}

std::string measured(const BodyLength& length) {
  return fmt::format("{} measures {} instead of about {}", length.name,
                     length_text(length.recorded), length_text(length.usual_m));
}

}  // namespace

std::vector<Doubt> check_scale(const Demonstration& recording, const AuditInput& input) {
  const RecordedPoints points = sampled_points(recording.streams, recording.hand);
  std::vector<BodyLength> lengths = body_lengths(points);
  const double size = relative_size(lengths);
  if (size < kMinRelativeSize || size > kMaxRelativeSize) {
    const bool small = size < kMinRelativeSize;
    Doubt doubt = wrong_length("", size, small,
                               fmt::format("the body has {:.3g} of the size of an adult: {}", size,
                                           measured(lengths.front())));
    doubt.flag.limit = small ? kMinRelativeSize : kMaxRelativeSize;
    if (!input.unit_given) doubt.question = {"unit", ""};
    return {doubt};
  }
  std::vector<Doubt> doubts;
  if (size > kMaxAdultSize && !recording.streams.sensors) {
    doubts.push_back(wrong_length("", size, false,
                                  fmt::format("the body has {:.3g} of the size of an adult: {}; is "
                                              "the calibration right?",
                                              size, measured(lengths.front()))));
    doubts.back().flag.limit = kMaxAdultSize;
  }
  const std::vector<BodyLength> palms = palm_lengths(points);
  lengths.insert(lengths.end(), palms.begin(), palms.end());
  for (const BodyLength& length : lengths) {
    const bool small = length.ratio() < kMinLengthRatio;
    if (!small && length.ratio() <= kMaxLengthRatio) continue;
    doubts.push_back(wrong_length(length.name, length.ratio(), small,
                                  measured(length) + ": the names cannot be right"));
  }
  return doubts;
}

}  // namespace morphe::imports
