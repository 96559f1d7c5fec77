// Writing beside, then taking the place: nothing is lost, and nobody ever sees half of it.
#pragma once
#include <filesystem>
#include <string>

namespace afterglow
{
// A new, empty file or folder beside `place`, under a name that nothing had; the folders above are made. What stands there at the end is
// removed: what was built, when it failed or Ctrl-C was pressed; else what it replaced. So is what a program that was killed left there.
// A link at `place` stays: what it leads to is replaced.
class Scaffold
{
public:
    enum class Kind { file, folder };
    Scaffold(const std::filesystem::path& place, Kind kind); // throws Error
    ~Scaffold();
    Scaffold(const Scaffold&) = delete;
    Scaffold& operator=(const Scaffold&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // At once: `place` is the old one until it is the new one, with no moment between. Throws Error, also when the signal came meanwhile.
    void takePlace();

    std::string told(std::string sentence) const; // with the name that a person knows

private:
    void exchange();
    std::filesystem::path place_, path_;
    Kind kind_;
    int lock_ = -1; // held on what stands at path_: whoever finds it unlocked knows that nobody builds it any more
};

// Where `place` is: absolute, links followed, with no `.`, `..` or slash at its end. Throws Error when it is empty.
std::filesystem::path placeOf(const std::filesystem::path& place);
}
