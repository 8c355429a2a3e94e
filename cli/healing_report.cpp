#include "cli/healing_report.h"

#include <cstdio>
#include <string>

#include "cli/place_text.h"

namespace tetfarm {
namespace {

std::string kinds_of_defects(const SurfaceReport& report) {
  std::string kinds;
  for (const SurfaceDefect& defect : report.defects) {
    kinds += (kinds.empty() ? "" : ", ") + defect.kind;
  }
  return kinds;
}

void print_acts(const char* first_label, const HealedSurface& healed) {
  const char* label = first_label;
  for (const std::string& text : heal_texts(healed.acts)) {
    std::printf("%-16s%s\n", label, text.c_str());
    label = "";
  }
}

}  // namespace

void print_healing(const HealedSurface& healed) {
  if (healed.acts.empty()) std::printf("healed          nothing: the surface is sound\n");
  print_acts("healed", healed);
}

nlohmann::ordered_json healing_json(const HealedSurface& healed) {
  nlohmann::ordered_json json = {{"mends_all", healed.checked.report.defects.empty()},
                                 {"acts", nlohmann::ordered_json::array()},
                                 {"left", nlohmann::ordered_json::array()}};
  for (std::size_t k = 0; k < heal_kinds; ++k) {
    const auto kind = static_cast<HealKind>(k);
    std::int64_t count = 0;
    const HealAct* first = nullptr;
    for (const HealAct& act : healed.acts) {
      if (act.kind != kind) continue;
      if (count++ == 0) first = &act;
    }
    if (first == nullptr) continue;
    json["acts"].push_back(
        {{"kind", name_of(kind)}, {"count", count}, {"first", place_json(first->at)}});
  }
  for (const SurfaceDefect& defect : healed.checked.report.defects) {
    json["left"].push_back(defect.kind);
  }
  return json;
}

void print_prospect_of_healing(const HealedSurface& healed, const std::string& input) {
  const SurfaceReport& left = healed.checked.report;
  if (left.defects.empty()) {
    std::printf("healing         would mend it: tetfarm surface %s --heal-only\n", input.c_str());
  } else {
    std::printf("healing         would leave: %s\n", kinds_of_defects(left).c_str());
  }
  print_acts("", healed);
}

}  // namespace tetfarm
