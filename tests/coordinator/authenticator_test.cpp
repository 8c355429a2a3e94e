#include "coordinator/authenticator.h"

#include <gtest/gtest.h>

#include "tests/base/temp_folder.h"

namespace tetfarm {
namespace {

TEST(Authenticator, admits_as_workers_only_keys_that_are_workers_now) {
  const TempFolder folder;
  const auto list = authorized_keys_path(folder.path());
  write_new_key(folder.path(), "coordinator");
  const AuthorizedPeer worker{make_key_pair().public_key, Role::worker, "node-1"};
  const AuthorizedPeer submitter{make_key_pair().public_key, Role::submitter, "anna"};
  authorize(list, worker);
  authorize(list, submitter);
  zmq::context_t context;
  Refusals refusals;
  Authenticator authenticator(context, {.keys_folder = folder.path()}, refusals);
  EXPECT_TRUE(authenticator.admits_worker(hex_of(worker.key)));
  EXPECT_FALSE(authenticator.admits_worker(hex_of(submitter.key)));
  EXPECT_FALSE(authenticator.admits_worker(hex_of(make_key_pair().public_key)));
  EXPECT_TRUE(authenticator.admits_worker("")) << "its connection is plain";
  revoke(list, "node-1");
  EXPECT_TRUE(authenticator.has_new_list());
  EXPECT_FALSE(authenticator.admits_worker(hex_of(worker.key)));
}

}  // namespace
}  // namespace tetfarm
