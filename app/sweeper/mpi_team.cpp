#include "app/sweeper/mpi_team.h"

#include <cstdlib>

#ifdef UNDERACT_HAS_MPI
#include <mpi.h>

#include <algorithm>
#include <array>
#include <deque>
#include <string_view>
#endif

namespace underact::sweep {

bool isOneOfTeam() {
  // Open MPI's mpirun; any launcher that speaks PMIx (Slurm, later Open MPI); PMI 1 and 2 (Slurm, MPICH).
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

#ifdef UNDERACT_HAS_MPI
namespace {

constexpr int kTag = 0;

/// The ranks of MPI_COMM_WORLD.
class MpiTeam final : public Team {
 public:
  MpiTeam() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }
  ~MpiTeam() override {
    for (Sent& sent : sent_) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
    MPI_Finalize();
  }
  MpiTeam(const MpiTeam&) = delete;
  MpiTeam& operator=(const MpiTeam&) = delete;

  int rank() const override { return rank_; }
  int size() const override { return size_; }

  // Two ranks that send long messages to each other must not wait for each other to read.
  void send(int to, const std::string& text) override {
    forgetArrived();
    Sent& sent = sent_.emplace_back(text);
    MPI_Isend(sent.text.data(), static_cast<int>(sent.text.size()), MPI_BYTE, to, kTag, MPI_COMM_WORLD, &sent.request);
  }

  std::optional<Message> receive() override {
    forgetArrived();
    int is_here = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &is_here, &status);
    if (is_here == 0) return {};
    int length = 0;
    MPI_Get_count(&status, MPI_BYTE, &length);
    Message message{status.MPI_SOURCE, std::string(static_cast<std::size_t>(length), '\0')};
    MPI_Recv(message.text.data(), length, MPI_BYTE, message.from, kTag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
  }

 private:
  /// A message being sent: MPI reads it until its request is done, so it must not move.
  struct Sent {
    explicit Sent(std::string words) : text(std::move(words)) {}
    std::string text;
    MPI_Request request = MPI_REQUEST_NULL;
  };
  void forgetArrived() {
    while (!sent_.empty()) {
      int is_done = 0;
      MPI_Test(&sent_.front().request, &is_done, MPI_STATUS_IGNORE);
      if (is_done == 0) return;
      sent_.pop_front();
    }
  }

  int rank_ = 0, size_ = 1;
  std::deque<Sent> sent_;
};

}  // namespace

Result<std::unique_ptr<Team>> joinTeam() {
  int granted = MPI_THREAD_SINGLE;
  // Cells run on threads that do not use MPI. An error in MPI ends all ranks, which is its default.
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &granted) != MPI_SUCCESS || granted < MPI_THREAD_FUNNELED)
    return Problems{{"MPI could not be started with threads; see its messages above."}};
  return std::unique_ptr<Team>(std::make_unique<MpiTeam>());
}

const char* mpiVersion() {
  static const std::string kText = [] {
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> text{};
    int length = 0;
    MPI_Get_library_version(text.data(), &length);
    const std::string_view all(text.data(), static_cast<std::size_t>(length));
    return std::string(all.substr(0, all.find_first_of(",\n")));
  }();
  return kText.c_str();
}

#else

Result<std::unique_ptr<Team>> joinTeam() {
  return Problems{
      {"mpirun has started this program, which was built without MPI: start it without mpirun, with --threads, or "
       "build it with libopenmpi-dev installed."}};
}

const char* mpiVersion() {
  return "none";
}

#endif

}  // namespace underact::sweep
