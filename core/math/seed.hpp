#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace morphe::math {

/// First 64 bits of SHA-256("<seed>/<name>"): seeds that depend on names, not on order.
std::uint64_t seed_from(std::uint64_t seed, std::string_view name);

/// Of "<name>/<number>": the seeds of a row of attempts, frames or searches.
std::uint64_t seed_from(std::uint64_t seed, std::string_view name, std::size_t number);

}  // namespace morphe::math
