#include "core/config/node.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <numbers>

namespace morphe::config {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::StartsWith;

/// The message of the InputError that `action` throws, "" if it throws none.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

ConfigNode parse(const std::string& text) { return ConfigNode::parse(text, "a.yaml"); }

TEST(ConfigNode, ReadsEveryKindOfValue) {
  const ConfigNode root = parse(
      "text: some words\nyes: true\ncount: -7\nx: 1.5e-3\nplus: +2\n"
      "point: [1, 2, 3]\nnames: [a, b]\nnested: {deep: {x: 4}}\n");
  EXPECT_EQ(root["text"].text(), "some words");
  EXPECT_TRUE(root["yes"].boolean());
  EXPECT_EQ(root["count"].integer(), -7);
  EXPECT_EQ(root["x"].number(), 1.5e-3);
  EXPECT_EQ(root["plus"].number(), 2);
  EXPECT_EQ(root["point"].vec3(bounds::kCoordinate), Vec3(1, 2, 3));
  EXPECT_THAT(root["names"].texts(), ElementsAre("a", "b"));
  EXPECT_EQ(root["nested"]["deep"]["x"].number(), 4);
  EXPECT_EQ(root["nested"]["deep"]["x"].key(), "nested.deep.x");
  EXPECT_THAT(root.keys(),
              ElementsAre("text", "yes", "count", "x", "plus", "point", "names", "nested"));
  EXPECT_NO_THROW(root.require_all_keys_read());
}

TEST(ConfigNode, DegreesBecomeRadians) {
  const ConfigNode root = parse("angles: [180 deg, -90deg, 1, 0.5 deg]\n");
  EXPECT_THAT(
      root["angles"].numbers(bounds::kJointPosition),
      ElementsAre(std::numbers::pi, -std::numbers::pi / 2, 1, 0.5 * std::numbers::pi / 180));
}

TEST(ConfigNode, RefusesWhatIsNoNumber) {
  for (const char* word : {".inf", ".nan", "nan", "inf deg", "1,5", "2x", "+-3", "1e999", "deg"}) {
    const ConfigNode root = parse(std::string("\na: {x: '") + word + "'}\n");
    const std::string error = error_of([&] { (void)root["a"]["x"].number(); });
    EXPECT_THAT(error, StartsWith("a.yaml:2: a.x: must be a number")) << word;
  }
}

TEST(ConfigNode, ErrorsNameFileLineAndKey) {
  const ConfigNode root = parse("a: 1\nlist:\n  - {x: 2}\n  - {x: wrong}\n");
  EXPECT_EQ(error_of([&] { (void)root["list"].items()[1]["x"].number(); }),
            "a.yaml:4: list[1].x: must be a number, not 'wrong'");
  EXPECT_EQ(error_of([&] { (void)root["list"].items()[0]["y"]; }),
            "a.yaml:3: list[0].y: is missing");
  EXPECT_EQ(error_of([&] { (void)root["a"]["b"]; }),
            "a.yaml:1: a: must be a mapping of keys to values");
  EXPECT_EQ(error_of([&] { (void)root["list"].vec3(bounds::kCoordinate); }).substr(0, 9),
            "a.yaml:3:");
  EXPECT_EQ(error_of([&] { (void)root["a"].items(); }), "a.yaml:1: a: must be a list");
}

TEST(ConfigNode, UnreadKeysAreErrors) {
  const ConfigNode root = parse("a: 1\nmap:\n  x: 2\n  typo: 3\nlist:\n  - y: 1\n    z: 2\n");
  (void)root["a"];
  (void)root["map"]["x"];
  EXPECT_EQ(error_of([&] { root.require_all_keys_read(); }),
            "a.yaml:4: map.typo: unknown key\na.yaml:6: list: unknown key");
  (void)root["map"]["typo"];
  for (const ConfigNode& item : root["list"].items()) (void)item["y"];
  EXPECT_EQ(error_of([&] { root.require_all_keys_read(); }), "a.yaml:7: list[0].z: unknown key");
}

TEST(ConfigNode, AKeyWithoutAValueAsksForTheDefault) {
  const ConfigNode root = parse("known:\nother:\n");
  EXPECT_FALSE(root.has("known"));
  EXPECT_EQ(error_of([&] { root.require_all_keys_read(); }), "a.yaml:2: other: unknown key");
}

TEST(ConfigNode, RefusesARepeatedKey) {
  EXPECT_EQ(error_of([] { parse("a: 1\nb: 2\na: 3\n"); }), "a.yaml:3: a: the key appears twice");
}

TEST(ConfigNode, RefusesWhatIsNoYaml) {
  EXPECT_THAT(error_of([] { parse("a: 1\nb: [1, 2\n"); }), StartsWith("a.yaml:"));
  EXPECT_EQ(error_of([] { parse(""); }), "a.yaml: is empty");
}

TEST(ConfigNode, LoadTellsMissingFromEmpty) {
  const std::filesystem::path folder = testing::TempDir();
  const std::filesystem::path file = folder / "config_node_empty.yaml";
  std::ofstream(file).close();
  EXPECT_THAT(error_of([&] { ConfigNode::load(file); }), EndsWith(": is empty"));
  std::filesystem::remove(file);
  EXPECT_THAT(error_of([&] { ConfigNode::load(file); }), EndsWith(": cannot be read"));
  EXPECT_THAT(error_of([&] { ConfigNode::load(folder); }), EndsWith(": cannot be read"));
}

TEST(ConfigNode, PathsAreRelativeToTheFile) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "config_node.yaml";
  std::ofstream(file) << "a: 1\n";
  const ConfigNode root = ConfigNode::load(file);
  EXPECT_EQ(root.file(), file);
  EXPECT_EQ(root["a"].folder(), file.parent_path());
  EXPECT_EQ(root["a"].line(), 1);
  std::filesystem::remove(file);
}

TEST(ConfigNode, SetReplacesAndAdds) {
  ConfigNode root = parse("map: {w_x: 1000, w_a: 1}\nempty:\n");
  root.set("map.w_x", "5");
  root.set("map.start", "[1, 2, 3]");
  root.set("new.deep.key", "word");
  root.set("empty.x", "3 deg");
  EXPECT_EQ(root["map"]["w_x"].number(), 5);
  EXPECT_EQ(root["map"]["w_a"].number(), 1);
  EXPECT_EQ(root["map"]["start"].vec3(bounds::kCoordinate), Vec3(1, 2, 3));
  EXPECT_EQ(root["new"]["deep"]["key"].text(), "word");
  EXPECT_DOUBLE_EQ(root["empty"]["x"].number(), 3 * std::numbers::pi / 180);
  EXPECT_NO_THROW(root.require_all_keys_read());
}

TEST(ConfigNode, SetIsNamedInErrors) {
  ConfigNode root = parse("map: {w_x: 1000}\n");
  EXPECT_EQ(error_of([&] { root.set("map.w_x.y", "1"); }),
            "--set map.w_x.y: 'w_x' is not a section");
  root.set("map.w_x", "much");
  EXPECT_EQ(error_of([&] { (void)root["map"]["w_x"].number(); }),
            "--set map.w_x: map.w_x: must be a number, not 'much'");
  root.set("map.typo", "1");
  EXPECT_EQ(error_of([&] { root.require_all_keys_read(); }),
            "--set map.typo: map.typo: unknown key");
}

}  // namespace
}  // namespace morphe::config
