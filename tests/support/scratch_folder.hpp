#pragma once

#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace stridor::support {

/// Where a scratch folder lies: in memory where the system has such a place, since a database waits for the disk at
/// each commit; on disk if a program in it is to be run, which a place in memory often forbids.
enum class Medium { memory, disk };

/// A folder of its own, gone with it.
class ScratchFolder {
public:
    explicit ScratchFolder(Medium medium = Medium::memory) {
        const std::filesystem::path memory = "/dev/shm";
        const bool is_in_memory = medium == Medium::memory && std::filesystem::is_directory(memory);
        const std::filesystem::path parent = is_in_memory ? memory : std::filesystem::temp_directory_path();
        std::string pattern = (parent / "stridor-scratch-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    const std::filesystem::path& path() const { return path_; }

    /// Number of files in it.
    long files() const {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

private:
    std::filesystem::path path_;
};

/// While it lives no file of this process can grow beyond a size, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace stridor::support
