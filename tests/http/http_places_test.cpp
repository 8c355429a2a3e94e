#include "http/http_places.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace tetfarm {
namespace {

using Stage = HttpPlace::Stage;

TEST(HttpPlaces, the_oldest_that_still_asks_gives_way) {
  EXPECT_EQ(who_gives_way({{1, "", Stage::asks, 30}, {2, "", Stage::asks, 10}}, 100), 2);
}

TEST(HttpPlaces, one_that_is_over_gives_way_before_one_that_asks) {
  EXPECT_EQ(who_gives_way({{1, "", Stage::asks, 10}, {2, "", Stage::over, 90}}, 100), 2);
}

TEST(HttpPlaces, whoever_takes_his_answer_stays_and_whoever_stopped_gives_way) {
  EXPECT_FALSE(who_gives_way({{1, "", Stage::listens, 1000}}, 2999));
  EXPECT_EQ(who_gives_way({{1, "", Stage::listens, 1000}}, 3000), 1);
  EXPECT_EQ(who_gives_way({{1, "", Stage::listens, 0}, {2, "", Stage::asks, 2999}}, 3000), 2);
}

TEST(HttpPlaces, who_holds_most_gives_way_to_who_holds_few) {
  EXPECT_EQ(who_gives_way({{1, "honest", Stage::asks, 10},
                           {2, "greedy", Stage::asks, 80},
                           {3, "greedy", Stage::asks, 70}},
                          100),
            3);
}

TEST(HttpPlaces, nobody_gives_way_where_nobody_is) { EXPECT_FALSE(who_gives_way({}, 0)); }

TEST(HttpPlaces, of_a_peer_are_its_own) {
  const auto own = places_of("b", {{1, "a", {}, 0}, {2, "b", {}, 0}, {3, "b", {}, 0}});
  ASSERT_EQ(own.size(), 2U);
  EXPECT_EQ(own[0].fd, 2);
}

std::string peer_of_text(const std::string& address) {
  sockaddr_storage storage{};
  auto& four = reinterpret_cast<sockaddr_in&>(storage);
  auto& six = reinterpret_cast<sockaddr_in6&>(storage);
  storage.ss_family = AF_INET;
  if (::inet_pton(AF_INET, address.c_str(), &four.sin_addr) != 1) {
    storage.ss_family = AF_INET6;
    EXPECT_EQ(::inet_pton(AF_INET6, address.c_str(), &six.sin6_addr), 1) << address;
  }
  return peer_of(storage);
}

TEST(HttpPeer, is_an_address_or_the_network_of_one) {
  EXPECT_EQ(peer_of_text("10.1.2.3"), "10.1.2.3");
  EXPECT_EQ(peer_of_text("::ffff:10.1.2.3"), "10.1.2.3");
  EXPECT_EQ(peer_of_text("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::");
  EXPECT_EQ(peer_of_text("2001:db8:1:2:ffff::1"), "2001:db8:1:2::");
  EXPECT_NE(peer_of_text("2001:db8:1:3::1"), "2001:db8:1:2::");
}

TEST(HttpPeer, of_this_host_is_anybody) {
  for (const char* address : {"127.0.0.1", "127.9.9.9", "::1", "::ffff:127.0.0.1"}) {
    EXPECT_EQ(peer_of_text(address), "") << address;
  }
}

}  // namespace
}  // namespace tetfarm
