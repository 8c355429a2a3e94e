#include "cli/address_probes.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "base/program_identity.h"
#include "base/program_version.h"
#include "tests/cli/fake_coordinator.h"
#include "tests/cli/plain_listener.h"
#include "tests/cli/said.h"

namespace tetfarm {
namespace {

using test::PlainListener;
using ::testing::HasSubstr;

wire::StatusReply farm_of_this_program() {
  wire::StatusReply farm;
  farm.set_workers(4);
  farm.set_connections(6);
  farm.set_security("keys");
  farm.set_program_version(program_version);
  farm.set_program(program_identity());
  farm.set_wall_ms(1'000'000);
  return farm;
}

ClientOptions client_of(const std::string& endpoint) {
  ClientOptions client;
  client.endpoint = endpoint;
  client.timeout_s = 0.5;
  return client;
}

TEST(AddressProbes, tell_who_answers) {
  const Findings found =
      findings_of_coordinator("tcp://h:1", farm_of_this_program(), {1'000'100, 3});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].found, "tcp://h:1: answered in 3 ms; 4 workers, 6 connections, keys");
  for (const Finding& finding : found) EXPECT_EQ(finding.verdict, Verdict::ok) << finding.found;
}

TEST(AddressProbes, find_other_programs_and_clocks_that_are_apart) {
  wire::StatusReply farm = farm_of_this_program();
  farm.set_program("another");
  EXPECT_EQ(findings_of_coordinator("x", farm, {}).at(1).verdict, Verdict::warning);
  EXPECT_THAT(findings_of_coordinator("x", farm, {}).at(1).found, HasSubstr("another build of"));
  farm.set_program_version("9.9.9");
  EXPECT_THAT(findings_of_coordinator("x", farm, {}).at(1).found,
              HasSubstr("the coordinator is 9.9.9; this program is "));
  farm.set_program_version("");
  EXPECT_THAT(findings_of_coordinator("x", farm, {}).at(1).found, HasSubstr("an older one"));
  farm.set_wall_ms(1'000'000);
  const Finding clock = findings_of_coordinator("x", farm, {930'000, 0}).at(2);
  EXPECT_EQ(clock.verdict, Verdict::warning);
  EXPECT_THAT(clock.found, HasSubstr("70 s ahead"));
  farm.set_wall_ms(0);
  EXPECT_EQ(findings_of_coordinator("x", farm, {}).size(), 2U) << "it does not tell";
}

TEST(AddressProbes, pass_on_why_a_coordinator_accepts_nothing) {
  wire::StatusReply farm = farm_of_this_program();
  farm.set_trouble("the database is read-only");
  const Finding answer = findings_of_coordinator("tcp://h:1", farm, {}).front();
  EXPECT_EQ(answer.verdict, Verdict::problem);
  EXPECT_EQ(answer.found, "tcp://h:1: the database is read-only");
}

TEST(AddressProbes, ask_a_coordinator) {
  const FakeCoordinator coordinator([](const wire::Envelope& said) {
    EXPECT_TRUE(said.status_request().farm_only());
    wire::Envelope answer;
    *answer.mutable_status_reply() = farm_of_this_program();
    return std::vector<wire::Envelope>{answer};
  });
  const Findings found = look_at_coordinator(client_of(coordinator.endpoint()), "");
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[0].verdict, Verdict::ok) << found[0].found;
  EXPECT_THAT(found[0].found, HasSubstr("4 workers"));
}

TEST(AddressProbes, tell_a_port_where_nobody_listens_from_one_where_another_program_does) {
  PlainListener listener;
  const Findings silent = look_at_coordinator(client_of(listener.endpoint()), "");
  ASSERT_EQ(silent.size(), 1U);
  EXPECT_EQ(silent[0].verdict, Verdict::problem);
  EXPECT_THAT(silent[0].found, HasSubstr("no coordinator answers"));
  EXPECT_THAT(silent[0].remedy, HasSubstr("(process " + std::to_string(::getpid())));
  listener.end();
  const Said said = said_by([&] {
    look_at_coordinator(client_of(listener.endpoint()), "");
    return ExitCode::ok;
  });
  EXPECT_THAT(said.error, HasSubstr("nobody listens there"));
  EXPECT_THAT(said.help, HasSubstr("tetfarm coordinator"));
}

TEST(AddressProbes, say_whether_a_coordinator_could_listen) {
  PlainListener listener;
  const Finding used = look_at_listening(listener.endpoint());
  EXPECT_EQ(used.verdict, Verdict::problem);
  EXPECT_THAT(used.found, HasSubstr("in use (process " + std::to_string(::getpid())));
  listener.end();
  EXPECT_EQ(look_at_listening(listener.endpoint()).verdict, Verdict::ok);
  EXPECT_EQ(look_at_listening("tcp://*:" + std::to_string(listener.port())).verdict, Verdict::ok);
  const Finding elsewhere = look_at_listening("tcp://192.0.2.1:5555");
  EXPECT_EQ(elsewhere.verdict, Verdict::problem);
  EXPECT_THAT(elsewhere.remedy, HasSubstr("an address of this machine"));
  EXPECT_EQ(look_at_listening("ipc:///tmp/socket").verdict, Verdict::ok);
  EXPECT_EQ(look_at_listening("ipc:///nowhere-at-all/socket").verdict, Verdict::problem);
  for (const char* wrong : {"5555", "tcp://5555", "tcp://host:", "tcp://host:x", "tcp://h:70000"}) {
    EXPECT_THROW(look_at_listening(wrong), UsageError) << wrong;
  }
}

}  // namespace
}  // namespace tetfarm
