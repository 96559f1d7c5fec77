// Writing beside, then taking the place: nothing is lost, and nobody ever sees half of it.
#pragma once
#include <filesystem>

namespace afterglow
{
// A new, empty file or folder beside `place`, under a name that nothing had; the folders above are made. What stands there at the end is
// removed: what was built, when it failed; else what it replaced.
class Scaffold
{
public:
    enum class Kind { file, folder };
    Scaffold(const std::filesystem::path& place, Kind kind); // throws Error
    ~Scaffold();
    Scaffold(const Scaffold&) = delete;
    Scaffold& operator=(const Scaffold&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // At once: `place` is the old one until it is the new one, with no moment between. Throws Error.
    void takePlace();

private:
    void exchange();
    std::filesystem::path place_, path_;
    Kind kind_;
};
}
