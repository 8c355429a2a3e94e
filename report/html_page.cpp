#include "report/html_page.h"

#include "report/html_text.h"

namespace tetfarm {
namespace {

/// Wide enough for two charts beside each other, one below the other on a narrow screen.
constexpr std::string_view style = R"(
body{font:15px/1.45 "DejaVu Sans",Verdana,sans-serif;color:#222;background:#fff;max-width:1040px;margin:24px auto;padding:0 16px}
h1{font-size:26px;margin:0 0 4px}h2{font-size:19px;margin:34px 0 8px;border-bottom:1px solid #ccc;padding-bottom:4px}
h3{font-size:15px;margin:18px 0 4px}p{margin:6px 0 10px;max-width:76ch}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(420px,1fr));gap:10px}
svg{width:100%;height:auto;display:block}svg text{font-size:11px;fill:#444}svg .title{font-size:12.5px;fill:#111}
.grid{stroke:#e2e2e2}.axis{stroke:#666}.equal{stroke:#888;stroke-dasharray:5 4}
table{border-collapse:collapse;font-size:13px;margin:8px 0}th,td{padding:3px 12px 3px 0;text-align:right;white-space:nowrap}
th{border-bottom:1px solid #999;font-weight:600}td{border-bottom:1px solid #eee}th:first-child,td:first-child{text-align:left}
.scroll{overflow-x:auto}figure{margin:8px 0}figure img{width:100%;height:auto;border:1px solid #ddd}
figcaption,.note{font-size:13px;color:#555}.key{display:inline-block;width:11px;height:11px;margin:0 5px 0 12px}
summary{cursor:pointer;margin:8px 0}
)";

}  // namespace

std::string html_page(std::string_view title, std::string_view body) {
  const std::string shown = escaped(title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "img-src data:; style-src 'unsafe-inline'\">\n<title>" +
      shown + " – Tetfarm</title>\n<style>" + std::string(style) + "</style></head>\n<body>\n<h1>" +
      shown + "</h1>\n";
  page += body;
  return page + "</body></html>\n";
}

}  // namespace tetfarm
