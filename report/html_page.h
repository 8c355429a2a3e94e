/// The frame of a page: its head, with the style of all pages, and its title.
///
/// A page needs nothing beside itself, and nothing in it may be fetched or run.
#pragma once

#include <string>
#include <string_view>

namespace tetfarm {

/// @param title any bytes: they are escaped. @param body markup.
std::string html_page(std::string_view title, std::string_view body);

}  // namespace tetfarm
