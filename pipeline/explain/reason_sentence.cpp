#include "pipeline/explain/reason_sentence.hpp"

#include <array>

namespace morphe::explain {

std::string_view reason_sentence(Reason reason) {
  constexpr std::array<std::string_view, enum_count<Reason>()> kSentences{
      "",
      "Nothing was tried yet.",
      "The demonstration has no complete reach, or it could not be rebuilt.",
      "The person's shoulder was not seen in the whole movement.",
      "No fingertip was seen, or the movement has fewer than five frames.",
      "No person's arm could have been where the rebuilt one is.",
      "The robot touches something at the first sample, in every posture found.",
      "At some time every posture found that holds the goals touches something.",
      "At some time no posture found holds the goals, obstacles or not.",
      "Something is in the way, and no way around it was found.",
      "The motion between two samples touches something.",
      "The path is free, the smooth curve through it is not.",
      "A joint would go beyond its limits.",
      "The joints jump from one frame to the next, and nothing closed the gap.",
      "A fingertip is farther from its goal than its phase allows.",
      "What was to be timed is no path of this robot.",
      "The path cannot be followed in the time asked for.",
      "There is no free way from the home posture to the first sample.",
      "There is no free way from the last sample back to the home posture.",
      "An object of the scene stands relative to something that is not there."};
  return kSentences.at(static_cast<std::size_t>(reason));
}

}  // namespace morphe::explain
