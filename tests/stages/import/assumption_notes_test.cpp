#include "stages/import/recording/assumption_notes.hpp"

#include <gmock/gmock.h>

namespace morphe::imports {
namespace {

using testing::IsEmpty;

TEST(AssumptionNotes, HaveTheSubjectOfTheirFirstPart) {
  const auto found = assumptions_in(
      {"3 blank lines skipped", "unit not in the file; assumed mm, as written by Qualisys",
       "unit of 't' not in the file; assumed ms, 125 rows per second",
       "right hand assumed: the file does not show which hand reaches",
       "static trial: a_static.csv, chosen from 2 that may be of this person",
       "recording rotated by 3.0 degrees about the vertical, so that the person faces Y (trunk)"});
  ASSERT_EQ(found.size(), 5u);
  const char* subjects[] = {"unit", "rate", "side", "static_trial", "heading"};
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].subject, subjects[k]);
  EXPECT_EQ(found[0].kind, AssumptionKind::assumed);
  EXPECT_EQ(found[4].kind, AssumptionKind::inferred);
  EXPECT_EQ(found[2].value, "right hand assumed: the file does not show which hand reaches");
}

TEST(AssumptionNotes, AreNotThoseThatStateWhatTheFileSays) {
  EXPECT_THAT(assumptions_in({"static trial: a_static.csv", "axes 'x y z' as given",
                              "5 frame numbers are missing"}),
              IsEmpty());
}

}  // namespace
}  // namespace morphe::imports
