#include "base/work_stage.h"

#include <array>
#include <cstdio>

namespace tetfarm {
namespace {

struct Words {
  const char* name;
  const char* doing;
  const char* things;  ///< that are counted
};

constexpr std::array<Words, work_stages> words = {{
    {"read", "reading", ""},
    {"check", "checking the surface", ""},
    {"spacing", "building the spacing", ""},
    {"cut", "cutting", "planes"},
    {"graph", "graph of sub-domains", "sub-domains"},
    {"join", "joining", "groups"},
    {"boundary", "boundary", "nodes"},
    {"edges", "recovery", "edges"},
    {"faces", "recovery", "faces"},
    {"splits", "recovery", "splits"},
    {"added_points", "recovery", "added points"},
    {"points", "points", ""},
    {"cosmetics", "cosmetics", "tries"},
    {"validate", "validating", ""},
    {"order", "ordering", "sub-domains"},
    {"extract", "extracting", ""},
    {"number", "numbering", ""},
    {"write", "writing", ""},
    {"layers", "growing layers", ""},
    {"solve", "running the solver", ""},
    {"adapt", "adapting", ""},
    {"transfer", "bringing the solution along", ""},
    {"cycles", "collecting", "cycles"},
    {"remeshing", "remeshing the surface", ""},
    {"assemble", "assembling", "sub-domains"},
}};

const Words& words_of(WorkStage stage) { return words.at(static_cast<std::size_t>(stage)); }

}  // namespace

const char* name_of(WorkStage stage) { return words_of(stage).name; }

std::optional<WorkStage> work_stage_of(std::string_view name) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (name == words[i].name) return static_cast<WorkStage>(i);
  }
  return std::nullopt;
}

std::string grouped_count(std::uint64_t count) {
  constexpr std::uint64_t first_short = 1'000'000;
  constexpr std::uint64_t first_giga = 1'000'000'000;
  std::array<char, 32> text;
  if (count >= first_short) {
    const bool is_giga = count >= first_giga;
    std::snprintf(text.data(), text.size(), "%.2f %c",
                  static_cast<double>(count) / (is_giga ? 1e9 : 1e6), is_giga ? 'G' : 'M');
    return text.data();
  }
  std::string digits = std::to_string(count);
  if (digits.size() > 3) digits.insert(digits.size() - 3, ",");
  return digits;
}

std::string work_text(const WorkCount& count) {
  const Words& said = words_of(count.stage);
  std::string text = said.doing;
  if (count.pass > 0) text += " pass " + std::to_string(count.pass);
  if (count.done == 0 && count.total == 0) return text;
  text += ": " + grouped_count(count.done);
  if (count.total > 0) text += " of " + grouped_count(count.total);
  const std::string things = said.things;
  return things.empty() ? text : text + " " + things;
}

}  // namespace tetfarm
