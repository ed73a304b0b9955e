#include "app/workbench/connection.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace tubeplan::app {

namespace {

constexpr auto kGlanceAtEnd = std::chrono::milliseconds(100);  // interval at which a wait checks for shutdown
constexpr auto kGoodbye = std::chrono::milliseconds(500);
constexpr std::size_t kMostDrained = 32u << 20;

}  // namespace

Connection::Connection(int socket, const ConnectionLimits& limits, std::function<bool()> is_closing)
    : socket_(socket), limits_(limits), is_closing_(std::move(is_closing)) {}

bool Connection::waitFor(short event, Clock::time_point until) const {
  while (!is_closing_()) {
    const auto remaining = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    if (remaining.count() <= 0) return false;
    pollfd watched{socket_, event, 0};
    const int found = ::poll(&watched, 1, static_cast<int>(std::min(remaining, kGlanceAtEnd).count()));
    if (found > 0) return true;
    if (found < 0 && errno != EINTR) return false;
  }
  return false;
}

bool Connection::waitForRequest() {
  bytes_ = end_ - begin_;
  deadline_ = Clock::now() + limits_.request_time;
  if (begin_ < end_) return true;
  if (!waitFor(POLLIN, Clock::now() + limits_.idle_time)) return false;
  deadline_ = Clock::now() + limits_.request_time;
  return fill();
}

bool Connection::fill() {
  const ssize_t received = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
  if (received <= 0) return false;
  begin_ = 0;
  end_ = static_cast<std::size_t>(received);
  bytes_ += end_;
  return bytes_ <= limits_.most_bytes;
}

bool Connection::is_readable() const { return begin_ < end_ || waitFor(POLLIN, Clock::now() + limits_.idle_time); }

bool Connection::is_writable() const {
  char byte = 0;
  const ssize_t seen = ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  const bool is_gone = seen == 0 || (seen < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
  return !is_gone && waitFor(POLLOUT, Clock::now() + limits_.idle_time);
}

ssize_t Connection::read(char* to, std::size_t size) {
  if (begin_ == end_) {
    const auto until = std::min(deadline_, Clock::now() + limits_.idle_time);
    if (!waitFor(POLLIN, until) || !fill()) return -1;
  }
  const std::size_t taken = std::min(size, end_ - begin_);
  std::memcpy(to, buffer_.data() + begin_, taken);
  begin_ += taken;
  return static_cast<ssize_t>(taken);
}

ssize_t Connection::write(const char* from, std::size_t size) {
  if (!waitFor(POLLOUT, Clock::now() + limits_.idle_time)) return -1;
  return ::send(socket_, from, size, MSG_NOSIGNAL);
}

void Connection::close() {
  ::shutdown(socket_, SHUT_WR);
  const auto until = Clock::now() + kGoodbye;
  for (std::size_t drained = 0; drained < kMostDrained && waitFor(POLLIN, until);) {
    const ssize_t received = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (received <= 0) break;
    drained += static_cast<std::size_t>(received);
  }
  ::close(socket_);
}

}  // namespace tubeplan::app
