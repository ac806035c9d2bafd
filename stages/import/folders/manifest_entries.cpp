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

void ask_file(ManifestEntry& entry) {
  if (entry.hand) return;
  try {
    const RecordingFormat* const format =
        entry.format.empty() ? recognised_format(entry.file) : nullptr;
    const auto said = hand_in_file(entry.file, format != nullptr ? format->name : entry.format);
    if (said) entry.hand = *said == Side::left ? Hands::left : Hands::right;
  } catch (const InputError&) {  // what is wrong with it is told when it is imported
  }
}

/// Of two entries of both hands that of another one falls away.
bool is_asked_for(const ManifestEntry& entry, const std::optional<Hands>& hand) {
  return !entry.of_both || !hand || *hand == Hands::both || *hand == *entry.hand;
}

}  // namespace

std::optional<Side> hand_in_file(const fs::path& file, const std::string& format) {
  return format == "clip-npz" ? clip_hand(file) : std::nullopt;
}

std::vector<ManifestEntry> entries_of(const ImportRequest& request, const fs::path& manifest,
                                      bool in_folder) {
  const std::optional<Hands> hand = in_folder ? std::nullopt : request.hand;
  std::vector<ManifestEntry> entries;
  for (ManifestEntry& entry : read_manifest(manifest)) {
    if (!request.format.empty()) entry.format = request.format;
    if (!request.names.empty()) entry.names = request.names.string();
    if (request.conventions.forward == ForwardBy::recorded)
      entry.conventions.forward = ForwardBy::recorded;
    if (!in_folder) override_conventions(request.conventions, entry.conventions);
    if (!is_asked_for(entry, hand)) continue;
    if (hand && !entry.of_both) entry.hand = hand;
    ask_file(entry);
    if (entry.of_both) {
      entries.push_back(std::move(entry));
    } else {
      for (ManifestEntry& one : hand_by_hand(std::move(entry))) entries.push_back(std::move(one));
    }
  }
  return entries;
}

}  // namespace morphe::imports
