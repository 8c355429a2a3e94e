#include "proto/local_endpoint.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(LocalEndpoint, only_this_host_reaches_loopback_and_ipc) {
  for (const char* endpoint :
       {"ipc:///tmp/socket", "inproc://a", "tcp://127.0.0.1:*", "tcp://127.8.0.1:5555",
        "tcp://localhost:1", "tcp://[::1]:*", "tcp://[::1]:5555"}) {
    EXPECT_TRUE(is_local(endpoint)) << endpoint;
  }
}

TEST(LocalEndpoint, other_hosts_reach_any_other_address) {
  for (const char* endpoint : {"tcp://*:5555", "tcp://0.0.0.0:5555", "tcp://10.0.0.1:5555",
                               "tcp://[::]:5555", "tcp://[2001:db8::1]:5555", "tcp://[::1",
                               "tcp://127.example.org:5555", "tcp://localhost.example.org:5555"}) {
    EXPECT_FALSE(is_local(endpoint)) << endpoint;
  }
}

TEST(LocalEndpoint, some_have_no_network_at_all) {
  EXPECT_TRUE(is_ipc("ipc:///tmp/socket"));
  EXPECT_TRUE(is_ipc("inproc://a"));
  EXPECT_FALSE(is_ipc("tcp://127.0.0.1:5555"));
  EXPECT_FALSE(is_ipc(""));
  EXPECT_FALSE(is_local("udp://127.0.0.1:5555"));
  EXPECT_FALSE(is_local("tcp://128.0.0.1:5555"));
  EXPECT_FALSE(is_local("tcp://127.0.0.256:5555"));
}

}  // namespace
}  // namespace tetfarm
