// `tubeplan report`: writes a workbench project as a page, with all files needed to reproduce its results.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/browser.hpp"
#include "app/cli/caller.hpp"
#include "app/cli/command.hpp"
#include "app/commands/option_groups.hpp"
#include "app/documents/figures.hpp"
#include "app/documents/printed_page.hpp"
#include "app/report/diagnosis_report.hpp"
#include "app/storage/atomic_file.hpp"
#include "app/workbench/project.hpp"
#include "app/workbench/project_report.hpp"

namespace tubeplan::app {

namespace {

struct ReportOptions {
  std::string project, out, pdf, files;
  FiguresTarget figures;
  bool open = false;
};

std::filesystem::path pathWithEnding(const std::string& project, const char* ending) {
  return std::filesystem::path(project).replace_extension(ending);
}

void writeProjectFiles(const Session& session, const std::string& folder) {
  OutputFolder out(folder, "--files");
  for (const auto& file : projectFiles(session, folder)) out.write(file.path.filename().string(), file.text);
  out.commit();
}

int run(const ReportOptions& options) {
  const std::string out = options.out.empty() ? pathWithEnding(options.project, ".html").string() : options.out;
  checkFigures(options.figures);
  checkWritableFile(out, "--out");
  if (!options.pdf.empty()) {
    checkWritableFile(options.pdf, "--pdf");
    requirePrinter();
  }
  const Session session = readProject(options.project);
  ProjectReportRequest request;
  request.project = options.project;
  request.files = options.files.empty() ? pathWithEnding(options.project, ".files").string() : options.files;
  request.made = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
  const nlohmann::json report = projectReportJson(session, request);
  if (!options.files.empty()) writeProjectFiles(session, options.files);
  writeFileAtomically(out, renderProjectReport(report), "--out");
  if (!options.pdf.empty()) printPage(out, options.pdf);
  if (options.open) openInBrowser(std::filesystem::absolute(out).string());
  writeFigures(options.figures, report);
  if (!printsText(options.figures)) return kDone;
  output("wrote {}\n", out);
  for (const auto& more : {options.pdf, options.files})
    if (!more.empty()) output("wrote {}\n", more);
  return kDone;
}

}  // namespace

Run configureReport(CLI::App& cli) {
  const auto options = std::make_shared<ReportOptions>();
  cli.add_option("PROJECT", options->project, "a project that the workbench has saved")->required();
  cli.add_option("--out", options->out, "write the report to this file (the project's name, .html)");
  cli.add_flag("--open", options->open, "open the report in a browser");
  cli.add_option("--pdf", options->pdf, "also print it to this file, by headless Chromium");
  cli.add_option("--files", options->files,
                 "write the readings in use and every model into this folder, as input of the report's command lines");
  addFigures(cli, options->figures);
  return [options] { return run(*options); };
}

}  // namespace tubeplan::app
