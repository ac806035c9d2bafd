#include "core/store/hdf5_file.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "same_bits.hpp"
#include "sample_data.hpp"

namespace morphe::store {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Hdf5File, ArraysOfAnyRankAndType) {
  const auto file = fresh_file("a.h5");
  const Hdf5Array<double> four{{2, 1, 3, 2}, {1, 2, 3, 4, -0.0, 6, kUnknown, 8, 9, 10, 11, 1e-320}};
  const Hdf5Array<std::int32_t> two{{1, 2}, {INT32_MIN, INT32_MAX}};
  const Hdf5Array<std::uint8_t> none{{0, 3}, {}};
  {
    Hdf5File out = Hdf5File::create(file);
    out.root().write("four", four);
    out.root().create("g").write("two", two);
    out.root().write("none", none);
    out.root().write_strings("words", {"ä", "", "longer", "with\nline"});
    out.root().write_strings("no words", {});
    out.root().write_text("text", "a\nb");
    out.close();
  }
  const Hdf5File in = Hdf5File::open(file);
  const Hdf5Group root = in.root();
  EXPECT_TRUE(same_bits(root.read<double>("four", {2, 1, kAnyLength, 2}).values, four.values));
  EXPECT_EQ(root.open("g").read<std::int32_t>("two", {kAnyLength, 2}).values, two.values);
  EXPECT_EQ(root.read<std::uint8_t>("none", {kAnyLength, 3}).dims, none.dims);
  EXPECT_THAT(root.read_strings("words"), ElementsAre("ä", "", "longer", "with\nline"));
  EXPECT_TRUE(root.read_strings("no words").empty());
  EXPECT_EQ(root.read_text("text"), "a\nb");
  EXPECT_THAT(root.children(), ElementsAre("four", "g", "none", "words", "no words", "text"));
  EXPECT_EQ(input_error([&] { root.open("g").read<double>("two", {3}); }),
            file.string() + ":/g/two: has shape [1,2], must be [3]");
  EXPECT_THAT(input_error([&] { root.read<std::int32_t>("four", {}); }),
              HasSubstr("/four: must contain integers"));
}

TEST(Hdf5File, LongArraysGoIntoSeveralChunks) {
  const auto file = fresh_file("a.h5");
  Hdf5Array<double> rows{{1000003, 3}, std::vector<double>(3000009)};  // 24 MB, no round number
  std::iota(rows.values.begin(), rows.values.end(), 0.5);
  {
    Hdf5File out = Hdf5File::create(file);
    out.root().write("rows", rows);
    out.close();
  }
  const Hdf5File in = Hdf5File::open(file);
  EXPECT_EQ(in.root().read<double>("rows", {kAnyLength, 3}).values, rows.values);
}

TEST(Hdf5File, Attributes) {
  const auto file = fresh_file("a.h5");
  const std::string text(200000, 'x');  // more than an object's header takes
  {
    Hdf5File out = Hdf5File::create(file);
    const Hdf5Group root = out.root();
    root.set("text", text);
    root.set("empty", std::string());
    root.set("number", kUnknown);
    root.set("integer", std::int32_t{-3});
    root.set("byte", std::uint8_t{255});
    root.set("numbers", std::vector<double>{1, 2.5});
    root.set("words", std::vector<std::string>{"a", "", "ß"});
    root.set("no words", std::vector<std::string>{});
    out.close();
  }
  const Hdf5File in = Hdf5File::open(file);
  const Hdf5Group root = in.root();
  std::string word;
  root.get("text", word);
  EXPECT_EQ(word, text);
  root.get("empty", word);
  EXPECT_EQ(word, "");
  double number = 0;
  root.get("number", number);
  EXPECT_TRUE(same_bits(number, kUnknown));
  std::int32_t integer = 0;
  root.get("integer", integer);
  EXPECT_EQ(integer, -3);
  std::uint8_t byte = 0;
  root.get("byte", byte);
  EXPECT_EQ(byte, 255);
  std::vector<double> numbers;
  root.get("numbers", numbers);
  EXPECT_THAT(numbers, ElementsAre(1, 2.5));
  std::vector<std::string> words;
  root.get("words", words);
  EXPECT_THAT(words, ElementsAre("a", "", "ß"));
  root.get("no words", words);
  EXPECT_TRUE(words.empty());
  EXPECT_EQ(input_error([&] { root.get("other", number); }),
            file.string() + ":/@other: is missing or not a single number");
  EXPECT_THAT(input_error([&] { root.get("numbers", number); }), HasSubstr("not a single number"));
  EXPECT_THAT(input_error([&] { root.get("text", number); }), HasSubstr("not a single number"));
}

}  // namespace
}  // namespace morphe::store
