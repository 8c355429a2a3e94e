// Databases as earlier programs left them (fixtures/schema_N.sql, made from the tables of those
// programs) are brought up with all their rows, and then take what they could not hold before.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>
#include <sstream>

#include "base/error.h"
#include "store/job_database.h"
#include "store/schema.h"
#include "store/sqlite_statement.h"
#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Migrations : public testing::TestWithParam<int> {
 protected:
  Migrations() {
    const std::string name = "schema_" + std::to_string(GetParam()) + ".sql";
    std::ifstream file(std::string(TETFARM_SOURCE_DIR) + "/tests/store/fixtures/" + name);
    std::ostringstream sql;
    sql << file.rdbuf();
    const SqlitePtr made = open_database(path(), DatabaseAccess::write);
    execute(made.get(), sql.str().c_str());
    EXPECT_EQ(schema_version(made.get()), GetParam());
  }
  std::filesystem::path path() const { return folder_.path() / "db"; }

  const TempFolder folder_;
};

void expect_rows_of_fixture(const JobDatabase& database, int version) {
  const DurableState state = database.load();
  const std::string inspected = "job " + std::string(32, 'a');
  ASSERT_THAT(state.jobs, SizeIs(2));
  EXPECT_EQ(state.jobs.at(JobId{1}).key, "key-1");
  EXPECT_EQ(state.jobs.at(JobId{1}).owner, "");
  EXPECT_EQ(state.jobs.at(JobId{1}).content,
            inspected + (version >= 7 ? "\ninput_surface " + std::string(32, 'b') : ""));
  EXPECT_EQ(state.jobs.at(JobId{2}),
            (JobRow{JobId{2}, "", "it's a box", "spacing = 2", JobPhase::failed, 3, "open edge",
                    2000, 2500, "", inspected}));
  ASSERT_THAT(state.subdomains, SizeIs(3));
  const SubdomainRow& leaf = state.subdomains.at({JobId{1}, 2});
  EXPECT_EQ(leaf.state, SubdomainState::leaf);
  EXPECT_EQ(leaf.tets, 120U);
  EXPECT_TRUE(leaf.meshed);
  ASSERT_THAT(state.tasks, SizeIs(5));
  const TaskRow& cut = state.tasks.at(TaskId{2});
  EXPECT_EQ(cut.kind, TaskKind::decompose);
  EXPECT_EQ(cut.losses, 1U);
  ASSERT_THAT(cut.outputs, SizeIs(2));
  EXPECT_EQ(cut.outputs[1], (ArtifactRef{"right", std::string(32, 'd'), 40}));
  EXPECT_EQ(cut.parameters.at("left_parts"), "1");
  EXPECT_EQ(state.tasks.at(TaskId{3}).numbers.at("tets"), 120);
  ASSERT_THAT(state.running_attempts, SizeIs(1));
  EXPECT_EQ(state.running_attempts.at(AttemptId{5}).nonce_hash, "") << "a nonce is forgotten";
  EXPECT_EQ(state.running_attempts.at(AttemptId{5}).key, "");
  EXPECT_EQ(state.running_attempts.at(AttemptId{5}).task, TaskId{4});
  EXPECT_EQ(state.running_attempts.at(AttemptId{5}).memory_bytes, version >= 4 ? 77U : 0U);
  EXPECT_THAT(state.quarantined_hosts, SizeIs(version >= 4 ? 1 : 0));
  EXPECT_EQ(state.last_attempt, 5U);
  EXPECT_EQ(state.last_worker, 2U);
  EXPECT_THAT(database.history().events({.job = JobId{1}}), SizeIs(3));
  EXPECT_THAT(database.history().attempts_of(TaskId{3}), SizeIs(2));
  EXPECT_THAT(database.damage(), IsEmpty());
}

std::string schema_of(const std::filesystem::path& path) {
  const SqlitePtr database = open_database(path, DatabaseAccess::read);
  Statement statement(database.get(), "SELECT group_concat(sql) FROM sqlite_schema");
  statement.step();
  return statement.text();
}

TEST_P(Migrations, keep_every_row) {
  const JobDatabase database(path());
  expect_rows_of_fixture(database, GetParam());
}

TEST_P(Migrations, that_fail_midway_leave_the_file_as_it_was) {
  // One of them makes an index of this name, and the last a column of that.
  execute(open_database(path(), DatabaseAccess::write).get(),
          GetParam() < 8 ? "CREATE TABLE one_job_of_a_key (x)"
                         : "ALTER TABLE jobs ADD COLUMN waits_for TEXT");
  const std::string before = schema_of(path());
  EXPECT_THROW(JobDatabase{path()}, IoError);
  EXPECT_EQ(schema_of(path()), before);
  EXPECT_EQ(schema_version(open_database(path(), DatabaseAccess::read).get()), GetParam());
}

TEST_P(Migrations, of_a_reader_leave_the_file_as_it_is) {
  {
    const JobDatabase reader = JobDatabase::open_to_read(path());
    expect_rows_of_fixture(reader, GetParam());
  }
  EXPECT_EQ(schema_version(open_database(path(), DatabaseAccess::read).get()), GetParam());
}

TEST_P(Migrations, make_room_for_what_is_new) {
  JobDatabase database(path());
  ChangeSet later;
  SubdomainRow joined = database.load().subdomains.at({JobId{1}, 3});
  joined.state = SubdomainState::joined;
  joined.joined_into = 2;
  joined.work = 1.5;
  later.subdomains = {joined};
  TaskRow task = database.load().tasks.at(TaskId{4});
  task.id = TaskId{6};
  task.kind = TaskKind::assimilate;
  task.path = 0;
  task.state = TaskState::ready;
  task.attempt = {};
  task.oom_count = 2;
  task.memory_bytes = std::uint64_t{3} << 30U;
  TaskRow mesh = database.load().tasks.at(TaskId{4});
  mesh.state = TaskState::replaced;
  mesh.attempt = {};
  TaskRow in_its_place = mesh;
  in_its_place.id = TaskId{7};
  in_its_place.state = TaskState::waiting;
  later.tasks = {mesh, task, in_its_place};
  AttemptRow rival{AttemptId{6}, TaskId{4}, WorkerId{2}, AttemptState::running, 6, 0, "", "hash",
                   true,         9};
  rival.host = "host-b";
  rival.key = "its key";
  AttemptRow starved{
      AttemptId{7}, TaskId{3}, WorkerId{2}, AttemptState::starved, 6, 8, "x", "", false, 9,
      12,           "its log"};
  later.attempts = {rival, starved};
  JobRow of_another = database.load().jobs.at(JobId{1});
  of_another.id = JobId{3};
  of_another.owner = "another";
  later.jobs = {of_another};
  later.hosts = {{"worse-host", true, 8, "three tasks failed there"}};
  database.apply(later);
  const DurableState state = database.load();
  EXPECT_EQ(state.subdomains.at({JobId{1}, 3}), joined);
  EXPECT_EQ(state.tasks.at(TaskId{6}), task);
  EXPECT_EQ(state.jobs.at(JobId{3}), of_another) << "a key is its owner's";
  EXPECT_EQ(state.tasks.at(TaskId{4}).state, TaskState::replaced);
  EXPECT_EQ(state.tasks.at(TaskId{7}), in_its_place);
  EXPECT_EQ(state.running_attempts.at(AttemptId{6}), rival);
  EXPECT_TRUE(state.quarantined_hosts.contains("worse-host"));
  EXPECT_EQ(database.history().attempts_of(TaskId{3}).back().peak_rss_bytes, 12U);
  EXPECT_EQ(database.history().log_of(AttemptId{7}), "its log");
  later.hosts[0].is_quarantined = false;
  database.apply(later);
  EXPECT_FALSE(database.load().quarantined_hosts.contains("worse-host"));
  ChangeSet impossible;
  rival.id = AttemptId{8};
  rival.task = TaskId{99};
  impossible.attempts = {rival};
  EXPECT_THROW(database.apply(impossible), IoError) << "foreign keys are checked again";
  impossible = {};
  of_another.id = JobId{4};
  impossible.jobs = {of_another};
  EXPECT_THROW(database.apply(impossible), IoError) << "two jobs of one key";
  impossible = {};
  in_its_place.id = TaskId{8};
  impossible.tasks = {in_its_place};
  EXPECT_THROW(database.apply(impossible), IoError) << "two tasks in a place";
}

INSTANTIATE_TEST_SUITE_P(OfSchema, Migrations, testing::Range(1, database_version));

}  // namespace
}  // namespace tetfarm
