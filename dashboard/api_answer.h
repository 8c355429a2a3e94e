/// What the API answers: a status of HTTP, and JSON or bytes, which many may be given at once.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "dashboard/api_request.h"

namespace tetfarm {

/// What an answer is: text, or numbers as they lie in memory.
enum class ApiForm { json, bytes };

struct ApiAnswer {
  int status = 200;
  std::shared_ptr<const std::string> body;
  ApiForm form = ApiForm::json;
};

/// Called once with the answer, in whatever thread has it.
using ApiAnswering = std::function<void(ApiAnswer)>;

ApiAnswer answer_of(std::string body);
/// {"error":…,"help":…}
ApiAnswer answer_of(const ApiError& error);

/// {"name":[lines]}, of JSON that is on lines already.
class JsonList {
 public:
  explicit JsonList(const std::string& name) : text_("{\"" + name + "\":[") {}
  void add(const std::string& line) {
    if (text_.back() != '[') text_ += ',';
    text_ += line;
  }
  std::string take() { return std::move(text_) + "]}"; }

 private:
  std::string text_;
};

}  // namespace tetfarm
