#include "json/quality_gates.h"

#include <gmock/gmock.h>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

wire::JobStatus status_of(double smallest, double unforced) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  numbers["min_dihedral_deg"] = smallest;
  numbers["min_dihedral_gate_deg"] = 0;
  numbers["unforced_elements"] = 100;
  numbers["unforced_min_dihedral_deg"] = unforced;
  numbers["unforced_worst_x"] = 1.5;
  numbers["min_unforced_dihedral_gate_deg"] = 1;
  return status;
}

TEST(QualityGates, angles_that_the_surface_forces_pass_by_default) {
  for (const QualityGate& gate : quality_gates_of(status_of(0.0002, 1.2))) {
    EXPECT_TRUE(gate.is_passed()) << gate.key;
  }
}

TEST(QualityGates, angles_that_it_does_not_force_do_not) {
  const std::vector<QualityGate> gates = quality_gates_of(status_of(0.0002, 0.0213));
  ASSERT_THAT(gates, SizeIs(2));
  EXPECT_TRUE(gates[0].is_passed());
  ASSERT_FALSE(gates[1].is_passed());
  const std::string text = gate_text(gates[1]);
  EXPECT_THAT(text, HasSubstr("error: where the surface forces no small angles, the smallest "
                              "dihedral angle is 0.021 deg, near (1.5, 0, 0)"));
  EXPECT_THAT(text, HasSubstr("gate is 1.00 deg"));
  EXPECT_THAT(text, HasSubstr("help: the mesh is complete"));
  EXPECT_THAT(text, HasSubstr("min_unforced_dihedral"));
}

TEST(QualityGates, are_passed_by_an_angle_of_just_that_size) {
  for (const QualityGate& gate : quality_gates_of(status_of(0.0002, 1))) {
    EXPECT_TRUE(gate.is_passed()) << gate.key;
  }
}

TEST(QualityGates, a_gate_of_0_is_none) {
  wire::JobStatus status = status_of(0.0002, 0);
  (*status.mutable_numbers())["min_unforced_dihedral_gate_deg"] = 0;
  for (const QualityGate& gate : quality_gates_of(status)) EXPECT_TRUE(gate.is_passed());
}

TEST(QualityGates, the_gate_of_all_tets_counts_forced_ones_too) {
  wire::JobStatus status = status_of(3, 25);
  (*status.mutable_numbers())["min_dihedral_gate_deg"] = 5;
  const std::vector<QualityGate> gates = quality_gates_of(status);
  ASSERT_FALSE(gates[0].is_passed());
  EXPECT_THAT(gate_text(gates[0]), HasSubstr("the smallest dihedral angle is 3.00 deg"));
  EXPECT_TRUE(gates[1].is_passed());
}

TEST(QualityGates, a_job_of_an_older_program_has_no_unforced_gate) {
  wire::JobStatus status;
  (*status.mutable_numbers())["min_dihedral_deg"] = 12;
  EXPECT_THAT(quality_gates_of(status), SizeIs(1));
}

}  // namespace
}  // namespace tetfarm
