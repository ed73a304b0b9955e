// Stands in for the generated page where it was not built.
#include "app/workbench/page_files.hpp"

namespace tubeplan::app {

const std::vector<EmbeddedFile>& embeddedPage() {
  static const std::vector<EmbeddedFile> kNone;
  return kNone;
}

}  // namespace tubeplan::app
