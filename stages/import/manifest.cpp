#include "stages/import/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pipeline/config/fields.hpp"
#include "pipeline/motion/movement.hpp"

namespace morphe::imports {
namespace {

void shared_fields(config::FieldReader& f, ManifestEntry& e) {
  f("static", e.static_trial);
  f("glove", e.glove);
  f("static_glove", e.static_glove);
  f("glove_calibration", e.glove_calibration);
  f("format", e.format);
  f("names", e.names);
  f("axes", e.conventions.axes);
  f("unit", e.conventions.unit);
  f("rate_hz", e.conventions.rate_hz);
  f("subject", e.subject);
  f("task", e.task);
  f("hand", e.hand);
  f("source", e.source);
  f("licence", e.licence);
  f("upper_arm", e.upper_arm);
  f("forearm", e.forearm);
  f("hand_length", e.hand_length);
  f("hand_breadth", e.hand_breadth);
  f("objects", e.objects);
}

std::vector<Label> read_labels(const config::ConfigNode& node) {
  std::vector<Label> labels;
  for (const config::ConfigNode& item : node.items()) {
    Label& label = labels.emplace_back();
    config::FieldReader reader(item);
    reader.required("phase", label.phase);
    reader.required("begin_s", label.begin_s);
    reader.required("end_s", label.end_s);
    if (!(label.end_s > label.begin_s)) item.fail("must end after it begins");
  }
  return labels;
}

}  // namespace

std::vector<ManifestEntry> read_manifest(const std::filesystem::path& file) {
  const config::ConfigNode root = config::ConfigNode::load(file);
  if (!root.is_map()) root.fail("must be a mapping of keys to values");
  ManifestEntry defaults;
  config::FieldReader root_reader(root);
  shared_fields(root_reader, defaults);
  std::vector<ManifestEntry> entries;
  for (const config::ConfigNode& item : root["recordings"].items()) {
    ManifestEntry entry = defaults;
    entry.manifest = file.string();
    config::FieldReader reader(item);
    reader.required("file", entry.file);
    reader("name", entry.name);
    shared_fields(reader, entry);
    if (item.has("labels")) entry.labels = read_labels(item["labels"]);
    for (const auto& length :
         {entry.upper_arm, entry.forearm, entry.hand_length, entry.hand_breadth}) {
      if (length && *length <= 0) item.fail("lengths must be positive (metres)");
    }
    entry.file = (file.parent_path() / entry.file).string();
    for (std::string* other : {&entry.static_trial, &entry.glove, &entry.static_glove,
                               &entry.glove_calibration, &entry.names}) {
      if (!other->empty()) *other = (file.parent_path() / *other).string();
    }
    if (entry.conventions.rate_hz && !(*entry.conventions.rate_hz > 0)) {
      item.fail("rate_hz must be positive");
    }
    entries.push_back(std::move(entry));
  }
  root.expect_all_read();
  return entries;
}

}  // namespace morphe::imports
