// A whole job in simulated time: the real decisions of the coordinator (JobState) hand out tasks
// that take the seconds they are told to take. bench/scaling.py makes the model and draws what
// comes out.
//
// service_scaling LEAVES ELEMENTS WORKERS...  < model
//   LEAVES   a power of two: the domain is a block that is halved along x, y, z in turn
//   model    a line for each kind of task: KIND SECONDS [RATIO...]; each leaf takes SECONDS times
//   one of the ratios,
//            always the same. "decompose SECONDS..." by depth. "coordinator SECONDS": each result,
//            one at a time. "start SECONDS": from the hand-out to the first instruction.
// Prints one JSON object for each number of workers: seconds, and the chain of tasks that took that
// long.
#include <bit>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <queue>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "coordinator/decisions/job_state.h"

namespace {

using namespace tetfarm;

constexpr double ms_per_s = 1000;
/// Nobody is lost here.
constexpr std::int64_t for_ever_ms = std::int64_t{1} << 50U;

using Model = std::map<std::string, std::vector<double>>;

struct Cell {
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint64_t z = 0;
};

/// Where a leaf lies: the bits of its heap number, below the first, are of x, y, z in turn.
Cell cell_of(std::uint64_t path) {
  Cell cell;
  const int depth = std::bit_width(path) - 1;
  for (int level = 0; level < depth; ++level) {
    const std::uint64_t bit = path >> static_cast<unsigned>(depth - 1 - level) & 1U;
    std::uint64_t& axis = level % 3 == 0 ? cell.x : level % 3 == 1 ? cell.y : cell.z;
    axis = 2 * axis + bit;
  }
  return cell;
}

class Job {
 public:
  Job(std::uint64_t leaves, double elements, const Model& model)
      : leaves_(leaves), elements_(elements), model_(model) {}

  double seconds(const TaskRow& task) const {
    const std::vector<double>& figures = model_.at(name_of(task.kind));
    if (task.kind == TaskKind::decompose) {
      return figures.at(static_cast<std::size_t>(std::bit_width(task.path) - 1));
    }
    if (figures.size() == 1) return figures[0];
    const std::uint64_t lot =
        hash128(std::string(name_of(task.kind)) + std::to_string(task.path)).low;
    return figures[0] * figures[1 + lot % (figures.size() - 1)];
  }

  TaskResult result(const TaskRow& task) const {
    TaskResult result;
    result.seconds = seconds(task);
    result.peak_rss_bytes = 1;
    const auto add = [&](const std::string& name) {
      const std::string content = place_of(task) + name;
      result.outputs.push_back({name, hash128(content).hex(), content.size()});
    };
    switch (task.kind) {
      case TaskKind::inspect:
        for (const char* name : {"surface", "spacing", "root", "settings"}) add(name);
        result.numbers = {{"parts", static_cast<double>(leaves_)},
                          {"total_work", elements_},
                          {"across_cuts", 1},
                          {"groups", 0},
                          {"most_bytes", 0},
                          {"needles", 0}};
        break;
      case TaskKind::decompose:
        add("left");
        add("right");
        result.numbers["left_work"] = result.numbers["right_work"] =
            elements_ / std::exp2(std::bit_width(task.path));
        result.numbers["left_needles"] = result.numbers["right_needles"] = 0;
        result.numbers["interdomain_nodes"] = 0;
        break;
      case TaskKind::mesh:
        add("mesh");
        result.numbers["tets"] = std::floor(elements_ / static_cast<double>(leaves_));
        result.numbers["interior_nodes"] = 0;
        break;
      case TaskKind::order:
        for (std::uint64_t leaf = leaves_; leaf < 2 * leaves_; ++leaf) {
          add("shared:" + std::to_string(leaf));
        }
        result.texts["order"] = turns();
        break;
      case TaskKind::extract:
      case TaskKind::cosmetic:
        add("elements");
        break;
      case TaskKind::number:
        add("numbering");
        break;
      case TaskKind::write:
        add("portion");
        add("tets");
        break;
      default:
        add("mesh.vtkhdf");
    }
    return result;
  }

 private:
  /// A leaf shares nodes with the 26 round it; eight colours.
  std::string turns() const {
    std::map<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>, std::uint64_t> place2leaf;
    for (std::uint64_t leaf = leaves_; leaf < 2 * leaves_; ++leaf) {
      const Cell cell = cell_of(leaf);
      place2leaf[{cell.x, cell.y, cell.z}] = leaf;
    }
    std::ostringstream text;
    for (std::uint64_t leaf = leaves_; leaf < 2 * leaves_; ++leaf) {
      const Cell cell = cell_of(leaf);
      text << leaf << ' ' << (cell.x % 2) + 2 * (cell.y % 2) + 4 * (cell.z % 2);
      std::set<std::uint64_t> neighbours;
      for (std::uint64_t i = 0; i < 27; ++i) {
        const auto there =
            place2leaf.find({cell.x + i % 3 - 1, cell.y + i / 3 % 3 - 1, cell.z + i / 9 - 1});
        if (i != 13 && there != place2leaf.end()) neighbours.insert(there->second);
      }
      for (const std::uint64_t neighbour : neighbours) text << ' ' << neighbour;
      text << '\n';
    }
    return text.str();
  }

  std::uint64_t leaves_;
  double elements_;
  const Model& model_;
};

/// What happened to a task.
struct Past {
  TaskId after;  ///< the last one that it waited for
  double start_s = 0;
  double end_s = 0;
};

class Simulation {
 public:
  Simulation(const Job& job, const Model& model)
      : job_(job),
        start_s_(model.at("start").at(0)),
        coordinator_s_(model.at("coordinator").at(0)),
        state_({}, rules(), [](const ArtifactRef&) { return true; }, {}) {}

  void run(std::size_t workers) {
    Submission submission;
    submission.given.job = {std::string(32, '0'), 1};
    job_id_ = state_.submit(submission, {}).job;
    WorkerInfo info;
    info.memory_bytes = std::uint64_t{1} << 32U;
    info.shares_memory = false;
    for (std::size_t i = 0; i < workers; ++i) {
      info.host = info.nonce = std::to_string(i);
      state_.worker_is_ready(state_.add_worker(info, {}, {}, {}), {});
    }
    turn(0);
    while (!ends_.empty() && !is_done()) {
      const End end = ends_.top();
      ends_.pop();
      // One result after the other: what the coordinator cannot take yet waits.
      busy_until_s_ = std::max(busy_until_s_, end.at_s) + coordinator_s_;
      take(end);
      turn(busy_until_s_);
    }
  }

  bool is_done() const { return state_.durable().jobs.at(job_id_).phase == JobPhase::done; }

  void print(std::size_t workers) const {
    double alone = 0;
    for (const auto& [id, task] : state_.durable().tasks) {
      alone += job_.seconds(task) + start_s_ + coordinator_s_;
    }
    std::map<std::string, std::pair<int, double>> chain;
    double chain_s = 0;
    for (TaskId id = last_; id; id = past_.at(id).after) {
      const TaskRow& task = state_.durable().tasks.at(id);
      auto& [count, seconds] = chain[name_of(task.kind)];
      ++count;
      seconds += job_.seconds(task);
      chain_s += job_.seconds(task) + start_s_ + coordinator_s_;
    }
    std::printf(
        "{\"workers\": %zu, \"tasks\": %zu, \"alone\": %.3f, \"seconds\": %.3f, \"chain_s\": %.3f, "
        "\"chain\": {",
        workers, state_.durable().tasks.size(), alone, busy_until_s_, chain_s);
    const char* comma = "";
    for (const auto& [kind, sum] : chain) {
      std::printf("%s\"%s\": [%d, %.3f]", comma, kind.c_str(), sum.first, sum.second);
      comma = ", ";
    }
    std::puts("}}");
    std::fflush(stdout);
  }

 private:
  struct End {
    double at_s;
    AttemptId attempt;
    WorkerId worker;
    TaskId task;

    bool operator<(const End& other) const {
      return std::pair(other.at_s, other.attempt) < std::pair(at_s, attempt);
    }
  };

  static FarmRules rules() {
    FarmRules rules;
    rules.lease_ms = for_ever_ms;
    rules.least_late_ms = for_ever_ms;  // no task is slower than it was told to be: nobody races
    return rules;
  }

  static Moment at(double seconds) {
    const auto ms = static_cast<std::int64_t>(seconds * ms_per_s);
    return {ms, ms};
  }

  void take(const End& end) {
    const std::uint64_t known = state_.durable().tasks.rbegin()->first.value;
    const TaskRow& task = state_.durable().tasks.at(end.task);
    past_[end.task].end_s = end.at_s;
    state_.done(end.worker, end.task, end.attempt, job_.result(task), at(end.at_s));
    state_.worker_is_ready(end.worker, at(end.at_s));
    for (auto made = state_.durable().tasks.upper_bound(TaskId{known});
         made != state_.durable().tasks.end(); ++made) {
      past_[made->first].after = end.task;
    }
    last_ = end.task;
  }

  void turn(double now_s) {
    state_.tick(at(now_s));
    for (const Command& command : state_.take_commands()) {
      const auto* assign = std::get_if<SendAssign>(&command);
      if (assign == nullptr) continue;
      past_[assign->task].start_s = now_s;
      const double end_s = now_s + start_s_ + job_.seconds(state_.durable().tasks.at(assign->task));
      ends_.push({end_s, assign->attempt, assign->worker, assign->task});
    }
    state_.take_changes();
  }

  const Job& job_;
  double start_s_;
  double coordinator_s_;
  JobState state_;
  JobId job_id_;
  std::priority_queue<End> ends_;
  std::map<TaskId, Past> past_;
  TaskId last_;
  double busy_until_s_ = 0;
};

Model read_model(std::istream& in) {
  Model model;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    double figure = 0;
    while (words >> figure) model[kind].push_back(figure);
  }
  return model;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() < 3) return 2;
  const Model model = read_model(std::cin);
  const Job job(std::stoull(words[0]), std::stod(words[1]), model);
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::size_t workers = std::stoull(words[i]);
    Simulation simulation(job, model);
    simulation.run(workers);
    if (!simulation.is_done()) return 1;
    simulation.print(workers);
  }
  return 0;
}
