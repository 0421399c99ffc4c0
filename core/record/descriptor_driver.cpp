#include "core/record/descriptor_driver.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>

#include "core/system/file.h"

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

namespace underact::record {
namespace {

/// What an access list passes to the driver; the library copies it byte by byte.
struct Given {
  int fd = -1;
  std::int64_t at_least = 0;
};

struct GivenFile {
  H5FD_t library{};  // the library's part of each file comes first
  Given given;
  haddr_t allocated = 0;
};

GivenFile* fileOf(H5FD_t* file) {
  return reinterpret_cast<GivenFile*>(file);
}
const GivenFile* fileOf(const H5FD_t* file) {
  return reinterpret_cast<const GivenFile*>(file);
}

H5FD_t* openGiven(const char* name, unsigned flags, hid_t access, haddr_t /*most*/) {
  const auto* given = static_cast<const Given*>(H5Pget_driver_info(access));
  const unsigned writing = H5F_ACC_RDWR | H5F_ACC_TRUNC | H5F_ACC_CREAT | H5F_ACC_EXCL;
  if (given == nullptr || (flags & writing) != 0 || std::strcmp(name, kGivenFile) != 0) return nullptr;
  auto file = std::make_unique<GivenFile>();
  file->given = *given;
  return &file.release()->library;
}

herr_t closeGiven(H5FD_t* file) {
  const std::unique_ptr<GivenFile> gone(fileOf(file));  // the descriptor stays the caller's
  return 0;
}

int compareGiven(const H5FD_t* a, const H5FD_t* b) {
  return fileOf(a)->given.fd - fileOf(b)->given.fd;
}

herr_t queryGiven(const H5FD_t* /*file*/, unsigned long* flags) {
  if (flags != nullptr) *flags = H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_SUPPORTS_SWMR_IO | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t allocatedOfGiven(const H5FD_t* file, H5FD_mem_t /*kind*/) {
  return fileOf(file)->allocated;
}

herr_t allocateGiven(H5FD_t* file, H5FD_mem_t /*kind*/, haddr_t until) {
  fileOf(file)->allocated = until;
  return 0;
}

haddr_t lengthOfGiven(const H5FD_t* file, H5FD_mem_t /*kind*/) {
  const Given& given = fileOf(file)->given;
  return static_cast<haddr_t>(std::max(system::lengthOf(given.fd), given.at_least));
}

herr_t handleOfGiven(H5FD_t* file, hid_t /*access*/, void** descriptor) {
  *descriptor = &fileOf(file)->given.fd;
  return 0;
}

/// Zeros beyond the end, as the library's own drivers return.
herr_t readGiven(H5FD_t* file, H5FD_mem_t /*kind*/, hid_t /*transfer*/, haddr_t from, size_t size, void* to) {
  if (from > static_cast<haddr_t>(INT64_MAX) || size > static_cast<haddr_t>(INT64_MAX) - from) return -1;
  const std::span into(static_cast<std::byte*>(to), size);
  const std::optional<std::size_t> count = system::readAllAt(fileOf(file)->given.fd, from, into);
  if (!count) return -1;
  std::fill(into.begin() + static_cast<std::ptrdiff_t>(*count), into.end(), std::byte{0});
  return 0;
}

herr_t writeToGiven(H5FD_t* /*file*/, H5FD_mem_t /*kind*/, hid_t /*transfer*/, haddr_t /*to*/, size_t /*size*/,
                    const void* /*from*/) {
  return -1;
}

// The file was locked when its descriptor was opened.
herr_t lockGiven(H5FD_t* /*file*/, hbool_t /*writes*/) {
  return 0;
}
herr_t unlockGiven(H5FD_t* /*file*/) {
  return 0;
}

H5FD_class_t givenDriver() {
  H5FD_class_t made{};
#if H5_VERSION_GE(1, 13, 0)
  made.version = H5FD_CLASS_VERSION;
  made.value = static_cast<H5FD_class_value_t>(511);  // one of the numbers reserved for testing
#endif
  made.name = "given";
  made.maxaddr = static_cast<haddr_t>(INT64_MAX);
  made.fc_degree = H5F_CLOSE_WEAK;
  made.fapl_size = sizeof(Given);
  made.open = openGiven;
  made.close = closeGiven;
  made.cmp = compareGiven;
  made.query = queryGiven;
  made.get_eoa = allocatedOfGiven;
  made.set_eoa = allocateGiven;
  made.get_eof = lengthOfGiven;
  made.get_handle = handleOfGiven;
  made.read = readGiven;
  made.write = writeToGiven;
  made.lock = lockGiven;
  made.unlock = unlockGiven;
  std::fill(std::begin(made.fl_map), std::end(made.fl_map), H5FD_MEM_DEFAULT);
  return made;
}

}  // namespace

bool accessThrough(Handle access, int fd, std::int64_t at_least) {
  static const H5FD_class_t kDriver = givenDriver();
  const Id registered(H5FDregister(&kDriver), H5FDunregister);
  const Given given{fd, at_least};
  return registered.isGood() && H5Pset_driver(access, registered, &given) >= 0;
}

}  // namespace underact::record
