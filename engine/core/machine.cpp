#include "engine/core/machine.hpp"
#include <cstring>
#include <fstream>
#include <link.h>

namespace afterglow
{
std::string processorName()
{
    std::ifstream told("/proc/cpuinfo");
    for (std::string line; std::getline(told, line);)
        if (const std::size_t at = line.find(": "); line.starts_with("model name") && at != std::string::npos) return line.substr(at + 2);
    return "CPU";
}

double machineLoad()
{
    double load = 0.0;
    std::ifstream("/proc/loadavg") >> load;
    return load;
}

// A line of the process's own status, in KiB there.
static std::uint64_t statusBytes(const std::string& what)
{
    std::ifstream told("/proc/self/status");
    for (std::string line; std::getline(told, line);)
        if (line.starts_with(what)) return std::stoull(line.substr(what.size())) << 10;
    return 0;
}

std::uint64_t memoryNow() { return statusBytes("VmRSS:"); }

std::uint64_t memoryPeak() { return statusBytes("VmHWM:"); }

// The GNU build id lies in a note of the first object that the loader names, the program: name and contents, each padded to 4 bytes.
static int readBuildId(dl_phdr_info* program, std::size_t, void* id)
{
    const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
    for (int i = 0; i < program->dlpi_phnum; ++i) {
        const auto& segment = program->dlpi_phdr[i];
        if (segment.p_type != PT_NOTE) continue;
        const char* at = reinterpret_cast<const char*>(program->dlpi_addr + segment.p_vaddr);
        for (const char* const end = at + segment.p_memsz; at + sizeof(ElfW(Nhdr)) <= end;) {
            ElfW(Nhdr) note;
            std::memcpy(&note, at, sizeof note);
            const char* const name = at + sizeof note;
            const char* const contents = name + padded(note.n_namesz);
            if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(name, "GNU", 4) == 0)
                static_cast<std::string*>(id)->assign(contents, note.n_descsz);
            at = contents + padded(note.n_descsz);
        }
    }
    return 1; // no other object
}

std::string buildId()
{
    std::string bytes, text;
    dl_iterate_phdr(readBuildId, &bytes);
    for (const char byte : bytes)
        for (const int shift : {4, 0}) text += "0123456789abcdef"[std::uint8_t(byte) >> shift & 15];
    return text;
}
}
