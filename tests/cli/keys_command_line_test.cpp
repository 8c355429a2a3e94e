#include "cli/keys_command_line.h"

#include <gmock/gmock.h>

#include "tests/cli/parsed.h"

namespace tetfarm {
namespace {

using ::testing::HasSubstr;

using KeysCommandLine = PlainEnvironment;
using Action = KeysCommand::Action;

TEST_F(KeysCommandLine, each_action_takes_what_it_needs) {
  const auto make = parsed_as<KeysCommand>({"keys", "new", "anna", "--keys", "d"});
  EXPECT_EQ(make.action, Action::make);
  EXPECT_EQ(make.subject, "anna");
  EXPECT_EQ(make.folder, "d");
  const auto authorize = parsed_as<KeysCommand>(
      {"keys", "authorize", "anna.pub", "--role", "submitter", "--name", "a", "--keys", "d"});
  EXPECT_EQ(authorize.action, Action::authorize);
  EXPECT_EQ(authorize.subject, "anna.pub");
  EXPECT_EQ(authorize.role, "submitter");
  EXPECT_EQ(authorize.name, "a");
  EXPECT_EQ(authorize.folder, "d");
  const auto revoke = parsed_as<KeysCommand>({"keys", "revoke", "anna", "--keys", "d"});
  EXPECT_EQ(revoke.action, Action::revoke);
  EXPECT_EQ(revoke.subject, "anna");
  EXPECT_EQ(revoke.folder, "d");
  const auto list = parsed_as<KeysCommand>({"keys", "list", "--json", "--keys", "d"});
  EXPECT_EQ(list.action, Action::list);
  EXPECT_TRUE(list.json);
  EXPECT_EQ(list.folder, "d");
  EXPECT_FALSE(parsed_as<KeysCommand>({"keys", "list"}).json);
  for (const char* role : {"worker", "submitter", "viewer"}) {
    EXPECT_EQ(parsed_as<KeysCommand>({"keys", "authorize", "a.pub", "--role", role}).role, role);
  }
}

TEST_F(KeysCommandLine, the_folder_of_a_farm_may_come_from_the_environment) {
  ::setenv("TETFARM_KEYS", "/keys", 1);
  const auto list = parsed_as<KeysCommand>({"keys", "list"});
  ::unsetenv("TETFARM_KEYS");
  EXPECT_EQ(list.folder, "/keys");
}

TEST_F(KeysCommandLine, what_cannot_be_is_refused) {
  expect_refused({
      {{"keys", "new"}, "NAME is required"},
      {{"keys", "authorize", "a.pub"}, "--role is required"},
      {{"keys", "authorize", "--role", "worker"}, "KEY is required"},
      {{"keys", "revoke"}, "NAME is required"},
      {{"keys", "new", ""}, "NAME: must not be empty"},
  });
  EXPECT_THAT(refusal_of({"keys", "authorize", "a.pub", "--role", "king"}),
              HasSubstr("--role: king not in {"));
}

}  // namespace
}  // namespace tetfarm
