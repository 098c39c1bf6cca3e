// Built where there is MPI.
#include <command/rank_link.h>

#include <climits>
#include <list>
#include <stdexcept>

#include <mpi.h>

#include <cable_variation/util/error.h>
#include <command/launched_ranks.h>

namespace cable_variation_command {

namespace {

void require(int result, const char* what) {
  if (result == MPI_SUCCESS) return;
  char text[MPI_MAX_ERROR_STRING] = "";
  int length = 0;
  MPI_Error_string(result, text, &length);
  throw cable_variation::InternalError(std::string("MPI ") + what + ": " + text);
}

class MpiLink : public RankLink {
 public:
  MpiLink() {
    int level = 0;
    require(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level), "start");
    if (level < MPI_THREAD_FUNNELED)
      throw std::invalid_argument("this MPI allows no threads beside it; expected MPI_THREAD_FUNNELED");
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    require(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "rank");
    require(MPI_Comm_size(MPI_COMM_WORLD, &size_), "size");
    char name[MPI_MAX_PROCESSOR_NAME] = "";
    int length = 0;
    require(MPI_Get_processor_name(name, &length), "name");
    host_.assign(name, static_cast<std::size_t>(length));
  }

  int rank() const override { return rank_; }
  int size() const override { return size_; }
  std::string host() const override { return host_; }

  void send(int to, RankMessage kind, std::string bytes) override {
    if (bytes.size() > INT_MAX)
      throw std::length_error(std::to_string(bytes.size()) + " bytes in a message; expected 2 GB at most");
    sending_.push_back({std::move(bytes), MPI_REQUEST_NULL});
    Sending& last = sending_.back();
    require(MPI_Isend(last.bytes.data(), static_cast<int>(last.bytes.size()), MPI_BYTE, to,
                      static_cast<int>(kind), MPI_COMM_WORLD, &last.request),
            "send");
  }

  bool receive(int& from, RankMessage& kind, std::string& bytes) override {
    sent();
    int is_there = 0;
    MPI_Status status;
    require(MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status), "probe");
    if (is_there == 0) return false;
    int size = 0;
    require(MPI_Get_count(&status, MPI_BYTE, &size), "count");
    bytes.resize(static_cast<std::size_t>(size));
    require(MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
                     MPI_STATUS_IGNORE),
            "receive");
    from = status.MPI_SOURCE;
    kind = static_cast<RankMessage>(status.MPI_TAG);
    return true;
  }

  bool sent() override {
    for (auto each = sending_.begin(); each != sending_.end();) {
      int done = 0;
      require(MPI_Test(&each->request, &done, MPI_STATUS_IGNORE), "test");
      each = done != 0 ? sending_.erase(each) : std::next(each);
    }
    return sending_.empty();
  }

  void finish() override { require(MPI_Finalize(), "end"); }

 private:
  struct Sending {
    std::string bytes;
    MPI_Request request;
  };

  int rank_ = 0, size_ = 1;
  std::string host_;
  std::list<Sending> sending_;
};

}  // namespace

std::unique_ptr<RankLink> linkOfRanks() {
  return launchedRanks() == 1 ? nullptr : std::make_unique<MpiLink>();
}

}  // namespace cable_variation_command
