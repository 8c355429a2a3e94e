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
  ReportContent content{attack, some_figures(), {{attack, "PNG"}}, {}, ReportedWork()};
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

/// Cells of the rows of a page, apart by "|", a row a line.
std::string rows_of(const std::string& page) {
  std::string rows;
  for (std::size_t at = page.find("<tr>"); at != std::string::npos; at = page.find("<tr>", at)) {
    const std::size_t end = page.find("</tr>", at);
    std::string row = page.substr(at + 4, end - at - 4);
    for (const char* kind : {"td", "th"}) {
      const std::string opens = std::string("<") + kind + ">";
      const std::string closes = std::string("</") + kind + ">";
      for (std::size_t i; (i = row.find(opens)) != std::string::npos;) row.erase(i, opens.size());
      for (std::size_t i; (i = row.find(closes)) != std::string::npos;) {
        row.replace(i, closes.size(), "|");
      }
    }
    rows += row + "\n";
    at = end;
  }
  return rows;
}

/// Of a job whose tasks tell all that they can.
ReportedWork told_work() {
  ReportedWork work;
  wire::JobStatus& status = work.status;
  status.set_job("job-7");
  status.set_state("done");
  status.set_seconds(72.25);
  status.set_peak_rss_bytes_worker(30'000'000);
  status.set_attempts_lost(4);
  (*status.mutable_texts())["digest"] = "d1g";
  const auto add = [&work](const char* kind, std::uint64_t path, double scale) {
    wire::TaskLine task = mesh_task(path, 10'000 * scale);
    task.set_kind(kind);
    task.set_expected_seconds(2 * scale);
    task.set_cpu_seconds(3 * scale);
    task.set_seconds(4 * scale);
    task.set_expected_bytes(5e6 * scale);
    task.set_peak_rss_bytes(static_cast<std::uint64_t>(6e6 * scale));
    work.tasks.push_back(task);
  };
  add("mesh", 3, 2);
  add("unheard_of", 0, 1);
  add("mesh", 2, 1);
  add("inspect", 0, 1);
  work.tasks[2].set_losses(1);
  wire::TaskLine unfinished = mesh_task(7, 1);
  unfinished.set_state("leased");
  work.tasks.push_back(unfinished);
  work.attempts = {attempt("done", 1000, 3000), attempt("crashed", 3000, 3500),
                   attempt("running", 3500, 0)};
  return work;
}

TEST(ReportPage, of_work_has_the_figures_of_the_job_of_each_kind_and_of_each_task) {
  EXPECT_EQ(rows_of(work_section(told_work())),
            "job|job-7 (done)|\n"
            "from submission to end|72.2 s|\n"
            "attempts|3|\n"
            "busy with attempts|2.5 s, all workers together|\n"
            "memory of the largest task|30.0 MB|\n"
            "attempts lost|4|\n"
            "digest of the mesh|d1g|\n"
            "kind|tasks|expected s|CPU s|s|bound MB|peak MB|estimated tets|tets made|\n"
            "inspect|1|2.00|3.00|4.00|5.0|6.0|||\n"
            "mesh|2|6.00|9.00|12.00|10.0|12.0|30 k|30 k|\n"
            "other|1|2.00|3.00|4.00|5.0|6.0|||\n"
            "task|expected s|CPU s|s|bound MB|peak MB|estimated tets|tets made|failed attempts|\n"
            "inspect |2.000|3.000|4.000|5.0|6.0||||\n"
            "mesh L|2.000|3.000|4.000|5.0|6.0|10000|10001|1|\n"
            "mesh R|4.000|6.000|8.000|10.0|12.0|20000|20001||\n"
            "unheard_of |2.000|3.000|4.000|5.0|6.0||||\n");
}

TEST(ReportPage, of_work_shows_every_attempt_that_ended_and_every_task_that_is_done) {
  const std::string section = work_section(told_work());
  EXPECT_THAT(section, HasSubstr("<title>mesh L, 2.000 s</title>"));
  EXPECT_THAT(section, HasSubstr("<title>mesh L crashed, 0.500 s</title>"));
  EXPECT_THAT(section, Not(HasSubstr("mesh L running")));
  EXPECT_THAT(section, HasSubstr("Each task (4 of 4)"));
  EXPECT_THAT(section, HasSubstr("<title>mesh R: 4 expected, 6</title>"));
  EXPECT_THAT(section, HasSubstr("<title>mesh R: 10 expected, 12</title>"));
  EXPECT_THAT(section, HasSubstr("Time of each task, s"));
  EXPECT_THAT(section, HasSubstr("Memory of each task, MB"));
  EXPECT_THAT(section, HasSubstr("</span>mesh<span"));
  EXPECT_THAT(section, Not(HasSubstr("</span>inspect"))) << "no attempt of it";
}

TEST(ReportPage, of_work_in_which_nothing_failed_has_no_sign_for_failures) {
  ReportedWork work = told_work();
  work.attempts = {attempt("done", 1000, 3000), attempt("running", 3500, 0)};
  EXPECT_THAT(work_section(work), Not(HasSubstr("failed or lost")));
  work.attempts.clear();
  EXPECT_THAT(work_section(work), Not(HasSubstr("What each worker did")));
}

TEST(ReportPage, of_very_many_tasks_names_two_thousand) {
  ReportedWork work;
  work.tasks.assign(2001, mesh_task(2, 1));
  EXPECT_THAT(work_section(work), HasSubstr("Each task (2000 of 2001)"));
}

MeshFigures told_figures() {
  MeshFigures figures = some_figures();
  figures.tets = 1'000'002;
  figures.boundary_triangles = 1'234;
  figures.volume = 0.125;
  for (TetFigures* side : {&figures.all, &figures.near_cuts, &figures.away_from_cuts}) {
    side->shapes = {};
  }
  const auto set = [](TetFigures& side, std::int64_t tets, double angle, double height) {
    side.shapes.tets = tets;
    side.shapes.min_dihedral_deg = angle;
    side.shapes.max_dihedral_deg = 180 - angle;
    side.shapes.sum_radius_ratio = 0.5 * static_cast<double>(tets);
    side.shapes.smallest_height = height;
  };
  set(figures.all, 1'000'002, 10, 0.125);
  set(figures.near_cuts, 2, 10, 0.125);
  set(figures.away_from_cuts, 1'000'000, 20, 0.25);
  figures.all.lowest_at = {1, 2.5, -3};
  return figures;
}

TEST(ReportPage, of_a_mesh_has_its_figures_both_sides_of_the_cuts_and_the_worst_tets) {
  ReportContent content;
  content.figures = told_figures();
  EXPECT_EQ(rows_of(mesh_sections(content)),
            "tetrahedra|1 000 002|\n"
            "nodes|1 234 567|\n"
            "boundary triangles|1 234|\n"
            "sub-domains|2|\n"
            "volume|0.125|\n"
            "dihedral angles|10.00° to 170.00°|\n"
            "mean radius ratio|0.5000|\n"
            "smallest height|0.125|\n"
            "|near|away|all|\n"
            "tetrahedra|2|1 000 000|1 000 002|\n"
            "smallest dihedral angle|10.00°|20.00°|10.00°|\n"
            "largest dihedral angle|170.00°|160.00°|170.00°|\n"
            "mean radius ratio|0.5000|0.5000|0.5000|\n"
            "smallest height = time step × wave speed|0.125|0.25|0.125|\n"
            "smallest angle|largest|radius ratio|height|sub-domain|near a cut|centre at|number|\n"
            "12.345°|150.000°|0.5000|0.01|1|yes|1.5, 2.5, 3.5|17|\n");
}

TEST(ReportPage, of_a_mesh_tells_the_time_step_and_the_balance) {
  ReportContent content;
  content.figures = told_figures();
  content.figures.subdomains[0].cells = 250'002;
  content.figures.subdomains[1].cells = 750'000;
  const std::string page = mesh_sections(content);
  EXPECT_THAT(page, HasSubstr("<b>0.125</b> / c here, at (1, 2.5, -3). That is 2.00 times the "
                              "number of steps that the mesh away from the cuts alone would "
                              "need.</p>"));
  EXPECT_THAT(page, HasSubstr("The worst 1 tetrahedra"));
  EXPECT_THAT(page, HasSubstr("The largest sub-domain has 1.500 times the mean"));
  content.figures.subdomains.pop_back();
  EXPECT_THAT(mesh_sections(content), Not(HasSubstr("Balance"))) << "of a single sub-domain";
  content.figures.knows_subdomains = false;
  EXPECT_THAT(rows_of(mesh_sections(content)), Not(HasSubstr("sub-domains")));
}

TEST(ReportPage, of_a_mesh_with_other_cells_counts_them_too) {
  ReportContent content;
  content.figures.others[ElementType::hex] = {12, 1.5, 0.75, 10.5};
  content.figures.others[ElementType::prism] = {3'000, 1.5, 0.5, 1500};
  content.figures.boundary_quads = 24;
  content.figures.knows_subdomains = false;
  EXPECT_EQ(rows_of(mesh_sections(content)),
            "tetrahedra|0|\nhexes|12|\nprisms|3 000|\nnodes|0|\nboundary triangles|0|\nvolume|0|\n"
            "scaled Jacobian of prisms|0.5000 mean, 0.5000 smallest|\n"
            "scaled Jacobian of hexes|0.8750 mean, 0.7500 smallest|\nboundary quads|24|\n");
}

TEST(ReportPage, shows_edges_over_the_spacing_where_that_is_known) {
  ReportContent content;
  content.figures = told_figures();
  EdgeFigures& edges = content.figures.edges;
  edges.edges = 4;
  edges.shortest = 0.5;
  edges.longest = 3;
  edges.sum = 5;
  edges.over_spacing.counts[5] = 1;
  edges.over_spacing.counts[24] = 3;
  const std::string page = mesh_sections(content);
  EXPECT_THAT(page,
              HasSubstr("0.500 to 3.000, mean 1.250; the last bin holds all that are longer"));
  EXPECT_THAT(page, HasSubstr("<title>0.5: 25 </title>"));
  EXPECT_THAT(page, HasSubstr("<title>2.4: 75 </title>"));
  EXPECT_THAT(page, Not(HasSubstr("is not available")));
}

TEST(ReportPage, shows_volumes_by_powers_of_two_also_those_between) {
  ReportContent content;
  content.figures = told_figures();
  content.figures.volumes = {{-3, 1}, {-1, 3}};
  const std::string page = mesh_sections(content);
  EXPECT_THAT(page, HasSubstr("<title>1.2e-01: 25 </title>"));
  EXPECT_THAT(page, HasSubstr("<title>5.0e-01: 75 </title>"));
  EXPECT_THAT(page, HasSubstr(">2.5e-01<"));
  EXPECT_THAT(page, HasSubstr(">Volume, % of tets<"));
  EXPECT_THAT(page, HasSubstr(">Volume, % of tets, log<"));
}

TEST(ReportPage, has_leaves_in_the_order_of_the_tree_at_whatever_depth) {
  ReportedWork work;
  work.tasks = {mesh_task(3, 30), mesh_task(5, 50), mesh_task(4, 40)};
  EXPECT_THAT(estimated_elements_of_leaves(work), ElementsAre(40, 50, 30));
  EXPECT_THAT(report_page(whole_report()), HasSubstr("<title>0: 1 made</title>"));
}

}  // namespace
}  // namespace tetfarm
