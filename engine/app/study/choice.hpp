// What a study turns: of all that there is to ask, what the level calls for and the device can.
#pragma once
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/study/study.hpp"
#include "engine/frame/plan.hpp"
#include "engine/gpu/device.hpp"

namespace afterglow
{
// The effect that calls for a subject: itself, where it is one.
const PlannedEffect& callerOf(const std::string& subject, const Plan& planned);

// The subjects that are asked for and called for; in `absent`, why not the rest. Throws Error when there is none.
std::vector<std::string> studied(const StudyCommand& command, const Plan& planned, std::vector<std::string>& absent);

// What is swept of a subject, with the device's values alone; in `absent`, what it cannot, and what there is no time for. `drawn`: drawn or
// not, too.
std::vector<Sweep> sweepsOf(const std::string& subject, const Device& device, bool drawn, const StudyCommand& command,
                            std::vector<std::string>& absent);
}
