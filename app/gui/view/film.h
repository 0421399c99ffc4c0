#pragma once
#include <QSize>
#include <string>

namespace underact::gui {

/// What a film shows, and how.
struct FilmOptions {
  std::string file;            // a scene, or a recorded session
  std::string out;             // F.webm, F.mp4 or F.gif
  std::string hand = "sweep";  // that holds the stylus in a scene: the name of a built-in one, or a file
  double seconds = 10.0;       // of a scene; a session ends by itself
  double speed = 1.0;          // 0.1 to 1: slower than it was
  int fps = 30;                // 1 to 60 pictures a second
  QSize size{1280, 720};       // px, both even
  bool overwrite = false;
  bool progress_lines = false;  // the percentage, for a program that reads it
};

/// "1280x720"; empty: it is no size, or its numbers are odd or not within 64 to 4096.
QSize filmSize(const std::string& text);

/// Films what the view shows: the scene in a scripted hand, or a session as it was recorded, with force and target,
/// off screen. The program ffmpeg encodes it (VP9, or GIF). The file is there once it is whole. Problems and the
/// progress go to stderr. Gives the exit status: 0, 1 (a bad scene), 2 (how it was asked), 4 (a file cannot be read or
/// written, ffmpeg is missing or fails, or it was interrupted).
int makeFilm(const FilmOptions& options);

}  // namespace underact::gui
