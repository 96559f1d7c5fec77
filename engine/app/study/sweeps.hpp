// The table of a study: every knob that is turned, one line each. Who adds an effect adds its lines here.
#pragma once
#include "engine/app/study/study.hpp"
#include "engine/frame/plan.hpp"

namespace afterglow
{
// An option of the bake, resolved.
template <class Field>
Knob ofBake(Field BakeOptions::*field)
{
    return {[=](const Setup& s) { return double(s.bake.*field); }, [=](Setup& s, double value) { s.bake.*field = Field(value); }};
}
template <class Field>
Knob ofBake(std::optional<Field> BakeOptions::*field)
{
    return {[=](const Setup& s) { return double((s.bake.*field).value()); }, [=](Setup& s, double value) { s.bake.*field = Field(value); }};
}

// All of them, whatever the level.
std::vector<Sweep> knobs();

// The effect drawn or not, against the path-traced picture: what it is for, and what it costs.
Sweep drawnOrNot(const std::string& effect);

// What a subject is asked, in one sentence.
std::string questionOf(const std::string& subject);

// The effect of the plan that calls for it: itself, where it is one.
std::string calledBy(const std::string& subject);

// In the order of the report: effects as the frame has them, then products, then the path tracer. Throws Error (usage) when `wanted`
// names what there is not; empty: all.
std::vector<std::string> subjectNames(const std::vector<std::string>& wanted);
}
