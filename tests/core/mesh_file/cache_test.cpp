#include "core/mesh_file/cache.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/random.h"

namespace underact::mesh_file {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

Bytes someBytes(std::size_t count, test::Seed seed) {
  test::Random random(seed);
  Bytes bytes(count);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.bits());
  return bytes;
}

bool put(const Cache& cache, const std::string& key, const Bytes& bytes) {
  const std::array<std::span<const std::byte>, 2> parts{std::span(bytes).first(bytes.size() / 3),
                                                        std::span(bytes).subspan(bytes.size() / 3)};
  return cache.put(key, parts);
}

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Cache, GivesBackWhatWasPut) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/made/on/demand");
  EXPECT_FALSE(cache.get("a"));
  for (const std::size_t count : {0U, 1U, 5'000'000U}) {
    const Bytes bytes = someBytes(count, test::Seed{count});
    ASSERT_TRUE(put(cache, "a", bytes));
    EXPECT_EQ(cache.get("a"), bytes);
  }
  EXPECT_FALSE(cache.get("b"));
  EXPECT_EQ(std::distance(fs::directory_iterator(cache.folder()), {}), 1);  // nothing is left beside it
}

TEST(Cache, ReplacesADamagedEntry) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path());
  const Bytes bytes = someBytes(300, test::Seed{1});
  ASSERT_TRUE(put(cache, "a", bytes));
  const fs::path path = fs::path(folder.path()) / "a.mesh";
  const std::string whole = contentOf(path);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 16);
    std::ofstream(path, std::ios::binary) << damaged;
    ASSERT_FALSE(cache.get("a")) << at;
    std::ofstream(path, std::ios::binary) << whole.substr(0, at);
    ASSERT_FALSE(cache.get("a")) << at;
  }
  std::ofstream(path, std::ios::binary) << whole << 'x';
  EXPECT_FALSE(cache.get("a"));
  std::ofstream(fs::path(folder.path()) / "b.mesh", std::ios::binary) << whole;  // under another's name
  EXPECT_FALSE(cache.get("b"));
  ASSERT_TRUE(put(cache, "a", bytes));
  EXPECT_EQ(cache.get("a"), bytes);
}

TEST(Cache, TheOnesUsedLongestAgoGo) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path(), 3500);
  const Bytes bytes = someBytes(1000, test::Seed{2});
  const auto age = [&](const std::string& key, int hours) {
    fs::last_write_time(fs::path(folder.path()) / (key + ".mesh"),
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const char* key : {"a", "b", "c"}) ASSERT_TRUE(put(cache, key, bytes));
  age("a", 3);
  age("b", 2);
  age("c", 1);
  EXPECT_TRUE(cache.get("a"));  // used now
  ASSERT_TRUE(put(cache, "d", bytes));
  EXPECT_TRUE(cache.get("a"));
  EXPECT_FALSE(cache.get("b"));
  EXPECT_TRUE(cache.get("c"));
  EXPECT_TRUE(cache.get("d"));
  EXPECT_FALSE(put(cache, "e", someBytes(3500, test::Seed{3})));  // larger than all of it
  EXPECT_TRUE(cache.get("d"));
}

TEST(Cache, TouchesNothingThatIsNotItsOwn) {
  const test::ScratchFolder folder;
  folder.write("letter.txt", std::string(10'000, 'x'));
  folder.write("old.part", "left by a program that was killed");
  folder.write("new.part", "being written");
  fs::last_write_time(folder.path() + "/old.part", fs::file_time_type::clock::now() - std::chrono::hours(2));
  const Cache cache(folder.path(), 2000);
  ASSERT_TRUE(put(cache, "a", someBytes(100, test::Seed{4})));
  EXPECT_TRUE(fs::exists(folder.path() + "/letter.txt"));
  EXPECT_TRUE(fs::exists(folder.path() + "/new.part"));
  EXPECT_FALSE(fs::exists(folder.path() + "/old.part"));
}

TEST(Cache, AFolderThatMayNotBeIsNoError) {
  const test::ScratchFolder folder;
  const std::string file = folder.write("file", "no folder");
  for (const std::string& place : {file + "/below", std::string("/proc/nowhere"), std::string("/dev/null")}) {
    const Cache cache(place);
    EXPECT_FALSE(put(cache, "a", someBytes(10, test::Seed{5}))) << place;
    EXPECT_FALSE(cache.get("a")) << place;
  }
}

TEST(Cache, KeysAreNoPaths) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  for (const char* key : {"", "../a", "a/b", "a.b", "A"})
    EXPECT_FALSE(put(cache, key, someBytes(10, test::Seed{6}))) << key;
}

TEST(Cache, IsWhereTheSystemWantsCaches) {
  const auto with = [](const char* own, const char* xdg, const char* home) {
    const auto keep = [](const char* name, const char* value) {
      value == nullptr ? ::unsetenv(name) : ::setenv(name, value, 1);
    };
    const char* old_home = std::getenv("HOME");
    const std::string old = old_home == nullptr ? "" : old_home;
    keep("UNDERACT_CACHE_DIR", own);
    keep("XDG_CACHE_HOME", xdg);
    keep("HOME", home);
    const std::string folder = Cache().folder();
    keep("UNDERACT_CACHE_DIR", nullptr);
    keep("XDG_CACHE_HOME", nullptr);
    keep("HOME", old.c_str());
    return folder;
  };
  EXPECT_EQ(with("/own", "/xdg", "/home/x"), "/own");
  EXPECT_EQ(with(nullptr, "/xdg", "/home/x"), "/xdg/underact/meshes");
  EXPECT_EQ(with(nullptr, "relative", "/home/x"), "/home/x/.cache/underact/meshes");
  EXPECT_EQ(with(nullptr, nullptr, nullptr), "");
}

TEST(Cache, ManyAtOnceGetWholeEntriesOrNone) {
  const test::ScratchFolder folder;
  std::array<Bytes, 4> contents;
  for (std::size_t k = 0; k < 4; ++k) contents[k] = someBytes(50'000 + k, test::Seed{k});
  std::atomic<int> wrong = 0, right = 0;
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      const Cache cache(folder.path(), 120'000);  // so that there is always one to go
      test::Random random(test::Seed{thread});
      for (int round = 0; round < 100; ++round) {
        const std::size_t k = random.below(4);
        const std::string key(1, static_cast<char>('a' + k));
        if (random.below(2) == 0) {
          put(cache, key, contents[k]);
        } else if (const auto bytes = cache.get(key)) {
          ++(*bytes == contents[k] ? right : wrong);
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(right, 0);
}

}  // namespace
}  // namespace underact::mesh_file
