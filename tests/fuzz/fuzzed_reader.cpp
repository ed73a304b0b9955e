#include "tests/fuzz/fuzzed_reader.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/storage/input_error.hpp"
#include "app/storage/text_file.hpp"

namespace {

using tubeplan::app::FuzzedReader, tubeplan::app::fuzzedReaders;

const FuzzedReader& chosenReader() {
  const char* name = std::getenv("TUBEPLAN_READER");
  for (const FuzzedReader& reader : fuzzedReaders())
    if (name && std::string(name) == reader.name) return reader;
  std::fprintf(stderr, "TUBEPLAN_READER must be one of:");
  for (const FuzzedReader& reader : fuzzedReaders()) std::fprintf(stderr, " %s", reader.name);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const FuzzedReader& reader = chosenReader();
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    if (reader.is_text) tubeplan::app::checkText("input", text);
    reader.read(text);
  } catch (const tubeplan::app::InputError&) {
  } catch (const nlohmann::json::exception&) {
  }
  return 0;
}
