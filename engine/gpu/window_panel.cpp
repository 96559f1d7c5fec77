// The panel by ImGui: all of its calls are here and in window_screen.cpp.
#include "engine/gpu/window.hpp"
#include <imgui.h>

namespace afterglow
{
void Panel::begin(const std::string& title) { ImGui::Begin(title.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize); }
void Panel::end() { ImGui::End(); }
bool Panel::section(const std::string& title) { return ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen); }
void Panel::text(const std::string& line) { ImGui::TextUnformatted(line.c_str(), line.c_str() + line.size()); }
bool Panel::button(const std::string& label) { return ImGui::Button(label.c_str()); }
bool Panel::toggle(const std::string& label, bool& value) { return ImGui::Checkbox(label.c_str(), &value); }
bool Panel::slider(const std::string& label, float& value, float low, float high)
{
    return ImGui::SliderFloat(label.c_str(), &value, low, high);
}
bool Panel::slider(const std::string& label, int& value, int low, int high) { return ImGui::SliderInt(label.c_str(), &value, low, high); }

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
    ImGui::ProgressBar(most > 0 ? value / most : 0.0f, ImVec2(200, 0), label.c_str());
}
}
