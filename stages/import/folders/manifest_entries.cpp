#include "stages/import/folders/manifest_entries.hpp"

#include "stages/import/clips/readers.hpp"
#include "stages/import/folders/read_recording.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

void override_conventions(const Conventions& given, Conventions& said) {
  if (!given.axes.empty()) said.axes = given.axes;
  if (!given.unit.empty()) said.unit = given.unit;
  if (given.rate_hz) said.rate_hz = given.rate_hz;
  if (!given.joint_order.empty()) said.joint_order = given.joint_order;
}

void set_hand_from_file(ManifestEntry& entry) {
  if (entry.hand) return;
  try {
    const RecordingFormat* const format =
        entry.format.empty() ? recognised_format(entry.file) : nullptr;
    const auto said = hand_in_file(entry.file, format != nullptr ? format->name : entry.format);
    if (said) entry.hand = *said == Side::left ? HandSelection::left : HandSelection::right;
  } catch (const InputError&) {  // the error is reported by the import
  }
}

/// Returns false for one of the two entries of both hands if only the other hand is requested.
bool is_asked_for(const ManifestEntry& entry, const std::optional<HandSelection>& hand) {
  return !entry.split_from_both || !hand || *hand == HandSelection::both || *hand == *entry.hand;
}

}  // namespace

std::optional<Side> hand_in_file(const fs::path& file, const std::string& format) {
  return format == "clip-npz" ? clip_reaching_side(file) : std::nullopt;
}

std::vector<ManifestEntry> entries_of(const ImportRequest& request, const fs::path& manifest,
                                      bool in_folder) {
  const std::optional<HandSelection> hand = in_folder ? std::nullopt : request.hand;
  std::vector<ManifestEntry> entries;
  for (ManifestEntry& entry : read_manifest(manifest)) {
    if (!request.format.empty()) entry.format = request.format;
    if (!request.name_map.empty()) entry.names = request.name_map.string();
    if (request.conventions.forward == ForwardSource::recorded)
      entry.conventions.forward = ForwardSource::recorded;
    if (!in_folder) override_conventions(request.conventions, entry.conventions);
    if (!is_asked_for(entry, hand)) continue;
    if (hand && !entry.split_from_both) entry.hand = hand;
    set_hand_from_file(entry);
    if (entry.split_from_both) {
      entries.push_back(std::move(entry));
    } else {
      for (ManifestEntry& one : split_by_hand(std::move(entry))) entries.push_back(std::move(one));
    }
  }
  return entries;
}

}  // namespace morphe::imports
