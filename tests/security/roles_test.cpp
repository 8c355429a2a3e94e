// A key that is right used for what is not its owner's business: every message by every role.
#include "proto/roles.h"

#include "tests/security/farm_under_attack.h"

namespace tetfarm {
namespace {

using test::RawPeer;
using test::status_request;
using ::testing::HasSubstr;

using Kind = wire::Envelope::BodyCase;

/// An envelope with an empty body of that kind.
wire::Envelope empty_message(Kind kind) {
  wire::Envelope envelope;
  const auto* field = wire::Envelope::descriptor()->FindFieldByNumber(static_cast<int>(kind));
  wire::Envelope::GetReflection()->MutableMessage(&envelope, field);
  return envelope;
}

std::vector<Kind> all_kinds() {
  std::vector<Kind> kinds;
  const auto* body = wire::Envelope::descriptor()->FindOneofByName("body");
  for (int i = 0; i < body->field_count(); ++i) {
    kinds.push_back(static_cast<Kind>(body->field(i)->number()));
  }
  return kinds;
}

class Roles : public test::FarmUnderAttack {
 protected:
  /// Sends every message that is another role's business, and expects each to be refused by name.
  /// How many there were.
  static std::uint64_t overstep(const std::string& who, Role role) {
    RawPeer intruder = peer(who);
    std::uint64_t count = 0;
    for (const Kind kind : all_kinds()) {
      const wire::Envelope message = empty_message(kind);
      if (may_send(role, message) || !is_for_the_coordinator(kind)) continue;
      const wire::Envelope answer = intruder.ask(message);
      EXPECT_THAT(answer.refused().reason(), HasSubstr(std::string(name_of(role)) + " " + who +
                                                       " may not send " + name_of(kind)));
      ++count;
    }
    return count;
  }
};

TEST_F(Roles, a_worker_may_do_nothing_of_a_submitter_or_viewer) {
  EXPECT_EQ(overstep("node", Role::worker), 10U);
  EXPECT_EQ(counted("wrong_role"), 10U);
}

TEST_F(Roles, a_submitter_may_do_nothing_of_a_worker) {
  EXPECT_EQ(overstep("anna", Role::submitter), 6U);
  EXPECT_EQ(counted("wrong_role"), 6U);
  EXPECT_EQ(farm().status().workers(), 0U);
}

TEST_F(Roles, a_viewer_may_change_nothing) {
  EXPECT_EQ(overstep("vera", Role::viewer), 14U);
  EXPECT_EQ(counted("wrong_role"), 14U);
}

TEST_F(Roles, a_viewer_can_neither_submit_nor_cancel_nor_drain_with_the_program) {
  EXPECT_NE(farm().ask({"submit", "surfaces/ball.off"}, "vera").code, 0);
  EXPECT_NE(farm().ask({"cancel", "job-1"}, "vera").code, 0);
  EXPECT_NE(farm().ask({"drain", "--all"}, "vera").code, 0);
  EXPECT_NE(farm().ask({"retry", "job-1"}, "vera").code, 0);
  EXPECT_EQ(counted("wrong_role"), 4U);
  EXPECT_EQ(farm().status().jobs_size(), 0);
}

TEST_F(Roles, what_only_the_coordinator_says_is_senseless_from_everybody) {
  std::uint64_t count = 0;
  for (const char* who : {"node", "anna", "vera"}) {
    RawPeer liar = peer(who);
    for (const Kind kind : all_kinds()) {
      if (is_for_the_coordinator(kind)) continue;
      liar.send(empty_message(kind));
      ++count;
    }
    EXPECT_TRUE(liar.hears_nothing());
  }
  EXPECT_EQ(counted("senseless"), count);
}

TEST_F(Roles, one_submitter_may_not_replace_the_jobs_of_all) {
  RawPeer anna = peer("anna");
  wire::Envelope takeover = test::submission(farm(), "takeover");
  takeover.mutable_submit()->set_replaces_others(true);
  EXPECT_THAT(anna.ask(takeover).refused().reason(), HasSubstr("may not replace"));
  EXPECT_EQ(counted("wrong_role"), 1U);
}

TEST_F(Roles, a_key_made_a_viewer_is_a_worker_no_longer) {
  const PeerKeys keys = farm().newcomer("demoted", Role::worker);
  RawPeer worker(farm().endpoint(), keys);
  EXPECT_TRUE(worker.ask(test::hello_of("demoted")).has_welcome());
  const auto list = authorized_keys_path(farm().keys_folder());
  revoke(list, "demoted");
  authorize(list, {keys.own.public_key, Role::viewer, "demoted"});
  worker.send(test::ready_message());
  const auto answer = worker.hear();
  ASSERT_TRUE(answer && answer->has_refused());
  EXPECT_EQ(farm().status().workers(), 0U);
}

TEST_F(Roles, a_revoked_workers_task_goes_to_another_at_once) {
  RawPeer anna = peer("anna");
  const std::string job = anna.ask(test::submission(farm(), "of the revoked")).submitted().job();
  RawPeer bad(farm().endpoint(), farm().newcomer("bad", Role::worker));
  EXPECT_TRUE(bad.ask(test::hello_of("bad")).has_welcome());
  const wire::Assign held = bad.ask(test::ready_message()).assign();
  EXPECT_EQ(held.job(), job);
  RawPeer good = peer("node");
  EXPECT_TRUE(good.ask(test::hello_of("good")).has_welcome());
  good.send(test::ready_message());
  revoke(authorized_keys_path(farm().keys_folder()), "bad");
  const auto turned_out = bad.hear();
  EXPECT_TRUE(turned_out && turned_out->has_refused()) << "without a message of its own";
  const auto next = good.hear();
  ASSERT_TRUE(next && next->has_assign());
  EXPECT_EQ(next->assign().task(), held.task());
  wire::Envelope done;
  done.mutable_done()->set_task(held.task());
  done.mutable_done()->set_attempt(held.attempt());
  EXPECT_TRUE(bad.ask(done).has_refused());
  EXPECT_EQ(farm().ask({"cancel", job}, "anna").code, 0);
}

TEST_F(Roles, a_list_of_keys_that_others_may_write_lets_nobody_in) {
  RawPeer anna = peer("anna");
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
  const auto list = authorized_keys_path(farm().keys_folder());
  std::filesystem::permissions(list, static_cast<std::filesystem::perms>(0666));
  EXPECT_TRUE(anna.ask(status_request()).has_refused());
  std::filesystem::permissions(list, static_cast<std::filesystem::perms>(0600));
  EXPECT_TRUE(anna.ask(status_request()).has_status_reply());
}

TEST_F(Roles, lines_of_the_list_that_cannot_be_read_let_nobody_in) {
  const auto list = authorized_keys_path(farm().keys_folder());
  const std::string good = test::contents(list);
  const PeerKeys wanting = farm().stranger();
  const std::string digits = hex_of(wanting.own.public_key);
  std::string lines;
  for (const std::string& line :
       {digits + " root wanting", digits + " submitter", digits + " submitter ../x",
        digits.substr(1) + " submitter wanting", "submitter " + digits + " wanting",
        "#" + digits + " submitter wanting", digits}) {
    lines += line + "\n";
  }
  test::write_contents(list, good + lines);
  RawPeer peer(farm().endpoint(), wanting);
  peer.send(status_request());
  EXPECT_TRUE(peer.hears_nothing());
  test::write_contents(list, good);
  expect_counted("unknown_key", 1);
}

}  // namespace
}  // namespace tetfarm
