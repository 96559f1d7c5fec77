#include "engine/core/scaffold.hpp"
#include "engine/core/error.hpp"
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace afterglow
{
static Error failure(const std::filesystem::path& place, const std::string& why)
{
    return Error("cannot write " + place.string() + ": " + why + "; choose another place");
}

static std::string reason() { return std::error_code(errno, std::generic_category()).message(); }

// Whether something new stands under that name now; not when the name was taken. Throws Error.
static bool makeNew(const std::filesystem::path& place, const std::string& name, Scaffold::Kind kind)
{
    const int made = kind == Scaffold::Kind::folder ? mkdir(name.c_str(), 0777) : open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY, 0666);
    if (made < 0 && errno != EEXIST) throw failure(place, reason());
    if (made > 0) close(made);
    return made >= 0;
}

Scaffold::Scaffold(const std::filesystem::path& place, Kind kind) : place_(place), kind_(kind)
{
    std::error_code problem;
    std::filesystem::create_directories(std::filesystem::absolute(place).parent_path(), problem);
    if (problem) throw failure(place, problem.message());
    const std::string name = place.string() + ".writing-" + std::to_string(getpid());
    std::string made = name;
    for (int next = 2; !makeNew(place, made, kind); ++next) made = name + "-" + std::to_string(next);
    path_ = made;
}

Scaffold::~Scaffold()
{
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

void Scaffold::takePlace()
{
    if (kind_ == Kind::folder && std::filesystem::exists(std::filesystem::symlink_status(place_))) return exchange();
    if (std::rename(path_.c_str(), place_.c_str()) != 0) throw failure(place_, reason());
    path_.clear();
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
