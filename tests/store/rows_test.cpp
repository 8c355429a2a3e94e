#include "store/rows.h"

#include <gtest/gtest.h>

#include <string>

namespace tetfarm {
namespace {

/// They lie in databases and travel in answers.
TEST(Rows, states_have_the_names_that_databases_know) {
  std::string names;
  for (int i = 0; i < 4; ++i) names += std::string(name_of(static_cast<JobPhase>(i))) + " ";
  EXPECT_EQ(names, "running done failed cancelled ");
  names.clear();
  for (int i = 0; i < 6; ++i) names += std::string(name_of(static_cast<TaskState>(i))) + " ";
  EXPECT_EQ(names, "waiting ready leased done failed replaced ");
  names.clear();
  for (int i = 0; i < 9; ++i) names += std::string(name_of(static_cast<AttemptState>(i))) + " ";
  EXPECT_EQ(names, "running done failed crashed killed lost returned revoked starved ");
  names.clear();
  for (int i = 0; i < 4; ++i) names += std::string(name_of(static_cast<SubdomainState>(i))) + " ";
  EXPECT_EQ(names, "open cut leaf joined ");
}

TEST(Rows, changes_are_empty_only_without_any) {
  EXPECT_TRUE(ChangeSet{}.empty());
  ChangeSet changes;
  changes.jobs.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.subdomains.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.tasks.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.workers.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.attempts.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.hosts.resize(1);
  EXPECT_FALSE(changes.empty());
  changes = {};
  changes.events.resize(1);
  EXPECT_FALSE(changes.empty());
}

}  // namespace
}  // namespace tetfarm
