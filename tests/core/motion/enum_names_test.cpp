#include "core/motion/enum_names.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/motion/demonstration.hpp"
#include "core/motion/plan.hpp"

namespace morphe {
namespace {

template <class E>
class Names : public testing::Test {};
using Enumerations =
    testing::Types<Cause, FrameStatus, HandKind, SampleOrigin, PhaseKind, Reason, Shape, Side>;
TYPED_TEST_SUITE(Names, Enumerations);

TYPED_TEST(Names, LeadBackToTheirValues) {
  std::set<std::string_view> names;
  for (std::size_t k = 0; k < enum_count<TypeParam>(); ++k) {
    const auto value = static_cast<TypeParam>(k);
    names.insert(name_of(value));
    EXPECT_EQ(enum_from_name<TypeParam>(name_of(value)), value);
  }
  EXPECT_EQ(names.size(), enum_count<TypeParam>());
  EXPECT_EQ(enum_from_name<TypeParam>("nothing of the kind"), std::nullopt);
}

// A table that is shifted by one would still lead back.
TEST(Name, IsThatOfItsValue) {
  EXPECT_EQ(name_of(PhaseKind::return_phase), "return");
  EXPECT_EQ(name_of(PhaseKind::reach), "reach");
  EXPECT_EQ(name_of(Cause::tracking), "tracking");
  EXPECT_EQ(name_of(Cause::object_collision), "object_collision");
  EXPECT_EQ(name_of(Reason::none), "");
  EXPECT_EQ(name_of(Reason::goal_in_collision), "goal_in_collision");
  EXPECT_EQ(name_of(Reason::smoothing_collision), "smoothing_collision");
  EXPECT_EQ(name_of(Reason::no_retreat), "no_retreat");
  EXPECT_EQ(name_of(Reason::no_reference_frame), "no_reference_frame");
  EXPECT_EQ(name_of(Reason::released_in_air), "released_in_air");
  EXPECT_EQ(name_of(Reason::rejected), "rejected");
  EXPECT_EQ(name_of(HandKind::keypoints), "keypoints");
  EXPECT_EQ(name_of(SampleOrigin::re_solved), "re_solved");
}

TEST(Choice, ReadsLikeASentence) {
  EXPECT_EQ(list_names<Side>(), "right or left");
  EXPECT_EQ(list_names<SampleOrigin>(), "mapped, re_solved or planned");
}

}  // namespace
}  // namespace morphe
