#include "worker/evidence.h"

#include <gmock/gmock.h>

#include "mesh/decompose/planar_cut.h"
#include "tests/base/temp_folder.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A tetrahedron of a cut domain, whose third triangle comes from a cut.
Subdomain corner() {
  Subdomain subdomain;
  subdomain.path = {5};
  subdomain.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 6, 0}, {0, 0, 9}};
  subdomain.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  subdomain.triangle_origin = {{0, 10}, {0, 11}, {1, 12}, {0, 13}};
  return subdomain;
}

TEST(Evidence, tells_a_triangle_by_its_number_its_owner_and_its_middle) {
  EXPECT_EQ(describe_triangle(corner(), 0), "triangle 10 of the input at (1, 2, 0)");
  EXPECT_EQ(describe_triangle(corner(), 2),
            "triangle 12 of the cut of sub-domain root at (1, 2, 3)");
}

TEST(Evidence, names_five_triangles_and_counts_the_others) {
  const std::string first = "sub-domain LR: it is odd\n  triangle 10 of the input at (1, 2, 0)";
  EXPECT_EQ(subdomain_message(corner(), "it is odd", {}), "sub-domain LR: it is odd");
  EXPECT_EQ(subdomain_message(corner(), "it is odd", {0}), first);
  const std::string five = first +
                           "\n  triangle 11 of the input at (1, 0, 3)"
                           "\n  triangle 12 of the cut of sub-domain root at (1, 2, 3)"
                           "\n  triangle 13 of the input at (0, 2, 3)"
                           "\n  triangle 11 of the input at (1, 0, 3)";
  EXPECT_EQ(subdomain_message(corner(), "it is odd", {0, 1, 2, 3, 1}), five);
  EXPECT_EQ(subdomain_message(corner(), "it is odd", {0, 1, 2, 3, 1, 0, 2}),
            five + "\n  and 2 more");
  EXPECT_EQ(subdomain_message(corner(), "sub-domain LR: said already", {}),
            "sub-domain LR: said already");
}

class EvidenceFiles : public testing::Test {
 protected:
  TempFolder folder_;
  ArtifactStore store_{folder_.path()};
  wire::Assign assign_;
  TaskIo io_{store_, assign_, [](const wire::Doing&) {}};
};

TEST_F(EvidenceFiles, of_bad_input_are_its_marked_triangles) {
  const RefusedInput refused = refused_subdomain(io_, corner(), "two vertices in one place", {3});
  EXPECT_STREQ(refused.what(),
               "sub-domain LR: two vertices in one place\n  triangle 13 of the input at (0, 2, 3)");
  EXPECT_EQ(refused.code(), ExitCode::bad_geometry);
  ASSERT_EQ(refused.evidence().size(), 1U);
  EXPECT_EQ(refused.evidence()[0].name, "subdomain_LR.defects.vtp");
  EXPECT_THAT(refused.evidence()[0].bytes, testing::HasSubstr("<VTKFile"));
  EXPECT_EQ(count_files(store_.scratch_folder()), 0U) << "nothing is left in the making";
}

TEST_F(EvidenceFiles, of_a_defect_of_ours_hold_the_sub_domain_too_and_say_where_to_send_it) {
  const OwnDefect defect = unrecovered_subdomain(io_, corner(), "a face is missing", {0});
  EXPECT_STREQ(defect.what(),
               "sub-domain LR: a face is missing\n  triangle 10 of the input at (1, 2, 0)\n"
               "This is a bug in Tetfarm: the surface is valid. Please send subdomain_LR.off to "
               "the developers; it holds this sub-domain exactly and is enough to reproduce the "
               "failure. Another number of sub-domains may avoid it.");
  EXPECT_EQ(defect.code(), ExitCode::failed);
  ASSERT_EQ(defect.evidence().size(), 2U);
  EXPECT_EQ(defect.evidence()[0].name, "subdomain_LR.defects.vtp");
  EXPECT_EQ(defect.evidence()[1].name, "subdomain_LR.off");
  EXPECT_THAT(defect.evidence()[1].bytes, testing::StartsWith("OFF"));
}

}  // namespace
}  // namespace tetfarm
