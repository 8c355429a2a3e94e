// The templates in deploy/ are what `tetfarm pool` submits, with names to be replaced.
// UPDATE_DEPLOY=1 writes them anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "pool/batch_system.h"

namespace tetfarm {
namespace {

constexpr std::uint64_t gib = std::uint64_t{1} << 30U;

PoolSettings placeholders() {
  PoolSettings settings;
  settings.name = "farm";
  settings.user = "USER";
  settings.program = "/SHARED/bin/tetfarm";
  settings.coordinator = "tcp://HEAD:5555";
  settings.store = "/SHARED/farm";
  settings.key = "/SHARED/keys/worker.key";
  settings.logs = "/SHARED/logs";
  settings.most_bytes = 16 * gib;
  return settings;
}

class Deploy : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(Deploy, the_template_is_what_the_pool_submits) {
  const auto [system, file] = GetParam();
  const std::string path = std::string(TETFARM_SOURCE_DIR) + "/deploy/" + file;
  const std::string text =
      make_batch_system(system, placeholders())->submit({20, 4 * gib}, {}).front().input;
  if (std::getenv("UPDATE_DEPLOY") != nullptr) std::ofstream(path) << text;
  std::ostringstream there;
  there << std::ifstream(path).rdbuf();
  EXPECT_EQ(there.str(), text) << "UPDATE_DEPLOY=1 pool_test writes it anew";
}

INSTANTIATE_TEST_SUITE_P(Templates, Deploy,
                         testing::Values(std::pair("slurm", "slurm_workers.sh"),
                                         std::pair("condor", "htcondor_workers.sub"),
                                         std::pair("lsf", "lsf_workers.sh"),
                                         std::pair("ge", "grid_engine_workers.sh")));

}  // namespace
}  // namespace tetfarm
