#include <gtest/gtest.h>

#include "core/config/node.hpp"

namespace morphe::config {
namespace {

TEST(ConfigNode, ExtendingTakesWhatIsMissingAndKeepsWhereItStood) {
  ConfigNode node = ConfigNode::parse("map: {a: 1}\nlist: [1]\n", "special/own.yaml");
  node.extend(
      ConfigNode::parse("map: {a: 5, b: 2}\nlist: [7, 8]\nfile: x.yaml\n", "base/base.yaml"));
  EXPECT_EQ(node["map"]["a"].integer(), 1);
  EXPECT_EQ(node["map"]["b"].integer(), 2);
  EXPECT_EQ(node["list"].numbers(bounds::kJointPosition), std::vector<double>{1});
  EXPECT_EQ(node["file"].folder(), "base");
  EXPECT_EQ(node["map"]["a"].folder(), "special");
  node.require_all_keys_read();
}

TEST(ConfigNode, AnUnreadKeyOfTheBaseIsNamedWithTheBase) {
  ConfigNode node = ConfigNode::parse("a: 1\n", "own.yaml");
  node.extend(ConfigNode::parse("a: 5\nmap:\n  typo: 2\n", "base.yaml"));
  EXPECT_EQ(node["a"].integer(), 1);
  EXPECT_TRUE(node["map"].is_map());
  try {
    node.require_all_keys_read();
    FAIL() << "typo was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "base.yaml:3: map.typo: unknown key");
  }
}

}  // namespace
}  // namespace morphe::config
