// The workbench accepts or refuses an HTTP request according to its headers, the host at which it listens, and its
// token.
#include "app/workbench/access.hpp"

#include <gtest/gtest.h>

namespace tubeplan::app {
namespace {

const AccessRules kLoopback{"127.0.0.1", 8642, ""};
const AccessRules kOpen{"0.0.0.0", 8642, "correct-horse-battery"};

Visitor visitor(const std::string& method, const std::string& host) {
  Visitor visitor;
  visitor.method = method;
  visitor.path = "/api/state";
  visitor.host = host;
  return visitor;
}

TEST(AccessRulesTest, letsLoopbackNamesInAtItsOwnPortOnly) {
  for (const char* host : {"127.0.0.1:8642", "localhost:8642", "LocalHost:8642", "[::1]:8642"})
    EXPECT_EQ(refuseAccess(kLoopback, visitor("GET", host)), 0) << host;
  for (const char* host :
       {"", "127.0.0.1", "localhost:80", "127.0.0.1:86420", "evil.example:8642", "127.0.0.1.evil:8642",
        "localhost:8642:8642", "[::1]", "10.0.0.1:8642", "0.0.0.0:8642", "127.0.0.1:8642 "})
    EXPECT_EQ(refuseAccess(kLoopback, visitor("GET", host)), 403) << host;
}

TEST(AccessRulesTest, refusesWhatAnotherSitesPageSends) {
  Visitor foreign = visitor("POST", "localhost:8642");
  for (const char* origin : {"http://evil.example", "https://localhost:8642", "null", "http://localhost:8643",
                             "http://127.0.0.1:8642", "file://"}) {
    foreign.origin = origin;
    EXPECT_EQ(refuseAccess(kLoopback, foreign), 403) << origin;
  }
  foreign.origin = "http://localhost:8642";
  EXPECT_EQ(refuseAccess(kLoopback, foreign), 0);
}

TEST(AccessRulesTest, withoutOriginAsksWhereTheRequestWasMade) {
  for (const char* method : {"POST", "DELETE", "GET"}) {
    Visitor seen = visitor(method, "localhost:8642");
    EXPECT_EQ(refuseAccess(kLoopback, seen), 0);
    for (const char* site : {"cross-site", "same-site"}) {
      seen.fetch_site = site;
      EXPECT_EQ(refuseAccess(kLoopback, seen), 403) << method << site;
    }
    for (const char* site : {"same-origin", "none"}) {
      seen.fetch_site = site;
      EXPECT_EQ(refuseAccess(kLoopback, seen), 0) << method << site;
    }
  }
}

TEST(AccessRulesTest, aLinkFromAnotherSiteMayOpenThePage) {
  Visitor seen = visitor("GET", "localhost:8642");
  seen.path = "/";
  seen.fetch_site = "cross-site";
  EXPECT_EQ(refuseAccess(kLoopback, seen), 0);
}

TEST(AccessRulesTest, asksForTheToken) {
  Visitor seen = visitor("GET", "192.0.2.7:8642");
  EXPECT_EQ(refuseAccess(kOpen, seen), 401);
  for (const char* wrong : {"Bearer wrong", "Bearer ", "Bearer correct-horse-batter", "Bearer correct-horse-batteryy",
                            "bearer correct-horse-battery", "correct-horse-battery"}) {
    seen.authorization = wrong;
    EXPECT_EQ(refuseAccess(kOpen, seen), 401) << wrong;
  }
  seen.authorization = "Bearer correct-horse-battery";
  EXPECT_EQ(refuseAccess(kOpen, seen), 0);
  seen.authorization = "";
  for (const char* wrong : {"tubeplan_token=", "tubeplan_token=x", "xtubeplan_token=correct-horse-battery", ";;;="}) {
    seen.cookie = wrong;
    EXPECT_EQ(refuseAccess(kOpen, seen), 401) << wrong;
  }
  seen.cookie = "a=b; tubeplan_token=correct-horse-battery; c=d";
  EXPECT_EQ(refuseAccess(kOpen, seen), 0);
}

TEST(AccessRulesTest, aNameIsNoAddressWhereItListensEverywhere) {
  Visitor seen = visitor("GET", "rebound.example:8642");
  seen.authorization = "Bearer correct-horse-battery";
  EXPECT_EQ(refuseAccess(kOpen, seen), 403);
  seen.host = "[2001:db8::1]:8642";
  EXPECT_EQ(refuseAccess(kOpen, seen), 0);
}

TEST(AccessRulesTest, comparesWholeTexts) {
  EXPECT_TRUE(equalInConstantTime("abc", "abc"));
  for (const char* other : {"", "ab", "abcd", "abd", "bbc"}) EXPECT_FALSE(equalInConstantTime(other, "abc")) << other;
}

TEST(AccessRulesTest, knowsLoopback) {
  for (const char* host : {"localhost", "127.0.0.1", "::1", "[::1]"}) EXPECT_TRUE(isLoopback(host)) << host;
  for (const char* host : {"", "0.0.0.0", "::", "192.0.2.1", "localhost.example"})
    EXPECT_FALSE(isLoopback(host)) << host;
}

}  // namespace
}  // namespace tubeplan::app
