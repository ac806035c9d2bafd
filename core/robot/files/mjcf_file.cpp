#include "core/robot/files/mjcf_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace morphe::robot {

using files::XmlElement;
using files::XmlText;

namespace {

bool is_include(const XmlElement& element) {
  return std::string_view(element.Value()) == "include";
}

std::filesystem::path existing_include(const std::filesystem::path& file,
                                       const std::filesystem::path& main,
                                       const std::filesystem::path& including) {
  const std::filesystem::path beside_main = main.parent_path() / file;
  const std::filesystem::path beside_including = including.parent_path() / file;
  if (!std::filesystem::exists(beside_main) && std::filesystem::exists(beside_including))
    return beside_including;
  return beside_main;
}

}  // namespace

MjcfFile::MjcfFile(const std::filesystem::path& file) {
  texts_.push_back(std::make_unique<XmlText>(file, "mujoco"));
  load_includes(root());
}

void MjcfFile::load_includes(const XmlElement& element) {
  if (is_include(element)) return load_include(element);
  for (const XmlElement* child = element.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    load_includes(*child);
  }
}

void MjcfFile::load_include(const XmlElement& include) {
  const XmlText& text = text_of(include);
  const std::string name = text.attribute(include, "file");
  const std::filesystem::path file = existing_include(name, path(), text.file);
  const auto same = [&](const auto& other) {
    std::error_code ignored;
    return std::filesystem::equivalent(other->file, file, ignored);
  };
  if (std::ranges::any_of(texts_, same))
    fail(include, "include.file", fmt::format("'{}' is included twice", name));
  if (!std::filesystem::is_regular_file(file))
    fail(include, "include.file", fmt::format("'{}' does not exist", file.string()));
  texts_.push_back(std::make_unique<XmlText>(file));
  const XmlElement& included = texts_.back()->root();
  included_.emplace(&include, &included);
  load_includes(included);
}

std::vector<const XmlElement*> MjcfFile::elements(const XmlElement& parent) const {
  std::vector<const XmlElement*> found;
  for (const XmlElement* child = parent.FirstChildElement(); child;
       child = child->NextSiblingElement()) {
    if (!is_include(*child)) {
      found.push_back(child);
      continue;
    }
    const std::vector<const XmlElement*> more = elements(*included_.at(child));
    found.insert(found.end(), more.begin(), more.end());
  }
  return found;
}

std::vector<const XmlElement*> MjcfFile::elements(const XmlElement& parent, const char* tag) const {
  std::vector<const XmlElement*> found = elements(parent);
  std::erase_if(found,
                [&](const XmlElement* child) { return std::string_view(child->Value()) != tag; });
  return found;
}

const XmlText& MjcfFile::text_of(const XmlElement& element) const {
  const auto owns = [&](const auto& text) { return &text->document == element.GetDocument(); };
  return **std::ranges::find_if(texts_, owns);
}

std::string MjcfFile::place(const XmlElement& element) const {
  return fmt::format("{}:{}", text_of(element).file.string(), element.GetLineNum());
}

void MjcfFile::fail(const XmlElement& element, const std::string& key,
                    const std::string& message) const {
  text_of(element).fail(element, key, message);
}

}  // namespace morphe::robot
