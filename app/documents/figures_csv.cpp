#include <fmt/format.h>

#include "app/documents/figure_list.hpp"
#include "tubesheets/csv_table.hpp"

namespace tubeplan::app {

std::string figuresCsv(const nlohmann::json& document) {
  constexpr int kDigits = 12;
  using tubesheets::csvField;
  std::string text = "key,description,value,unit,note\n";
  for (const Figure& figure : figuresOf(document))
    text += fmt::format("{},{},{},{},{}\n", csvField(figure.key()), csvField(figure.description),
                        csvField(cellText(figure.value, kDigits)), csvField(figure.unit), csvField(figure.note));
  return text;
}

}  // namespace tubeplan::app
