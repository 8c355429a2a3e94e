#include <gtest/gtest.h>

#include "mesh/job_file/job_file.h"

namespace tetfarm {
namespace {

TEST(JobFileText, of_the_defaults_is_what_the_store_keeps) {
  JobFile job;
  job.name = "wing";
  job.surface = "/a.stl";
  EXPECT_EQ(to_toml(job), R"(version = 1
name = "wing"

[geometry]
surface = "/a.stl"

[domain]
outer = "none"

[spacing]
default = 0
growth = 0.3
surface = "inherit"
max_elements = 2000000000

[decompose]
subdomains = 0
target_elements = 0
plane = "auto"

[mesh]
points = "lattice"

[cosmetics]
across_cuts = true

[quality]
min_dihedral = 0
min_unforced_dihedral = 0.1

[output]
formats = ["vtkhdf"]
)");
}

TEST(JobFileText, has_everything_that_a_job_may_ask_for) {
  JobFile job;
  job.name = "a\"b\\c\x01\x1f\x7f é";
  job.surface = "/a.stl";
  job.outer_kind = "box";
  job.outer_factor = 2.5;
  job.outer_spacing = -0.0;
  job.regions = {{{1, 2, 3}, "steel", false}, {{-1, 0, 0.1}, "", true}};
  job.spacing_default = 1e-7;
  job.growth = 1.0 / 3;
  job.inherit_surface = false;
  job.max_elements = 7'000'000'000;
  const JobSource::Corner corner{{1, 2, 3}, 0.5, 1, 2};
  job.sources = {{{corner}}, {{corner, corner}}, {{corner, corner, corner}}};
  JobLayers counted;
  counted.patches = {"wing_*", "a\"b"};
  counted.first_height = 1e-4;
  counted.growth_cap = 1.5;
  counted.acceleration = 1.05;
  counted.count = 20;
  counted.equal = 2;
  counted.typed = "not kept";
  JobLayers until;
  until.patches = {"tip"};
  until.y_plus = 1;
  until.reynolds = 6e6;
  until.length = 2.5;
  until.total_height = 0.01;
  until.room = "stop";
  JobLayers isotropic;
  isotropic.patches = {"*"};
  isotropic.first_height = 1;
  job.layers = {counted, until, isotropic};
  job.subdomains = 12;
  job.target_elements = 5000;
  job.plane = "axis";
  job.points = "sweeps";
  job.across_cuts = false;
  job.groups = 3;
  job.assimilate_method = "k-way";
  job.min_dihedral_deg = 5;
  job.min_unforced_dihedral_deg = 7.5;
  job.formats = {"su2", "cgns"};
  EXPECT_EQ(to_toml(job), R"(version = 1
name = "a\"b\\c\u0001\u001F\u007F é"

[geometry]
surface = "/a.stl"

[domain]
outer = "box"
factor = 2.5
spacing = 0

[[region]]
at = [1, 2, 3]
name = "steel"
void = false

[[region]]
at = [-1, 0, 0.1]
name = ""
void = true

[spacing]
default = 1e-07
growth = 0.3333333333333333
surface = "ignore"
max_elements = 7000000000

[[source]]
kind = "point"
at = [1, 2, 3]
spacing = 0.5
inner = 1
outer = 2

[[source]]
kind = "line"
from = { at = [1, 2, 3], spacing = 0.5, inner = 1, outer = 2 }
to = { at = [1, 2, 3], spacing = 0.5, inner = 1, outer = 2 }

[[source]]
kind = "triangle"
corner = [
  { at = [1, 2, 3], spacing = 0.5, inner = 1, outer = 2 },
  { at = [1, 2, 3], spacing = 0.5, inner = 1, outer = 2 },
  { at = [1, 2, 3], spacing = 0.5, inner = 1, outer = 2 },
]

[[layers]]
patches = ["wing_*", "a\"b"]
first_height = 1e-04
growth = 1.2
growth_cap = 1.5
acceleration = 1.05
count = 20
equal = 2
room = "ratio"

[[layers]]
patches = ["tip"]
y_plus = 1
reynolds = 6e+06
length = 2.5
growth = 1.2
total_height = 0.01
equal = 1
room = "stop"

[[layers]]
patches = ["*"]
first_height = 1
growth = 1.2
count = "isotropic"
equal = 1
room = "ratio"

[decompose]
subdomains = 12
target_elements = 5000
assimilate = { groups = 3, method = "k-way" }
plane = "axis"

[mesh]
points = "sweeps"

[cosmetics]
across_cuts = false

[quality]
min_dihedral = 5
min_unforced_dihedral = 7.5

[output]
formats = ["su2", "cgns"]
)");
}

TEST(JobFileText, with_a_limit_of_memory_has_no_counts_that_it_decides) {
  JobFile job;
  job.subdomains = 3;
  job.max_memory_bytes = 1'610'612'736;
  const std::string text = to_toml(job);
  EXPECT_NE(text.find("[decompose]\nmax_memory = \"1610612736B\"\nplane = \"auto\"\n"), text.npos)
      << text;
}

}  // namespace
}  // namespace tetfarm
