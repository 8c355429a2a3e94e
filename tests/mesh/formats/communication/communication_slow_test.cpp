// Communication tables of real models, meshed by the built program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file_system.h"
#include "mesh/formats/communication/communication_table.h"
#include "tests/support/program.h"

namespace tetfarm {
namespace {

/// Meshes the model in so many sub-domains, and writes the tables into the folder "tables".
void mesh_and_export(const std::filesystem::path& model, int parts,
                     const std::filesystem::path& folder) {
  const test::Ended meshed =
      test::run_program({"run", model.string(), "--subdomains", std::to_string(parts), "-o", "out",
                         "--progress", "none"},
                        folder, 300);
  ASSERT_EQ(meshed.code, 0) << meshed.err;
  const test::Ended exported =
      test::run_program({"export", "out", "--format", "comm", "-o", "tables"}, folder);
  ASSERT_EQ(exported.code, 0) << exported.err;
}

TEST(CommunicationOfModels, tables_are_right_and_all_owned_nodes_are_the_mesh) {
  const char* data = std::getenv("TETFARM_DATA");
  if (data == nullptr) GTEST_SKIP() << "TETFARM_DATA is not set";
  for (const char* model : {"onera_m6_sharp_te/onera_m6_sharp_te.msh.gz", "flange/flange.msh",
                            "gmsh_piece_4vol/gmsh_piece_4vol.msh"}) {
    for (const int parts : {4, 16}) {
      SCOPED_TRACE(std::string(model) + ", " + std::to_string(parts) + " sub-domains");
      const test::TemporaryFolder folder;
      mesh_and_export(std::filesystem::path(data) / model, parts, folder.path());
      const auto read = [&](std::int32_t i) {
        const std::string name = "part-" + std::to_string(i) + ".comm";
        return communication_from_bytes(read_file(folder.path() / "tables" / name), name);
      };
      const std::int32_t made = read(0).parts;
      EXPECT_GT(made, 1);
      EXPECT_THAT(communication_complaints(made, read), testing::IsEmpty());
    }
  }
}

}  // namespace
}  // namespace tetfarm
