/// The dashboard: the pages and the API of docs/dashboard.md over HTTP, answered from a farm that
/// is asked by one client however many watch. Serves in threads of its own until it is destroyed.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "dashboard/farm_source.h"

namespace tetfarm {

struct DashboardOptions {
  std::string address = "127.0.0.1:8470";  ///< port 0: any that is free
  std::filesystem::path token_file;        ///< "": no token; only loopback addresses then
  bool acts = false;                       ///< jobs can be cancelled, and so on
};

class Dashboard {
 public:
  /// @throws UsageError when the address is malformed or not free, when other hosts can reach it
  /// and there is no token, or when the token is short or others may read it; IoError.
  Dashboard(const DashboardOptions& options, std::unique_ptr<FarmSource> source);
  ~Dashboard();
  Dashboard(const Dashboard&) = delete;
  Dashboard& operator=(const Dashboard&) = delete;

  /// "http://127.0.0.1:8470/", as bound.
  std::string url() const;

 private:
  class Site;
  std::unique_ptr<Site> site_;
};

}  // namespace tetfarm
