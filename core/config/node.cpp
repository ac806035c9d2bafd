#include "core/config/node.hpp"

#include <fmt/format.h>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "core/config/renamed_keys.hpp"
#include "core/config/spelling_hint.hpp"
#include "core/files/printable.hpp"

namespace morphe::config {
namespace {

constexpr std::size_t kMaxValueCount = 1'000'000, kMaxDocumentBytes = std::size_t{64} << 20;
constexpr int kMaxNestingDepth = 100;

/// Finds the first line with content in a document.
struct ContentDetector : YAML::EventHandler {
  int line = 0;  ///< 0 = no content

  void notice(const YAML::Mark& mark) {
    if (line == 0) line = mark.line + 1;
  }
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { notice(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                const std::string&) override {
    notice(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    notice(mark);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    notice(mark);
  }
  void OnMapEnd() override {}
};

/// Parses the single document of a text. (YAML::LoadAll does not terminate on some texts.)
YAML::Node parse_single_document(const std::string& text, const std::string& label) {
  if (text.size() > kMaxDocumentBytes)
    throw InputError(fmt::format("{}: is longer than {} MB", label, kMaxDocumentBytes >> 20));
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  ContentDetector first, second;
  if (parser.HandleNextDocument(first) && parser.HandleNextDocument(second) && second.line > 0)
    throw InputError(fmt::format("{}:{}: a second YAML document begins; only one is allowed", label,
                                 second.line));
  return YAML::Load(text);
}

/// Returns the content of a file. An error about one that is missing on the disk has a hint.
std::string read_text(const std::filesystem::path& file, const files::GivenFiles* given) {
  try {
    return files::read_bytes(file, given);
  } catch (const InputError& error) {
    if (given) throw;
    throw InputError(error.what() + file_spelling_hint(file));
  }
}

std::string join(const std::string& path, std::string_view key) {
  const std::string shown = files::make_printable(key);
  return path.empty() ? shown : fmt::format("{}.{}", path, shown);
}

/// Returns a hint which of the unrequested keys is meant to be the missing one, or "".
std::string missing_key_hint(std::string_view key, const std::vector<std::string>& unrequested) {
  const std::string former = former_name(key, unrequested);
  if (!former.empty()) return fmt::format("; '{}' is now called '{}'", former, key);
  const std::string misspelt = nearest_word(key, unrequested);
  return misspelt.empty() ? "" : fmt::format("; is '{}' a misspelling of it?", misspelt);
}

}  // namespace

struct ConfigNode::Value {
  enum class Kind { empty, scalar, list, map } kind = Kind::empty;
  std::string scalar;
  std::vector<std::pair<std::string, std::unique_ptr<Value>>> children;  ///< empty keys for a list
  std::string file, origin;  ///< origin: "FILE:LINE" or "--set a.b"
  int line = 0;
  bool read = false;
  std::set<std::string, std::less<>> requested_keys;
  std::map<std::string, Value*, std::less<>> by_key;  ///< children of a map

  Value* find(std::string_view key) const {
    const auto found = by_key.find(key);
    return found == by_key.end() ? nullptr : found->second;
  }
  void add(const std::string& key, std::unique_ptr<Value> child) {
    if (kind == Kind::map) by_key[key] = child.get();
    children.emplace_back(key, std::move(child));
  }
  void put(const std::string& key, std::unique_ptr<Value> child) {
    const auto old = std::ranges::find(children, key, &decltype(children)::value_type::first);
    if (old == children.end()) return add(key, std::move(child));
    by_key[key] = child.get();
    old->second = std::move(child);
  }
  void erase(std::string_view key) {
    std::erase_if(children, [&](const auto& child) { return child.first == key; });
    if (const auto found = by_key.find(key); found != by_key.end()) by_key.erase(found);
  }
  void mark_all_read() {
    read = true;
    for (const auto& entry : children) entry.second->mark_all_read();
  }
  std::vector<std::string> unrequested_keys() const {
    std::vector<std::string> names;
    for (const auto& entry : children)
      if (!requested_keys.contains(entry.first)) names.push_back(entry.first);
    return names;
  }
  std::unique_ptr<Value> clone() const {
    auto copy = std::make_unique<Value>();
    copy->kind = kind;
    copy->scalar = scalar;
    copy->file = file;
    copy->origin = origin;
    copy->line = line;
    copy->read = read;
    for (const auto& [key, child] : children) copy->add(key, child->clone());
    return copy;
  }
  void extend(const Value& base) {
    if (kind != Kind::map || base.kind != Kind::map) return;
    for (const auto& [key, child] : base.children)
      if (Value* own = find(key))
        own->extend(*child);
      else
        add(key, child->clone());
  }
  void set_file(const std::string& name) {
    file = name;
    for (auto& entry : children) entry.second->set_file(name);
  }

  /// The rest of a document's limits: aliases can expand a short text to an infinite value.
  struct ConversionLimits {
    std::size_t values = kMaxValueCount;
    int depth = kMaxNestingDepth;
  };

  static std::unique_ptr<Value> convert(const YAML::Node& node, const std::string& label,
                                        ConversionLimits& budget) {
    auto value = std::make_unique<Value>();
    value->line = node.Mark().line + 1;
    value->file = label;
    value->origin = fmt::format("{}:{}", label, value->line);
    if (budget.depth == 0)
      throw InputError(fmt::format("{}: is nested deeper than {} levels, or contains itself",
                                   value->origin, kMaxNestingDepth));
    if (budget.values == 0)
      throw InputError(
          fmt::format("{}: the document has more than {} values", value->origin, kMaxValueCount));
    --budget.values;
    --budget.depth;
    if (node.IsScalar()) {
      value->kind = Kind::scalar;
      value->scalar = node.Scalar();
    } else if (node.IsSequence()) {
      value->kind = Kind::list;
      for (const YAML::Node& item : node) value->add("", convert(item, label, budget));
    } else if (node.IsMap()) {
      value->kind = Kind::map;
      for (const auto& entry : node) {
        const std::string key = entry.first.as<std::string>();
        const int line = entry.first.Mark().line + 1;
        if (value->find(key))
          throw InputError(fmt::format("{}:{}: {}: the key appears twice", label, line,
                                       files::make_printable(key)));
        auto child = convert(entry.second, label, budget);
        if (child->kind == Kind::empty) child->origin = fmt::format("{}:{}", label, line);
        value->add(key, std::move(child));
      }
    }
    ++budget.depth;
    return value;
  }
};

struct ConfigNode::Document {
  std::filesystem::path file;
  std::unique_ptr<Value> root;
  const files::GivenFiles* given = nullptr;
};

ConfigNode ConfigNode::load(const std::filesystem::path& file, const files::GivenFiles* given) {
  const std::filesystem::path found = files::located(file, given);
  ConfigNode node = parse(read_text(found, given), found.string());
  node.document_->file = found;
  node.document_->given = given;
  return node;
}

ConfigNode ConfigNode::parse(const std::string& text, const std::string& label) {
  auto document = std::make_shared<Document>();
  document->file = label;
  try {
    Value::ConversionLimits budget;
    document->root = Value::convert(parse_single_document(text, label), label, budget);
  } catch (const YAML::Exception& error) {
    throw InputError(
        fmt::format("{}:{}: not valid YAML: {}", label, error.mark.line + 1, error.msg));
  }
  Value* root = document->root.get();
  if (root->kind == Value::Kind::empty) throw InputError(label + ": is empty");
  return {std::move(document), root, ""};
}

bool ConfigNode::is_map() const { return value_->kind == Value::Kind::map; }
bool ConfigNode::is_list() const { return value_->kind == Value::Kind::list; }
bool ConfigNode::is_scalar() const { return value_->kind == Value::Kind::scalar; }
bool ConfigNode::has(std::string_view key) const {
  if (!is_map()) return false;
  value_->requested_keys.emplace(key);
  Value* child = value_->find(key);
  if (!child) return false;
  if (child->kind == Value::Kind::empty) child->read = true;  // "key:" alone requests the default
  return child->kind != Value::Kind::empty;
}

std::vector<std::string> ConfigNode::keys() const {
  std::vector<std::string> names;
  for (const auto& entry : value_->children) names.push_back(entry.first);
  return names;
}

ConfigNode ConfigNode::operator[](std::string_view key) const {
  expect_map();
  value_->requested_keys.emplace(key);
  Value* child = value_->find(key);
  if (!child)
    throw InputError(fmt::format("{}: {}: is missing{}", value_->origin, join(key_, key),
                                 missing_key_hint(key, value_->unrequested_keys())));
  child->read = true;
  return {document_, child, join(key_, key)};
}

std::vector<ConfigNode> ConfigNode::items() const {
  if (!is_list()) fail_shape("must be a list");
  std::vector<ConfigNode> nodes;
  for (const auto& [key, child] : value_->children)
    nodes.push_back({document_, child.get(), fmt::format("{}[{}]", key_, nodes.size())});
  return nodes;
}

std::string ConfigNode::text() const {
  if (!is_scalar()) fail_shape("must be a single value");
  return value_->scalar;
}

bool ConfigNode::boolean() const {
  const std::string word = text();
  if (word == "true") return true;
  if (word == "false") return false;
  fail(fmt::format("must be true or false, not '{}'", word));
}

std::int64_t ConfigNode::integer() const {
  const std::string word = text();
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size())
    fail(fmt::format("must be a whole number, not '{}'", word));
  return number;
}

double ConfigNode::number() const {
  std::string word = text();
  double factor = 1;
  if (word.ends_with("deg")) {
    factor = kRadPerDegree;
    word.resize(word.size() - 3);
    while (word.ends_with(' ')) word.pop_back();
  }
  const char* begin = word.data() + (word.starts_with('+') && !word.starts_with("+-") ? 1 : 0);
  double number = 0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(number))
    fail(fmt::format("must be a number, not '{}'", text()));
  return number * factor;
}

std::int64_t ConfigNode::integer(const KeyBounds& bounds) const {
  const std::int64_t number = integer();
  if (!bounds.contain(static_cast<double>(number))) fail_at_value(bounds);
  return number;
}

double ConfigNode::number(const KeyBounds& bounds) const {
  const double value = number();
  if (!bounds.contain(value)) fail_at_value(bounds);
  return value;
}

std::vector<double> ConfigNode::numbers(const KeyBounds& bounds) const {
  std::vector<double> values;
  for (const ConfigNode& item : items()) values.push_back(item.number(bounds));
  return values;
}

Vec3 ConfigNode::vec3(const KeyBounds& bounds) const {
  const std::vector<double> values = numbers(bounds);
  if (values.size() != 3) fail(fmt::format("must have 3 numbers, not {}", values.size()));
  return {values[0], values[1], values[2]};
}

std::vector<std::string> ConfigNode::texts() const {
  std::vector<std::string> values;
  for (const ConfigNode& item : items()) values.push_back(item.text());
  return values;
}

void ConfigNode::set(const std::string& dotted_path, const std::string& value) {
  const std::string label = fmt::format("--set {}", dotted_path);
  std::unique_ptr<Value> replacement;
  try {
    Value::ConversionLimits budget;
    replacement = Value::convert(parse_single_document(value, label), label, budget);
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: not valid YAML: {}", label, error.msg));
  }
  replacement->origin = label;
  replacement->set_file(document_->root->file);
  Value* parent = value_;
  std::stringstream path(dotted_path);
  std::vector<std::string> keys;
  for (std::string key; std::getline(path, key, '.');) keys.push_back(key);
  if (keys.empty()) throw InputError("--set: must have the form a.b=value");
  if (std::ssize(keys) > kMaxNestingDepth)
    throw InputError(fmt::format("--set: names more than {} levels", kMaxNestingDepth));
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    Value* child = parent->find(keys[i]);
    if (!child) {
      auto made = std::make_unique<Value>();
      made->kind = Value::Kind::map;
      made->origin = label;
      made->file = document_->root->file;
      child = made.get();
      parent->add(keys[i], std::move(made));
    }
    if (child->kind == Value::Kind::empty) child->kind = Value::Kind::map;
    if (child->kind != Value::Kind::map)
      throw InputError(fmt::format("{}: '{}' is not a section", label, keys[i]));
    parent = child;
  }
  parent->put(keys.back(), std::move(replacement));
}

void ConfigNode::extend(const ConfigNode& base) { value_->extend(*base.value_); }

void ConfigNode::erase(std::string_view key) { value_->erase(key); }

ConfigNode ConfigNode::copy_as_document() const {
  auto document = std::make_shared<Document>();
  document->file = document_->file;
  document->given = document_->given;
  document->root = value_->clone();
  Value* root = document->root.get();
  return {std::move(document), root, key_};
}

void ConfigNode::report_unread_keys(ErrorList& problems) const {
  constexpr int kMaxReportedKeys = 1000;  // limits the length of the message
  int found = 0;
  const auto visit = [&](const auto& self, const Value& value, const std::string& path) -> void {
    for (std::size_t i = 0; i < value.children.size() && found < kMaxReportedKeys; ++i) {
      const auto& [key, child] = value.children[i];
      const bool in_map = value.kind == Value::Kind::map;
      const std::string child_path = in_map ? join(path, key) : fmt::format("{}[{}]", path, i);
      if (in_map && !child->read) {
        ++found;
        problems.add(fmt::format(
            "{}: {}: unknown key{}", child->origin, child_path,
            spelling_hint(key, {value.requested_keys.begin(), value.requested_keys.end()})));
      } else {
        self(self, *child, child_path);
      }
    }
  };
  visit(visit, *document_->root, value_ == document_->root.get() ? key_ : "");
}

void ConfigNode::require_all_keys_read() const {
  ErrorList problems;
  report_unread_keys(problems);
  problems.throw_if_any();
}

void ConfigNode::expect_map() const {
  if (!is_map()) fail_shape("must be a mapping of keys to values");
}

void ConfigNode::fail_shape(const std::string& message) const {
  value_->mark_all_read();
  fail(message);
}

void ConfigNode::fail_at_value(const KeyBounds& bounds) const {
  fail(fmt::format("must be {}, not {}", text_of(bounds), text()));
}

void ConfigNode::fail_at_key(const std::string& message) const {
  const std::size_t end = message.find_first_of(": ");
  const std::string key = message.substr(0, end);
  if (end == std::string::npos || !is_map() || !has(key)) fail(message);
  (*this)[key].fail(message.substr(message.find_first_not_of(": ", end)));
}

void ConfigNode::fail(const std::string& message) const {
  throw InputError(key_.empty() ? fmt::format("{}: {}", value_->origin, message)
                                : fmt::format("{}: {}: {}", value_->origin, key_, message));
}

std::filesystem::path ConfigNode::file() const { return value_->file; }
std::filesystem::path ConfigNode::folder() const {
  return std::filesystem::path(value_->file).parent_path();
}
const files::GivenFiles* ConfigNode::given() const { return document_->given; }
int ConfigNode::line() const { return value_->line; }

}  // namespace morphe::config
