#include "stridor/base/threads.hpp"

namespace stridor::base {

Error no_thread(const std::system_error& failure) {
    return {ErrorKind::io,
            {"the system starts no more threads", failure.code().message(),
             "Choose fewer --threads, or raise the limit of this user or container (ulimit -u)."}};
}

}  // namespace stridor::base
