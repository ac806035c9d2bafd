#include "stages/import/folders/given_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "stages/import/folders/read_recording.hpp"
#include "stages/import/folders/recording_formats.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

/// Options that do not override a manifest that is found in a folder.
constexpr const char* kOverruledInFolders[] = {"--static-trial", "--axes",        "--unit",
                                               "--rate",         "--joint-order", "--hand"};

bool is_overruled_in_folders(const std::string& option) {
  return std::ranges::find(kOverruledInFolders, option) != std::end(kOverruledInFolders);
}

/// Returns true if a manifest of a folder, rather than one given directly, lists the entry.
bool is_from_folder(const ImportRequest& request, const NamedEntry& named) {
  return fs::is_directory(request.paths[named.request_index]);
}

/// Returns the manifest entries that the option would override.
std::vector<const NamedEntry*> overridden_entries(const std::string& option,
                                                  const ImportRequest& request,
                                                  const DatasetContents& contents) {
  std::vector<const NamedEntry*> overridden;
  for (const NamedEntry& named : contents.entries) {
    const bool stays = option == "--static-trial" ||
                       (is_overruled_in_folders(option) && is_from_folder(request, named));
    if (!stays) overridden.push_back(&named);
  }
  return overridden;
}

std::string format_of(const ManifestEntry& entry) {
  if (!entry.format.empty()) return entry.format;
  try {
    const RecordingFormat* const format = recognised_format(entry.file);
    return format == nullptr ? "" : format->name;
  } catch (const InputError&) {  // the error is reported by the import
    return "";
  }
}

/// Returns false if no recording of the format uses the option.
bool format_uses(const std::string& format, const std::string& option) {
  if (option == "--joint-order") return format.empty() || format == "clip-npz";
  const auto known = std::ranges::find(recording_formats(), format, &RecordingFormat::name);
  if (known == recording_formats().end()) return true;
  return std::ranges::find(known->ignored_conventions, option.substr(2)) ==
         known->ignored_conventions.end();
}

[[noreturn]] void throw_overruled(const std::string& option, const ImportRequest& request,
                                  const DatasetContents& contents) {
  std::set<std::string> folders, manifests;
  for (const NamedEntry& named : contents.entries) {
    folders.insert(request.paths[named.request_index].string());
    manifests.insert(named.entry.manifest);
  }
  const std::string change = "change it there";
  throw InputError(fmt::format(
      "{} has no effect: all recordings of {} are listed in {}, which states it; {}{}", option,
      fmt::join(folders, ", "), fmt::join(manifests, ", "), change,
      option == "--static-trial" ? " (static_trial:)" : ", or give the manifest itself"));
}

/// Returns true if the import of the file depends on the option.
bool file_uses(const DatasetFile& file, const std::string& option) {
  if (option == "--names") return !file.names.empty();
  if (option == "--static-trial") return !file.from_folder || file.descriptor.has_markers;
  return format_uses(file.descriptor.format, option);
}

std::string why_without_effect(const std::string& option, const std::set<std::string>& formats) {
  if (option == "--names") return "no recording has one of its names";
  if (option == "--static-trial") return "no recording has markers";
  return fmt::format("recordings of the format {} do not need it", fmt::join(formats, ", "));
}

void expect_effect(const std::string& option, const ImportRequest& request,
                   const DatasetContents& contents) {
  const auto overridden = overridden_entries(option, request, contents);
  if (contents.files.empty() && overridden.empty()) {
    if (!contents.entries.empty()) throw_overruled(option, request, contents);
    return;
  }
  bool is_used = false;
  std::set<std::string> formats;
  for (const DatasetFile& file : contents.files) {
    formats.insert(file.descriptor.format);
    is_used = is_used || file_uses(file, option);
  }
  for (const NamedEntry* const named : overridden) {
    formats.insert(format_of(named->entry));
    is_used = is_used || format_uses(format_of(named->entry), option);
  }
  if (is_used) return;
  throw InputError(fmt::format("{} has no effect: {}; leave it out", option,
                               why_without_effect(option, formats)));
}

/// Adds a note to the entries of folders' manifests, to which the options are not applied.
void report_overruled(const ImportRequest& request, DatasetContents& contents) {
  std::vector<std::string> overruled;
  for (const std::string& option : given_options(request))
    if (is_overruled_in_folders(option)) overruled.push_back(option);
  if (overruled.empty()) return;
  for (NamedEntry& named : contents.entries) {
    if (!is_from_folder(request, named)) continue;
    named.entry.notes.push_back(fmt::format("{} not applied: {} decides",
                                            fmt::join(overruled, ", "), named.entry.manifest));
  }
}

}  // namespace

std::vector<std::string> given_options(const ImportRequest& request) {
  const Conventions& conventions = request.conventions;
  std::vector<std::string> options;
  const auto add = [&](bool given, const char* option) {
    if (given) options.emplace_back(option);
  };
  add(!request.static_trial.empty(), "--static-trial");
  add(!request.format.empty(), "--format");
  add(!request.name_map.empty(), "--names");
  add(!conventions.axes.empty(), "--axes");
  add(request.forward_given, "--forward");
  add(!conventions.unit.empty(), "--unit");
  add(conventions.rate_hz.has_value(), "--rate");
  add(!conventions.joint_order.empty(), "--joint-order");
  add(request.hand.has_value(), "--hand");
  return options;
}

void expect_effect_of_options(const ImportRequest& request, DatasetContents& contents) {
  for (const std::string& option : given_options(request)) expect_effect(option, request, contents);
  report_overruled(request, contents);
}

}  // namespace morphe::imports
