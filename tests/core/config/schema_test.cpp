#include "core/config/schema.hpp"

#include <gmock/gmock.h>

namespace morphe::config {
namespace {

struct Section {
  double share = 0.5;  ///< in (0, 1]
  double length = 2;   ///< at least 0
  int count = 3;       ///< at least 1
  std::optional<double> maybe;
};
template <class Fields>
void fields(Fields& f, Section& o) {
  f("share", o.share, bounds::kPositiveShare);
  f("length", o.length, bounds::kLength);
  f("count", o.count, bounds::kCount);
  f("maybe", o.maybe, KeyBounds{0, 1, "", true, true});
}
struct Item {
  std::string name;
  Vec3 point = Vec3::Zero();
};
template <class Fields>
void fields(Fields& f, Item& o) {
  f.required("name", o.name);
  f("point", o.point, bounds::kCoordinate);
}

struct Whole {
  Section section;
  std::vector<Item> items;
  bool on = true;
};
template <class Fields>
void fields(Fields& f, Whole& o) {
  f("section", o.section);
  f("items", o.items);
  f("on", o.on);
}

const KeyDescriptions kMeanings = [](const std::string& type, const std::string& key) {
  return type == "Section" && key == "share" ? "a part" : "";
};

TEST(Schema, HasTypesDefaultsAndMeanings) {
  const Schema schema = schema_of<Whole>(kMeanings)["properties"];
  EXPECT_EQ(schema["on"], (Schema{{"type", {"boolean", "null"}}, {"default", true}}));
  const Schema& share = schema["section"]["properties"]["share"];
  EXPECT_EQ(share["description"], "a part");
  EXPECT_EQ(share["default"], 0.5);
  EXPECT_EQ(schema["section"]["additionalProperties"], false);
  const Schema& item = schema["items"]["items"];
  EXPECT_EQ(item["required"], Schema({"name"}));
  EXPECT_EQ(item["properties"]["point"]["minItems"], 3);
}

TEST(Schema, StatesTheBounds) {
  const Schema keys = schema_of<Whole>(kMeanings)["properties"]["section"]["properties"];
  EXPECT_EQ(keys["share"]["exclusiveMinimum"], 0);
  EXPECT_EQ(keys["share"]["maximum"], 1);
  EXPECT_FALSE(keys["share"].contains("minimum"));
  EXPECT_EQ(keys["length"]["minimum"], 0);
  EXPECT_EQ(keys["length"]["maximum"], 10);
  EXPECT_EQ(keys["count"]["minimum"].dump(), "1");
  EXPECT_EQ(keys["count"]["maximum"].dump(), "1000000");
  EXPECT_EQ(keys["maybe"]["exclusiveMaximum"], 1);
  const Schema item = schema_of<Whole>(kMeanings)["properties"]["items"]["items"];
  EXPECT_EQ(item["properties"]["point"]["items"]["maximum"], 20);
}

TEST(Schema, TellsEveryKeyThatItDoesNotHave) {
  const ConfigNode node =
      ConfigNode::parse("on: true\nsecton: {}\nsection: {shar: 1}\nitems: [{name: a, x: 1}]", "a");
  ErrorList problems;
  report_unknown_keys(node, schema_of<Whole>(kMeanings), problems);
  try {
    problems.throw_if_any();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "a:2: secton: unknown key; did you mean 'section'?\n"
                 "a:3: section.shar: unknown key; did you mean 'share'?\n"
                 "a:4: items[0].x: unknown key");
  }
}

}  // namespace
}  // namespace morphe::config
