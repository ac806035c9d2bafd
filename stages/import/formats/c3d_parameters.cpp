#include "stages/import/formats/c3d_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "core/files/text_encoding.hpp"
#include "core/motion/input_error.hpp"

namespace morphe::imports {
namespace {

std::string to_upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

bool is_printable(const std::string& text) {
  return std::ranges::none_of(text, [](unsigned char c) { return c < 0x20 || c == 0x7f; });
}

int signed_byte(const C3dBytes& bytes, std::size_t offset) {
  return static_cast<std::int8_t>(bytes.byte(offset));
}

}  // namespace

C3dParameters::C3dParameters(const C3dBytes& bytes, std::size_t start, std::size_t section_end)
    : bytes_(bytes) {
  struct Named {
    int group;
    std::string name;
    Record record;
  };
  std::map<int, std::string> groups;
  std::vector<Named> parameters;
  for (std::size_t offset = start + 4; offset + 2 < section_end;) {
    const int length = std::abs(signed_byte(bytes, offset));
    if (length == 0) break;
    const int group = signed_byte(bytes, offset + 1);
    const std::string name = to_upper(bytes.text(offset + 2, length));
    if (!is_printable(name)) bytes.fail(offset + 2, "a parameter's name is not text");
    const std::size_t after_name = offset + 2 + length;
    const std::size_t step = bytes.word(after_name);
    if (group < 0) {
      groups[-group] = name;
    } else {
      const std::size_t end = step == 0 ? bytes.size() : after_name + step;
      parameters.push_back({group, name, read_record(after_name + 2, end, name)});
    }
    if (step == 0) break;
    offset = after_name + step;
  }
  for (Named& parameter : parameters)
    records_[groups[parameter.group] + ":" + parameter.name] = std::move(parameter.record);
}

C3dParameters::Record C3dParameters::read_record(std::size_t offset, std::size_t end,
                                                 const std::string& name) const {
  Record record;
  record.type = signed_byte(bytes_, offset);
  if (record.type != -1 && record.type != 1 && record.type != 2 && record.type != 4)
    bytes_.fail(offset, fmt::format("parameter {} has the unknown type {}", name, record.type));
  const std::size_t dimensions = bytes_.byte(offset + 1);
  if (dimensions > 7)
    bytes_.fail(offset + 1, fmt::format("parameter {} has {} dimensions", name, dimensions));
  record.count = 1;
  for (std::size_t d = 0; d < dimensions; ++d) {
    record.dimensions.push_back(bytes_.byte(offset + 2 + d));
    record.count *= record.dimensions.back();
  }
  record.offset = offset + 2 + dimensions;
  const std::size_t size = record.count * std::abs(record.type);
  bytes_.require(record.offset, size, "parameter " + name);
  if (record.offset + size > end)
    bytes_.fail(record.offset, fmt::format("parameter {} overlaps the next one", name));
  return record;
}

std::vector<double> C3dParameters::numbers(const std::string& key) const {
  const auto found = records_.find(key);
  if (found == records_.end()) return {};
  const Record& record = found->second;
  if (record.type < 0) fail(key, "must be a number");
  std::vector<double> values;
  for (std::size_t i = 0; i < record.count; ++i) {
    const std::size_t offset = record.offset + i * record.type;
    values.push_back(record.type == 1   ? bytes_.byte(offset)
                     : record.type == 2 ? bytes_.word(offset)
                                        : static_cast<double>(bytes_.real(offset)));
  }
  return values;
}

std::vector<std::string> C3dParameters::texts(const std::string& key) const {
  const auto found = records_.find(key);
  if (found == records_.end()) return {};
  const Record& record = found->second;
  if (record.type >= 0) fail(key, "must be text");
  const std::size_t length = record.dimensions.empty() ? 1 : record.dimensions[0];
  std::vector<std::string> texts;
  for (std::size_t i = 0; length > 0 && i < record.count; i += length) {
    std::string& text = texts.emplace_back(bytes_.text(record.offset + i, length));
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    if (!is_printable(text)) fail(key, "contains characters that are not text");
    if (!files::is_utf8(text)) text = files::utf8_from_latin1(text);
  }
  return texts;
}

double C3dParameters::number(const std::string& key, double fallback) const {
  const std::vector<double> values = numbers(key);
  return values.empty() ? fallback : values[0];
}

std::string C3dParameters::text(const std::string& key) const {
  const std::vector<std::string> values = texts(key);
  return values.empty() ? "" : values[0];
}

void C3dParameters::fail(const std::string& key, const std::string& message) const {
  throw InputError(fmt::format("{}: {}: {}", bytes_.file, key, message));
}

}  // namespace morphe::imports
