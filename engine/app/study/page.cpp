// The page: a template, and in it its style, its script, and the report as JSON with its pictures as data.
#include "engine/app/study/files.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/gpu/shader.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static std::string dataOf(const std::vector<std::uint8_t>& jpeg)
{
    static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text = "data:image/jpeg;base64,";
    for (std::size_t i = 0; i < jpeg.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < jpeg.size() ? jpeg[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > jpeg.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

static void put(std::string& page, const std::string& place, const std::string& text)
{
    const std::size_t at = page.find(place);
    check(at != std::string::npos, "page.html says where its parts go");
    page.replace(at, place.size(), text);
}

std::string pageOf(const Report& report)
{
    json data = jsonOf(report);
    for (std::size_t s = 0; s < report.subjects.size(); ++s)
        for (std::size_t c = 0; c < report.subjects[s].curves.size(); ++c) {
            const Curve& curve = report.subjects[s].curves[c];
            json& row = data["subjects"][s]["curves"][c];
            row["reference"] = dataOf(curve.reference);
            for (std::size_t p = 0; p < curve.points.size(); ++p) {
                row["points"][p]["picture"] = dataOf(curve.points[p].picture);
                row["points"][p]["heat"] = dataOf(curve.points[p].heat);
                if (!curve.points[p].reference.empty()) row["points"][p]["reference"] = dataOf(curve.points[p].reference);
            }
        }
    // A name in a level may be anything: it must not end the script that holds it
    std::string text = data.dump(-1, ' ', /* ensure_ascii= */ true, json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");

    const std::filesystem::path folder = shaderRoot() / "engine/app/study";
    std::string page = readText(folder / "page.html");
    put(page, "@style@", readText(folder / "page.css"));
    put(page, "@script@", readText(folder / "page.js"));
    put(page, "@report@", text); // the last: it may hold any words
    return page;
}
}
