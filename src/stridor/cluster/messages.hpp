#pragma once

#include "stridor/base/error.hpp"
#include "stridor/crew/crew.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Messages between ranks. The bytes are those of this machine: all ranks run one program on machines of one kind,
/// which the first message checks.
namespace stridor::cluster {

/// Rank 0 begins a work: the others leave their present one.
struct Begin {
    std::string build;  // program and commit
    std::string work;   // a fingerprint of what decides the results
    std::string host;   // the machine it runs on
};

/// The first message of a rank to rank 0 about a work that both have.
struct Hello {
    std::string host;           // the machine it runs on
    std::uint32_t threads = 1;  // [1] that compute there
};

/// Rank 0 gives a rank tasks to compute, in this order.
struct Batch {
    std::vector<crew::Task> tasks;
};

/// A rank hands over results.
struct Delivery {
    std::vector<crew::Result> results;
    double seconds_per_task = 0.0;  // [s] on average in that rank; 0: not known yet
};

/// A rank has no results to hand over, and is alive.
struct Alive {};

/// Rank 0 asks a rank to give up the work and to hand over what is finished.
struct Stop {};

/// A rank has given up the work after handing over all that it finished.
struct Stopped {};

/// Something failed in a rank, which computes nothing any more.
struct Failure {
    ErrorKind kind = ErrorKind::io;
    base::Problem problem;
};

/// Rank 0 has no more work, now or ever.
struct End {
    int exit_code = 0;  // of the whole job
};

/// A rank has heard of the end, and sends nothing any more.
struct Bye {};

/// Any of these messages.
using Message = std::variant<Begin, Hello, Batch, Delivery, Alive, Stop, Stopped, Failure, End, Bye>;

/// Returns a message as bytes.
std::string pack(const Message& message);

/// Returns the message in these bytes. Throws `Error` (io) if they are not a message of ours, or end too soon.
Message unpack(std::string_view bytes);

/// Returns the message with which rank 0 begins a work.
Begin begin_of(const crew::Work& work);

/// Returns the name of the machine that this process runs on.
std::string host_name();

/// Returns the complaint of a rank whose program differs from that of rank 0, or which lacks the work that rank 0 has
/// begun: their results would not belong together.
Failure mismatch(const Begin& begun, int rank);

}  // namespace stridor::cluster
