#include "app/gui/model/file_kind.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>
#include <fstream>

namespace underact::gui::test {
namespace {

using namespace std::string_literals;

const std::string kStl = std::string(80, 's') + "\1\0\0\0"s + std::string(50, '\0');
const std::string kUrdf = "<?xml version='1.0'?>\n<!-- mine -->\n<robot name='r'><link name='l'/></robot>";

struct Case {
  const char* name;
  std::string content;
  FileKind kind;
};

struct ForeignCase {
  const char* name;
  std::string content;
  const char* says;
};

}  // namespace

TEST(FileKind, IsThatOfTheContentWhateverTheName) {
  const Case cases[] = {
      {"a.json", R"({"underact_scene": 1, "title": "A"})", FileKind::Scene},
      {"scene.txt", "\xEF\xBB\xBF\n{\"title\": \"{\\\"underact_lesson\\\": 1\", \"underact_scene\": 1}",
       FileKind::Scene},
      {"a.json", R"({"title": "A", "constraints": []})", FileKind::Scene},
      {"a.json", "{not yet", FileKind::Scene},
      {"lesson.txt", R"({"steps": [{"scene": {"underact_scene": 1}}], "underact_lesson": 1})", FileKind::Lesson},
      {"arm.dat", R"({"underact_arm": 1})", FileKind::Arm},
      {"robot.URDF", kUrdf, FileKind::Arm},
      {"robot.xml", kUrdf, FileKind::Arm},
      {"robot.txt", kUrdf, FileKind::Arm},
      {"session.bin", "\x89HDF\r\n\x1A\n"s + "0", FileKind::Session},
      {"damaged.H5", "no more", FileKind::Session},
      {"ball.bin", kStl, FileKind::Mesh},
      {"part.STL", kStl + "more", FileKind::Mesh},
      {"text.txt", "solid a\n facet normal 0 0 1\n", FileKind::Mesh},
      {"mesh.json", "ply\nformat ascii 1.0\n", FileKind::Mesh},
      {"mesh.txt", "OFF\n3 1 0\n", FileKind::Mesh},
      {"mesh.txt", "# made\nv 0 0 1\n", FileKind::Mesh},
      {"path", "x,y,z\n1,2,3\n", FileKind::Curve},
      {"path.csv", "1;+2.5;3e1\n", FileKind::Curve},
      {"path.txt", "# of points\n2\n0 0 0\n1 1 1\n", FileKind::Curve},
      {"wrong.csv", "1 2\n", FileKind::Curve},
      {"figures.json", R"([{"figure": "4.5", "numbers": []}])", FileKind::Figures},
      {"book.json", R"({"cells": [{"source": ["{\"underact_scene\": 1}"]}], "nbformat": 4})", FileKind::Notebook}};
  for (const Case& one : cases) {
    const Result<FileKind> kind = fileKindOf(one.content, one.content.size(), one.name);
    ASSERT_TRUE(kind) << one.name << ": " << kind.problems()[0].sentence;
    EXPECT_EQ(kind.value(), one.kind) << one.name << ": " << one.content.substr(0, 60);
  }
}

TEST(FileKind, OfAnotherFileIsASentenceThatSaysWhatItIs) {
  const ForeignCase cases[] = {
      {"part.stl", "%PDF-1.7\n", "This is a PDF document."},
      {"part.stl", "version https://git-lfs.github.com/spec/v1\n", "git lfs pull"},
      {"part.stl", "PK\3\4", "This is a ZIP archive."},
      {"a.h5", "\x1F\x8B", "This is a gzip archive."},
      {"a.tar", std::string(257, 'a') + "ustar", "This is a tar archive."},
      {"a.7z", "7z\xBC\xAF\x27\x1C", "This is a 7z archive."},
      {"a.docx", "PK\3\4" + std::string(26, '-') + "[Content_Types].xml", "This is a Microsoft Office document."},
      {"a.json", "<!DOCTYPE html>\n<html>", "This is a web page"},
      {"a.urdf", "<?xml version='1.0'?><html xmlns='x'>", "This is a web page"},
      {"a.svg", "<?xml version='1.0'?><!DOCTYPE svg><svg/>", "This is a picture (SVG)."},
      {"a.json", "\x89PNG\r\n", "This is a picture (PNG)."},
      {"a.dae", "<COLLADA>", "This is a COLLADA model."},
      {"a.mp4", "\0\0\0\x18"s + "ftypmp42", "This is a film (MP4)."},
      {"a.bin", "\x7F"s + "ELF", "This is a program."},
      {"a.sdf", "<sdf version='1.6'>", "the element \"sdf\""},
      {"robot.xacro", "<robot xmlns:xacro='x'><xacro:include/></robot>", "This is a xacro file"},
      {"hand.json", R"({"underact_hand": 1})", "the key \"underact_hand\""},
      {"package.json", R"({"name": "x"})", "This JSON is none of Underact's"},
      {"notes.txt", "The 3 of us\nmet.", "This is a text without the points of a curve"},
      {"notes.md", "# Notes\n", "This is a text. Underact opens"},
      {"part.ply", "nothing\n", "This is not a PLY file"},
      {"huge.bin", "\1\2\0\3"s, "This is binary data of an unknown format. Underact opens"},
      {"a.json", "", "The file is empty."}};
  for (const ForeignCase& one : cases) {
    const std::uint64_t bytes = one.name == "huge.bin"s ? std::uint64_t{9} << 40 : one.content.size();
    const Result<FileKind> kind = fileKindOf(one.content, bytes, one.name);
    ASSERT_FALSE(kind) << one.name;
    ASSERT_EQ(kind.problems().size(), 1U);
    EXPECT_NE(kind.problems()[0].sentence.find(one.says), std::string::npos) << kind.problems()[0].sentence;
    EXPECT_EQ(kind.problems()[0].place.file, one.name);
  }
}

TEST(FileKind, OfAFolderAPipeAndAFileThatIsGoneIsSaidAtOnce) {
  const QTemporaryDir folder;
  EXPECT_EQ(kindOfFile(folder.path().toStdString()).problems()[0].sentence,
            "This is a folder. Open one of the files in it.");
  EXPECT_NE(kindOfFile("/dev/null").problems()[0].sentence.find("not a regular file"), std::string::npos);
  EXPECT_NE(kindOfFile(folder.filePath("gone").toStdString()).problems()[0].sentence.find("cannot be opened"),
            std::string::npos);
}

TEST(FileKind, OfAFileWithManyGigabytesTakesItsBeginningOnly) {
  const QTemporaryDir folder;
  const std::string path = folder.filePath("huge.json").toStdString();
  std::ofstream(path) << R"({"underact_scene": 1)";
  std::filesystem::resize_file(path, std::uintmax_t{1} << 36);  // a hole, without room on the disk
  const Result<FileKind> kind = kindOfFile(path);
  EXPECT_FALSE(kind) << "zeros are no text";
}

}  // namespace underact::gui::test
