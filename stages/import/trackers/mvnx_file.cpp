#include "stages/import/trackers/mvnx_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/files/csv.hpp"
#include "core/files/xml_text.hpp"
#include "core/motion/count_with_noun.hpp"
#include "stages/import/trackers/add_note.hpp"

namespace morphe::imports {
namespace {

using files::XmlElement;
using files::XmlText;

const XmlElement& child_of(const XmlText& xml, const XmlElement& parent, const char* tag) {
  const XmlElement* child = parent.FirstChildElement(tag);
  if (child == nullptr) xml.fail(parent, tag, "is missing");
  return *child;
}

std::vector<double> numbers_of(const XmlText& xml, const XmlElement& element, std::size_t count) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::string_view text = element.GetText() == nullptr ? "" : element.GetText();
  std::vector<double> numbers;
  const char* position = text.data();
  const char* const end = position + text.size();
  while (position != end) {
    if (kBlanks.find(*position) != std::string_view::npos) {
      ++position;
      continue;
    }
    double value = 0;
    const auto [value_end, error] = std::from_chars(position, end, value);
    if (error != std::errc() || !std::isfinite(value)) {
      xml.fail(element, element.Value(),
               fmt::format("value {} is not a number", numbers.size() + 1));
    }
    numbers.push_back(value);
    position = value_end;
  }
  if (numbers.size() != count) {
    xml.fail(element, element.Value(),
             fmt::format("must have {} numbers, not {}", count, numbers.size()));
  }
  return numbers;
}

/// Reads the labels of segments, and the positions of points whose label contains "Tip".
MvnxSegments read_segments(const XmlText& xml, const XmlElement* list) {
  MvnxSegments segments;
  if (list == nullptr) return segments;
  for (const XmlElement* segment : files::children(*list, "segment")) {
    const std::string label = xml.attribute(*segment, "label");
    segments.labels.push_back(label);
    const XmlElement* points = segment->FirstChildElement("points");
    if (points == nullptr) continue;
    for (const XmlElement* point : files::children(*points, "point")) {
      const char* name = point->Attribute("label");
      if (name == nullptr || std::string_view(name).find("Tip") == std::string_view::npos) continue;
      const auto tip = numbers_of(xml, child_of(xml, *point, "pos_b"), 3);
      segments.tips[label] = Vec3(tip[0], tip[1], tip[2]);
    }
  }
  return segments;
}

void read_frame(const XmlText& xml, const XmlElement& frame, const std::string& suffix,
                std::size_t row, MvnxSegments& segments) {
  const std::size_t count = segments.labels.size();
  if (count == 0) return;
  const XmlElement& positions = child_of(xml, frame, ("position" + suffix).c_str());
  const XmlElement& orientations = child_of(xml, frame, ("orientation" + suffix).c_str());
  const auto p = numbers_of(xml, positions, 3 * count);
  const auto q = numbers_of(xml, orientations, 4 * count);
  for (std::size_t k = 0; k < count; ++k) {
    segments.position(row, k) = Vec3(p[3 * k], p[3 * k + 1], p[3 * k + 2]);
    const Quat rotation(q[4 * k], q[4 * k + 1], q[4 * k + 2], q[4 * k + 3]);
    if (!(std::abs(rotation.norm() - 1) < 0.01)) {
      xml.fail(orientations, orientations.Value(),
               fmt::format("{}: is not a quaternion of unit length", segments.labels[k]));
    }
    segments.orientation(row, k) = rotation.normalized();
  }
}

double number_attribute(const XmlText& xml, const XmlElement& element, const char* name) {
  const std::string text = xml.attribute(element, name);
  const auto value = files::finite_number(text);
  if (!value) {
    xml.fail(element, fmt::format("{}.{}", element.Value(), name),
             fmt::format("must be a number, not '{}'", text));
  }
  return *value;
}

std::vector<const XmlElement*> motion_frames(const XmlText& xml, const XmlElement& frames,
                                             std::vector<std::string>& reports) {
  std::vector<const XmlElement*> motion;
  std::size_t calibration_count = 0;
  for (const XmlElement* frame : files::children(frames, "frame")) {
    if (xml.attribute(*frame, "type") == "normal") {
      motion.push_back(frame);
    } else {
      ++calibration_count;
    }
  }
  if (motion.empty()) xml.fail(frames, "frame", "no frame has the type normal");
  if (calibration_count > 0)
    add_note(reports, "{} of the calibration skipped", count_with_noun(calibration_count, "frame"));
  return motion;
}

void allocate_frames(MvnxSegments& segments, std::size_t rows) {
  segments.position = Array2D<Vec3>(rows, segments.labels.size(), unknown_point());
  segments.orientation = Array2D<Quat>(rows, segments.labels.size(), unknown_rotation());
}

}  // namespace

MvnxFile read_mvnx_file(const std::filesystem::path& path, double rate_hz) {
  const XmlText xml(path, "mvnx");
  MvnxFile read;
  const XmlElement& subject = child_of(xml, xml.root(), "subject");
  const std::size_t people = files::children(xml.root(), "subject").size();
  if (const char* label = subject.Attribute("label")) read.subject = label;
  if (people > 1) {
    add_note(read.import_notes, "the file has {} people; the first, {}, is used", people,
             read.subject);
  }
  if (!(rate_hz > 0)) rate_hz = number_attribute(xml, subject, "frameRate");
  if (!(rate_hz > 0)) xml.fail(subject, "subject.frameRate", "must be positive");
  read.body = read_segments(xml, &child_of(xml, subject, "segments"));
  read.fingers[0] = read_segments(xml, subject.FirstChildElement("fingerTrackingSegmentsRight"));
  read.fingers[1] = read_segments(xml, subject.FirstChildElement("fingerTrackingSegmentsLeft"));
  const auto frames = motion_frames(xml, child_of(xml, subject, "frames"), read.import_notes);
  allocate_frames(read.body, frames.size());
  for (MvnxSegments& hand : read.fingers) allocate_frames(hand, frames.size());
  double first_index = 0, last_index = 0;
  for (std::size_t row = 0; row < frames.size(); ++row) {
    const XmlElement& frame = *frames[row];
    // The times in the file are rounded to milliseconds, so times are computed from the index.
    const double index = frame.Attribute("index") != nullptr ? number_attribute(xml, frame, "index")
                                                             : static_cast<double>(row);
    if (row == 0) {
      first_index = index;
    } else if (!(index >= last_index)) {
      xml.fail(frame, "frame.index", "must be greater than in the previous frame");
    }
    last_index = index;
    read.time.push_back((index - first_index) / rate_hz);
    read_frame(xml, frame, "", row, read.body);
    read_frame(xml, frame, "FingersRight", row, read.fingers[0]);
    read_frame(xml, frame, "FingersLeft", row, read.fingers[1]);
  }
  return read;
}

}  // namespace morphe::imports
