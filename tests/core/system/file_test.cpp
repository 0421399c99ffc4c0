#include "core/system/file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "tests/support/odd_files.h"

namespace underact::system {
namespace {

namespace fs = std::filesystem;

std::string textAt(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

int put(const std::string& part, const std::string& path, std::string_view text) {
  return putInPlace(makeFile(part, Making::New, Readers::Default), part, path, text, Lasting::OnDisk);
}

TEST(PutInPlace, TakesThePlaceOfWhatWasThereOrLeavesItAndNoPart) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("file", "old"), part = folder.file("part");
  EXPECT_EQ(put(part, path, "new"), 0);
  EXPECT_EQ(textAt(path), "new");
  EXPECT_FALSE(fs::exists(part));
  EXPECT_EQ(put(part, folder.file("no folder/file"), "new"), ENOENT);
  EXPECT_FALSE(fs::exists(part));
  const std::string taken = folder.write("taken", "mine");
  EXPECT_EQ(put(taken, path, "newer"), EEXIST);
  EXPECT_EQ(textAt(path), "new");
  EXPECT_EQ(textAt(taken), "mine");
}

TEST(RenameIfFree, TakesNoName) {
  const test::ScratchFolder folder;
  const std::string from = folder.write("from", "mine"), taken = folder.write("taken", "theirs");
  EXPECT_EQ(renameIfFree(from, taken), EEXIST);
  EXPECT_EQ(textAt(taken), "theirs");
  EXPECT_EQ(renameIfFree(from, folder.file("free")), 0);
  EXPECT_EQ(textAt(folder.file("free")), "mine");
  EXPECT_FALSE(fs::exists(from));
}

TEST(Lock, IsSharedOrSomebodysAlone) {
  const test::ScratchFolder folder;
  const std::string path = folder.write("file", "");
  const Descriptor other = openToRead(path);
  {
    const Descriptor one = openToRead(path);
    EXPECT_TRUE(lock(one.number(), Lock::Shared));
    EXPECT_TRUE(lock(other.number(), Lock::Shared));
    EXPECT_FALSE(lock(one.number(), Lock::Alone));
    unlock(other.number());
    EXPECT_TRUE(lock(one.number(), Lock::Alone));
    EXPECT_FALSE(lock(other.number(), Lock::Shared));
  }
  EXPECT_TRUE(lock(other.number(), Lock::Alone)) << "closed, and free again";
}

TEST(File, IsMadeAnewEmptiedOrWrittenFurther) {
  const test::ScratchFolder folder;
  const std::string path = folder.file("file");
  const auto write = [&](Making making, std::string_view text) {
    const Descriptor file = makeFile(path, making, Readers::Default);
    return file.isOpen() ? writeAll(file.number(), std::as_bytes(std::span(text))) : errno;
  };
  EXPECT_EQ(write(Making::New, "one"), 0);
  EXPECT_EQ(write(Making::New, "other"), EEXIST);
  EXPECT_EQ(write(Making::Further, "two"), 0);
  EXPECT_EQ(textAt(path), "onetwo");
  EXPECT_EQ(write(Making::Emptied, "3"), 0);
  EXPECT_EQ(textAt(path), "3");
}

TEST(File, IsReadFromAPlaceOnUpToItsEnd) {
  const test::ScratchFolder folder;
  const Descriptor file = openToRead(folder.write("file", "0123456789"));
  std::array<std::byte, 4> four{};
  EXPECT_EQ(readAllAt(file.number(), 8, four), 2U);
  EXPECT_EQ(four[1], std::byte{'9'});
  EXPECT_EQ(readAllAt(file.number(), 20, four), 0U);
  EXPECT_EQ(readAll(file.number(), four), 4U) << "from the beginning: the other reads do not move it";
  EXPECT_EQ(four[0], std::byte{'0'});
  EXPECT_FALSE(readAll(-1, four));
}

}  // namespace
}  // namespace underact::system
