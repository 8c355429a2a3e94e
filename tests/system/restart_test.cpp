// The same output folder with another number of sub-domains, and assimilated ones (thesis 4.3.1,
// 4.3.2): what serves is used, and the mesh is that of a fresh run.
#include <gmock/gmock.h>

#include <map>

#include "store/job_database.h"
#include "tests/system/farm_cases.h"

namespace tetfarm {
namespace {

using test::Ended;
using test::run_program;
using test::TemporaryFolder;

class Restart : public ::testing::Test {
 protected:
  std::string digest(const std::string& output, int subdomains, int groups = 0, int workers = 2) {
    std::vector<std::string> words = test::run_words(input_, output, workers, subdomains);
    if (groups > 0) words.insert(words.end(), {"--groups", std::to_string(groups)});
    const Ended ended = run_program(words, folder_.path());
    EXPECT_EQ(ended.code, 0) << ended.err;
    result_ = test::result_of(ended);
    return test::digest_of(ended);
  }

  /// How often a sub-domain was worked on, over all jobs of the store.
  std::map<std::uint64_t, int> attempts(const std::string& output, TaskKind kind) const {
    const JobDatabase database(folder_.path() / output / ".tetfarm" / "tetfarm.db");
    const DurableState state = database.load();
    std::map<std::uint64_t, int> path2attempts;
    for (const AttemptRow& attempt : database.history().attempts_of({}, {}, 1000)) {
      const TaskRow& task = state.tasks.at(attempt.task);
      if (task.kind == kind) ++path2attempts[task.path];
    }
    return path2attempts;
  }

  TemporaryFolder folder_;
  std::string input_ = test::sphere_in_box(folder_.path(), 8, 2);
  nlohmann::json result_;
};

TEST_F(Restart, with_more_subdomains_cuts_nothing_twice) {
  digest("out", 4);
  const std::string sixteen = digest("out", 16);
  for (const auto& [path, count] : attempts("out", TaskKind::decompose)) {
    EXPECT_EQ(count, 1) << "sub-domain " << path;
  }
  EXPECT_EQ(digest("fresh", 16), sixteen);
  const std::string eight = digest("out", 8);
  const std::map<std::uint64_t, int> cuts = attempts("out", TaskKind::decompose);
  for (const std::uint64_t path : {1, 2, 3}) EXPECT_EQ(cuts.at(path), 1) << path;
  EXPECT_EQ(digest("fresh8", 8), eight);
}

TEST_F(Restart, with_other_groups_cuts_nothing) {
  const std::string three = digest("out", 12, 3);
  EXPECT_EQ(result_["subdomains"], 3);
  EXPECT_EQ(result_["balance"]["leaves"], 12);
  EXPECT_LE(result_["balance"]["estimated"], 1.05);
  const auto cuts = attempts("out", TaskKind::decompose);
  const std::string five = digest("out", 12, 5, 3);
  EXPECT_EQ(attempts("out", TaskKind::decompose), cuts);
  EXPECT_EQ(digest("fresh", 12, 5, 1), five);
  EXPECT_NE(three, five);
}

TEST_F(Restart, an_assimilated_mesh_is_sound) {
  digest("out", 12, 3);
  const Ended quality = run_program({"quality", "out", "--json"}, folder_.path());
  EXPECT_EQ(quality.code, 0) << quality.err;
}

}  // namespace
}  // namespace tetfarm
