#include "app/cli/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/cli/caller.hpp"

namespace tubeplan::app {

namespace {

int terminalWidth() {
  constexpr int kUsualWidth = 80;
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsualWidth;
}

std::string clockText(double seconds) {
  const auto rounded = static_cast<long>(std::ceil(seconds));
  return fmt::format("{}:{:02}", rounded / 60, rounded % 60);
}

}  // namespace

std::string progressLine(const std::string& label, std::size_t done, std::size_t total, double seconds, int width) {
  if (total == 0) return (label + " ...").substr(0, static_cast<std::size_t>(std::max(width, 0)));
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  const std::string remaining =
      rate > 0 ? clockText(static_cast<double>(total - std::min(done, total)) / rate) + " left" : "";
  const std::string figures = fmt::format(" {}/{}  {:.1f}/s  {}", done, total, rate, remaining);
  const int room = width - static_cast<int>(label.size() + figures.size()) - 3;
  std::string bar;
  if (room >= 5) {
    const int cells = std::min(room, 30);
    const int full = static_cast<int>(static_cast<double>(cells) * static_cast<double>(std::min(done, total)) /
                                      static_cast<double>(total));
    bar = " [" + std::string(static_cast<std::size_t>(full), '#') +
          std::string(static_cast<std::size_t>(cells - full), '-') + "]";
  }
  return (label + bar + figures).substr(0, static_cast<std::size_t>(std::max(width, 0)));
}

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      caller_(CalledBy::current()),
      is_shown_(!caller_ && ::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      drawn_(start_ - std::chrono::hours(1)) {}

Progress::~Progress() {
  if (is_shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(std::size_t done) {
  if (caller_ && caller_->hooks.progress) caller_->hooks.progress(label_, done, total_);
  const auto now = Clock::now();
  const bool is_due = now - drawn_ >= std::chrono::milliseconds(100) || (total_ > 0 && done >= total_);
  if (!is_shown_ || !is_due) return;
  drawn_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r\x1b[K{}", progressLine(label_, done, total_, seconds, terminalWidth() - 1));
  std::fflush(stderr);
}

}  // namespace tubeplan::app
