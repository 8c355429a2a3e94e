// What must hold in a farm at each step, under the names of ARCHITECTURE.md, one function each.
//
// They look from outside, at what was committed, said and written; what JobState knows of itself is
// checked by JobState::validate(). Each looks only at what has changed, so that it is cheap enough
// to be asked after every commit.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "tests/coordinator/durable_record.h"
#include "tests/coordinator/simulated_database.h"
#include "tests/coordinator/simulated_world.h"

namespace tetfarm::simulation {

class Invariants {
 public:
  // ---- what the farm tells
  void worker_starts(const WorkerInfo& info) {
    processes_[sha256_hex(info.nonce)] = info;
    std::uint64_t& most = host_memory_[info.host];
    if (info.shares_memory) most = std::max(most, info.memory_bytes);
  }
  void result_said(AttemptId attempt, const std::string& nonce) {
    presented_by_[attempt].insert(sha256_hex(nonce));
  }

  void committed(const ChangeSet& changes, const DurableRecord& record, const Disk& disk) {
    immutable(changes, disk);
    found_after_a_restart(changes, record);
  }
  /// A transaction that was in doubt: its files may have been lost since.
  void found_after_a_restart(const ChangeSet& changes, const DurableRecord& record) {
    accepted_once(changes);
    pure(changes);
    conforming(changes, record.state());
    bounded(changes, record.state());
    blamed_for_what_others_did(changes, record);
  }

  /// 1. A published file never changes, and a row names only files that are durable.
  void immutable(const ChangeSet& changes, const Disk& disk) {
    for (const TaskRow& task : changes.tasks) {
      for (const ArtifactRef& file : task.outputs) {
        const auto [known, is_new] = sizes_.emplace(file.hash, file.size);
        EXPECT_EQ(known->second, file.size) << "a file changed";
        const bool is_promised = is_new && task.state == TaskState::done;
        EXPECT_TRUE(!is_promised || disk.was_durable(file)) << "a row names what is not durable";
      }
    }
  }

  /// 2. A result is taken once, from one attempt, of the process that the attempt was given to.
  void accepted_once(const ChangeSet& changes) {
    for (const EventRow& event : changes.events) {
      if (event.what == "again") ++wanted_again_[event.task];
      if (event.what == "served") ++accepted_[event.task];
    }
    for (const AttemptRow& attempt : changes.attempts) {
      if (attempt.state != AttemptState::done) continue;
      ++accepted_[attempt.task];
      EXPECT_LE(accepted_[attempt.task], 1 + wanted_again_[attempt.task])
          << "task " << attempt.task.value << " was accepted twice";
      EXPECT_TRUE(presented_by_[attempt.id].contains(attempt.nonce_hash))
          << "attempt " << attempt.id.value << " was brought by another process";
    }
  }

  /// 3. The same task makes the same files, whoever does it and how often.
  void pure(const ChangeSet& changes) {
    for (const TaskRow& task : changes.tasks) {
      if (task.state != TaskState::done) continue;
      const auto [known, is_new] = made_.emplace(task.id, task.outputs);
      EXPECT_EQ(known->second, task.outputs) << "task " << task.id.value << " made other files";
    }
  }

  /// 4. The tree has no holes, and what is assembled is exactly its leaves.
  void conforming(const ChangeSet& changes, const DurableState& state) {
    for (const SubdomainRow& node : changes.subdomains) {
      const auto finds = [&](std::uint64_t path, SubdomainState wanted) {
        const auto found = state.subdomains.find({node.job, path});
        return found != state.subdomains.end() && found->second.state == wanted;
      };
      const auto is_there = [&](std::uint64_t path) {
        return state.subdomains.contains({node.job, path});
      };
      const std::uint64_t root = chunks_of(state, node.job).empty() ? 1 : 2;
      EXPECT_TRUE(node.path == root || finds(node.path / 2, SubdomainState::cut)) << "an orphan";
      EXPECT_TRUE(node.state != SubdomainState::cut ||
                  (is_there(2 * node.path) && is_there(2 * node.path + 1)))
          << "half of sub-domain " << node.path << " is missing";
      EXPECT_TRUE(node.state != SubdomainState::joined ||
                  finds(node.joined_into, SubdomainState::leaf))
          << "sub-domain " << node.path << " went into none";
    }
    for (const TaskRow& task : changes.tasks) {
      if (task.kind == TaskKind::assemble && assembled_.insert(task.id).second) {
        EXPECT_EQ(leaves_named(task), leaves_of(state, task.job)) << "holes, or twice the same";
      }
    }
  }

  /// 5. A worker has one task, a task two attempts, a host the memory that it has; rows are in
  /// proportion to sub-domains.
  void bounded(const ChangeSet& changes, const DurableState& state) {
    for (const WorkerRow& worker : changes.workers) worker2host_[worker.id] = worker.host;
    std::map<TaskId, int> attempts;
    std::set<std::string> busy;
    std::map<std::string, std::uint64_t> given_of_host;
    for (const auto& [id, attempt] : state.running_attempts) {
      EXPECT_LE(++attempts[attempt.task], 2) << "task " << attempt.task.value;
      EXPECT_FALSE(replaced_.contains(attempt.task)) << "a replaced task runs";
      EXPECT_TRUE(busy.insert(attempt.nonce_hash).second) << "two tasks for one worker";
      const WorkerInfo& process = processes_.at(attempt.nonce_hash);
      EXPECT_LE(attempt.memory_bytes, process.memory_bytes) << "more room than there is";
      if (!process.shares_memory) continue;
      std::uint64_t& given = given_of_host[process.host];
      given += attempt.memory_bytes;
      EXPECT_LE(given, host_memory_[process.host]) << process.host << " has less to share";
    }
    for (const TaskRow& task : changes.tasks) {
      if (task.state == TaskState::replaced) replaced_.insert(task.id);
    }
    EXPECT_LE(state.tasks.size() - replaced_.size(),
              6 * (state.subdomains.size() + state.jobs.size()));
  }

  /// A file that is removed is needed by nothing that was committed.
  void removed(const std::string& hash, const DurableRecord& record,
               const KeepsAllFiles& keeps_all_files) {
    ++removed_;
    const DurableState& state = record.state();
    for (const auto& [id, task] : state.tasks) {
      const JobRow& job = state.jobs.at(task.job);
      const bool is_whole = keeps_all_files(job) && task.state != TaskState::replaced;
      const bool is_to_run = task.state == TaskState::waiting || task.state == TaskState::ready ||
                             task.state == TaskState::failed;
      const bool reads = task.state == TaskState::leased || traits_of(task.kind).begins_job ||
                         (is_to_run && job.phase != JobPhase::done);
      const bool delivers = traits_of(task.kind).ends_job && task.state == TaskState::done;
      const bool needs_inputs = is_whole || reads;
      const bool needs_outputs = is_whole || delivers;
      EXPECT_FALSE(needs_inputs && names(task.inputs, hash)) << "task " << id.value << " needs it";
      EXPECT_FALSE(needs_outputs && names(task.outputs, hash)) << "task " << id.value << " made it";
    }
  }
  std::size_t removed() const { return removed_; }

  /// Where no file was lost, none is made again.
  static void none_made_again(const DurableRecord& record) {
    for (const EventRow& event : record.events()) {
      EXPECT_NE(event.what, "again") << "task " << event.task.value << " " << event.message;
      EXPECT_NE(event.what, "waiting") << "task " << event.task.value << " " << event.message;
    }
  }

  /// 6. What was committed is all that is needed: decisions go on from it.
  void resumable(const DurableState& found, const JobState& state) {
    EXPECT_TRUE(state.durable().running_attempts == found.running_attempts);
    for (const auto& [id, attempt] : found.running_attempts) {
      EXPECT_LE(id.value, found.last_attempt) << "an attempt's number may be given out again";
    }
    const std::vector<std::string> broken = state.validate();
    EXPECT_TRUE(broken.empty()) << "after a restart: " << broken.front();
  }

  /// Decision 15: a host comes into quarantine for tasks of several jobs that crashed there, and
  /// that another host did.
  void blamed_for_what_others_did(const ChangeSet& changes, const DurableRecord& record) {
    for (const HostRow& host : changes.hosts) {
      if (!host.is_quarantined) continue;
      std::set<TaskId> crashed;
      std::set<TaskId> proofs;
      std::set<JobId> jobs;
      for (const auto& [id, attempt] : record.attempts()) {
        const bool is_crash = attempt.state == AttemptState::crashed;
        if (is_crash && attempt.host == host.host) crashed.insert(attempt.task);
      }
      for (const auto& [id, attempt] : record.attempts()) {
        const bool is_proof = attempt.state == AttemptState::done && attempt.host != host.host;
        if (!is_proof || !crashed.contains(attempt.task)) continue;
        proofs.insert(attempt.task);
        jobs.insert(record.state().tasks.at(attempt.task).job);
      }
      EXPECT_GE(proofs.size(), FarmRules{}.host_tasks) << host.host << ": " << host.reason;
      EXPECT_GE(jobs.size(), 2U) << host.host << ": " << host.reason;
    }
  }

  /// Decision 1: nothing is said that is not committed.
  void spoken_after_commit(const Command& command, const DurableRecord& record) {
    if (const auto* assign = std::get_if<SendAssign>(&command)) {
      const auto found = record.state().running_attempts.find(assign->attempt);
      const bool runs = found != record.state().running_attempts.end();
      // One that was revoked in the same turn is still said, and was committed as ended.
      EXPECT_TRUE(record.attempts().contains(assign->attempt)) << "an attempt that nobody knows";
      if (!runs) return;
      const auto [holder, is_new] = given_to_.emplace(assign->attempt, found->second.nonce_hash);
      EXPECT_EQ(holder->second, found->second.nonce_hash)
          << "an attempt was given to two processes";
      EXPECT_FALSE(is_new && state_has_quarantined(record.state(), found->second.worker))
          << "a host in quarantine got a task";
    } else if (const auto* accepted = std::get_if<SendAccepted>(&command)) {
      const auto found = record.attempts().find(accepted->attempt);
      const bool has_ended =
          found != record.attempts().end() && found->second.state != AttemptState::running;
      EXPECT_TRUE(!accepted->taken || has_ended) << "a result was praised and not kept";
    }
  }

  /// At the end: each task that is done was accepted once, and once more for each time that its
  /// files were lost.
  void all_accepted_once(const DurableState& state) {
    for (const auto& [id, task] : state.tasks) {
      // A lost file that turned out not to be needed may still be in the making.
      const std::size_t in_the_making = task.state == TaskState::done ? 0 : 1;
      if (task.state == TaskState::replaced) {
        EXPECT_LE(accepted_[id], 1 + wanted_again_[id]) << "task " << id.value;
        continue;
      }
      EXPECT_EQ(accepted_[id] + in_the_making, 1 + wanted_again_[id]) << "task " << id.value;
    }
  }

 private:
  static bool names(const std::vector<ArtifactRef>& files, const std::string& hash) {
    return std::any_of(files.begin(), files.end(),
                       [&hash](const ArtifactRef& file) { return file.hash == hash; });
  }

  bool state_has_quarantined(const DurableState& state, WorkerId worker) const {
    const auto host = worker2host_.find(worker);
    return host != worker2host_.end() && state.quarantined_hosts.contains(host->second);
  }

  static std::set<std::uint64_t> leaves_of(const DurableState& state, JobId job) {
    std::set<std::uint64_t> leaves;
    for (const auto& [key, node] : state.subdomains) {
      if (key.first == job && node.state == SubdomainState::leaf) leaves.insert(node.path);
    }
    leaves.merge(chunks_of(state, job));
    return leaves;
  }

  /// Of layers.
  static std::set<std::uint64_t> chunks_of(const DurableState& state, JobId job) {
    std::set<std::uint64_t> chunks;
    for (const auto& [id, task] : state.tasks) {
      if (task.job != job || task.kind != TaskKind::inspect) continue;
      for (const ArtifactRef& file : task.outputs) {
        if (!file.name.starts_with("layers:")) continue;
        chunks.insert(std::stoull(file.name.substr(file.name.find(':') + 1)));
      }
    }
    return chunks;
  }

  /// A leaf that is named twice counts as 0, which no leaf is.
  static std::set<std::uint64_t> leaves_named(const TaskRow& assemble) {
    std::set<std::uint64_t> leaves;
    for (const ArtifactRef& file : assemble.inputs) {
      if (!file.name.starts_with("portion:")) continue;
      const std::uint64_t leaf = std::stoull(file.name.substr(file.name.find(':') + 1));
      leaves.insert(leaves.contains(leaf) ? 0 : leaf);
    }
    return leaves;
  }

  std::map<std::string, WorkerInfo> processes_;       // by the hash of the nonce
  std::map<std::string, std::uint64_t> host_memory_;  // that its workers share
  std::map<AttemptId, std::set<std::string>> presented_by_;
  std::map<AttemptId, std::string> given_to_;
  std::map<std::string, std::uint64_t> sizes_;
  std::map<TaskId, std::size_t> accepted_;
  std::map<TaskId, std::size_t> wanted_again_;
  std::map<TaskId, std::vector<ArtifactRef>> made_;
  std::map<WorkerId, std::string> worker2host_;
  std::set<TaskId> assembled_;
  std::set<TaskId> replaced_;
  std::size_t removed_ = 0;
};

}  // namespace tetfarm::simulation
