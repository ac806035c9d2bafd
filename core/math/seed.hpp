#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace morphe::math {

/// Returns the first 64 bits of SHA-256("<seed>/<name>"), independent of the order of calls.
std::uint64_t seed_from(std::uint64_t seed, std::string_view name);

/// Returns the seed for "<name>/<number>", for numbered attempts, frames or searches.
std::uint64_t seed_from(std::uint64_t seed, std::string_view name, std::size_t number);

}  // namespace morphe::math
