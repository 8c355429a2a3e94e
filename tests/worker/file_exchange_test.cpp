#include "worker/file_exchange.h"

#include <gtest/gtest.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(FileExchange, an_input_that_the_task_found_damaged_is_kept_no_longer) {
  const TempFolder folder;
  FileExchange exchange(folder.path(), 1U << 20U);
  const StoredArtifact damaged = exchange.store().publish("an input");
  const StoredArtifact sound = exchange.store().publish("another");
  wire::Envelope outcome;
  outcome.mutable_failed()->add_damaged_inputs(damaged.hash);
  exchange.send_outputs(outcome);
  EXPECT_FALSE(exchange.store().has(damaged.hash, damaged.size));
  EXPECT_TRUE(exchange.store().has(sound.hash, sound.size));
}

TEST(FileExchange, that_has_nothing_to_send_is_not_sending) {
  const TempFolder folder;
  FileExchange exchange(folder.path(), 1U << 20U);
  EXPECT_FALSE(exchange.is_fetching());
  EXPECT_TRUE(exchange.due(0).empty());
  wire::Envelope outcome;
  outcome.mutable_failed();
  exchange.send_outputs(outcome);
  EXPECT_FALSE(exchange.is_sending());
  EXPECT_TRUE(exchange.due(0).empty());
}

}  // namespace
}  // namespace tetfarm
