#include "core/record/participant_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

#include "core/base/translate.h"
#include "core/record/session.h"

namespace underact::record {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSessionEnding = ".h5";
constexpr std::string_view kCsvMetadata = "-metadata.json";
constexpr std::array<std::string_view, 6> kExportEndings{kCsvMetadata, ".parquet", ".mcap", ".pdf", ".png", ".svg"};

bool isFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(fs::symlink_status(path, error));
}

std::vector<std::string> filesBelow(const std::vector<std::string>& places) {
  std::vector<std::string> files;
  for (const std::string& place : places) {
    if (isFile(place)) files.push_back(place);
    std::error_code error;
    for (fs::recursive_directory_iterator at(place, fs::directory_options::skip_permission_denied, error), end;
         !error && at != end; at.increment(error)) {
      if (isFile(at->path())) files.push_back(at->path().string());
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

/// Whether one of the words is in the file; read piece by piece.
bool holdsOneOf(const std::string& path, const std::vector<std::string>& words) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;
  std::ifstream file(path, std::ios::binary);
  std::string text, piece(kPiece, '\0');
  while (file) {
    file.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece, 0, static_cast<std::size_t>(file.gcount()));
    const auto is_in = [&text](const std::string& word) { return text.find(word) != std::string::npos; };
    if (std::any_of(words.begin(), words.end(), is_in)) return true;
    constexpr std::size_t kLongestWord = 64;
    if (text.size() > kLongestWord) text.erase(0, text.size() - kLongestWord);
  }
  return false;
}

}  // namespace

ParticipantFiles filesOfParticipant(const std::string& code, const std::vector<std::string>& places) {
  ParticipantFiles found;
  std::vector<std::string> ids;
  const std::vector<std::string> files = filesBelow(places);
  for (const std::string& path : files) {
    if (!path.ends_with(kSessionEnding)) continue;
    const Result<Session> session = Session::open(path);
    if (!session) {
      found.unread.insert(found.unread.end(), session.problems().begin(), session.problems().end());
      continue;
    }
    const SessionHeader& header = session.value().info().header;
    if (header.words.subject != code) continue;
    found.sessions.push_back(path);
    if (!header.session_id.empty()) ids.push_back(header.session_id);
  }
  for (const std::string& path : files) {
    const auto ends = [&path](std::string_view ending) { return path.ends_with(ending); };
    if (ids.empty() || !std::any_of(kExportEndings.begin(), kExportEndings.end(), ends)) continue;
    if (!holdsOneOf(path, ids)) continue;
    found.exports.push_back(path);
    if (!path.ends_with(kCsvMetadata)) continue;
    const std::string csv = path.substr(0, path.size() - kCsvMetadata.size());
    if (isFile(csv)) found.exports.push_back(csv);
  }
  return found;
}

Problems removeFiles(const ParticipantFiles& files) {
  Problems problems;
  for (const std::vector<std::string>* const list : {&files.exports, &files.sessions}) {
    for (const std::string& path : *list) {
      std::error_code error;
      if (!fs::remove(path, error))
        problems.push_back({phrase(TRANSLATE_NOOP("problem", "This file could not be deleted: %1."),
                                   {error ? error.message() : std::string("?")}),
                            {path}});
    }
  }
  return problems;
}

}  // namespace underact::record
