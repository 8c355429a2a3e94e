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

TEST(QualityGates, are_told_with_place_limit_and_what_to_do) {
  QualityGate gate{"min_dihedral", 5, 3, {1.5, 2.5, -3}};
  EXPECT_EQ(gate_text(gate),
            "error: the smallest dihedral angle is 3.00 deg, near (1.5, 2.5, -3); the job's gate "
            "is 5.00 deg\nhelp: the mesh is complete; `tetfarm quality` shows more\n");
  gate.key = "min_unforced_dihedral";
  EXPECT_EQ(gate_text(gate),
            "error: where the surface forces no small angles, the smallest dihedral angle is 3.00 "
            "deg, near (1.5, 2.5, -3); the job's gate is 5.00 deg\n"
            "help: the mesh is complete; `tetfarm quality` shows more. A finer surface there, or a "
            "smaller size, gives better elements; `[quality] min_unforced_dihedral` in the job "
            "file sets the gate; 0 means none\n");
}

TEST(QualityGates, are_at_the_places_of_their_own_angles) {
  wire::JobStatus status;
  auto& numbers = *status.mutable_numbers();
  double next = 1;
  for (const char* name :
       {"min_dihedral_gate_deg", "min_dihedral_deg", "worst_x", "worst_y", "worst_z",
        "min_unforced_dihedral_gate_deg", "unforced_min_dihedral_deg", "unforced_worst_x",
        "unforced_worst_y", "unforced_worst_z", "unforced_elements"}) {
    numbers[name] = next++;
  }
  const std::vector<QualityGate> gates = quality_gates_of(status);
  ASSERT_THAT(gates, SizeIs(2));
  EXPECT_EQ(gates[0].key, "min_dihedral");
  EXPECT_EQ(gates[0].limit_deg, 1);
  EXPECT_EQ(gates[0].smallest_deg, 2);
  EXPECT_EQ(gates[0].at, (std::array<double, 3>{3, 4, 5}));
  EXPECT_EQ(gates[1].key, "min_unforced_dihedral");
  EXPECT_EQ(gates[1].limit_deg, 6);
  EXPECT_EQ(gates[1].smallest_deg, 7);
  EXPECT_EQ(gates[1].at, (std::array<double, 3>{8, 9, 10}));
}

}  // namespace
}  // namespace tetfarm
