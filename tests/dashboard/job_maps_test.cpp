#include "dashboard/job_maps.h"

#include <gmock/gmock.h>

#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_system.h"
#include "dashboard/surface_answers.h"
#include "mesh/inspect/vtp_text.h"
#include "mesh/inspect/write_defects_vtp.h"
#include "tests/base/temp_folder.h"
#include "tests/dashboard/fake_farm.h"
#include "tests/support/shapes.h"

namespace tetfarm {
namespace {

/// A failed job whose store has the files that a test adds.
class MapsOfAJob : public ::testing::Test {
 protected:
  MapsOfAJob() {
    farm_.files = folder_.path();
    farm_.add_job(1, "failed");
  }

  wire::Artifact& add(const std::string& name, const std::string& bytes) {
    const std::string hash = "hash" + std::to_string(farm_.jobs[0].files_size());
    write_file_atomically(folder_.path() / hash, bytes);
    wire::Artifact& file = *farm_.jobs[0].add_files();
    file.set_name(name);
    file.set_hash(hash);
    file.set_size(bytes.size());
    return file;
  }
  static std::string defects_vtp() {
    const TempFolder folder;
    const std::filesystem::path path = folder.path() / "defects.vtp";
    write_defects_vtp(shapes::sphere({0, 0, 0}, 1, 2),
                      {{"open edge", "one", {3}}, {"self-intersection", "two", {5, 6}}},
                      path.string());
    return read_file(path);
  }
  static std::string layers_vtp(const std::string& layers) {
    VtpTriangles text;
    text.points = 3;
    text.triangles = 1;
    text.coordinates = "0 0 0\n1 0 0\n0 1 0\n";
    text.corners = "0 1 2\n";
    text.arrays = {{"Int64", "layers", layers + "\n"}, {"Int64", "wanted", "9\n"}};
    return vtp_text(text);
  }
  nlohmann::json list() { return nlohmann::json::parse(maps_.list("job-1", farm_)).at("maps"); }
  std::string map(std::uint64_t number, std::uint32_t triangles = 1024) {
    ApiRequest request;
    request.subject = ApiSubject::map;
    request.job = "job-1";
    request.number = number;
    request.triangles = triangles;
    const ApiAnswer answer = maps_.map(request, farm_);
    EXPECT_EQ(answer.form, ApiForm::bytes);
    return *answer.body;
  }
  static std::vector<std::int32_t> numbers_on(const std::string& bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 16, sizeof count);
    if (count == 0) return {};
    std::vector<std::int32_t> numbers(count);
    std::memcpy(numbers.data(), bytes.data() + bytes.size() - 4 * count, 4 * std::size_t{count});
    return numbers;
  }
  ExitCode refusal(std::uint64_t number) {
    try {
      map(number);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::ok;
  }

  const TempFolder folder_;
  FakeFarm farm_;
  JobMaps maps_;
};

TEST_F(MapsOfAJob, are_those_of_its_files_that_mark_triangles) {
  add("wing.vtkhdf", "a mesh");
  add("wing.defects.vtp", defects_vtp());
  add("wing.layers.vtp", layers_vtp("7"));
  add("wing.vtp", "another");
  const nlohmann::json maps = list();
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0]["map"], 1);
  EXPECT_EQ(maps[0]["file"], "wing.defects.vtp");
  EXPECT_EQ(maps[0]["of"], "defects");
  EXPECT_EQ(maps[0]["meanings"], nlohmann::json({"open edge", "self-intersection"}));
  EXPECT_EQ(maps[0]["is_there"], true);
  EXPECT_EQ(maps[1]["of"], "layers");
  EXPECT_EQ(maps[1]["meanings"], nlohmann::json::array());
}

TEST_F(MapsOfAJob, give_each_triangle_its_number) {
  add("wing.defects.vtp", defects_vtp());
  add("wing.layers.vtp", layers_vtp("7"));
  EXPECT_THAT(numbers_on(map(1)), testing::ElementsAre(0, 1, 1));
  EXPECT_THAT(numbers_on(map(2)), testing::ElementsAre(7));
  EXPECT_EQ(map(1).substr(0, 8), "TFSHOWN\n");
  EXPECT_LE(numbers_on(map(1, 1)).size(), 1U) << "no more than were asked for";
}

TEST_F(MapsOfAJob, are_made_once_of_each_file) {
  add("wing.defects.vtp", defects_vtp());
  const std::string made = map(1);
  write_file_atomically(folder_.path() / "hash0", std::string(defects_vtp().size(), 'x'));
  EXPECT_EQ(map(1), made);
}

TEST_F(MapsOfAJob, that_are_not_there_or_too_large_are_told_so) {
  add("wing.defects.vtp", defects_vtp()).set_hash("gone");
  add("wing.layers.vtp", layers_vtp("7")).set_size(largest_shown_file + 1);
  EXPECT_EQ(list()[0]["is_there"], false);
  EXPECT_EQ(list()[1]["is_there"], false);
  EXPECT_EQ(refusal(1), ExitCode::not_found);
  EXPECT_EQ(refusal(2), ExitCode::out_of_resources);
  EXPECT_EQ(refusal(3), ExitCode::not_found);
  farm_.files.clear();
  EXPECT_EQ(refusal(1), ExitCode::not_found);
  EXPECT_THROW(maps_.list("job-2", farm_), Error);
}

TEST_F(MapsOfAJob, that_are_damaged_are_refused) {
  add("a.defects.vtp", "no map at all");
  add("a.layers.vtp", layers_vtp("-1"));
  add("b.layers.vtp", layers_vtp("1.5"));
  add("c.layers.vtp", defects_vtp());
  add("d.layers.vtp", layers_vtp("7").substr(0, 300));
  for (std::uint64_t number = 1; number <= 5; ++number) {
    EXPECT_THROW(map(number), Error) << number;
  }
}

}  // namespace
}  // namespace tetfarm
