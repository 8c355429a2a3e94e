/// A worker of the attacker: says hello, is given a task, and then says what it likes.
#pragma once

#include "tests/security/farm_under_attack.h"

namespace tetfarm::test {

class RawWorker {
 public:
  /// Known to the coordinator when it is made; says goodbye at its end.
  RawWorker(const Farm& farm, const PeerKeys& keys, const std::string& nonce);
  ~RawWorker();
  RawWorker(const RawWorker&) = delete;
  RawWorker& operator=(const RawWorker&) = delete;

  /// The task that it is given; an empty one, and a failure of the test, when there is none.
  wire::Assign take_task();
  RawPeer& peer() { return peer_; }
  /// Whether the coordinator takes that message for the result of the attempt.
  bool is_taken(const wire::Envelope& result);

 private:
  RawPeer peer_;
};

wire::Envelope done_message(std::uint64_t task, std::uint64_t attempt);
wire::Envelope failed_message(std::uint64_t task, std::uint64_t attempt);

/// A suite whose tests each have a job of their own, cancelled at their end, so that the only task
/// to be had is its `inspect`.
class WithOneJob : public FarmUnderAttack {
 protected:
  void SetUp() override;
  void TearDown() override;
  const std::string& job() const { return job_; }
  /// What a viewer is told of it.
  wire::JobStatus job_status() const;

 private:
  std::string job_;
};

}  // namespace tetfarm::test
