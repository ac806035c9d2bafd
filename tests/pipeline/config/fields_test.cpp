#include "pipeline/config/fields.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace morphe::config {
namespace {

struct Inner {
  double x = 1;
  std::vector<std::string> names;
  bool operator==(const Inner&) const = default;
};
template <class Fields>
void fields(Fields& f, Inner& o) {
  f("x", o.x);
  f("names", o.names);
}

struct Options {
  bool on = false;
  int count = 3;
  std::uint64_t seed = 1;
  double tolerance = 0.1;
  std::string word = "default";
  Vec3 point = Vec3::Zero();
  std::vector<double> numbers = {1, 2};
  std::vector<std::vector<int>> rows;
  std::optional<double> maybe, never;
  Inner inner;
  std::vector<Inner> list;
  bool operator==(const Options&) const = default;
};
template <class Fields>
void fields(Fields& f, Options& o) {
  f("on", o.on);
  f("count", o.count);
  f("seed", o.seed);
  f("tolerance", o.tolerance);
  f("word", o.word);
  f("point", o.point);
  f("numbers", o.numbers);
  f("rows", o.rows);
  f("maybe", o.maybe);
  f("never", o.never);
  f("inner", o.inner);
  f("list", o.list);
}
std::string why_invalid(const Options& o) {
  return o.count < 0 ? "count must not be negative" : "";
}

struct Strict {
  double needed = 0;
};
template <class Fields>
void fields(Fields& f, Strict& o) {
  f.required("needed", o.needed);
}

template <class T>
T read(const std::string& text) {
  const ConfigNode root = ConfigNode::parse(text, "o.yaml");
  T options;
  read_options(root, options);
  root.expect_all_read();
  return options;
}

template <class T>
std::string error_of(const std::string& text) {
  try {
    read<T>(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Fields, WriteThenReadGivesTheSameValues) {
  Options options;
  options.on = true;
  options.count = -0;
  options.seed = 18446744073709551615u;
  options.tolerance = 0.1 + 0.2;
  options.word = "it's: a #word";
  options.point = {1e-300, -1.0 / 3, 1e20};
  options.numbers = {std::nextafter(1.0, 2.0)};
  options.rows = {{1, 2}, {3}, {}};
  options.maybe = 5;
  options.inner = {7, {"a", ""}};
  options.list = {{1, {}}, {2, {"x", "y"}}};
  const std::string text = write_options(options);
  EXPECT_EQ(read<Options>(text), options) << text;
  EXPECT_EQ(write_options(read<Options>(text)), text);
}

TEST(Fields, DefaultsSurviveTheRoundTrip) {
  EXPECT_EQ(read<Options>(write_options(Options{})), Options{});
}

TEST(Fields, AbsentAndEmptyKeysKeepTheirDefaults) {
  const Options options = read<Options>("count: 9\nword:\ninner: {x: 4}\n");
  Options expected;
  expected.count = 9;
  expected.inner.x = 4;
  EXPECT_EQ(options, expected);
}

TEST(Fields, ListsReplaceTheirDefaults) {
  EXPECT_THAT(read<Options>("numbers: [5]").numbers, testing::ElementsAre(5));
  EXPECT_THAT(read<Options>("numbers: []").numbers, testing::IsEmpty());
}

TEST(Fields, ErrorsNameFileLineAndKey) {
  EXPECT_EQ(error_of<Options>("on: true\ninner: {x: 1,\n  y: 2}\n"),
            "o.yaml:3: inner.y: unknown key");
  EXPECT_EQ(error_of<Options>("inner: 3"), "o.yaml:1: inner: must be a mapping of keys to values");
  EXPECT_EQ(error_of<Options>("count: 1.5"), "o.yaml:1: count: must be a whole number, not '1.5'");
  EXPECT_EQ(error_of<Options>("count: 5000000000"), "o.yaml:1: count: is out of range: 5000000000");
  EXPECT_EQ(error_of<Options>("seed: -1"),
            "o.yaml:1: seed: must be a whole number from 0 to 2^64 - 1, not '-1'");
  EXPECT_EQ(error_of<Strict>("other: 1"), "o.yaml:1: needed: is missing");
}

TEST(Fields, ChecksAreReportedWithTheSection) {
  EXPECT_EQ(error_of<Options>("count: -1"), "o.yaml:1: count must not be negative");
}

}  // namespace
}  // namespace morphe::config
