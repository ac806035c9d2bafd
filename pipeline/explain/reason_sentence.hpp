#pragma once

#include <string_view>

#include "core/motion/reason.hpp"

namespace morphe::explain {

/// Returns the meaning of a reason as a sentence; "" for Reason::none.
std::string_view reason_sentence(Reason reason);

}  // namespace morphe::explain
