#include "app/workbench/exchange.hpp"

#include "app/storage/input_question.hpp"

namespace tubeplan::app {

namespace {

nlohmann::json choiceJson(const InputChoice& choice) {
  nlohmann::json values = nlohmann::json::array();
  for (const auto& [value, words] : choice.values) values.push_back({{"value", value}, {"words", words}});
  return {{"name", choice.name}, {"label", choice.label}, {"values", values}};
}

}  // namespace

Answer answerOf(const nlohmann::json& json, int status) {
  Answer answer;
  answer.status = status;
  answer.body = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return answer;
}

nlohmann::json errorJson(const InputError& error) {
  nlohmann::json json = {{"where", error.where()},
                         {"found", error.found()},
                         {"expected", error.expected()},
                         {"advice", error.advice()},
                         {"message", error.what()}};
  if (const auto* question = dynamic_cast<const InputQuestion*>(&error)) json["choice"] = choiceJson(question->choice);
  return json;
}

Answer refusal(int status, const InputError& error) { return answerOf({{"error", errorJson(error)}}, status); }

Answer downloadOf(const std::string& name, const std::string& content_type, std::string content) {
  Answer answer;
  answer.content_type = content_type;
  answer.body = std::move(content);
  answer.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
  return answer;
}

}  // namespace tubeplan::app
