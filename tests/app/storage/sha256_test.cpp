// Digests equal the examples of FIPS 180-4, and texts of different lengths, some just filling a block, have different
// digests.
#include "app/storage/sha256.hpp"

#include <gtest/gtest.h>
#include <openssl/crypto.h>

#include <cstdlib>
#include <new>
#include <set>

namespace tubeplan::app {
namespace {

bool has_memory = true;
void* allocated(std::size_t size, const char*, int) { return has_memory ? std::malloc(size) : nullptr; }
void* reallocated(void* old, std::size_t size, const char*, int) {
  return has_memory ? std::realloc(old, size) : nullptr;
}
void freed(void* memory, const char*, int) { std::free(memory); }

/// True if OpenSSL has accepted the memory functions, which it does only before its first use.
const bool kIsTaken = CRYPTO_set_mem_functions(allocated, reallocated, freed) == 1;

TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256Of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256Of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256Of(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, EveryLengthAboutABlockHasItsOwn) {
  std::set<std::string> all;
  for (std::size_t length = 50; length < 140; ++length) all.insert(sha256Of(std::string(length, 'x')));
  EXPECT_EQ(all.size(), 90u);
}

TEST(Sha256, WithoutMemoryIsOutOfMemory) {
  ASSERT_TRUE(kIsTaken);
  has_memory = false;
  EXPECT_THROW((void)sha256Of("abc"), std::bad_alloc);
  has_memory = true;
  EXPECT_EQ(sha256Of("abc").substr(0, 8), "ba7816bf");
}

}  // namespace
}  // namespace tubeplan::app
