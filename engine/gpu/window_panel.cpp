// The panel by ImGui: all of its calls are here and in window_screen.cpp.
#include "engine/gpu/window.hpp"
#include <cmath>
#include <imgui.h>

namespace afterglow
{
// In the top left corner, as large as what is in it; scrolled when the window is smaller.
void Panel::begin(const std::string& title)
{
    const ImVec2 margin(8, 8), whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(margin, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(whole.x - 2 * margin.x, whole.y - 2 * margin.y));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(4, 1)); // many lines: close together
    ImGui::Begin(title.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize);
}

void Panel::end()
{
    ImGui::End();
    ImGui::PopStyleVar();
}

bool Panel::section(const std::string& title) { return ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen); }

void Panel::text(const std::string& line)
{
    ImGui::PushTextWrapPos(30 * ImGui::GetFontSize());
    ImGui::TextUnformatted(line.c_str(), line.c_str() + line.size());
    ImGui::PopTextWrapPos();
}

bool Panel::button(const std::string& label) { return ImGui::Button(label.c_str()); }

// Its label may be long: wrapped, and clicked as the box is.
bool Panel::toggle(const std::string& label, bool& value)
{
    bool changed = ImGui::Checkbox(("##" + label).c_str(), &value);
    ImGui::SameLine();
    text(label);
    if (ImGui::IsItemClicked()) {
        value = !value;
        changed = true;
    }
    return changed;
}

bool Panel::slider(const std::string& label, float& value, float low, float high)
{
    // A number may be typed as well: "nan" is one to it
    const float before = value;
    const bool changed = ImGui::SliderFloat(label.c_str(), &value, low, high, "%.3f", ImGuiSliderFlags_AlwaysClamp);
    if (!std::isfinite(value)) value = before;
    return changed;
}

bool Panel::choice(const std::string& label, int& index, const std::vector<std::string>& names)
{
    const bool valid = index >= 0 && index < static_cast<int>(names.size());
    if (!ImGui::BeginCombo(label.c_str(), valid ? names[static_cast<std::size_t>(index)].c_str() : "")) return false;
    const int before = index;
    for (int i = 0; i < static_cast<int>(names.size()); ++i)
        if (ImGui::Selectable(names[static_cast<std::size_t>(i)].c_str(), i == index)) index = i;
    ImGui::EndCombo();
    return index != before;
}

void Panel::bar(const std::string& label, float value, float most)
{
    ImGui::ProgressBar(most > 0 ? value / most : 0.0f, ImVec2(6 * ImGui::GetFontSize(), 0), "");
    ImGui::SameLine();
    text(label);
}
}
