/// The one thread that asks the farm, for all who watch: it looks about once a second while anybody
/// watches or has asked within 10 s, and answers what a look does not show.
///
/// Bounded: at most 256 questions wait, none for longer than 15 s.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "dashboard/api_answer.h"
#include "dashboard/farm_look.h"
#include "dashboard/farm_snapshot.h"
#include "dashboard/farm_source.h"
#include "dashboard/fetched_answers.h"

namespace tetfarm {

class FarmDesk {
 public:
  /// Told of what changed, in the thread of the desk: server-sent events.
  using Publishing = std::function<void(std::string messages)>;

  /// @param acts whether requests may change something
  FarmDesk(std::unique_ptr<FarmSource> source, bool acts, Publishing publish);
  /// Answers what still waits with 503.
  ~FarmDesk();
  FarmDesk(const FarmDesk&) = delete;
  FarmDesk& operator=(const FarmDesk&) = delete;

  // From any thread.
  /// Calls `done` at once where what was seen last is new enough; else from the desk's thread.
  void ask(const ApiRequest& request, const ApiAnswering& done);
  void note_watchers(std::size_t count);
  /// What a new watcher is told first.
  std::string first_messages() const;

 private:
  struct Question {
    ApiRequest request;
    ApiAnswering done;
    std::int64_t since_ms = 0;
  };
  void run();
  bool wait_for_work(std::unique_lock<std::mutex>& lock);
  bool is_look_due(std::int64_t now_ms) const;
  bool is_look_new(std::int64_t now_ms) const;
  void take_a_look();
  void answer_all(const std::deque<Question>& questions);
  ApiAnswer answer(const ApiRequest& request);

  const std::unique_ptr<FarmSource> source_;
  const bool acts_;
  const Publishing publish_;
  FarmLook look_;  // this and the next: of the desk's thread
  FetchedAnswers answers_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<const FarmSnapshot> snapshot_ = std::make_shared<const FarmSnapshot>();
  std::deque<Question> questions_;
  std::size_t watchers_ = 0;
  bool is_over_ = false;
  bool is_looking_ = false;
  std::int64_t asked_ms_;   ///< when anybody asked last
  std::int64_t looked_ms_;  ///< when the last look ended
  std::int64_t next_look_ms_;
  std::int64_t told_farm_ms_;  ///< when watchers were told of the farm last

  std::thread thread_;
};

/// The answer to what every snapshot shows; nothing when the farm has to be asked.
std::optional<ApiAnswer> answer_from(const FarmSnapshot& snapshot, const ApiRequest& request);

}  // namespace tetfarm
