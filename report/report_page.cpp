#include "report/report_page.h"

#include "report/html_page.h"

namespace tetfarm {

std::string report_page(const ReportContent& content) {
  std::string body = mesh_sections(content);
  if (content.work) body += work_section(*content.work);
  return html_page(content.name, body);
}

}  // namespace tetfarm
