#include "pipeline/planning/input_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <set>
#include <string_view>

#include "core/files/given_files.hpp"

namespace morphe::planning {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

fs::path normal(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

bool begins_with(const fs::path& file, const fs::path& folder) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && (!folder.empty() || file.is_relative());
}

/// Returns the deepest folder that contains all files. There must be at least one.
fs::path common_folder(const Paths& files) {
  fs::path common = files.front().parent_path();
  for (const fs::path& file : files) {
    while (file.lexically_relative(common).string().starts_with(".."))
      common = common.parent_path();
  }
  return common;
}

/// Returns the two outermost folders of a file.
fs::path outermost_folders(const fs::path& file) {
  const fs::path inside = file.parent_path().relative_path();
  fs::path outermost = file.root_path();
  int count = 0;
  for (auto folder = inside.begin(); folder != inside.end() && count < 2; ++folder, ++count)
    outermost /= *folder;
  return outermost;
}

/// Returns the groups of files as they were opened: each belongs to the first earlier file whose
/// folder its path begins with.
std::vector<Paths> named_groups(const Paths& files) {
  std::vector<Paths> groups;
  for (const fs::path& file : files) {
    const auto names_it = [&](const fs::path& other) {
      return begins_with(file, other.parent_path());
    };
    const auto found = std::ranges::find_if(
        groups, [&](const Paths& group) { return std::ranges::any_of(group, names_it); });
    (found == groups.end() ? groups.emplace_back() : *found).push_back(file);
  }
  return groups;
}

/// Returns a group itself, or its parts if their common folder says too little or too much.
std::vector<Paths> divided(const Paths& group) {
  Paths paths;
  std::ranges::transform(group, std::back_inserter(paths), normal);
  const fs::path common = common_folder(paths).relative_path();
  if (std::distance(common.begin(), common.end()) >= 2) return {group};
  std::vector<Paths> parts;
  for (const fs::path& file : group) {
    const auto beside = [&](const Paths& part) {
      return outermost_folders(normal(part.front())) == outermost_folders(normal(file));
    };
    const auto found = std::ranges::find_if(parts, beside);
    (found == parts.end() ? parts.emplace_back() : *found).push_back(file);
  }
  return parts;
}

bool is_part_of_path(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
         std::string_view("._-/+~").find(c) != std::string_view::npos;
}

/// Replaces a path wherever it stands alone in a text.
void replace_path(const std::string& path, const std::string& name, std::string& text) {
  for (std::size_t begin = 0; (begin = text.find(path, begin)) != text.npos;) {
    const std::size_t end = begin + path.size();
    const bool alone = (begin == 0 || !is_part_of_path(text[begin - 1])) &&
                       (end == text.size() || !is_part_of_path(text[end]));
    if (alone) text.replace(begin, path.size(), name);
    begin += alone ? name.size() : path.size();
  }
}

}  // namespace

InputNames::InputNames(const Paths& files) {
  std::set<std::string> used;
  for (const Paths& whole : named_groups(files)) {
    for (const Paths& group : divided(whole)) add_group(group, used);
  }
}

void InputNames::add_group(const Paths& group, std::set<std::string>& used) {
  Paths paths;
  std::ranges::transform(group, std::back_inserter(paths), normal);
  const fs::path common = common_folder(paths);
  const auto name_in = [&](const std::string& folder, const fs::path& file) {
    return folder + file.lexically_relative(common).generic_string();
  };
  std::string folder;
  const auto collides = [&](const fs::path& file) {
    return !find(file) && used.contains(name_in(folder, file));
  };
  for (int number = 2; std::ranges::any_of(paths, collides); ++number)
    folder = fmt::format("{}/", number);
  for (std::size_t k = 0; k < group.size(); ++k) {
    const File* const same = find(paths[k]);
    files_.push_back({group[k], paths[k], same ? same->name : name_in(folder, paths[k])});
    used.insert(files_.back().name);
  }
}

void InputNames::hide(const fs::path& file) {
  if (file.is_absolute()) hidden_[file.string()] = file.filename().string();
}

const InputNames::File* InputNames::find(const fs::path& opened) const {
  const auto found = std::ranges::find(files_, normal(opened), &File::path);
  return found == files_.end() ? nullptr : &*found;
}

std::string InputNames::without_paths(std::string text, const fs::path& from) const {
  const File* const own = find(from);
  const fs::path folder = own ? fs::path(own->name).parent_path() : fs::path();
  for (const File& file : files_) {
    if (file.opened.is_absolute())
      replace_path(file.opened.string(),
                   fs::path(file.name).lexically_proximate(folder).generic_string(), text);
  }
  for (const auto& [path, name] : hidden_) replace_path(path, name, text);
  return text;
}

std::vector<PlanFileHeader::Input> InputNames::read() const {
  std::vector<PlanFileHeader::Input> inputs;
  for (const File& file : files_) {
    if (std::ranges::find(inputs, file.name, &PlanFileHeader::Input::path) != inputs.end())
      continue;
    inputs.push_back({file.name, without_paths(files::read_bytes(file.path), file.path)});
  }
  return inputs;
}

}  // namespace morphe::planning
