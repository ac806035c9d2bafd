#include "stages/import/formats/bvh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr std::size_t kMaxJointCount = 2000;  // a body with both hands has about 100

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

/// Splits a file into words; a bracket is a separate word.
class Tokenizer {
 public:
  explicit Tokenizer(const files::CsvText& text) : text_(text) {}

  std::size_t line() const { return line_ + 1; }

  /// Returns the next word, "" at the end of the file.
  std::string_view next() {
    for (; line_ < text_.lines.size(); ++line_, column_ = 0) {
      const std::string_view here = text_.lines[line_];
      while (column_ < here.size() && is_blank(here[column_])) ++column_;
      if (column_ == here.size()) continue;
      const std::size_t begin = column_++;
      if (here[begin] == '{' || here[begin] == '}') return here.substr(begin, 1);
      while (column_ < here.size() && !is_blank(here[column_]) && here[column_] != '{' &&
             here[column_] != '}') {
        ++column_;
      }
      return here.substr(begin, column_ - begin);
    }
    return {};
  }

  /// Returns the rest of this line up to a bracket, without blanks around it: a name may contain
  /// blanks.
  std::string rest_of_line() {
    const std::string_view here = text_.lines[line_];
    std::size_t begin = column_, end = std::min(here.find('{', column_), here.size());
    column_ = end;
    while (begin < end && is_blank(here[begin])) ++begin;
    while (end > begin && is_blank(here[end - 1])) --end;
    return std::string(here.substr(begin, end - begin));
  }

  void expect(std::string_view word) {
    const std::string found(next());
    if (to_lower(found) != to_lower(word))
      fail(word, fmt::format("expected here, not '{}'", found));
  }

  [[noreturn]] void fail(std::string_view key, std::string_view message) const {
    text_.fail(std::max<std::size_t>(1, std::min(line(), text_.lines.size())), key, message);
  }

 private:
  const files::CsvText& text_;
  std::size_t line_ = 0, column_ = 0;
};

std::optional<BvhChannel> channel_of(std::string_view word) {
  const std::string name = to_lower(word);
  if (name.empty() || name[0] < 'x' || name[0] > 'z') return std::nullopt;
  const std::string_view kind = std::string_view(name).substr(1);
  if (kind != "position" && kind != "rotation") return std::nullopt;
  return BvhChannel{kind == "rotation", name[0] - 'x'};
}

/// Reads the tree with a list of open joints, so that its depth cannot exhaust the stack.
class Hierarchy {
 public:
  Hierarchy(Tokenizer& words, const files::CsvText& text, std::vector<BvhJoint>& joints)
      : words_(words), text_(text), joints_(joints) {}

  void read() {
    words_.expect("HIERARCHY");
    words_.expect("ROOT");
    open(words_.rest_of_line());
    while (!open_.empty()) {
      const std::string_view found = words_.next();
      const std::string word = to_lower(found);
      if (word == "offset" && !here().has_offset) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) joint().offset[axis] = number("OFFSET");
        here().has_offset = true;
      } else if (word == "channels" && !here().is_end && !here().has_channels) {
        read_channels();
      } else if (word == "joint" && !here().is_end) {
        open(words_.rest_of_line());
      } else if (word == "end" && !here().is_end) {
        const std::string parent = joint().name;
        words_.rest_of_line();  // "Site", or a name written by some programs
        open(parent + "_end", true);
      } else if (word == "}") {
        close();
      } else if (word.empty()) {
        words_.fail(joint().name, "the file ends inside this joint");
      } else {
        words_.fail(joint().name, fmt::format("'{}' is not allowed here", found));
      }
    }
  }

 private:
  struct OpenJoint {
    std::size_t index;
    bool is_end;
    bool has_offset = false, has_channels = false;
  };

  OpenJoint& here() { return open_.back(); }
  BvhJoint& joint() { return joints_[here().index]; }

  void open(const std::string& name, bool is_end = false) {
    if (name.empty()) words_.fail("", "a joint has no name");
    if (!names_.insert(name).second) words_.fail(name, "the joint appears twice");
    if (joints_.size() == kMaxJointCount) {
      words_.fail(name, fmt::format("the skeleton has more than {} joints", kMaxJointCount));
    }
    joints_.push_back(
        {name, open_.empty() ? -1 : static_cast<int>(here().index), Vec3::Zero(), {}});
    open_.push_back({joints_.size() - 1, is_end});
    words_.expect("{");
  }

  void close() {
    if (!here().has_offset) words_.fail(joint().name, "has no OFFSET");
    open_.pop_back();
  }

  double number(std::string_view key) {
    const std::string_view word = words_.next();
    return text_.number(std::min(words_.line(), text_.lines.size()), key, word);
  }

  void read_channels() {
    const double count = number("CHANNELS");
    if (count < 0 || count > 6 || count != std::floor(count)) {
      words_.fail("CHANNELS", "must be a whole number from 0 to 6");
    }
    for (int k = 0; k < static_cast<int>(count); ++k) {
      const std::string_view word = words_.next();
      const std::optional<BvhChannel> channel = channel_of(word);
      if (!channel) words_.fail("CHANNELS", fmt::format("'{}' is not a channel", word));
      for (const BvhChannel& other : joint().channels) {
        if (other.rotates == channel->rotates && other.axis == channel->axis) {
          words_.fail("CHANNELS", fmt::format("{} appears twice", word));
        }
      }
      joint().channels.push_back(*channel);
    }
    here().has_channels = true;
  }

  Tokenizer& words_;
  const files::CsvText& text_;
  std::vector<BvhJoint>& joints_;
  std::vector<OpenJoint> open_;
  std::set<std::string> names_;
};

/// Reads the number of "Frames: 12" or "Frame Time:.01", with blanks anywhere.
double read_setting(Tokenizer& words, const files::CsvText& text, std::string_view key) {
  std::string line(words.next());
  if (line.empty()) words.fail(key, "is missing: the file ends before it");
  line += " " + words.rest_of_line();
  std::string squeezed;
  for (const char c : to_lower(line)) {
    if (!is_blank(c)) squeezed += c;
  }
  std::string wanted;
  for (const char c : to_lower(key)) {
    if (!is_blank(c)) wanted += c;
  }
  wanted += ':';
  if (!squeezed.starts_with(wanted)) {
    words.fail(key, fmt::format("'{}:' expected, not '{}'", key, line));
  }
  return text.number(words.line(), key, std::string_view(squeezed).substr(wanted.size()));
}

/// Reads the numbers of one line into `row`.
void read_row(const files::CsvText& text, std::size_t line, Eigen::Index channels, double* row) {
  const std::string_view here = text.lines[line - 1];
  Eigen::Index count = 0;
  for (std::size_t at = 0; at < here.size();) {
    if (is_blank(here[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < here.size() && !is_blank(here[end])) ++end;
    if (count < channels) row[count] = text.number(line, "MOTION", here.substr(at, end - at));
    ++count;
    at = end;
  }
  if (count != channels) {
    text.fail(
        line, "MOTION",
        fmt::format("the row has {} numbers, but the skeleton has {} channels", count, channels));
  }
}

}  // namespace

BvhFile read_bvh_file(const std::filesystem::path& file) {
  BvhFile bvh;
  bvh.text = files::read_csv(file, ' ');
  const files::CsvText& text = bvh.text;
  if (text.lines.empty()) text.fail(1, "", "the file is empty");
  Tokenizer words(text);
  Hierarchy(words, text, bvh.joints).read();
  words.expect("MOTION");
  const double frames = read_setting(words, text, "Frames");
  if (frames < 0 || frames > 1e9 || frames != std::floor(frames)) {
    words.fail("Frames", "must be a whole number");
  }
  bvh.declared_frame_count = static_cast<std::size_t>(frames);
  bvh.frame_s = read_setting(words, text, "Frame Time");
  bvh.frame_time_line = words.line();

  std::vector<std::size_t> row_lines;
  for (std::size_t line = words.line() + 1; line <= text.lines.size(); ++line) {
    if (!std::ranges::all_of(text.lines[line - 1], is_blank)) row_lines.push_back(line);
  }
  if (row_lines.empty()) text.fail(text.lines.size(), "MOTION", "the file has no frames");
  Eigen::Index channels = 0;
  for (const BvhJoint& joint : bvh.joints) {
    channels += joint.channels.size();
  }
  bvh.rows.resize(row_lines.size(), channels);
  for (std::size_t i = 0; i < row_lines.size(); ++i) {
    read_row(text, row_lines[i], channels, bvh.rows.row(i).data());
  }
  return bvh;
}

void bvh_forward_kinematics(const BvhFile& bvh, const double* row, BvhPoses& poses) {
  poses.position.resize(bvh.joints.size());
  poses.orientation.resize(bvh.joints.size());
  for (std::size_t j = 0; j < bvh.joints.size(); ++j) {
    const BvhJoint& joint = bvh.joints[j];
    Vec3 position = joint.offset;
    Quat turn = Quat::Identity();
    for (const BvhChannel& channel : joint.channels) {
      if (row == nullptr) break;
      const double value = *row++;
      if (channel.rotates) {
        const double half = value * M_PI / 360;
        Vec3 axis = Vec3::Zero();
        axis[channel.axis] = std::sin(half);
        turn = turn * Quat(std::cos(half), axis.x(), axis.y(), axis.z());
      } else {
        position[channel.axis] = value;
      }
    }
    if (joint.parent < 0) {
      poses.position[j] = row == nullptr ? Vec3(Vec3::Zero()) : position;
      poses.orientation[j] = turn;
      continue;
    }
    const auto parent = static_cast<std::size_t>(joint.parent);
    poses.position[j] = poses.position[parent] + poses.orientation[parent] * position;
    poses.orientation[j] = (poses.orientation[parent] * turn).normalized();
  }
}

}  // namespace morphe::imports
