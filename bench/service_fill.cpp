// Fills a store's database with jobs of make-believe tasks, as a coordinator would have: each row
// comes out of the real decisions, for results that were made up. What waiting tasks read lies in
// the store.
//
// service_fill STORE [--finished JOBS LEAVES] [--waiting LEAVES]
//   --finished  so many jobs of so many sub-domains that are done: 3 tasks a sub-domain
//   --waiting   a job that is cut into so many sub-domains, of which none is meshed
#include <charconv>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "base/clock.h"
#include "base/error.h"
#include "base/hash.h"
#include "coordinator/decisions/job_state.h"
#include "store/artifact_store.h"
#include "store/job_database.h"

namespace {

using namespace tetfarm;

constexpr int workers = 64;
constexpr int rounds_per_commit = 64;
constexpr double work_of_leaf = 1e6;

struct File {
  std::string name;
  std::string content;

  ArtifactRef ref() const { return {name, hash128(content).hex(), content.size()}; }
};

/// What a task makes, each file with other bytes than any other.
std::vector<File> outputs_of(const TaskRow& task) {
  const std::string seed =
      job_name(task.job) + " " + name_of(task.kind) + " " + std::to_string(task.path) + " ";
  const auto files = [&seed](const std::vector<std::string>& names) {
    std::vector<File> made;
    for (const std::string& name : names) made.push_back({name, seed + name});
    return made;
  };
  switch (task.kind) {
    case TaskKind::inspect:
      return files({"surface", "spacing", "root", "settings"});
    case TaskKind::decompose:
      return files({"left", "right"});
    case TaskKind::mesh:
      return files({"mesh"});
    case TaskKind::number:
      return files({"numbering"});
    case TaskKind::write:
      return files({"portion", "tets"});
    default:
      return files({"mesh.vtkhdf"});
  }
}

TaskResult result_of(const TaskRow& task, std::uint64_t leaves, const std::vector<File>& files) {
  TaskResult result;
  for (const File& file : files) result.outputs.push_back(file.ref());
  result.seconds = 1;
  result.peak_rss_bytes = std::uint64_t{50} << 20U;
  result.numbers["cpu_seconds"] = 1;
  if (task.kind == TaskKind::inspect) {
    for (const char* name : {"groups", "most_bytes", "needles", "across_cuts"}) {
      result.numbers[name] = 0;
    }
    result.numbers["parts"] = static_cast<double>(leaves);
    result.numbers["total_work"] = work_of_leaf * static_cast<double>(leaves);
  }
  if (task.kind == TaskKind::decompose) {
    const auto work = [&task](const char* side) {
      return work_of_leaf * std::stod(task.parameters.at(side));
    };
    result.numbers["interdomain_nodes"] = 100;
    result.numbers["left_needles"] = result.numbers["right_needles"] = 0;
    result.numbers["left_work"] = work("left_parts");
    result.numbers["right_work"] = work("right_parts");
  }
  if (task.kind == TaskKind::mesh) {
    result.numbers["interior_nodes"] = 166'666;
    result.numbers["tets"] = work_of_leaf;
  }
  return result;
}

/// A farm without sockets: workers whose tasks take no time.
class Filler {
 public:
  explicit Filler(const std::filesystem::path& store)
      : store_(store),
        database_(store / "tetfarm.db"),
        state_(
            database_.load(), {}, [](const ArtifactRef&) { return true; }, now()) {
    WorkerInfo info;
    info.host = "make-believe";
    for (int i = 0; i < workers; ++i) {
      info.nonce = std::to_string(i);
      idle_.push_back(state_.add_worker(info, {}, {}, now()));
    }
  }

  void add_job(std::uint64_t leaves, bool finishes) {
    Submission submission;
    submission.name = "make-believe";
    submission.job_toml = "# " + std::to_string(leaves) + " sub-domains";
    const ArtifactRef job_file = File{"job", submission.job_toml}.ref();
    submission.given.job = {job_file.hash, job_file.size};
    job_ = state_.submit(submission, now()).job;
    put_into_store({{"job", submission.job_toml}});
    leaves_ = leaves;
    finishes_ = finishes;
    for (int round = 1; !idle_.empty(); ++round) {
      play_round();
      if (state_.durable().jobs.at(job_).phase != JobPhase::running) break;
      if (round % rounds_per_commit == 0) database_.apply(state_.take_changes());
    }
    database_.apply(state_.take_changes());
  }

 private:
  static Moment now() { return {steady_ms(), wall_ms()}; }

  /// A worker that gets a task which is to wait hands it back, and takes no more.
  void play_round() {
    for (const WorkerId worker : idle_) state_.worker_is_ready(worker, now());
    state_.tick(now());
    idle_.clear();
    for (const Command& command : state_.take_commands()) {
      const auto* assign = std::get_if<SendAssign>(&command);
      if (assign == nullptr) continue;
      const TaskRow task = state_.durable().tasks.at(assign->task);
      if (!finishes_ && task.kind == TaskKind::mesh) {
        state_.worker_left(assign->worker, false, now());
        continue;
      }
      const std::vector<File> files = outputs_of(task);
      if (!finishes_) put_into_store(files);
      state_.done(assign->worker, task.id, assign->attempt, result_of(task, leaves_, files), now());
    }
    for (const WorkerAtWork& worker : state_.workers_at_work()) idle_.push_back(worker.row.id);
  }

  /// Without the fsync of each that ArtifactStore::publish does.
  void put_into_store(const std::vector<File>& files) const {
    for (const File& file : files) {
      const std::filesystem::path path = store_.path_of(file.ref().hash);
      std::filesystem::create_directories(path.parent_path());
      std::ofstream(path, std::ios::binary) << file.content;
    }
  }

  ArtifactStore store_;
  JobDatabase database_;
  JobState state_;
  std::vector<WorkerId> idle_;
  JobId job_;
  std::uint64_t leaves_ = 0;
  bool finishes_ = false;
};

std::uint64_t number_of(const char* text) {
  std::uint64_t number = 0;
  const char* end = text + std::strlen(text);
  if (std::from_chars(text, end, number).ptr != end || number == 0) {
    throw UsageError("not a count", text);
  }
  return number;
}

void fill(const std::vector<const char*>& words) {
  Filler filler(words.at(0));
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (std::strcmp(words[i], "--finished") == 0) {
      const std::uint64_t jobs = number_of(words.at(++i));
      const std::uint64_t leaves = number_of(words.at(++i));
      for (std::uint64_t job = 0; job < jobs; ++job) filler.add_job(leaves, true);
    } else if (std::strcmp(words[i], "--waiting") == 0) {
      filler.add_job(number_of(words.at(++i)), false);
    } else {
      throw UsageError("unknown", words[i]);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    fill({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "service_fill: %s\n", error.what());
    return 1;
  }
}
