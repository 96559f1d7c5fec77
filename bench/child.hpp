// A measurement in a process of its own: its processor time and its peak of memory are nobody else's.
#pragma once
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
// Runs `work` in a child and returns its answer with {"process":{"wall_seconds","cpu_seconds","peak_mib"}} added. To be called before this
// process starts a thread. What `work` throws is thrown here again, as an Error.
nlohmann::json inChild(const std::function<nlohmann::json()>& work);
}
