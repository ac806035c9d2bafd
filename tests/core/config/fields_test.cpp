#include "core/config/fields.hpp"

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
  f("x", o.x, KeyBounds{-10, 10});
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
  f("count", o.count, KeyBounds{0, 1000});
  f("seed", o.seed);
  f("tolerance", o.tolerance, bounds::kPositiveLength);
  f("word", o.word);
  f("point", o.point, KeyBounds{-1e21, 1e21});
  f("numbers", o.numbers, KeyBounds{0, 10});
  f("rows", o.rows, KeyBounds{0, 10});
  f("maybe", o.maybe, bounds::kAngle);
  f("never", o.never, bounds::kAngle);
  f("inner", o.inner);
  f("list", o.list);
}
std::string validation_error(const Options& o) {
  return o.count == 7 ? "count must not be seven" : "";
}

struct Strict {
  double needed = 0;
};
template <class Fields>
void fields(Fields& f, Strict& o) {
  f.required("needed", o.needed, bounds::kLength);
}

template <class T>
T read(const std::string& text) {
  const ConfigNode root = ConfigNode::parse(text, "o.yaml");
  T options;
  read_document(root, options);
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
  EXPECT_EQ(error_of<Options>("count: 5000000000"),
            "o.yaml:1: count: must be at least 0 and at most 1000, not 5000000000");
  EXPECT_EQ(error_of<Options>("seed: -1"),
            "o.yaml:1: seed: must be a whole number from 0 to 2^64 - 1, not '-1'");
  EXPECT_EQ(error_of<Strict>("{}"), "o.yaml:1: needed: is missing");
}

TEST(Fields, AllThatIsWrongIsToldAtOnce) {
  EXPECT_EQ(error_of<Options>("cuont: 1\non: 1\ninner: {x: far, nmaes: []}\nlist:\n"
                              "  - {x: 1, z: 2}\n  - 5\n  - {names: {a: {b: 1}}}\npoint: [1, 2]\n"),
            "o.yaml:2: on: must be true or false, not '1'\n"
            "o.yaml:8: point: must have 3 numbers, not 2\n"
            "o.yaml:3: inner.x: must be a number, not 'far'\n"
            "o.yaml:6: list[1]: must be a mapping of keys to values\n"
            "o.yaml:7: list[2].names: must be a list\n"
            "o.yaml:1: cuont: unknown key; did you mean 'count'?\n"
            "o.yaml:3: inner.nmaes: unknown key; did you mean 'names'?\n"
            "o.yaml:5: list[0].z: unknown key");
  EXPECT_EQ(error_of<Strict>("neded: 1"),
            "o.yaml:1: needed: is missing; is 'neded' a misspelling of it?\n"
            "o.yaml:1: neded: unknown key; did you mean 'needed'?");
}

TEST(Fields, NumbersKeepTheirBounds) {
  EXPECT_EQ(error_of<Options>("tolerance: 10\ncount: 1000\nmaybe: -100\nrows: [[0, 10]]"), "");
  EXPECT_EQ(error_of<Options>("tolerance: 0"),
            "o.yaml:1: tolerance: must be above 0 and at most 10 m, not 0");
  EXPECT_EQ(error_of<Options>("on: true\nmaybe: 6000 deg"),
            "o.yaml:2: maybe: must be at least -100 and at most 100 rad, not 6000 deg");
  EXPECT_EQ(error_of<Options>("numbers: [1, 11]\nrows: [[1], [2, -1]]\nneeded: 1e308"),
            "o.yaml:1: numbers[1]: must be at least 0 and at most 10, not 11\n"
            "o.yaml:2: rows[1][1]: must be at least 0 and at most 10, not -1\n"
            "o.yaml:3: needed: unknown key");
  EXPECT_EQ(error_of<Strict>("needed: 1e308"),
            "o.yaml:1: needed: must be at least 0 and at most 10 m, not 1e308");
  EXPECT_EQ(error_of<Strict>("needed: .nan"), "o.yaml:1: needed: must be a number, not '.nan'");
}

TEST(Fields, AMessageThatBeginsWithAKeyIsToldOfIt) {
  EXPECT_EQ(error_of<Options>("on: true\ncount: 7"), "o.yaml:2: count: must not be seven");
}

TEST(Fields, OneThatDoesNotIsToldOfTheSection) {
  const ConfigNode root = ConfigNode::parse("a:\n  b: 1", "o.yaml");
  EXPECT_THAT(
      [&] { root["a"].fail_at_key("c must be positive"); },
      testing::ThrowsMessage<InputError>(testing::StrEq("o.yaml:2: a: c must be positive")));
}

}  // namespace
}  // namespace morphe::config
