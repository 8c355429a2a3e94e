/// What the coordinator's replies hold, by name: the figures and texts of a job, and the names of
/// workers and sub-domains. For the JSON of this room and the texts of the command line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/messages.pb.h"

namespace tetfarm {

/// A figure that the job's tasks reported; 0 when they did not.
double number_of(const wire::JobStatus& status, const std::string& name);

/// The same of texts; "".
std::string text_of(const wire::JobStatus& status, const std::string& name);

/// A place by its three numbers, `what`_x, _y and _z.
std::array<double, 3> place_of(const wire::JobStatus& status, const std::string& what);

/// Figures of the region with that number, from 1, have names that begin so.
std::string region_prefix(int region);

/// What is said of sub-domains under such a mark, by their ways from the root: "uncut:", why they
/// could not be cut; "cut_further:", why they were cut though that was not planned.
std::vector<std::pair<std::string, std::string>> said_of_subdomains(const wire::JobStatus& status,
                                                                    std::string_view mark);

/// "worker-3"; "" for 0.
std::string worker_name(std::uint64_t worker);

/// A sub-domain by its way from the root, "LR"; "" for 0.
std::string subdomain_name(std::uint64_t path);

/// How long an attempt took, or runs until now.
double seconds_of(const wire::AttemptLine& attempt);

}  // namespace tetfarm
