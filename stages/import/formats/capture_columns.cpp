#include "stages/import/formats/capture_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/human/glove.hpp"
#include "stages/import/recording/repeated_names.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;
constexpr std::string_view kJointSuffix = "_joint";

/// The parts of a column's name: "wrist_azimuth_deg" is the part azimuth of wrist, in the unit deg.
struct ParsedColumnName {
  std::string_view name, part, unit;
};

/// Removes "_SUFFIX" from the end of a text; returns false if it is absent.
bool strip_suffix(std::string_view& text, std::string_view suffix) {
  if (text.size() <= suffix.size() + 1 || !text.ends_with(suffix)) return false;
  if (text[text.size() - suffix.size() - 1] != '_') return false;
  text.remove_suffix(suffix.size() + 1);
  return true;
}

std::optional<ParsedColumnName> parse_column_name(std::string_view column) {
  ParsedColumnName parsed;
  for (const std::string_view unit : {"m", "cm", "mm", "in", "deg", "rad"}) {
    if (!strip_suffix(column, unit)) continue;
    parsed.unit = unit;
    break;
  }
  const bool in_angle = parsed.unit == "deg" || parsed.unit == "rad";
  const bool in_no_unit = parsed.unit.empty();
  for (const std::string_view part :
       {"x", "y", "z", "qw", "qx", "qy", "qz", "azimuth", "elevation", "roll"}) {
    if (!strip_suffix(column, part)) continue;
    const bool is_length = part.size() == 1, is_quaternion = part.starts_with('q');
    const bool fits = is_length ? !in_angle : is_quaternion ? in_no_unit : in_angle || in_no_unit;
    if (!fits) return std::nullopt;
    parsed.name = column;
    parsed.part = part;
    return parsed;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(const files::CsvText& csv, const std::map<std::string, std::string>& renamed,
               std::vector<std::string>& used)
      : csv_(csv), renamed_(renamed), used_(used) {}

  Columns read() {
    const auto cells = csv_.cells(1);
    columns_.names.assign(cells.begin(), cells.end());
    const auto unnamed = std::ranges::find(columns_.names, "") - columns_.names.begin();
    if (unnamed < std::ssize(cells))
      csv_.fail(1, fmt::format("column {}", unnamed + 1), "has no name");
    number_repeated_names(columns_.names, columns_.notes);
    for (int c = 0; c < std::ssize(cells); ++c) add(c, columns_.names[c]);
    for (Columns::Body& body : bodies_) {
      check(body);
      const bool tracked = body.rotation_format != Columns::RotationFormat::none;
      auto& same_kind = tracked ? columns_.bodies : columns_.points;
      body.name = mapped_name(body.name);
      if (!tracked && body.name.ends_with(kJointSuffix))
        body.name.resize(body.name.size() - kJointSuffix.size());
      if (std::ranges::find(same_kind, body.name, &Columns::Body::name) != same_kind.end())
        csv_.fail(1, body.name, "two columns get this name");
      same_kind.push_back(std::move(body));
    }
    std::ranges::sort(columns_.glove, {}, &Columns::GloveSensor::sensor);
    for (std::size_t k = 1; k < columns_.glove.size(); ++k) {
      const auto& sensor = columns_.glove[k];
      if (sensor.sensor == columns_.glove[k - 1].sensor)
        csv_.fail(1, columns_.names[sensor.column], "the sensor appears twice");
    }
    return std::move(columns_);
  }

 private:
  std::string mapped_name(std::string_view name) {
    const auto entry = renamed_.find(std::string(name));
    if (entry == renamed_.end()) return std::string(name);
    used_.push_back(entry->first);
    return entry->second;
  }

  void add(int c, std::string_view name) {
    if (name == "time_s") {
      columns_.time = c;
    } else if (name == "frame") {
      columns_.frame = c;
    } else if (const auto part = parse_column_name(name)) {
      add_part(c, *part);
    } else if (!add_glove(c, name)) {
      columns_.left_out.emplace_back(name);
    }
  }

  bool add_glove(int c, std::string_view column) {
    using Unit = Columns::GloveSensor::Unit;
    std::string_view recorded_name = column;
    std::optional<Unit> unit;
    if (strip_suffix(recorded_name, "deg"))
      unit = Unit::degrees;
    else if (strip_suffix(recorded_name, "rad"))
      unit = Unit::radians;
    else if (strip_suffix(recorded_name, "raw"))
      unit = Unit::raw;
    const std::string name = mapped_name(recorded_name);
    for (int sensor = 0; sensor < std::ssize(human::kGloveSensors); ++sensor) {
      if (human::kGloveSensors[sensor] != name) continue;
      if (!unit) csv_.fail(1, column, "unit missing: must end in _deg, _rad or _raw");
      columns_.glove.push_back({sensor, c, *unit});
      return true;
    }
    return false;
  }

  Columns::Body& find_or_add_body(std::string_view name) {
    const auto found = std::ranges::find(bodies_, name, &Columns::Body::name);
    if (found != bodies_.end()) return *found;
    bodies_.emplace_back().name = name;
    return bodies_.back();
  }

  void add_part(int c, const ParsedColumnName& column) {
    Columns::Body& body = find_or_add_body(column.name);
    const auto fail = [&](const std::string& message) { csv_.fail(1, columns_.names[c], message); };
    const auto set = [&](int& index) {
      if (index != Columns::kNoColumn) fail(fmt::format("{} has this column twice", body.name));
      index = c;
    };
    const char last = column.part.back();
    if (column.part.size() == 1) {
      const bool first = body.position == Columns::Body().position;
      set(body.position[last - 'x']);
      if (!first && body.unit != column.unit)
        fail("has another unit than the other columns of the body");
      body.unit = column.unit;
      return;
    }
    const bool quaternion = column.part.front() == 'q';
    const auto format =
        quaternion ? Columns::RotationFormat::quaternion : Columns::RotationFormat::euler;
    const bool first = body.rotation_format == Columns::RotationFormat::none;
    if (!first && body.rotation_format != format)
      fail("the body has both a quaternion and Euler angles; remove one");
    body.rotation_format = format;
    if (quaternion) return set(body.rotation[last - 'w']);
    if (column.unit.empty()) fail("unit missing: must end in _deg or _rad");
    const double radians = column.unit == "deg" ? kRadPerDegree : 1;
    if (!first && body.radians_per_unit != radians)
      fail("has another unit than the other columns of the body");
    body.radians_per_unit = radians;
    set(body.rotation[column.part == "azimuth" ? 0 : column.part == "elevation" ? 1 : 2]);
  }

  void check(const Columns::Body& body) const {
    const auto missing = [&](const char* part) {
      csv_.fail(1, fmt::format("{}_{}", body.name, part), "the column is missing");
    };
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    static constexpr const char* kQuaternion[] = {"qw", "qx", "qy", "qz"};
    static constexpr const char* kEuler[] = {"azimuth", "elevation", "roll"};
    for (int k = 0; k < 3; ++k) {
      if (body.position[k] == Columns::kNoColumn) missing(kAxes[k]);
    }
    if (body.rotation_format == Columns::RotationFormat::none) return;
    const bool quaternion = body.rotation_format == Columns::RotationFormat::quaternion;
    for (int k = 0; k < (quaternion ? 4 : 3); ++k) {
      if (body.rotation[k] == Columns::kNoColumn) missing(quaternion ? kQuaternion[k] : kEuler[k]);
    }
  }

  const files::CsvText& csv_;
  const std::map<std::string, std::string>& renamed_;
  std::vector<std::string>& used_;
  Columns columns_;
  std::vector<Columns::Body> bodies_;
};

}  // namespace

CaptureColumns read_capture_columns(const files::CsvText& csv,
                                    const std::map<std::string, std::string>& renamed,
                                    std::vector<std::string>& used) {
  if (csv.lines.empty()) csv.fail(1, "", "the file is empty");
  return HeaderReader(csv, renamed, used).read();
}

}  // namespace morphe::imports
