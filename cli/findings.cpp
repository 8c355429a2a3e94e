#include "cli/findings.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/counted.h"
#include "base/printable_text.h"
#include "json/json_line.h"

namespace tetfarm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t verdict_columns = 9;
constexpr std::size_t check_columns = 14;

std::string padded(std::string text, std::size_t columns) {
  text.resize(std::max(columns, text.size() + 1), ' ');
  return text;
}

std::size_t count_of(std::span<const Finding> findings, Verdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [verdict](const Finding& finding) { return finding.verdict == verdict; }));
}

Json json_of_finding(const Finding& finding) {
  return {{"type", "finding"},
          {"check", finding.check},
          {"verdict", name_of(finding.verdict)},
          {"found", finding.found},
          {"remedy", finding.remedy}};
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr std::array<const char*, 3> names = {"ok", "warning", "problem"};
  const auto number = static_cast<std::size_t>(verdict);
  TF_CHECK(number < names.size());
  return names[number];
}

std::string findings_text(std::span<const Finding> findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += padded(name_of(finding.verdict), verdict_columns) +
            padded(finding.check, check_columns) + printable(finding.found) + "\n";
    if (finding.remedy.empty()) continue;
    text += std::string(verdict_columns + check_columns, ' ') + printable(finding.remedy) + "\n";
  }
  return text + counted(count_of(findings, Verdict::problem), "problem") + ", " +
         counted(count_of(findings, Verdict::warning), "warning") + "\n";
}

std::string findings_json(std::span<const Finding> findings) {
  std::string text;
  for (const Finding& finding : findings) text += json_line(json_of_finding(finding)) + "\n";
  const Json all = {{"type", "doctor"},
                    {"ok", count_of(findings, Verdict::ok)},
                    {"warnings", count_of(findings, Verdict::warning)},
                    {"problems", count_of(findings, Verdict::problem)}};
  return text + json_line(all) + "\n";
}

std::string packed_findings(std::span<const Finding> findings) {
  Json all = Json::array();
  for (const Finding& finding : findings) {
    all.push_back(
        {finding.check, static_cast<int>(finding.verdict), finding.found, finding.remedy});
  }
  return json_line(all);
}

Findings unpacked_findings(const std::string& packed) {
  const Json all = Json::parse(packed, nullptr, false);
  Findings findings;
  if (!all.is_array()) return findings;
  for (const Json& one : all) {
    TF_CHECK(one.is_array() && one.size() == 4);
    findings.push_back({one[0].get<std::string>(), static_cast<Verdict>(one[1].get<int>()),
                        one[2].get<std::string>(), one[3].get<std::string>()});
  }
  return findings;
}

}  // namespace tetfarm
