#include <google/protobuf/stubs/common.h>
#include <hdf5.h>
#include <spdlog/version.h>
#include <sqlite3.h>
#include <zlib.h>
#include <zmq.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "base/program_identity.h"
#include "base/program_version.h"
#include "cli/commands.h"
#include "json/json_line.h"

namespace tetfarm {
namespace {

template <class Number>
std::string three_numbers(Number major, Number minor, Number patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string zeromq_version() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  ::zmq_version(&major, &minor, &patch);
  return three_numbers(major, minor, patch);
}

std::string hdf5_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned patch = 0;
  return ::H5get_libversion(&major, &minor, &patch) < 0 ? "" : three_numbers(major, minor, patch);
}

/// "GCC 12.2.0"
std::string compiler() {
#if defined(__clang__)
  return std::string("Clang ") + __clang_version__;
#elif defined(__GNUC__)
  return std::string("GCC ") + __VERSION__;
#else
  return "";
#endif
}

/// Those that are in use, where they tell it, else those that the program was compiled with.
std::vector<std::pair<std::string, std::string>> libraries() {
  return {{"ZeroMQ", zeromq_version()},
          {"Protocol Buffers", google::protobuf::internal::VersionString(GOOGLE_PROTOBUF_VERSION)},
          {"SQLite", ::sqlite3_libversion()},
          {"HDF5", hdf5_version()},
          {"zlib", ::zlibVersion()},
          {"spdlog", three_numbers(SPDLOG_VER_MAJOR, SPDLOG_VER_MINOR, SPDLOG_VER_PATCH)}};
}

void print_version_json() {
  nlohmann::ordered_json versions = nlohmann::ordered_json::object();
  for (const auto& [name, version] : libraries()) versions[name] = version;
  nlohmann::ordered_json json = {{"type", "version"},
                                 {"name", "tetfarm"},
                                 {"version", program_version},
                                 {"commit", nullptr},
                                 {"program", program_identity()},
                                 {"compiler", compiler()},
                                 {"libraries", versions}};
  if (*program_commit != '\0') json["commit"] = program_commit;
  std::printf("%s\n", json_line(json).c_str());
}

}  // namespace

ExitCode version_command(const VersionCommand& command) {
  if (command.json) {
    print_version_json();
    return ExitCode::ok;
  }
  std::printf("tetfarm %s\n", program_version);
  if (*program_commit != '\0') std::printf("commit     %s\n", program_commit);
  std::printf("program    %s\ncompiler   %s\n", program_identity().c_str(), compiler().c_str());
  std::string text;
  for (const auto& [name, version] : libraries()) {
    text += (text.empty() ? "" : ", ") + name + " " + version;
  }
  std::printf("libraries  %s\n", text.c_str());
  return ExitCode::ok;
}

}  // namespace tetfarm
