/// What a job may be called: its name appears in logs, on terminals and in the names of its files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tetfarm {

inline constexpr std::size_t longest_job_name = 255;  ///< bytes

/// "" for a good name: 1 to 255 bytes of UTF-8 without `/` and control characters, not `.` or `..`.
/// Otherwise what is to be said of it, such as "must not contain `/`".
std::string problem_with_job_name(std::string_view name);

/// The name of a file of the job: its name and the ending, the name as far as file systems have
/// room for both. @pre the ending has less than 255 bytes.
std::string file_name_of_job(std::string_view name, std::string_view ending);

}  // namespace tetfarm
