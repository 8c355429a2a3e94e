#include "report/report_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tetfarm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* attack = "<script>alert('x')</script>";

MeshFigures some_figures() {
  MeshFigures figures;
  for (const double x : {1.0, 0.1}) {
    const TetShape shape = tet_shape({0, 0, 0}, {x, 0, 0}, {0, 1, 0}, {0, 0, 1});
    figures.all.add(shape);
    (x < 1 ? figures.near_cuts : figures.away_from_cuts).add(shape);
    ++figures.volumes[x < 1 ? -6 : -3];
    figures.subdomains.push_back({1, 4, 0, x / 6, 30});
  }
  figures.tets = 2;
  figures.nodes = 1'234'567;
  figures.worst.push_back({12.345, 150, 0.5, 0.01, {1.5, 2.5, 3.5}, 1, 17, true});
  return figures;
}

wire::TaskLine mesh_task(std::uint64_t path, double expected) {
  wire::TaskLine task;
  task.set_kind("mesh");
  task.set_path(path);
  task.set_state("done");
  task.set_expected_elements(expected);
  task.set_elements(expected + 1);
  task.set_expected_seconds(2);
  task.set_cpu_seconds(3);
  return task;
}

wire::AttemptLine attempt(const std::string& state, std::int64_t from_ms, std::int64_t to_ms) {
  wire::AttemptLine line;
  line.set_kind("mesh");
  line.set_path(2);
  line.set_host(attack);
  line.set_process(7);
  line.set_state(state);
  line.set_started_ms(from_ms);
  line.set_ended_ms(to_ms);
  return line;
}

ReportContent whole_report() {
  ReportContent content{attack, some_figures(), {{attack, "PNG"}}, ReportedWork()};
  content.work->status.set_message(attack);
  content.work->tasks = {mesh_task(3, 30), mesh_task(2, 20)};
  content.work->attempts = {attempt("done", 1000, 3000), attempt("crashed", 3000, 3500)};
  return content;
}

TEST(ReportPage, holds_no_markup_and_no_addresses_of_others) {
  const std::string page = report_page(whole_report());
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;"));
  for (const char* outside : {"http:", "https:", "url(", "<link", "@import"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
  EXPECT_THAT(page, HasSubstr("data:image/png;base64,UE5H"));
}

TEST(ReportPage, tells_both_sides_of_the_cuts_the_time_step_and_the_worst_tets) {
  const std::string page = report_page(whole_report());
  EXPECT_THAT(page, HasSubstr("Near the cuts and away from them"));
  EXPECT_THAT(page, HasSubstr("1 234 567"));
  EXPECT_THAT(page, HasSubstr("12.345°"));
  EXPECT_THAT(page, HasSubstr("1.5, 2.5, 3.5"));
  // Heights over the largest faces: 1 / sqrt(3) and 0.1 / sqrt(1.02) or so.
  EXPECT_THAT(page, HasSubstr("5.8"));
  EXPECT_THAT(page, HasSubstr("the spacing that the mesh was made with is not available"));
}

TEST(ReportPage, groups_digits_by_three_and_gives_shares_in_percent) {
  ReportContent content = whole_report();
  content.figures.nodes = 123;
  content.figures.boundary_triangles = 1'000;
  const std::string page = report_page(content);
  EXPECT_THAT(page, HasSubstr(">123<"));
  EXPECT_THAT(page, HasSubstr(">1 000<"));
  // Of the one tet away from the cuts all angles of a kind lie in one bin.
  EXPECT_THAT(page, HasSubstr(": 100 away from them"));
}

TEST(ReportPage, puts_estimates_beside_what_was_made_in_tree_order) {
  EXPECT_THAT(estimated_elements_of_leaves(*whole_report().work), ElementsAre(20, 30));
  EXPECT_THAT(report_page(whole_report()), HasSubstr("estimated before"));
  ReportContent content = whole_report();
  content.work->tasks.pop_back();
  EXPECT_THAT(report_page(content), Not(HasSubstr("estimated before")))
      << "not every sub-domain has an estimate";
}

TEST(ReportPage, keeps_what_is_measured_apart) {
  ReportContent content = whole_report();
  const std::string one = report_page(content);
  content.work->attempts.clear();
  content.work->tasks[0].set_cpu_seconds(99);
  const std::string other = report_page(content);
  EXPECT_NE(one, other);
  const std::size_t mesh_part = one.find(measured_part);
  ASSERT_NE(mesh_part, std::string::npos);
  EXPECT_EQ(one.substr(0, mesh_part), other.substr(0, other.find(measured_part)));
}

TEST(ReportPage, names_attempts_that_were_in_vain) {
  EXPECT_THAT(report_page(whole_report()), HasSubstr("mesh L crashed, 0.500 s"));
  EXPECT_THAT(report_page(whole_report()), HasSubstr("failed or lost"));
}

TEST(ReportPage, counts_the_attempts_of_each_task_that_were_lost_crashed_or_out_of_memory) {
  ReportContent content = whole_report();
  EXPECT_THAT(report_page(content), HasSubstr("<td></td></tr>"));
  content.work->tasks[0].set_oom_count(41);
  EXPECT_THAT(report_page(content), HasSubstr("<td>41</td></tr>"));
  content.work->tasks[0].set_crashes(2);
  content.work->tasks[0].set_losses(100);
  EXPECT_THAT(report_page(content), HasSubstr("<td>143</td></tr>"));
}

TEST(ReportPage, of_a_mesh_alone_has_no_work_and_without_cuts_no_sides) {
  ReportContent content = whole_report();
  content.work.reset();
  content.figures.near_cuts = {};
  const std::string page = report_page(content);
  EXPECT_THAT(page, Not(HasSubstr(std::string(measured_part))));
  EXPECT_THAT(page, Not(HasSubstr("near the cuts")));
}

TEST(ReportPage, of_a_mesh_without_tets_tells_no_figures_of_tets) {
  ReportContent content;
  content.figures.others[ElementType::hex] = {12, 1.5, 0.75, 10.5};
  const std::string page = report_page(content);
  EXPECT_THAT(page, AllOf(HasSubstr("hexes"), HasSubstr("0.8750 mean, 0.7500 smallest")));
  for (const char* of_tets : {"dihedral", "radius ratio", "time step", "The worst"}) {
    EXPECT_THAT(page, Not(HasSubstr(of_tets)));
  }
}

}  // namespace
}  // namespace tetfarm
