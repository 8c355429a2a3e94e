#include "coordinator/leftovers.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <fstream>

#include "tests/base/temp_folder.h"
#include "tests/coordinator/child_coordinator.h"

namespace tetfarm {
namespace {

namespace fs = std::filesystem;

ChangeSet gone(std::uint64_t worker) {
  ChangeSet changes;
  changes.workers.emplace_back();
  changes.workers.back().id = WorkerId{worker};
  changes.workers.back().gone = true;
  return changes;
}

ChangeSet ended(std::uint64_t attempt, AttemptState state) {
  ChangeSet changes;
  changes.attempts.emplace_back();
  changes.attempts.back().id = AttemptId{attempt};
  changes.attempts.back().state = state;
  return changes;
}

TEST(Leftovers, of_a_worker_that_is_gone_are_its_probe) {
  Leftovers leftovers;
  leftovers.note_probe(WorkerId{3}, "abc");
  EXPECT_TRUE(leftovers.orders_after(gone(4)).empty());
  const std::vector<FileOrder> orders = leftovers.orders_after(gone(3));
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].kind, FileOrder::Kind::forget);
  EXPECT_EQ(orders[0].file.hash, "abc");
  EXPECT_TRUE(leftovers.orders_after(gone(3)).empty()) << "once is enough";
}

TEST(Leftovers, of_a_worker_that_came_again_under_another_number_stay) {
  Leftovers leftovers;
  leftovers.note_probe(WorkerId{3}, "abc");
  leftovers.note_probe(WorkerId{4}, "abc");
  EXPECT_TRUE(leftovers.orders_after(gone(3)).empty());
  EXPECT_EQ(leftovers.orders_after(gone(4)).size(), 1U);
}

TEST(Leftovers, of_a_lost_attempt_are_its_files_in_the_making) {
  Leftovers leftovers;
  const std::vector<FileOrder> orders = leftovers.orders_after(ended(9, AttemptState::lost));
  ASSERT_EQ(orders.size(), 1U);
  EXPECT_EQ(orders[0].kind, FileOrder::Kind::clear);
  EXPECT_EQ(orders[0].attempt, AttemptId{9});
  EXPECT_TRUE(leftovers.orders_after(ended(9, AttemptState::done)).empty());
}

TEST(Leftovers, are_removed_by_their_orders) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  const std::string name(32, 'a');
  std::ofstream(probe_path(store, name)) << "x";
  fs::create_directory(store.scratch_folder() / "attempt-9");
  std::ofstream(store.scratch_folder() / "attempt-9/mesh.vtkhdf") << "x";
  FileOrder order;
  order.kind = FileOrder::Kind::forget;
  order.file.hash = name;
  EXPECT_EQ(carry_out(order, store).trouble, "");
  order.kind = FileOrder::Kind::clear;
  order.attempt = AttemptId{9};
  EXPECT_EQ(carry_out(order, store).trouble, "");
  EXPECT_TRUE(fs::is_empty(store.scratch_folder()));
}

TEST(Leftovers, are_swept_when_a_coordinator_starts) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  fs::create_directory(store.scratch_folder() / "attempt-9");
  for (const char* name :
       {"probe-0123", "frame.vtkhdf.77.0123abcd.tmp", "attempt-9/frame.vtkhdf"}) {
    std::ofstream(store.scratch_folder() / name) << "x";
  }
  test::ChildCoordinator coordinator(folder.path());
  EXPECT_TRUE(fs::is_empty(store.scratch_folder()));
}

/// A worker says Hello with a probe in the store, and leaves without removing it.
TEST(Leftovers, of_a_worker_that_says_goodbye_are_removed_while_the_coordinator_runs) {
  const TempFolder folder;
  const ArtifactStore store(folder.path());
  test::ChildCoordinator coordinator(folder.path());
  const std::string name(32, 'b');
  std::ofstream(probe_path(store, name)) << "text";
  test::Dealer worker(coordinator.endpoint());
  wire::Envelope hello;
  hello.mutable_hello()->set_host("here");
  hello.mutable_hello()->set_nonce("one process");
  hello.mutable_hello()->set_store_probe(store.probe());
  hello.mutable_hello()->set_probe_file(name);
  hello.mutable_hello()->set_probe_text("text");
  EXPECT_TRUE(worker.ask(hello).welcome().sees_store());
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  worker.send(goodbye);
  for (int i = 0; i < 1000 && fs::exists(probe_path(store, name)); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(fs::exists(probe_path(store, name)));
}

}  // namespace
}  // namespace tetfarm
