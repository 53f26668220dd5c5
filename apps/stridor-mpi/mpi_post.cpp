#include "mpi_post.hpp"

#include "stridor/base/check.hpp"

#include <mpi.h>

#include <cstdlib>
#include <limits>
#include <utility>

namespace stridor::app {

namespace {

constexpr int tag = 0;

}  // namespace

struct MpiPost::Sending {
    std::string bytes;
    MPI_Request request = MPI_REQUEST_NULL;
};

// MPI's own way with errors, which is to end the job with a message, is the right one here: nothing goes on without it
MpiPost::MpiPost(int& argc, char**& argv) {
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &neighbours_);
    MPI_Comm_free(&machine);
}

MpiPost::~MpiPost() {
    for (const std::unique_ptr<Sending>& sending : sending_)
        MPI_Wait(&sending->request, MPI_STATUS_IGNORE);
    MPI_Finalize();
}

void MpiPost::send(int to, std::string bytes) {
    STRIDOR_EXPECT(bytes.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()));
    sending_.push_back(std::make_unique<Sending>(Sending{std::move(bytes)}));
    Sending& last = *sending_.back();
    MPI_Isend(last.bytes.data(), static_cast<int>(last.bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD, &last.request);
}

std::optional<cluster::Letter> MpiPost::poll() {
    sending_.remove_if([](const std::unique_ptr<Sending>& sending) {
        int has_left = 0;
        MPI_Test(&sending->request, &has_left, MPI_STATUS_IGNORE);
        return has_left != 0;
    });
    int is_there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &is_there, &status);
    if (is_there == 0) return std::nullopt;
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    cluster::Letter letter{status.MPI_SOURCE, std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(letter.bytes.data(), size, MPI_BYTE, letter.from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return letter;
}

void MpiPost::abort(int exit_code) {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

}  // namespace stridor::app
