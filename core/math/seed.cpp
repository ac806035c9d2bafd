#include "core/math/seed.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

#include "core/files/sha256.hpp"

namespace morphe::math {

std::uint64_t seed_from(std::uint64_t seed, std::string_view name) {
  const std::string digest = files::sha256(fmt::format("{}/{}", seed, name));
  std::uint64_t value = 0;
  std::from_chars(digest.data(), digest.data() + 16, value, 16);
  return value;
}

std::uint64_t seed_from(std::uint64_t seed, std::string_view name, std::size_t number) {
  return seed_from(seed, fmt::format("{}/{}", name, number));
}

}  // namespace morphe::math
