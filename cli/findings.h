/// What `tetfarm doctor` found: of each thing that it looked at whether it is well, what was found,
/// and what to do about it.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace tetfarm {

enum class Verdict { ok, warning, problem };

/// "ok", "warning", "problem".
const char* name_of(Verdict verdict);

struct Finding {
  std::string check;  ///< what was looked at: "memory", "keys"
  Verdict verdict = Verdict::ok;
  std::string found;   ///< a sentence without its full stop
  std::string remedy;  ///< what to do; "": nothing, of what is well

  friend bool operator==(const Finding&, const Finding&) = default;
};
using Findings = std::vector<Finding>;

/// For people: a line for each, what to do below it, and how many there are of which verdict.
std::string findings_text(std::span<const Finding> findings);

/// For programs: an object and a line for each, and one for all.
std::string findings_json(std::span<const Finding> findings);

/// As one text that can be carried from one process to another, and back; nothing of another text.
std::string packed_findings(std::span<const Finding> findings);
Findings unpacked_findings(const std::string& packed);

}  // namespace tetfarm
