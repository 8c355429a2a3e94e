#include "tests/security/raw_worker.h"

namespace tetfarm::test {

RawWorker::RawWorker(const Farm& farm, const PeerKeys& keys, const std::string& nonce)
    : peer_(farm.endpoint(), keys) {
  EXPECT_TRUE(peer_.ask(hello_of(nonce)).has_welcome());
}

RawWorker::~RawWorker() {
  peer_.socket().set(zmq::sockopt::linger, patience_ms);
  wire::Envelope goodbye;
  goodbye.mutable_goodbye();
  peer_.send(goodbye);
}

wire::Assign RawWorker::take_task() {
  const wire::Envelope answer = peer_.ask(ready_message());
  EXPECT_TRUE(answer.has_assign()) << answer.ShortDebugString();
  return answer.assign();
}

bool RawWorker::is_taken(const wire::Envelope& result) {
  const wire::Envelope answer = peer_.ask(result);
  EXPECT_TRUE(answer.has_accepted()) << answer.ShortDebugString();
  return answer.accepted().taken();
}

wire::Envelope done_message(std::uint64_t task, std::uint64_t attempt) {
  wire::Envelope envelope;
  envelope.mutable_done()->set_task(task);
  envelope.mutable_done()->set_attempt(attempt);
  return envelope;
}

wire::Envelope failed_message(std::uint64_t task, std::uint64_t attempt) {
  wire::Envelope envelope;
  envelope.mutable_failed()->set_task(task);
  envelope.mutable_failed()->set_attempt(attempt);
  return envelope;
}

void WithOneJob::SetUp() {
  static int jobs = 0;
  FarmUnderAttack::SetUp();
  RawPeer anna = peer("anna");
  job_ = anna.ask(submission(farm(), "job of test " + std::to_string(++jobs))).submitted().job();
  EXPECT_NE(job_, "");
}

void WithOneJob::TearDown() {
  wire::Envelope cancel;
  cancel.mutable_cancel()->set_job(job_);
  peer("anna").ask(cancel);
  FarmUnderAttack::TearDown();
}

wire::JobStatus WithOneJob::job_status() const {
  wire::Envelope request = status_request();
  request.mutable_status_request()->set_job(job_);
  const wire::Envelope answer = peer("vera").ask(request);
  EXPECT_EQ(answer.status_reply().jobs_size(), 1);
  return answer.status_reply().jobs_size() == 1 ? answer.status_reply().jobs(0) : wire::JobStatus{};
}

}  // namespace tetfarm::test
