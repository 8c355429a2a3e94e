/// What the system tests share: a small job, how to run it, and how to read its result line.
#pragma once

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/shapes.h"

namespace tetfarm::test {

inline std::string off_of(const SurfaceMesh& surface) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << surface.vertices.size() << " " << surface.triangles.size() << " 0\n";
  for (const Vec3& p : surface.vertices) text << p.x << " " << p.y << " " << p.z << "\n";
  for (const Triangle& t : surface.triangles) {
    text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
  }
  return text.str();
}

/// The space between a sphere and a box: the file's name in `folder`.
inline std::string sphere_in_box(const std::filesystem::path& folder, int box_squares,
                                 int sphere_levels) {
  const SurfaceMesh box = shapes::box({-2, -2, -2}, {2, 2, 2}, box_squares);
  const SurfaceMesh sphere = shapes::sphere({0.1, 0.05, -0.07}, 0.8, sphere_levels);
  write_contents(folder / "sphere_in_box.off", off_of(shapes::between(box, sphere)));
  return "sphere_in_box.off";
}

/// `tetfarm run` with 4 sub-domains into `output`.
inline std::vector<std::string> run_words(const std::string& input, const std::string& output,
                                          int workers, int subdomains = 4) {
  return {"run",
          input,
          "-o",
          output,
          "-j",
          std::to_string(workers),
          "--subdomains",
          std::to_string(subdomains),
          "--json",
          "--progress",
          "none",
          "--grace",
          "0"};
}

/// The last line of the output; null when it is no JSON.
inline nlohmann::json result_of(const Ended& ended) {
  std::istringstream lines(ended.out);
  std::string line;
  std::string last;
  while (std::getline(lines, line)) last = line;
  return nlohmann::json::parse(last, nullptr, false);
}

/// Where a coordinator listens, as soon as it says so on its first line; "" when it ends before.
inline std::string endpoint_of(Program& coordinator) {
  while (coordinator.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::string said = coordinator.out_so_far();
    const std::size_t end = said.find('\n');
    const std::size_t at = said.find("tcp://");
    if (end != std::string::npos) return said.substr(at, end - at);
  }
  return "";
}

inline std::string digest_of(const Ended& ended) {
  const nlohmann::json result = result_of(ended);
  return result.is_object() ? result.value("digest", "") : "";
}

}  // namespace tetfarm::test
