#include "stages/import/formats/capture_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>

#include "core/human/glove.hpp"

namespace morphe::imports {
namespace {

using Columns = CaptureColumns;
constexpr std::string_view kJointSuffix = "_joint";

/// The parts of a column's name: "wrist_x_mm" is part x of wrist, in mm; "wrist_azimuth_deg" is its
/// part azimuth, in deg.
struct ParsedColumnName {
  std::string_view name, part, unit;
};

/// Removes "_tail" from the end of a text; returns false if it is absent.
bool strip_suffix(std::string_view& text, std::string_view tail) {
  if (text.size() <= tail.size() + 1 || !text.ends_with(tail)) return false;
  if (text[text.size() - tail.size() - 1] != '_') return false;
  text.remove_suffix(tail.size() + 1);
  return true;
}

std::optional<ParsedColumnName> parse_column_name(std::string_view column) {
  ParsedColumnName part;
  for (const std::string_view unit : {"m", "cm", "mm", "in", "deg", "rad"}) {
    if (strip_suffix(column, unit)) {
      part.unit = unit;
      break;
    }
  }
  const bool angle = part.unit == "deg" || part.unit == "rad", none = part.unit.empty();
  for (const std::string_view name :
       {"x", "y", "z", "qw", "qx", "qy", "qz", "azimuth", "elevation", "roll"}) {
    if (!strip_suffix(column, name)) continue;
    const bool of_length = name.size() == 1, of_rotation = name.starts_with('q');
    if (of_length ? angle : of_rotation ? !none : !(angle || none)) return std::nullopt;
    part.name = column;
    part.part = name;
    return part;
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
    std::set<std::string_view> known;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (cells[c].empty()) csv_.fail(1, fmt::format("column {}", c + 1), "has no name");
      if (!known.insert(cells[c]).second) csv_.fail(1, cells[c], "the column appears twice");
      columns_.names.emplace_back(cells[c]);
      add(c, cells[c]);
    }
    for (Columns::Body& body : bodies_) {
      check(body);
      const bool tracked = body.rotation_format != Columns::RotationFormat::none;
      auto& among = tracked ? columns_.bodies : columns_.points;
      body.name = mapped_name(body.name);
      if (!tracked && body.name.ends_with(kJointSuffix))
        body.name.resize(body.name.size() - kJointSuffix.size());
      if (std::ranges::find(among, body.name, &Columns::Body::name) != among.end()) {
        csv_.fail(1, body.name, "two columns get this name");
      }
      among.push_back(std::move(body));
    }
    std::ranges::sort(columns_.glove, {}, &Columns::GloveSensor::sensor);
    for (std::size_t k = 1; k < columns_.glove.size(); ++k) {
      const auto& sensor = columns_.glove[k];
      if (sensor.sensor == columns_.glove[k - 1].sensor) {
        csv_.fail(1, columns_.names[sensor.column], "the sensor appears twice");
      }
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

  void add(std::size_t c, std::string_view name) {
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

  bool add_glove(std::size_t c, std::string_view column) {
    using Unit = Columns::GloveSensor::Unit;
    std::string_view name = column;
    std::optional<Unit> unit;
    if (strip_suffix(name, "deg"))
      unit = Unit::degrees;
    else if (strip_suffix(name, "rad"))
      unit = Unit::radians;
    else if (strip_suffix(name, "raw"))
      unit = Unit::raw;
    const auto sensor = std::ranges::find(human::kGloveSensors, mapped_name(name));
    if (sensor == std::end(human::kGloveSensors)) return false;
    if (!unit) csv_.fail(1, column, "unit missing: must end in _deg, _rad or _raw");
    columns_.glove.push_back(
        {static_cast<std::size_t>(sensor - std::begin(human::kGloveSensors)), c, *unit});
    return true;
  }

  Columns::Body& find_or_add_body(std::string_view name) {
    const auto found = std::ranges::find(bodies_, name, &Columns::Body::name);
    if (found != bodies_.end()) return *found;
    bodies_.emplace_back().name = name;
    return bodies_.back();
  }

  void add_part(std::size_t c, const ParsedColumnName& part) {
    Columns::Body& body = find_or_add_body(part.name);
    const auto put = [&](std::size_t& where) {
      if (where != Columns::kNoColumn) {
        csv_.fail(1, columns_.names[c], fmt::format("{} has this column twice", body.name));
      }
      where = c;
    };
    const char last = part.part.back();
    if (part.part.size() == 1) {
      const auto axis = static_cast<std::size_t>(last - 'x');
      const bool first =
          body.position == std::array{Columns::kNoColumn, Columns::kNoColumn, Columns::kNoColumn};
      put(body.position[axis]);
      if (!first && body.unit != part.unit)
        csv_.fail(1, columns_.names[c], "has another unit than the other columns of the body");
      body.unit = part.unit;
      return;
    }
    const bool quaternion = part.part.front() == 'q';
    const auto turn =
        quaternion ? Columns::RotationFormat::quaternion : Columns::RotationFormat::euler;
    if (body.rotation_format != Columns::RotationFormat::none && body.rotation_format != turn) {
      csv_.fail(1, columns_.names[c],
                "the body has both a quaternion and Euler angles; remove one");
    }
    const bool first = body.rotation_format == Columns::RotationFormat::none;
    body.rotation_format = turn;
    if (quaternion)
      return put(body.rotation[last == 'w' ? 0 : static_cast<std::size_t>(last - 'w')]);
    if (part.unit.empty())
      csv_.fail(1, columns_.names[c], "unit missing: must end in _deg or _rad");
    const double radians = part.unit == "deg" ? kRadPerDegree : 1;
    if (!first && body.radians_per_unit != radians)
      csv_.fail(1, columns_.names[c], "has another unit than the other columns of the body");
    body.radians_per_unit = radians;
    put(body.rotation[part.part == "azimuth" ? 0 : part.part == "elevation" ? 1 : 2]);
  }

  void check(const Columns::Body& body) const {
    const auto missing = [&](const char* part) {
      csv_.fail(1, fmt::format("{}_{}", body.name, part), "the column is missing");
    };
    static constexpr const char* kAxes[] = {"x", "y", "z"};
    for (std::size_t k = 0; k < 3; ++k) {
      if (body.position[k] == Columns::kNoColumn) missing(kAxes[k]);
    }
    static constexpr const char* kQuaternion[] = {"qw", "qx", "qy", "qz"};
    static constexpr const char* kEuler[] = {"azimuth", "elevation", "roll"};
    if (body.rotation_format == Columns::RotationFormat::none) return;
    const bool quaternion = body.rotation_format == Columns::RotationFormat::quaternion;
    for (std::size_t k = 0; k < (quaternion ? 4u : 3u); ++k) {
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
