#include "dashboard/dashboard.h"

#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "base/check.h"
#include "dashboard/api_answer.h"
#include "dashboard/farm_desk.h"
#include "dashboard/web_pages.h"
#include "dashboard/web_request.h"
#include "dashboard/web_server.h"
#include "http/http_access.h"
#include "http/http_listener.h"

namespace tetfarm {
namespace {

WebAnswer web_answer(const ApiAnswer& answer) {
  WebAnswer web;
  web.status = answer.status;
  web.body = answer.body;
  if (answer.form == ApiForm::bytes) web.type = "application/octet-stream";
  return web;
}

}  // namespace

class Dashboard::Site : public WebSite {
 public:
  Site(const DashboardOptions& options, std::unique_ptr<FarmSource> source)
      : rules_{read_http_token(options.token_file), options.acts},
        listener_(options.address, !rules_.token.empty()),
        server_(listener_, *this, WebLimits()),
        desk_(std::make_unique<FarmDesk>(
            std::move(source), options.acts,
            [this](std::string messages) { server_.publish(std::move(messages)); })) {
    server_.start();
  }
  /// The server asks the desk, and the desk tells the server: the one that asks ends first, the
  /// one that is told last.
  ~Site() override {
    server_.stop();
    desk_.reset();
  }
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  std::string url() const { return "http://" + listener_.address() + "/"; }

  void answer(const WebRequest& request, Answering done) override {
    if (const std::optional<ApiError> refusal = refusal_of(request, rules_)) {
      return done(web_answer(answer_of(*refusal)));
    }
    if (!is_api_path(request.target)) return done(page(request.target));
    const std::variant<ApiRequest, ApiError> parsed =
        parse_api_request(request.method, request.target);
    if (const auto* wrong = std::get_if<ApiError>(&parsed)) {
      return done(web_answer(answer_of(*wrong)));
    }
    const auto& asked = std::get<ApiRequest>(parsed);
    if (asked.subject == ApiSubject::changes) return done(watch());
    desk_->ask(asked,
               [done = std::move(done)](const ApiAnswer& given) { done(web_answer(given)); });
  }

  void note_watchers(std::size_t count) override { desk_->note_watchers(count); }

 private:
  WebAnswer watch() const {
    WebAnswer web;
    web.type = "text/event-stream; charset=utf-8";
    web.body = std::make_shared<const std::string>(": tetfarm\n\n" + desk_->first_messages());
    web.is_stream = true;
    return web;
  }

  /// Copied once: what is being sent has to be held by somebody.
  WebAnswer page(const std::string& target) {
    const std::optional<WebFile> file = web_page(target, built_in_web_files());
    if (!file) {
      return web_answer(answer_of(ApiError{404, "no such page", "the pages begin at /"}));
    }
    std::shared_ptr<const std::string>& kept = pages_[std::string(file->name)];
    if (!kept) kept = std::make_shared<const std::string>(file->bytes);
    WebAnswer web;
    web.type = content_type_of(file->name);
    web.body = kept;
    return web;
  }

  const WebRules rules_;
  const HttpListener listener_;
  std::map<std::string, std::shared_ptr<const std::string>> pages_;  ///< of the server's thread
  WebServer server_;
  std::unique_ptr<FarmDesk> desk_;
};

Dashboard::Dashboard(const DashboardOptions& options, std::unique_ptr<FarmSource> source)
    : site_(std::make_unique<Site>(options, std::move(source))) {
  TF_CHECK(site_ != nullptr);
}

Dashboard::~Dashboard() = default;

std::string Dashboard::url() const { return site_->url(); }

}  // namespace tetfarm
