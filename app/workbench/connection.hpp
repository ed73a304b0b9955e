// Connection of one browser, with bounds on the size and duration of its requests.
#pragma once

#include <httplib.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>

namespace tubeplan::app {

struct ConnectionLimits {
  std::size_t most_bytes = 9u << 20;              ///< maximum size of one request, headers included
  std::chrono::milliseconds request_time{20000};  ///< maximum time to send one request
  std::chrono::milliseconds idle_time{5000};      ///< maximum time between two bytes, and between two requests
  int most_requests = 1000;                       ///< maximum number of requests on one connection
};

/// Stream from which the HTTP library reads requests and to which it writes answers. A connection that exceeds a limit
/// is closed.
class Connection : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;

  /// Takes over an open socket. `is_closing` returns true once the server is shutting down.
  Connection(int socket, const ConnectionLimits& limits, std::function<bool()> is_closing);

  /// Waits for the next request. Returns false on a timeout or if the server is shutting down.
  [[nodiscard]] bool waitForRequest();

  [[nodiscard]] bool is_readable() const override;
  [[nodiscard]] bool is_writable() const override;
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  // Not provided, because no rule or log uses addresses.
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  [[nodiscard]] int socket() const override { return socket_; }

  /// Briefly reads the remaining input of the peer, then closes the socket. Unread input would reset the connection
  /// before the peer has received the answer.
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
