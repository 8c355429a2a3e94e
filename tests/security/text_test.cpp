// Texts that would forge lines of the log, steer a terminal or fill memory, in every place where
// somebody may write one.
#include "base/utf8.h"
#include "tasks/failure_cause.h"
#include "tests/security/raw_worker.h"

namespace tetfarm {
namespace {

using test::failed_message;
using test::RawPeer;
using test::RawWorker;
using ::testing::HasSubstr;

/// Forges a line, clears a terminal and sets its title, turns the direction, and is no UTF-8.
const std::string forged_time = "[2026-01-01 00:00:00.000]";
const std::string wicked = "seen\n" + forged_time +
                           " [coordinator] [info] job=1 forged\r\x1b[2J\x1b]0;title\x07"
                           "\xc2\x9b"
                           "31m\xe2\x80\xae\xff\xfe\x7f";

/// A text that nobody could have meant as control characters, nor as anything but UTF-8.
void expect_harmless(const std::string& text, const std::string& what) {
  EXPECT_TRUE(is_utf8(text)) << what;
  for (std::size_t at = 0; at < text.size();) {
    const CodePoint point = code_point_at(text, at);
    if (point.bytes == 0) return;  // told above
    const bool is_layout = point.value == U'\n' || point.value == U'\t';
    ASSERT_TRUE(is_layout || !is_control(point.value)) << what << " has a control character";
    at += point.bytes;
  }
}

class Texts : public test::WithOneJob {
 protected:
  static std::string fifteen_mebibytes() { return std::string(std::size_t{15} << 20U, 'n'); }

  /// Every command that looks, in words.
  void expect_views_harmless() const {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"status"},
                                                  {"status", "--json"},
                                                  {"jobs"},
                                                  {"workers", "--all"},
                                                  {"tasks"},
                                                  {"events", "--all"},
                                                  {"attempts"},
                                                  {"logs", job()}}) {
      const test::Ended ended = farm().ask(words, "vera");
      expect_harmless(ended.out, words[0] + " on standard output");
      expect_harmless(ended.err, words[0] + " on standard error");
    }
  }
  static void expect_log_harmless() {
    const std::string log = farm().log();
    expect_harmless(log, "the log");
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
      EXPECT_EQ(line.rfind('[', 0), 0U) << line;
      EXPECT_NE(line.rfind(forged_time, 0), 0U) << line;
    }
  }
};

TEST_F(Texts, in_the_name_of_a_job_are_refused) {
  RawPeer anna = peer("anna");
  for (const std::string& name :
       {wicked, std::string("../../x"), std::string("a/b"), std::string("."), std::string(".."),
        std::string("a\nb"), std::string("a\x1b[2J"), std::string("\xff"), std::string("a\0b", 3),
        std::string(256, 'n'), std::string("\xe2\x80\xae")}) {
    wire::Envelope named = test::submission(farm(), "name " + std::to_string(name.size()));
    named.mutable_submit()->set_name(name);
    EXPECT_TRUE(anna.ask(named).has_refused()) << name.substr(0, 20);
  }
  expect_log_harmless();
}

TEST_F(Texts, of_a_job_refused_are_harmless_in_the_words_of_the_refusal) {
  const std::string path = farm().folder() / "wicked.toml";
  test::write_contents(path,
                       "name = \"\\u001b[2J\\n\"\n[geometry]\nsurface = \"surfaces/ball.off\"\n");
  const test::Ended ended = farm().ask({"submit", path}, "anna");
  EXPECT_EQ(ended.code, 2) << ended.err;
  expect_harmless(ended.err, "standard error");
}

TEST_F(Texts, of_a_failure_reach_neither_log_nor_terminal_as_they_are) {
  RawWorker worker(farm(), farm().keys_of("node"), "wicked");
  const wire::Assign held = worker.take_task();
  wire::Envelope failed = failed_message(held.task(), held.attempt());
  failed.mutable_failed()->set_exit_code(3);
  failed.mutable_failed()->set_cause(on_wire(FailureCause::for_good));
  failed.mutable_failed()->set_message(wicked);
  failed.mutable_failed()->set_log(wicked);
  wire::Artifact& evidence = *failed.mutable_failed()->add_evidence();
  evidence.set_name(wicked);
  evidence.set_hash(held.inputs(0).hash());
  evidence.set_size(held.inputs(0).size());
  EXPECT_TRUE(worker.is_taken(failed));
  expect_log_harmless();
  expect_views_harmless();
  const test::Ended waited = farm().ask({"wait", job(), "--progress", "none"}, "anna");
  expect_harmless(waited.out + waited.err, "wait");
  EXPECT_THAT(waited.out + waited.err, HasSubstr("seen"));
}

TEST_F(Texts, of_a_workers_hello_reach_neither_log_nor_terminal_as_they_are) {
  RawPeer worker = peer("node");
  wire::Envelope hello = test::hello_of("nonce of the wicked");
  hello.mutable_hello()->set_host(wicked);
  hello.mutable_hello()->set_tag(wicked);
  hello.mutable_hello()->set_program_version("\x1b[2J\n");
  EXPECT_TRUE(worker.ask(hello).has_welcome());
  expect_log_harmless();
  expect_views_harmless();
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  worker.send(goodbye);
}

TEST_F(Texts, of_fifteen_mebibytes_from_a_submitter_are_refused) {
  RawPeer anna = peer("anna");
  const std::string large = fifteen_mebibytes();
  wire::Envelope name = test::submission(farm(), "large name");
  name.mutable_submit()->set_name(large);
  EXPECT_TRUE(anna.ask(name).has_refused());
  wire::Envelope key = test::submission(farm(), large);
  EXPECT_TRUE(anna.ask(key).has_refused());
  wire::Envelope path = test::submission(farm(), "large path");
  path.mutable_submit()->set_surface_path("/" + large);
  EXPECT_TRUE(anna.ask(path).has_refused());
  wire::Envelope cancel;
  cancel.mutable_cancel()->set_job(large);
  EXPECT_FALSE(anna.ask(cancel).cancelled().found());
  EXPECT_LT(farm().status().ByteSizeLong(), 100'000U);
}

TEST_F(Texts, of_fifteen_mebibytes_from_a_worker_are_refused_or_cut) {
  RawPeer worker = peer("node");
  const std::string large = fifteen_mebibytes();
  for (int field = 0; field < 4; ++field) {
    wire::Envelope envelope = test::hello_of(field == 0 ? large : "short");
    wire::Hello& hello = *envelope.mutable_hello();
    if (field == 1) hello.set_host(large);
    if (field == 2) hello.set_tag(large);
    if (field == 3) hello.set_program_version(large);
    const wire::Envelope answer = worker.ask(envelope);
    EXPECT_TRUE(answer.has_refused() || answer.has_welcome());
  }
  EXPECT_LT(farm().status().ByteSizeLong(), 100'000U);
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  worker.send(goodbye);
}

TEST_F(Texts, of_fifteen_mebibytes_in_a_failure_are_refused_or_cut) {
  RawWorker worker(farm(), farm().keys_of("node"), "large");
  const wire::Assign held = worker.take_task();
  wire::Envelope failed = failed_message(held.task(), held.attempt());
  failed.mutable_failed()->set_exit_code(3);
  failed.mutable_failed()->set_cause(on_wire(FailureCause::for_good));
  failed.mutable_failed()->set_message(fifteen_mebibytes());
  worker.peer().ask(failed);
  EXPECT_LT(farm().status().ByteSizeLong(), 100'000U);
  const test::Ended status = farm().ask({"status", "--json"}, "vera");
  EXPECT_LT(status.out.size(), 100'000U);
}

TEST_F(Texts, a_submission_key_with_other_content_is_refused) {
  RawPeer anna = peer("anna");
  const wire::Envelope first = test::submission(farm(), "one key");
  const std::string job = anna.ask(first).submitted().job();
  wire::Envelope other = first;
  other.mutable_submit()->set_job_toml(test::good_job("another"));
  EXPECT_TRUE(anna.ask(other).has_refused());
  const wire::Envelope again = anna.ask(first);
  EXPECT_TRUE(again.submitted().existed());
  EXPECT_EQ(again.submitted().job(), job);
  EXPECT_EQ(farm().ask({"cancel", job}, "anna").code, 0);
}

TEST_F(Texts, the_submission_key_of_another_submitter_is_not_answered_with_its_job) {
  const wire::Envelope same = test::submission(farm(), "guessed key");
  const wire::Envelope of_anna = peer("anna").ask(same);
  const wire::Envelope of_bert = peer("bert").ask(same);
  EXPECT_FALSE(of_bert.submitted().existed());
  EXPECT_NE(of_bert.submitted().job(), of_anna.submitted().job());
  for (const std::string& job : {of_anna.submitted().job(), of_bert.submitted().job()}) {
    EXPECT_EQ(farm().ask({"cancel", job}, "anna").code, 0);
  }
}

}  // namespace
}  // namespace tetfarm
