#include "dashboard/api_answer.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "base/check.h"
#include "json/json_line.h"

namespace tetfarm {

ApiAnswer answer_of(std::string body) {
  return {200, std::make_shared<const std::string>(std::move(body)), ApiForm::json};
}

ApiAnswer answer_of(const ApiError& error) {
  TF_CHECK(error.status >= 400 && error.status < 600);
  return {error.status,
          std::make_shared<const std::string>(
              json_line({{"error", error.error}, {"help", error.help}})),
          ApiForm::json};
}

}  // namespace tetfarm
