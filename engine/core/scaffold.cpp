#include "engine/core/scaffold.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace afterglow
{
static constexpr const char* kMark = ".writing-"; // then the process, then which of its own
static constexpr int kMostLinks = 40;             // that lead to one another, as Linux allows

static Error failure(const std::filesystem::path& place, const std::string& why)
{
    return Error("cannot write " + place.string() + ": " + why + "; choose another place");
}

static std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

static std::filesystem::path followed(const std::filesystem::path& path, const std::filesystem::path& place)
{
    std::error_code problem;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(path, problem);
    if (problem) throw failure(place, problem.message());
    return whole.has_filename() ? whole : whole.parent_path();
}

std::filesystem::path placeOf(const std::filesystem::path& place)
{
    if (place.empty()) throw Error("an output has an empty name; name a file or a folder", Exit::usage);
    std::filesystem::path whole = followed(std::filesystem::absolute(place), place);
    std::error_code none;
    for (int link = 0; link < kMostLinks && std::filesystem::is_symlink(std::filesystem::symlink_status(whole, none)); ++link)
        whole = followed(whole.parent_path() / std::filesystem::read_symlink(whole), place); // it leads to what is not there yet
    return whole;
}

// Whether something new stands under that name now; not when the name was taken. Throws Error.
static bool makeNew(const std::filesystem::path& place, const std::string& name, Scaffold::Kind kind)
{
    const int made = kind == Scaffold::Kind::folder ? mkdir(name.c_str(), 0777) : open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
    if (made < 0 && errno != EEXIST) throw failure(place, reason());
    if (made > 0) close(made);
    return made >= 0;
}

// -1: somebody else holds it, or it cannot be held.
static int lockOf(const std::filesystem::path& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB) != 0) {
        close(file);
        return -1;
    }
    return file;
}

// The process that a name of ours speaks of; 0: the name is not of ours. `start` is `place.writing-`.
static pid_t builderOf(const std::string& name, const std::string& start)
{
    if (!name.starts_with(start)) return 0;
    const std::string rest = name.substr(start.size());
    if (rest.empty() || rest.find_first_not_of("0123456789-") != std::string::npos || rest[0] == '-') return 0;
    return pid_t(std::atol(rest.c_str()));
}

// What a program that was killed left: of a process that is gone (here, and by the lock in whatever container).
static void removeStale(const std::filesystem::path& place)
{
    std::error_code ignored;
    const std::string start = place.filename().string() + kMark;
    std::filesystem::directory_iterator entry(place.parent_path(), ignored), end;
    for (; !ignored && entry != end; entry.increment(ignored)) {
        const pid_t builder = builderOf(entry->path().filename().string(), start);
        if (builder <= 0 || kill(builder, 0) == 0 || errno != ESRCH) continue;
        const int lock = lockOf(entry->path());
        if (lock < 0) continue;
        std::error_code unremovable;
        std::filesystem::remove_all(entry->path(), unremovable);
        close(lock);
    }
}

Scaffold::Scaffold(const std::filesystem::path& place, Kind kind) : place_(placeOf(place)), kind_(kind)
{
    std::error_code problem;
    std::filesystem::create_directories(place_.parent_path(), problem);
    if (problem) throw failure(place, problem.message());
    removeStale(place_);
    const std::string name = place_.string() + kMark + std::to_string(getpid());
    std::string made = name;
    beginWriting();
    try {
        for (int next = 2; !makeNew(place, made, kind); ++next) made = name + "-" + std::to_string(next);
    } catch (...) {
        endWriting();
        throw;
    }
    path_ = made;
    lock_ = lockOf(path_);
}

Scaffold::~Scaffold()
{
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
    if (lock_ >= 0) close(lock_);
    endWriting();
}

void Scaffold::takePlace()
{
    stopIfInterrupted();
    if (kind_ == Kind::folder && std::filesystem::exists(std::filesystem::symlink_status(place_)))
        exchange();
    else if (std::rename(path_.c_str(), place_.c_str()) == 0)
        path_.clear();
    else
        throw failure(place_, reason());
    tellWritten();
}

std::string Scaffold::told(std::string sentence) const
{
    for (std::size_t at; (at = sentence.find(path_.string())) != std::string::npos;)
        sentence.replace(at, path_.string().size(), place_.string());
    return sentence;
}

void Scaffold::exchange()
{
    if (renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0) return;

    // A file system that cannot exchange: the old folder steps aside first, onto an empty one.
    const Scaffold aside(place_, Kind::folder);
    if (std::rename(place_.c_str(), aside.path().c_str()) != 0) throw failure(place_, reason());
    if (std::rename(path_.c_str(), place_.c_str()) != 0) {
        const std::string why = reason();
        std::rename(aside.path().c_str(), place_.c_str());
        throw failure(place_, why);
    }
    path_.clear();
}
}
