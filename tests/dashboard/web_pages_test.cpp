#include "dashboard/web_pages.h"

#include <gmock/gmock.h>

#include <array>

namespace tetfarm {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::array<WebFile, 3> bundle = {
    {{"app.js", "script"}, {"fonts/text.woff2", "font"}, {"index.html", "page"}}};

/// "none": there is no such file.
std::string_view shown(std::string_view target, std::span<const WebFile> files) {
  const std::optional<WebFile> page = web_page(target, files);
  return page ? page->bytes : "none";
}

TEST(WebPages, are_the_files_of_the_bundle_by_their_names) {
  EXPECT_EQ(shown("/app.js", bundle), "script");
  EXPECT_EQ(shown("/app.js?v=2", bundle), "script");
  EXPECT_EQ(shown("/fonts/text.woff2", bundle), "font");
  EXPECT_EQ(shown("/other.js", bundle), "none");
}

TEST(WebPages, are_the_index_at_every_place_within_the_page) {
  for (const char* target : {"/", "/?x=1", "/jobs/job-7", "/workers", "/jobs/job-7?view=tree.1"}) {
    EXPECT_EQ(shown(target, bundle), "page") << target;
  }
}

TEST(WebPages, lead_to_no_other_file) {
  for (const char* target : {"/../app.js", "/x/app.js", "/..%2fapp.js", "//app.js", "/.env"}) {
    EXPECT_EQ(shown(target, bundle), "none") << target;
  }
}

TEST(WebPages, without_a_bundle_say_so_and_where_the_answers_are) {
  const WebFile page = web_page("/jobs/job-7", {}).value();
  EXPECT_THAT(std::string(page.bytes), HasSubstr("built without its dashboard"));
  EXPECT_THAT(std::string(page.bytes), HasSubstr("/api/v1"));
  EXPECT_THAT(std::string(page.bytes), Not(HasSubstr("<script")));
  EXPECT_EQ(content_type_of(page.name), "text/html; charset=utf-8");
  EXPECT_EQ(shown("/app.js", {}), "none");
}

TEST(WebPages, have_types_by_their_endings) {
  EXPECT_EQ(content_type_of("app.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(content_type_of("favicon.svg"), "image/svg+xml");
  EXPECT_EQ(content_type_of("strange.bin"), "application/octet-stream");
}

}  // namespace
}  // namespace tetfarm
