#pragma once

#include <string_view>

#include "core/motion/reason.hpp"

namespace morphe::explain {

/// What a reason means, as a sentence; "" for none.
std::string_view sentence_of(Reason reason);

}  // namespace morphe::explain
