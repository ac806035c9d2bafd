#include "core/collision/stl_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace morphe::collision {
namespace {

constexpr std::size_t kTitleBytes = 80, kFacetBytes = 50, kNormalBytes = 12;
constexpr std::size_t kHeaderBytes = kTitleBytes + sizeof(std::uint32_t);  ///< with facet count
constexpr std::string_view kBlanks = " \t\r\n\v\f", kByteOrderMark = "\xEF\xBB\xBF";

void add_vertex(const float (&vertex)[3], SceneObject& mesh) {
  // Adding 0 turns -0 into 0.
  mesh.vertices.emplace_back(vertex[0] + 0.0f, vertex[1] + 0.0f, vertex[2] + 0.0f);
  const std::ptrdiff_t count = std::ssize(mesh.vertices);
  if (count % 3 == 0) mesh.triangles.emplace_back(count - 3, count - 2, count - 1);
}

/// Returns the number of facets in the header of a binary file.
std::uint32_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + kTitleBytes, sizeof count);
  return count;
}

std::string read_binary(std::string_view bytes, SceneObject& mesh) {
  if (bytes.size() < kHeaderBytes) {
    return fmt::format("the header of a binary STL has {} bytes, but the file has only {}",
                       kHeaderBytes, bytes.size());
  }
  const std::uint32_t count = facet_count(bytes);
  bytes.remove_prefix(kHeaderBytes);
  if (bytes.size() / kFacetBytes < count)
    return fmt::format("the header states {} facets, but the file has only {}", count,
                       bytes.size() / kFacetBytes);
  for (std::uint32_t k = 0; k < count; ++k) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      float vertex[3];
      std::memcpy(vertex, bytes.data() + k * kFacetBytes + kNormalBytes + corner * sizeof vertex,
                  sizeof vertex);
      add_vertex(vertex, mesh);
    }
  }
  return "";
}

/// Splits a text into words and counts lines.
struct Words {
  std::string_view rest;
  int line = 1;

  std::string_view next() {
    while (!rest.empty() && kBlanks.find(rest[0]) != std::string_view::npos) {
      line += rest[0] == '\n' ? 1 : 0;
      rest.remove_prefix(1);
    }
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
    rest.remove_prefix(word.size());
    return word;
  }
};

/// Returns true if a text is this word, given in lower case, in any case.
bool is_word(std::string_view text, std::string_view word) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return std::ranges::equal(text, word, {}, lower);
}

std::string_view without_mark(std::string_view bytes) {
  return bytes.substr(bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
}

/// Returns true if the file has the length that its number of facets requires, because a binary
/// header may begin with any bytes, if it has a zero byte, which no text has, or if its first word
/// does not begin with "solid".
bool is_binary(std::string_view bytes) {
  const bool is_whole =
      bytes.size() >= kHeaderBytes &&
      bytes.size() - kHeaderBytes == kFacetBytes * std::size_t{facet_count(bytes)};
  if (bytes.empty() || is_whole) return is_whole;
  return bytes.find('\0') != std::string_view::npos ||
         !is_word(Words{without_mark(bytes)}.next().substr(0, 5), "solid");
}

bool read_number(std::string_view word, float& number) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

/// Reads the numbers after each "vertex" and counts the vertices before each "endfacet". The rest
/// of a line after "solid" or "endsolid" is skipped, because a name may be any text.
std::string read_text(std::string_view text, SceneObject& mesh) {
  Words words{text};
  int facet_vertex_count = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (is_word(word, "solid") || is_word(word, "endsolid")) {
      words.rest.remove_prefix(std::min(words.rest.find('\n'), words.rest.size()));
    } else if (is_word(word, "endfacet")) {
      if (facet_vertex_count != 3) {
        return fmt::format("line {}: the facet that ends here has {} {}, not 3", words.line,
                           facet_vertex_count, facet_vertex_count == 1 ? "vertex" : "vertices");
      }
      facet_vertex_count = 0;
    } else if (is_word(word, "vertex")) {
      const int line = words.line;
      float vertex[3];
      for (float& value : vertex) {
        if (!read_number(words.next(), value))
          return fmt::format("line {}: 'vertex' must be followed by 3 numbers", line);
      }
      add_vertex(vertex, mesh);
      ++facet_vertex_count;
    }
  }
  return mesh.vertices.size() % 3 == 0 ? "" : "the file ends within a facet";
}

}  // namespace

std::string read_stl(const std::filesystem::path& file, SceneObject& mesh,
                     const files::GivenFiles* given) {
  const std::string bytes = files::read_bytes(file, given);
  return is_binary(bytes) ? read_binary(bytes, mesh) : read_text(without_mark(bytes), mesh);
}

}  // namespace morphe::collision
