#include "proto/address_family.h"

#include <gtest/gtest.h>

namespace tetfarm {
namespace {

TEST(AddressFamily, is_ipv6_for_addresses_in_brackets_only) {
  for (const char* endpoint : {"tcp://[::1]:*", "tcp://[::1]:5555", "tcp://[::]:5555"}) {
    EXPECT_TRUE(needs_ipv6(endpoint, EndpointUse::bind)) << endpoint;
    EXPECT_TRUE(needs_ipv6(endpoint, EndpointUse::connect)) << endpoint;
  }
  for (const char* endpoint :
       {"tcp://127.0.0.1:*", "tcp://*:5555", "ipc:///tmp/[socket]", "inproc://a", "", "nonsense"}) {
    EXPECT_FALSE(needs_ipv6(endpoint, EndpointUse::bind)) << endpoint;
  }
}

TEST(AddressFamily, of_a_name_with_an_ipv4_address_is_ipv4) {
  EXPECT_FALSE(needs_ipv6("tcp://localhost:5555", EndpointUse::connect));
  EXPECT_FALSE(needs_ipv6("tcp://127.0.0.1:5555", EndpointUse::connect));
}

TEST(AddressFamily, an_ipv6_listener_is_reached_over_the_endpoint_that_it_tells) {
  zmq::context_t context;
  zmq::socket_t router(context, zmq::socket_type::router);
  zmq::socket_t dealer(context, zmq::socket_type::dealer);
  for (zmq::socket_t* socket : {&router, &dealer}) {
    socket->set(zmq::sockopt::linger, 0);
    socket->set(zmq::sockopt::rcvtimeo, 10'000);
  }
  set_address_family(router, "tcp://[::1]:*", EndpointUse::bind);
  router.bind("tcp://[::1]:*");
  const std::string endpoint = router.get(zmq::sockopt::last_endpoint);
  EXPECT_TRUE(endpoint.starts_with("tcp://[::1]:")) << endpoint;
  set_address_family(dealer, endpoint, EndpointUse::connect);
  dealer.connect(endpoint);
  dealer.send(zmq::str_buffer("hello"));
  zmq::message_t sender;
  zmq::message_t message;
  ASSERT_TRUE(router.recv(sender));
  ASSERT_TRUE(router.recv(message));
  EXPECT_EQ(message.to_string(), "hello");
}

}  // namespace
}  // namespace tetfarm
