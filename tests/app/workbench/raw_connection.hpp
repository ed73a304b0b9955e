// Raw bytes over a socket, including bytes that no client library sends.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <string>

namespace tubeplan::app {

/// Returns a socket connected to `port` on loopback; -1 if the connection fails.
inline int connectedTo(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const timeval patience{60, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) return socket;
  ::close(socket);
  return -1;
}

/// Returns the server's answer to these bytes until the connection is closed; empty if there is no answer.
inline std::string saidTo(int port, const std::string& bytes) {
  const int socket = connectedTo(port);
  std::string answer;
  if (socket < 0) return answer;
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t now = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (now <= 0) break;
    sent += static_cast<std::size_t>(now);
  }
  ::shutdown(socket, SHUT_WR);
  char block[4096];
  for (ssize_t got; (got = ::recv(socket, block, sizeof block, 0)) > 0;)
    answer.append(block, static_cast<std::size_t>(got));
  ::close(socket);
  return answer;
}

}  // namespace tubeplan::app
