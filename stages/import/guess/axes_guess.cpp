#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stages/import/guess/body_cues.hpp"
#include "stages/import/guess/constants.hpp"
#include "stages/import/guess/convention_guess.hpp"
#include "stages/import/recording/conventions.hpp"

namespace morphe::imports {
namespace {

double weighted_cosines(const std::vector<BodyCue>& cues, const Eigen::Matrix3d& rotation) {
  double sum = 0;
  for (const BodyCue& cue : cues) {
    const double cosine = cue.world.dot(rotation * cue.recorded);
    sum += cue.weight * (cue.undirected ? std::abs(cosine) : cosine);
  }
  return sum;
}

/// Returns the cues of trunk and arms that identify axes; those of a hand alone do not.
std::vector<BodyCue> axes_cues(const RecordedPoints& points) {
  std::vector<BodyCue> cues = body_cues(points);
  std::erase_if(cues, [](const BodyCue& cue) {
    return cue.source == CueSource::hand || cue.source == CueSource::reach ||
           cue.purpose == CuePurpose::heading;
  });
  return cues;
}

constexpr const char* kAxisWords[] = {"x", "y", "z", "-x", "-y", "-z"};

}  // namespace

Guess guess_axes(const RecordedPoints& points) {
  const std::vector<BodyCue> cues = axes_cues(points);
  if (cues.empty()) return {};
  struct Choice {
    std::string axes;
    double agreement;
  };
  std::vector<Choice> choices;
  double weight_sum = 0;
  for (const BodyCue& cue : cues) weight_sum += cue.weight;
  for (int right = 0; right < 6; ++right) {
    for (int forward = 0; forward < 6; ++forward) {
      for (int up = 0; up < 6; ++up) {
        if (right % 3 == forward % 3 || right % 3 == up % 3 || forward % 3 == up % 3) continue;
        const std::string axes =
            fmt::format("{} {} {}", kAxisWords[right], kAxisWords[forward], kAxisWords[up]);
        Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
        for (const auto& [row, axis] : {std::pair(0, right), {1, forward}, {2, up}})
          rotation(row, axis % 3) = axis < 3 ? 1 : -1;
        if (rotation.determinant() > 0)
          choices.push_back({axes, weighted_cosines(cues, rotation) / weight_sum});
      }
    }
  }
  std::ranges::stable_sort(choices, std::ranges::greater{}, &Choice::agreement);
  const Eigen::Matrix3d rotation = world_from_recorded(choices[0].axes, "");
  std::vector<std::string> reasons;
  for (const BodyCue& cue : cues) {
    const double cosine = cue.world.dot(rotation * cue.recorded);
    const bool agrees = (cue.undirected ? std::abs(cosine) : cosine) > kMinCueCosine;
    if (agrees && std::ranges::find(reasons, cue.description) == reasons.end())
      reasons.emplace_back(cue.description);
  }
  const double margin = choices[0].agreement - choices[1].agreement;
  const bool sure = margin > kSureMargin && choices[0].agreement > kMinAgreement;
  return {choices[0].axes,
          sure                     ? Confidence::sure
          : margin > kLikelyMargin ? Confidence::likely
                                   : Confidence::guessed,
          fmt::format("{}", fmt::join(reasons, "; "))};
}

}  // namespace morphe::imports
