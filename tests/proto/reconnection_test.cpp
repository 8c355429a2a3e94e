#include "proto/reconnection.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

struct Pauses {
  int first_ms;
  int longest_ms;  ///< 0: as the first
};

Pauses pauses_to(const std::string& endpoint) {
  zmq::context_t context;
  zmq::socket_t socket(context, zmq::socket_type::dealer);
  set_reconnection(socket, endpoint);
  return {socket.get(zmq::sockopt::reconnect_ivl), socket.get(zmq::sockopt::reconnect_ivl_max)};
}

TEST(Reconnection, to_this_host_is_tried_every_few_milliseconds) {
  const Pauses pauses = pauses_to("ipc:///tmp/somewhere");
  EXPECT_LE(pauses.first_ms, 5);
  EXPECT_EQ(pauses.longest_ms, 0);
}

TEST(Reconnection, over_a_network_is_tried_less_and_less_often) {
  const Pauses pauses = pauses_to("tcp://127.0.0.1:5555");
  EXPECT_GE(pauses.first_ms, 50);
  EXPECT_GE(pauses.longest_ms, 1000);
}

TEST(Reconnection, begins_with_a_tenth_of_a_second_and_ends_with_two) {
  const Pauses pauses = pauses_to("tcp://node-1:5555");
  EXPECT_EQ(pauses.first_ms, 100);
  EXPECT_EQ(pauses.longest_ms, 2000);
  EXPECT_EQ(pauses_to("ipc:///tmp/somewhere").first_ms, 3);
}

}  // namespace
}  // namespace tetfarm
