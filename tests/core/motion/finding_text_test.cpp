#include "core/motion/finding_text.hpp"

#include <gtest/gtest.h>

namespace morphe {
namespace {

TEST(Finding, SaysWhatIsWrongByHowMuch) {
  Finding finding{1.853, 2.81, Cause::object_collision, "thumb_distal", "cup", 0.0035};
  finding.limit = 0.001;
  EXPECT_EQ(sentence(finding), "thumb_distal is 3.5 mm too close to cup, 1.85–2.81 s");
  finding.limit = -0.005;
  EXPECT_EQ(sentence(finding), "thumb_distal is 3.5 mm too deep in cup, 1.85–2.81 s");
  EXPECT_EQ(excess_text(finding), "thumb_distal 3.5 mm too deep in cup");
}

TEST(Finding, JointsAreSaidInTheirUnit) {
  const double degree = 0.017453292519943295;
  Finding finding{1, 1, Cause::joint_limit, "elbow", "", 2 * degree, FindingUnit::radian, 1.5};
  EXPECT_EQ(sentence(finding), "joint elbow is 2.00 degrees beyond its limit, at 1.00 s");
  finding = {1, 1, Cause::jump, "lift", "", 0.002, FindingUnit::metre, 0.01};
  EXPECT_EQ(sentence(finding), "joint lift is 2.0 mm beyond the largest allowed step, at 1.00 s");
}

TEST(Finding, SmallAmountsKeepTheirDigits) {
  EXPECT_EQ(amount_text(3e-6, FindingUnit::metre), "0.003 mm");
  EXPECT_EQ(amount_text(1e-6, FindingUnit::radian), "5.7e-05 degrees");
  EXPECT_EQ(amount_text(kInfinity, FindingUnit::radian), "inf degrees");
}

TEST(Finding, ARadianCountsAtALever) {
  EXPECT_EQ((Finding{0, 0, Cause::tracking, "tip", "", 0.03}.excess_m()), 0.03);
  EXPECT_EQ((Finding{0, 0, Cause::jump, "elbow", "", 0.5, FindingUnit::radian}.excess_m()), 0.05);
}

}  // namespace
}  // namespace morphe
