#include "stages/import/folders/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "core/config/fields.hpp"
#include "core/motion/key_bounds.hpp"
#include "core/motion/movement.hpp"

namespace morphe::imports {
namespace {

namespace fs = std::filesystem;

/// The fields that may also be at the top of a manifest, for all recordings.
template <class Fields>
void shared_fields(Fields& f, ManifestEntry& e) {
  f("static_trial", e.static_trial);
  f("glove", e.glove);
  f("glove_static_trial", e.glove_static_trial);
  f("glove_calibration", e.glove_calibration);
  f("format", e.format);
  f("names", e.names);
  f("axes", e.conventions.axes);
  f("forward", e.conventions.forward);
  f("unit", e.conventions.unit);
  f("rate_hz", e.conventions.rate_hz, bounds::kRate);
  f("joint_order", e.conventions.joint_order);
  f("subject", e.subject);
  f("task", e.task);
  f("hand", e.hand);
  f("source", e.source);
  f("licence", e.licence);
  f("upper_arm", e.upper_arm, bounds::kBone);
  f("forearm", e.forearm, bounds::kBone);
  f("hand_length", e.hand_length, bounds::kBone);
  f("hand_breadth", e.hand_breadth, bounds::kBone);
  f("objects", e.objects);
  f("accept", e.accept);
}

template <class Fields>
void own_fields(Fields& f, ManifestEntry& e) {
  f.required("file", e.file);
  f("name", e.name);
  shared_fields(f, e);
  f("notes", e.notes);
}

template <class Fields>
void label_keys(Fields& f, Label& label) {
  f.required("phase", label.phase);
  f.required("begin_s", label.begin_s, bounds::kClockTime);
  f.required("end_s", label.end_s, bounds::kClockTime);
}

std::vector<Label> read_labels(const config::ConfigNode& node, config::ErrorList& problems) {
  std::vector<Label> labels;
  for (const config::ConfigNode& item : node.items()) {
    Label& label = labels.emplace_back();
    config::FieldReader reader(item, problems);
    label_keys(reader, label);
    if (problems.none() && !(label.end_s > label.begin_s))
      problems.attempt([&] { item.fail("must end after it begins"); });
  }
  return labels;
}

/// Returns an item of a list: the first key follows the dash.
std::string list_item(std::string fields, std::size_t indent) {
  return fields.replace(indent - 2, 1, "-");
}

struct NonDefaultFields {
  config::FieldWriter& out;

  template <class T, class... Bounds>
  void operator()(const char* key, T& value, const Bounds&... bounds) {
    if constexpr (requires { value.empty(); }) {
      if (value.empty()) return;
    }
    if constexpr (std::is_same_v<T, ForwardSource>) {
      if (value == ForwardSource::body) return;
    }
    out(key, value, bounds...);
  }
  template <class T, class... Bounds>
  void required(const char* key, T& value, const Bounds&... bounds) {
    out(key, value, bounds...);
  }
};

}  // namespace

std::vector<std::string*> paths_of(ManifestEntry& entry) {
  return {&entry.file,
          &entry.static_trial,
          &entry.glove,
          &entry.glove_static_trial,
          &entry.glove_calibration,
          &entry.names};
}

std::vector<ManifestEntry> read_manifest(const std::filesystem::path& file) {
  const config::ConfigNode root = config::ConfigNode::load(file);
  if (!root.is_map()) root.fail("must be a mapping of keys to values");
  ManifestEntry defaults;
  config::ErrorList problems;
  config::FieldReader root_reader(root, problems);
  shared_fields(root_reader, defaults);
  std::vector<ManifestEntry> entries;
  for (const config::ConfigNode& item : root["recordings"].items()) {
    ManifestEntry entry = defaults;
    entry.manifest = file.string();
    config::FieldReader reader(item, problems);
    own_fields(reader, entry);
    if (item.has("labels")) entry.labels = read_labels(item["labels"], problems);
    for (std::string* path : paths_of(entry)) {
      if (!path->empty() || path == &entry.file) *path = (file.parent_path() / *path).string();
    }
    std::ranges::move(split_by_hand(std::move(entry)), std::back_inserter(entries));
  }
  root.report_unread_keys(problems);
  problems.throw_if_any();
  return entries;
}

std::vector<ManifestEntry> split_by_hand(ManifestEntry entry) {
  if (entry.hand != HandSelection::both) return {std::move(entry)};
  const std::string name = entry.name.empty() ? fs::path(entry.file).stem().string() : entry.name;
  std::vector<ManifestEntry> entries;
  for (const HandSelection hand : {HandSelection::right, HandSelection::left}) {
    ManifestEntry& split = entries.emplace_back(entry);
    split.hand = hand;
    split.split_from_both = true;
    split.name = fmt::format("{}_{}", name, name_of(hand));
  }
  return entries;
}

Side side_of(const ManifestEntry& entry) {
  return entry.hand == HandSelection::left ? Side::left : Side::right;
}

std::string manifest_text(std::vector<ManifestEntry> entries, const fs::path& folder) {
  const fs::path base = fs::weakly_canonical(folder);
  std::string text = "recordings:\n";
  for (ManifestEntry& entry : entries) {
    for (std::string* path : paths_of(entry)) {
      if (!path->empty()) *path = fs::weakly_canonical(*path).lexically_relative(base).string();
    }
    config::FieldWriter writer("    ");
    NonDefaultFields fields{writer};
    own_fields(fields, entry);
    text += list_item(writer.text, 4);
    if (!entry.labels.empty()) text += "    labels:\n";
    for (Label& label : entry.labels) {
      config::FieldWriter inner("        ");
      label_keys(inner, label);
      text += list_item(inner.text, 8);
    }
  }
  return text;
}

config::Schema manifest_schema(const config::KeyDescriptions& meanings) {
  constexpr const char* kTable = "ManifestEntry";
  ManifestEntry entry;
  Label label;
  config::FieldSchema all(kTable, meanings, false), own(kTable, meanings, false),
      labels(kTable, meanings, false);
  shared_fields(all, entry);
  own_fields(own, entry);
  label_keys(labels, label);
  config::Schema recording = own.schema();
  recording["properties"]["labels"] = config::list_schema(labels.schema());
  config::Schema schema = all.schema();
  schema["properties"]["recordings"] = config::list_schema(recording);
  schema["required"] = config::Schema::array({"recordings"});
  return schema;
}

}  // namespace morphe::imports
