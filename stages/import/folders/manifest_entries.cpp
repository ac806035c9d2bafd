#include "stages/import/folders/manifest_entries.hpp"

#include <algorithm>
#include <iterator>

#include "stages/import/clips/readers.hpp"
#include "stages/import/folders/read_recording.hpp"
#include "stages/import/recording/format.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

void override_conventions(const Conventions& given, Conventions& conventions) {
  if (!given.axes.empty()) conventions.axes = given.axes;
  if (!given.unit.empty()) conventions.unit = given.unit;
  if (given.rate_hz) conventions.rate_hz = given.rate_hz;
  if (!given.joint_order.empty()) conventions.joint_order = given.joint_order;
}

void set_hand_from_file(ManifestEntry& entry) {
  if (entry.hand) return;
  try {
    const RecordingFormat* const format =
        entry.format.empty() ? recognised_format(entry.file) : nullptr;
    const auto side = hand_in_file(entry.file, format ? format->name : entry.format);
    if (side) entry.hand = *side == Side::left ? HandSelection::left : HandSelection::right;
  } catch (const InputError&) {  // the error is reported by the import
  }
}

/// Returns false for an entry split from both hands if only the other hand is requested.
bool is_requested(const ManifestEntry& entry, const std::optional<HandSelection>& hand) {
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
    if (request.forward_given || request.conventions.forward == ForwardSource::recorded)
      entry.conventions.forward = request.conventions.forward;
    if (!in_folder) override_conventions(request.conventions, entry.conventions);
    if (!is_requested(entry, hand)) continue;
    if (hand && !entry.split_from_both) entry.hand = hand;
    set_hand_from_file(entry);
    std::vector<ManifestEntry> split =
        entry.split_from_both ? std::vector{std::move(entry)} : split_by_hand(std::move(entry));
    std::ranges::move(split, std::back_inserter(entries));
  }
  return entries;
}

}  // namespace morphe::imports
