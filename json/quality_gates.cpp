#include "json/quality_gates.h"

#include "base/angle_text.h"
#include "base/check.h"
#include "json/reply_values.h"
#include "mesh/core/complaints.h"

namespace tetfarm {
namespace {

constexpr const char* unforced_key = "min_unforced_dihedral";

QualityGate gate_of(const wire::JobStatus& status, const std::string& key,
                    const std::string& whose) {
  return {key,
          number_of(status, key + "_gate_deg"),
          number_of(status, whose + "min_dihedral_deg"),
          {number_of(status, whose + "worst_x"), number_of(status, whose + "worst_y"),
           number_of(status, whose + "worst_z")}};
}

}  // namespace

std::vector<QualityGate> quality_gates_of(const wire::JobStatus& status) {
  std::vector<QualityGate> gates = {gate_of(status, "min_dihedral", "")};
  if (number_of(status, "unforced_elements") > 0) {
    gates.push_back(gate_of(status, unforced_key, "unforced_"));
  }
  return gates;
}

std::string gate_text(const QualityGate& gate) {
  TF_CHECK(!gate.key.empty());
  const std::string where = text_of(Vec3{gate.at[0], gate.at[1], gate.at[2]});
  const std::string limit = angle_text(gate.limit_deg) + " deg";
  if (gate.key == unforced_key) {
    return "error: where the surface forces no small angles, the smallest dihedral angle is " +
           angle_text(gate.smallest_deg) + " deg, near " + where + "; the job's gate is " + limit +
           "\nhelp: the mesh is complete; `tetfarm quality` shows more. A finer surface "
           "there, or a smaller size, gives better elements; `[quality] min_unforced_dihedral` in "
           "the job file sets the gate; 0 means none\n";
  }
  return "error: the smallest dihedral angle is " + angle_text(gate.smallest_deg) + " deg, near " +
         where + "; the job's gate is " + limit +
         "\nhelp: the mesh is complete; `tetfarm quality` shows more\n";
}

}  // namespace tetfarm
