#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/math/rigid.hpp"
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

struct AxesChoice {
  std::string axes;
  Eigen::Matrix3d world_from_recorded;  ///< a reflection if the axes are left-handed
  double agreement;
};

/// Returns the 24 choices of axes of one handedness, those that agree best first.
std::vector<AxesChoice> axes_choices(const std::vector<BodyCue>& cues, Handedness handedness) {
  std::vector<AxesChoice> choices;
  double weight_sum = 0;
  for (const BodyCue& cue : cues) weight_sum += cue.weight;
  for (int right = 0; right < 6; ++right) {
    for (int forward = 0; forward < 6; ++forward) {
      for (int up = 0; up < 6; ++up) {
        if (right % 3 == forward % 3 || right % 3 == up % 3 || forward % 3 == up % 3) continue;
        const std::string axes =
            fmt::format("{} {} {}", kAxisWords[right], kAxisWords[forward], kAxisWords[up]);
        const Eigen::Matrix3d rotation = world_from_points(axes, "");
        if ((rotation.determinant() > 0) == (handedness == Handedness::right))
          choices.push_back({axes, rotation, weighted_cosines(cues, rotation) / weight_sum});
      }
    }
  }
  std::ranges::stable_sort(choices, std::ranges::greater{}, &AxesChoice::agreement);
  return choices;
}

}  // namespace

AxesAgreement axes_agreement(const RecordedPoints& points) {
  const std::vector<BodyCue> cues = axes_cues(points);
  if (cues.empty()) return {};
  return {axes_choices(cues, Handedness::right).front().agreement,
          axes_choices(cues, Handedness::left).front().agreement};
}

BodyVertical body_vertical(const RecordedPoints& points) {
  std::vector<BodyCue> cues = axes_cues(points);
  std::erase_if(cues, [](const BodyCue& cue) { return cue.undirected; });
  if (cues.size() < 2) return {};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double weight_sum = 0;
  bool trunk_known = false;
  for (const BodyCue& cue : cues) {
    covariance += cue.weight * cue.world * cue.recorded.transpose();
    weight_sum += cue.weight;
    trunk_known |= cue.source == CueSource::trunk;
  }
  const Eigen::Matrix3d rotation = math::nearest_rotation(covariance);
  return {rotation.transpose() * Vec3::UnitZ(), weighted_cosines(cues, rotation) / weight_sum,
          trunk_known};
}

Guess guess_axes(const RecordedPoints& points, Handedness handedness) {
  const std::vector<BodyCue> cues = axes_cues(points);
  if (cues.empty()) return {};
  const std::vector<AxesChoice> choices = axes_choices(cues, handedness);
  std::vector<std::string> reasons;
  for (const BodyCue& cue : cues) {
    const double cosine = cue.world.dot(choices[0].world_from_recorded * cue.recorded);
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
