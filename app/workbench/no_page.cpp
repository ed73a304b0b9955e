// Empty substitutes for the generated files of the workbench page and of reports, used if the page was not built.
#include "app/report/page_sources.hpp"
#include "app/workbench/page_files.hpp"

namespace tubeplan::app {

namespace {

const std::vector<EmbeddedFile>& noFiles() {
  static const std::vector<EmbeddedFile> kNone;
  return kNone;
}

}  // namespace

const std::vector<EmbeddedFile>& embeddedPage() { return noFiles(); }

const std::vector<EmbeddedFile>& embeddedReport() { return noFiles(); }

}  // namespace tubeplan::app
