#include "tests/architecture/rooms.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>

namespace underact::architecture {

namespace fs = std::filesystem;

std::string textOf(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

namespace {

/// The room that a path lies in: the longest folder that it begins with.
std::optional<std::string> roomOf(const Rooms& rooms, const std::string& path) {
  std::optional<std::string> best;
  for (const auto& [folder, may_use] : rooms) {
    if (path.starts_with(folder + "/") && (!best || folder.size() > best->size())) best = folder;
  }
  return best;
}

/// A library that system headers bring to every room, and where it belongs.
struct Library {
  const char* name;
  std::regex header;               // what its includes begin with
  std::vector<std::string> rooms;  // empty: none; "app/gui/*": that folder and all in it
  bool in_headers;                 // it may be seen in those rooms' headers
};

const std::vector<Library>& libraries() {
  static const std::vector<Library> kLibraries{
      {"Qt", std::regex("Q[A-Z]|Qt|private/q"), {"app/gui/*"}, true},
      {"VTK", std::regex("vtk"), {"app/gui/view"}, true},
      {"XCB", std::regex("xcb/"), {"app/gui/kit"}, false},
      {"GLFW", std::regex("GLFW"), {"device/input"}, false},
      {"hidapi", std::regex("hidapi"), {"device"}, false},
      {"ZeroMQ", std::regex("zmq"), {"device"}, false},
      {"libsodium", std::regex("sodium"), {"app/serve"}, false},
      {"OpenMesh", std::regex("OpenMesh"), {"app/mesh_reader"}, false},
      {"xxHash", std::regex("xxh"), {"core/mesh_file"}, false},
      {"HDF5", std::regex("hdf5|H5|highfive"), {"core/record"}, false},
      {"RapidJSON", std::regex("rapidjson"), {"core/json"}, false},
      {"TinyXML-2", std::regex("tinyxml2"), {"core/arm"}, false},
      {"SLEEF", std::regex("sleef"), {"core/base"}, false},
      {"Boost.Beast", std::regex("boost/beast"), {"core/web_socket"}, false},
      {"systemd", std::regex("systemd/"), {"core/system"}, false},
      {"CLI11", std::regex("CLI/"), {"app/options"}, false},
      {"MPI", std::regex("mpi\\.h"), {"app/sweeper"}, false},
      {"pybind11", std::regex("pybind11"), {"app/bindings"}, true},
      {"MD4C", std::regex("md4c"), {"app/page"}, false},
      {"zlib", std::regex("zlib"), {"core/record"}, false},
      // Last: headers with an ending are of no C++ library, and of none of the above. Not of the system are ours, and
      // those of what a processor can do.
      {"the operating system",
       std::regex("csignal$|(?!(core|device|app|underact)/|[ex]mmintrin).*\\.h$"),
       {"core/system"},
       false},
  };
  return kLibraries;
}

bool isAmong(const std::string& room, const std::string& allowed) {
  if (!allowed.ends_with("/*")) return room == allowed;
  return (room + "/").starts_with(allowed.substr(0, allowed.size() - 1));
}

/// What is wrong with including <header> in a file of room; empty: nothing.
std::string wrongLibrary(const std::string& header, const std::string& room, bool is_header) {
  for (const Library& library : libraries()) {
    if (!std::regex_search(header, library.header, std::regex_constants::match_continuous)) continue;
    if (std::none_of(library.rooms.begin(), library.rooms.end(),
                     [&room](const std::string& allowed) { return isAmong(room, allowed); })) {
      return std::string(library.name) + " does not belong in " + room;
    }
    return is_header && !library.in_headers ? std::string(library.name) + " may not show in a header" : "";
  }
  return {};
}

/// What is wrong with including "header" in a file of room; empty: nothing.
std::string wrongRoom(const Rooms& rooms, const std::string& header, const std::string& room) {
  if (header == "underact/version.h") return {};  // CMake makes it
  const std::optional<std::string> used = roomOf(rooms, header);
  if (!used) return "\"" + header + "\" lies in no room";
  if (!rooms.at(room).contains(*used)) return room + " may not use " + *used;
  return {};
}

/// As LINKS calls it.
std::string nameOf(const std::string& folder) {
  return std::regex_replace(folder, std::regex("^(core|device|app)/"), "");
}

/// A force for a device made by other hands than the gate's; zero, GatedForce{}, is anybody's.
std::string aroundTheGate(const std::string& line, const std::string& path) {
  static const std::regex kMade(R"(GatedForce\s*[({]\s*[^)}\s])");
  static const std::regex kForged(R"((reinterpret_cast|bit_cast|memcpy|static_cast)\b.*GatedForce)");
  static const std::regex kFriend(R"(\bfriend\b)");
  if (path.starts_with("core/safety/gate.")) {
    const bool second = std::regex_search(line, kFriend) && line.find("friend Gated gate(") == std::string::npos;
    return second ? "GatedForce has gate() for its only friend" : "";
  }
  if (std::regex_search(line, kMade) || std::regex_search(line, kForged)) return "only the gate makes a GatedForce";
  return {};
}

/// The servo's host in the hands of a feature: they get what they may ask, and what they may steer.
std::string aroundTheModel(const std::string& line, const std::string& path, const std::string& room) {
  static const std::regex kHost(R"(servo::Host\s*[&*])");
  static const std::set<std::string> kMay{"app/gui", "app/gui/model", "app/gui/window"};
  if (!path.starts_with("app/gui/") || kMay.contains(room) || !std::regex_search(line, kHost)) return {};
  return "nobody but the model has the servo's host: ServoFacts, ServoControl";
}

/// A name of Qt's where there is no Qt; what stands in a comment or a text is none.
std::string nameOfQt(const std::string& line, const std::string& path) {
  if (!path.starts_with("core/") && !path.starts_with("device/")) return {};
  static const std::regex kApart(R"re("(?:[^"\\]|\\.)*"|//.*)re");
  static const std::regex kName(R"(\b(?:Qt|QT_\w+|Q[A-Z][a-z]\w*|tr(?=\()))");
  const std::string code = std::regex_replace(line, kApart, "");
  std::smatch name;
  return std::regex_search(code, name, kName) ? name.str() + " is a name of Qt's" : "";
}

bool isSource(const fs::path& path) {
  return path.extension() == ".h" || path.extension() == ".cpp";
}

std::vector<std::string> violationsOf(const Rooms& rooms, const fs::path& file, const std::string& path) {
  const std::string room = *roomOf(rooms, path);
  const bool is_header = file.extension() == ".h";
  static const std::regex kInclude(R"re(^\s*#\s*include\s*(["<])([^">]+)[">])re");
  std::vector<std::string> found;
  std::stringstream text(textOf(file));
  int number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    std::smatch include;
    std::string wrong = aroundTheGate(line, path);
    if (wrong.empty()) wrong = aroundTheModel(line, path, room);
    if (wrong.empty()) wrong = nameOfQt(line, path);
    if (std::regex_search(line, include, kInclude)) {
      wrong = wrongLibrary(include[2], room, is_header);
      if (wrong.empty() && include[1] == "\"") wrong = wrongRoom(rooms, include[2], room);
    }
    if (!wrong.empty()) found.push_back(path + ":" + std::to_string(number) + ": " + wrong);
  }
  return found;
}

}  // namespace

Rooms roomsOf(const std::string& cmake) {
  static const std::regex kRoom(R"(underact_(room|feature)\(([^)]*)\))");
  static const std::set<std::string> kOther{"USES", "SHOWS",   "WITHOUT", "STARTS",    "OPENS",
                                            "LIKE", "PROGRAM", "IN",      "COMPONENT", "PRECOMPILES"};
  const std::string code = std::regex_replace(cmake, std::regex("#[^\n]*"), "");
  Rooms rooms;
  std::map<std::string, std::string> folder_of;  // by its name
  std::vector<std::string> features;
  for (std::sregex_iterator at(code.begin(), code.end(), kRoom), end; at != end; ++at) {
    const bool is_feature = (*at)[1] == "feature";
    std::stringstream words((*at)[2]);
    std::string folder;
    words >> folder;
    std::set<std::string>& may_use = rooms[folder] = {folder};
    folder_of[nameOf(folder)] = folder;
    const auto link = [&](const std::string& name) {
      const auto found = folder_of.find(name);
      if (found != folder_of.end()) may_use.insert(rooms[found->second].begin(), rooms[found->second].end());
    };
    if (is_feature) {
      features.push_back(nameOf(folder));
      link("gui/feature");
    }
    bool links = false;
    for (std::string word; words >> word;) {
      if (word == "LINKS" || kOther.contains(word)) {
        links = word == "LINKS";
      } else if (links && word == "${UNDERACT_FEATURES}") {
        for (const std::string& feature : features) link(feature);
      } else if (links) {
        link(word);
      }
    }
  }
  return rooms;
}

std::vector<std::string> violations(const fs::path& root) {
  const Rooms rooms = roomsOf(textOf(root / "CMakeLists.txt"));
  std::vector<std::string> found;
  for (const char* top : {"core", "device", "app"}) {
    if (!fs::exists(root / top)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / top)) {
      if (!entry.is_regular_file() || !isSource(entry.path())) continue;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      if (!roomOf(rooms, path)) {
        found.push_back(path + ": lies in no room");
        continue;
      }
      for (std::string& one : violationsOf(rooms, entry.path(), path)) found.push_back(std::move(one));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::string> withoutTests(const fs::path& root) {
  const std::string window = "app/gui/";
  std::vector<std::string> found;
  for (const auto& [room, uses] : roomsOf(textOf(root / "CMakeLists.txt"))) {
    if (!room.starts_with(window)) continue;
    const fs::path folder = root / "tests/gui" / room.substr(window.size());
    bool has_one = false;
    if (fs::exists(folder)) {
      for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        has_one = has_one || entry.path().filename().string().ends_with("_test.cpp");
    }
    if (!has_one) found.push_back(room + ": has no test in tests/gui/" + room.substr(window.size()));
  }
  return found;
}

}  // namespace underact::architecture
