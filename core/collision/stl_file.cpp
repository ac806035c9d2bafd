#include "core/collision/stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>

namespace morphe::collision {
namespace {

constexpr std::size_t kHeader = 80, kFacet = 50, kNormal = 12;

void add_corner(const float (&corner)[3], SceneObject& mesh) {
  mesh.vertices.emplace_back(corner[0] + 0.0f, corner[1] + 0.0f, corner[2] + 0.0f);  // avoids -0
  const int count = static_cast<int>(mesh.vertices.size());
  if (count % 3 == 0) mesh.triangles.emplace_back(count - 3, count - 2, count - 1);
}

/// Decides by the length of the file, because text and binary files may begin with any bytes.
bool is_binary(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() < kHeader + sizeof count) return false;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  return bytes.size() == kHeader + sizeof count + kFacet * std::size_t{count} ||
         !bytes.starts_with("solid");
}

std::string read_binary(std::string_view bytes, SceneObject& mesh) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kHeader, sizeof count);
  bytes.remove_prefix(kHeader + sizeof count);
  if (bytes.size() / kFacet < count)
    return fmt::format("the header states {} facets, but the file has only {}", count,
                       bytes.size() / kFacet);
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      float at[3];
      std::memcpy(at, bytes.data() + k * kFacet + kNormal + corner * sizeof at, sizeof at);
      add_corner(at, mesh);
    }
  }
  return "";
}

/// Splits a text into words and keeps the line of the last one.
struct Words {
  std::string_view rest;
  int line = 1;

  std::string_view next() {
    while (!rest.empty() && std::string_view(" \t\r\n").find(rest[0]) != std::string_view::npos) {
      line += rest[0] == '\n' ? 1 : 0;
      rest.remove_prefix(1);
    }
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r\n"));
    rest.remove_prefix(word.size());
    return word;
  }
};

bool read_number(std::string_view word, float& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

/// Reads only the words after "vertex". Names may contain any text, but are on a line that begins
/// with "solid" or "endsolid".
std::string read_text(std::string_view text, SceneObject& mesh) {
  Words words{text};
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "solid" || word == "endsolid") {
      words.rest.remove_prefix(std::min(words.rest.find('\n'), words.rest.size()));
    } else if (word == "endfacet" && mesh.vertices.size() % 3 != 0) {
      return fmt::format("line {}: a facet must have 3 corners", words.line);
    } else if (word == "vertex") {
      float corner[3];
      for (float& value : corner) {
        if (!read_number(words.next(), value))
          return fmt::format("line {}: a corner needs 3 numbers", words.line);
      }
      add_corner(corner, mesh);
    }
  }
  return mesh.vertices.size() % 3 == 0 ? "" : "the file ends within a facet";
}

}  // namespace

std::string read_stl(const std::filesystem::path& file, SceneObject& mesh) {
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  if (!stream.good() && !stream.eof()) return "cannot be read";
  return is_binary(bytes) ? read_binary(bytes, mesh) : read_text(bytes, mesh);
}

}  // namespace morphe::collision
