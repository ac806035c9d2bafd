#include "stages/import/formats/bvh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "stages/import/recording/column_label.hpp"

namespace morphe::imports {
namespace {

constexpr int kMaxJointCount = 2000;  // a body with both hands has about 100

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

/// Splits a file into words; a bracket is a separate word.
class Tokenizer {
 public:
  explicit Tokenizer(const files::CsvText& text) : text_(text) {}

  std::size_t line() const { return line_ + 1; }

  /// Returns the next word, "" at the end of the file.
  std::string_view next() {
    const auto is_bracket = [](char c) { return c == '{' || c == '}'; };
    for (; line_ < text_.lines.size(); ++line_, column_ = 0) {
      const std::string_view text = text_.lines[line_];
      while (column_ < text.size() && is_blank(text[column_])) ++column_;
      if (column_ == text.size()) continue;
      const std::size_t begin = column_++;
      const auto continues = [&](char c) { return !is_blank(c) && !is_bracket(c); };
      while (!is_bracket(text[begin]) && column_ < text.size() && continues(text[column_]))
        ++column_;
      return text.substr(begin, column_ - begin);
    }
    return {};
  }

  /// Returns the rest of this line up to a bracket, without blanks at its ends.
  std::string rest_of_line() {
    const std::string_view text = text_.lines[line_];
    std::size_t begin = column_, end = std::min(text.find('{', column_), text.size());
    column_ = end;
    while (begin < end && is_blank(text[begin])) ++begin;
    while (end > begin && is_blank(text[end - 1])) --end;
    return std::string(text.substr(begin, end - begin));
  }

  void expect(std::string_view expected) {
    const std::string word(next());
    if (to_lower(word) != to_lower(expected))
      fail(expected, fmt::format("expected here, not '{}'", word));
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

/// Reads the tree of joints, with a list in place of a recursion, which depth could overflow.
class Hierarchy {
 public:
  Hierarchy(Tokenizer& tokens, const files::CsvText& text, std::vector<BvhJoint>& joints)
      : tokens_(tokens), text_(text), joints_(joints) {}

  void read() {
    tokens_.expect("HIERARCHY");
    tokens_.expect("ROOT");
    open(tokens_.rest_of_line());
    while (!open_.empty()) {
      const std::string_view word_as_written = tokens_.next();
      const std::string word = to_lower(word_as_written);
      if (word == "offset" && !innermost().has_offset) {
        for (int axis = 0; axis < 3; ++axis) joint().offset[axis] = number("OFFSET");
        innermost().has_offset = true;
      } else if (word == "channels" && !innermost().is_end && !innermost().has_channels) {
        read_channels();
      } else if (word == "joint" && !innermost().is_end) {
        open(tokens_.rest_of_line());
      } else if (word == "end" && !innermost().is_end) {
        const std::string parent = joint().name;
        tokens_.rest_of_line();  // "Site", or a name written by some programs
        open(parent + "_end", true);
      } else if (word == "}") {
        close();
      } else if (word.empty()) {
        tokens_.fail(joint().name, "the file ends inside this joint");
      } else {
        tokens_.fail(joint().name, fmt::format("'{}' is not allowed here", word_as_written));
      }
    }
  }

 private:
  struct OpenJoint {
    int index;
    bool is_end;
    bool has_offset = false, has_channels = false;
  };

  OpenJoint& innermost() { return open_.back(); }
  BvhJoint& joint() { return joints_[innermost().index]; }

  void open(const std::string& name, bool is_end = false) {
    if (name.empty()) tokens_.fail("", "a joint has no name");
    if (!names_.insert(name).second) tokens_.fail(name, "the joint appears twice");
    if (std::ssize(joints_) == kMaxJointCount)
      tokens_.fail(name, fmt::format("the skeleton has more than {} joints", kMaxJointCount));
    joints_.push_back({name, open_.empty() ? -1 : innermost().index, Vec3::Zero(), {}});
    open_.push_back({joint_count_++, is_end});
    tokens_.expect("{");
  }

  void close() {
    if (!innermost().has_offset) tokens_.fail(joint().name, "has no OFFSET");
    open_.pop_back();
  }

  double number(std::string_view key) {
    const std::string_view word = tokens_.next();
    return text_.number(std::min(tokens_.line(), text_.lines.size()), key, word);
  }

  void read_channels() {
    const double count = number("CHANNELS");
    if (count < 0 || count > 6 || count != std::floor(count))
      tokens_.fail("CHANNELS", "must be a whole number from 0 to 6");
    for (int k = 0; k < count; ++k) {
      const std::string_view word = tokens_.next();
      const std::optional<BvhChannel> channel = channel_of(word);
      if (!channel) tokens_.fail("CHANNELS", fmt::format("'{}' is not a channel", word));
      for (const BvhChannel& other : joint().channels) {
        if (other.rotates == channel->rotates && other.axis == channel->axis)
          tokens_.fail("CHANNELS", fmt::format("{} appears twice", word));
      }
      joint().channels.push_back(*channel);
    }
    innermost().has_channels = true;
  }

  Tokenizer& tokens_;
  const files::CsvText& text_;
  std::vector<BvhJoint>& joints_;
  int joint_count_ = 0;
  std::vector<OpenJoint> open_;
  std::set<std::string> names_;
};

/// Reads the number of "Frames: 12" or "Frame Time:.01", with blanks anywhere.
double read_setting(Tokenizer& tokens, const files::CsvText& text, std::string_view key) {
  std::string line(tokens.next());
  if (line.empty()) tokens.fail(key, "is missing: the file ends before it");
  line += " " + tokens.rest_of_line();
  std::string setting = to_lower(line), expected = to_lower(key) + ":";
  std::erase_if(setting, is_blank);
  std::erase_if(expected, is_blank);
  if (!setting.starts_with(expected))
    tokens.fail(key, fmt::format("'{}:' expected, not '{}'", key, line));
  return text.number(tokens.line(), key, std::string_view(setting).substr(expected.size()));
}

void read_row(const files::CsvText& text, std::size_t line, Eigen::Index channels, double* row) {
  const std::string& cells = text.lines[line - 1];
  Eigen::Index count = 0;
  for (auto begin = std::ranges::find_if_not(cells, is_blank); begin != cells.end();) {
    const auto end = std::find_if(begin, cells.end(), is_blank);
    if (count < channels) row[count] = text.number(line, "MOTION", std::string_view(begin, end));
    ++count;
    begin = std::find_if_not(end, cells.end(), is_blank);
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
  Tokenizer tokens(text);
  Hierarchy(tokens, text, bvh.joints).read();
  tokens.expect("MOTION");
  const double frames = read_setting(tokens, text, "Frames");
  if (frames < 0 || frames > 1e9 || frames != std::floor(frames))
    tokens.fail("Frames", "must be a whole number");
  bvh.declared_frame_count = static_cast<int>(frames);
  bvh.frame_s = read_setting(tokens, text, "Frame Time");
  bvh.frame_time_line = tokens.line();

  std::vector<std::size_t> row_lines;
  for (std::size_t line = tokens.line() + 1; line <= text.lines.size(); ++line) {
    if (!std::ranges::all_of(text.lines[line - 1], is_blank)) row_lines.push_back(line);
  }
  if (row_lines.empty()) text.fail(text.lines.size(), "MOTION", "the file has no frames");
  Eigen::Index channels = 0;
  for (const BvhJoint& joint : bvh.joints) channels += std::ssize(joint.channels);
  bvh.rows.resize(row_lines.size(), channels);
  for (std::size_t i = 0; i < row_lines.size(); ++i)
    read_row(text, row_lines[i], channels, bvh.rows.row(i).data());
  return bvh;
}

void bvh_forward_kinematics(const BvhFile& bvh, const double* row, BvhPoses& poses) {
  poses.position.resize(bvh.joints.size());
  poses.orientation.resize(bvh.joints.size());
  for (std::size_t j = 0; j < bvh.joints.size(); ++j) {
    const BvhJoint& joint = bvh.joints[j];
    Vec3 position = joint.offset;
    Quat rotation = Quat::Identity();
    for (const BvhChannel& channel : joint.channels) {
      if (row == nullptr) break;
      const double value = *row++;
      if (channel.rotates) {
        const double half = value * M_PI / 360;
        Vec3 axis = Vec3::Zero();
        axis[channel.axis] = std::sin(half);
        rotation = rotation * Quat(std::cos(half), axis.x(), axis.y(), axis.z());
      } else {
        position[channel.axis] = value;
      }
    }
    if (joint.parent < 0) {
      poses.position[j] = row == nullptr ? Vec3(Vec3::Zero()) : position;
      poses.orientation[j] = rotation;
      continue;
    }
    const int parent = joint.parent;
    poses.position[j] = poses.position[parent] + poses.orientation[parent] * position;
    poses.orientation[j] = (poses.orientation[parent] * rotation).normalized();
  }
}

}  // namespace morphe::imports
