// One browser's connection, with bounds on what it may send and how long it may take.
#pragma once

#include <httplib.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>

namespace tubeplan::app {

struct ConnectionLimits {
  std::size_t most_bytes = 9u << 20;              ///< of one request, headers included
  std::chrono::milliseconds request_time{20000};  ///< to send one request in
  std::chrono::milliseconds idle_time{5000};      ///< between two bytes, and between two requests
  int most_requests = 1000;                       ///< on one connection
};

/// The stream that the library reads requests from and writes answers to. What goes beyond the limits ends it.
class Connection : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;

  /// `is_closing` says whether the server is about to end.
  Connection(int socket, const ConnectionLimits& limits, std::function<bool()> is_closing);

  /// Waits for the next request; false where none comes.
  [[nodiscard]] bool waitForRequest();

  [[nodiscard]] bool is_readable() const override;
  [[nodiscard]] bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string&, int&) const override {}  // no rule and no record asks for addresses
  void get_local_ip_and_port(std::string&, int&) const override {}
  [[nodiscard]] int socket() const override { return socket_; }

  /// Says good-bye: what the peer still sends is read for a moment, so that it sees the answer, and the socket closed.
  void close();

 private:
  [[nodiscard]] bool waitFor(short event, Clock::time_point until) const;
  [[nodiscard]] bool fill();

  int socket_;
  ConnectionLimits limits_;
  std::function<bool()> is_closing_;
  std::array<char, 16384> buffer_;
  std::size_t begin_ = 0, end_ = 0, bytes_ = 0;
  Clock::time_point deadline_;
};

}  // namespace tubeplan::app
