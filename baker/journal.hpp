// What a bake has done so far, in a file beside its folder: a bake that was killed goes on from there. A unit of work is a pure function
// of the journal's key and of itself, so that it does not matter who did it.
#pragma once
#include "baker/ray_count.hpp"
#include "engine/core/progress.hpp"
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace afterglow
{
enum class Job : std::uint32_t { pace = 1, lightmaps, probes, reflections, lods, voxels, layers }; // numbers of the file

struct Unit {
    Job job;
    std::uint32_t index = 0; // of the job
    std::uint32_t step = 0;  // of the index: units that build on one another
    std::uint64_t layer = 0; // of light, that a later bake may ask for (key.hpp); 0: of this bake alone
    auto operator<=>(const Unit&) const = default;
};

struct Done {
    std::vector<std::uint8_t> bytes;
    RayCount rays;
};

struct Spent {
    double seconds = 0.0, cpuSeconds = 0.0;
};

// Held by one process at a time. What is kept survives a killed process, not a machine that loses its power: nothing waits for the disk.
class Journal
{
public:
    enum class Start { afresh, resume };

    // Of the bake into `place` whose key it is (key.hpp). Throws Error when another process bakes there, or when the file is a stranger's.
    // A journal of another key is not read; damaged records are cut off, with all that follow.
    Journal(const std::filesystem::path& place, const std::string& key, Start start);
    explicit Journal(const std::filesystem::path& kept); // what finish() left, for recall() alone. Throws Error when it is a stranger's
    ~Journal();                                          // the file stays, unless it holds nothing
    Journal(const Journal&) = delete;

    std::optional<Done> recall(const Unit& unit) const; // what was kept, whoever did it; from any thread
    void keep(const Unit& unit, std::span<const std::uint8_t> bytes, const RayCount& rays); // from any thread
    void forget(const Unit& unit); // nobody asks for it again; it stays in the file
    // The bake is complete: the file is removed, or becomes `kept`.
    void finish(const std::filesystem::path& kept = {});

    Spent before() const { return before_; }      // by earlier processes
    Spent before(Job job) const;                  // of that, by one job
    Spent spent() const;                          // until now, this process included
    bool resumable() const { return whole_ > 0; } // a later process can go on

private:
    void open(const std::filesystem::path& path);
    std::uint64_t sizeOfOwn() const;
    void read(const std::string& key, Start start);
    std::uint64_t index(std::uint64_t size);
    bool append(const std::vector<std::uint8_t>& bytes);

    struct Place {
        std::uint64_t at;
        std::uint32_t size;
        RayCount rays;
    };
    std::filesystem::path path_;
    std::string key_;
    int file_ = -1;
    std::map<Unit, Place> units_;
    std::map<Job, Spent> spentBy_;
    Spent before_, began_;        // began_: clocks when it was opened
    mutable std::mutex changing_; // the units, and the end of the file
    std::uint64_t whole_ = 0;     // bytes of the file that this bake may go on from; 0: it holds none
    bool full_ = false;           // a record did not go in
};
}
