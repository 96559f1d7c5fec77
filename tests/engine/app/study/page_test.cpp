// The page in a real browser: it loads without a word on the console, the slider wipes, a point changes the picture. Skipped where there is
// no Chromium.
#include "engine/app/study/files.hpp"
#include "engine/core/file.hpp"
#include "report.hpp"
#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>

namespace afterglow
{
// Stands behind the page's own script, does what a person does, and says what came of it.
static const char* kVisitor = R"(<pre id="seen"></pre><script>
const seen = [];
addEventListener("error", event => seen.push("ERROR " + event.message));
setTimeout(() => {
  const section = document.getElementById("occlusion"), slider = section.querySelector("input[type=range]"), over = section.querySelector("img.over");
  slider.focus();
  seen.push("focus:" + (document.activeElement === slider));
  slider.value = 20, slider.dispatchEvent(new Event("input"));
  seen.push("wipe:" + over.style.clipPath);
  seen.push("loaded:" + [...document.images].every(image => image.complete && image.naturalWidth === 8));
  const dots = section.querySelectorAll(".dot"), caption = section.querySelector("figcaption b");
  seen.push("dots:" + dots.length);
  dots[0].dispatchEvent(new Event("focus"));
  seen.push("tip:" + document.getElementById("tip").textContent);
  dots[0].dispatchEvent(new KeyboardEvent("keydown", { key: "Enter" }));
  seen.push("picked:" + caption.textContent);
  seen.push("chosen:" + section.querySelectorAll(".chosen").length);
  section.querySelectorAll("button[aria-pressed]")[1].click();
  seen.push("law:" + section.querySelectorAll("path.law").length);
  const timed = document.getElementById("triangles");
  seen.push("timed:" + timed.querySelectorAll("svg").length + " with " + timed.querySelectorAll(".dot").length + " and " + timed.querySelectorAll("path.law").length);
  timed.querySelector(".dot").dispatchEvent(new Event("focus"));
  seen.push("ray:" + document.getElementById("tip").textContent);
  seen.push("bold:" + document.querySelectorAll("header b").length);
  seen.push("title:" + document.title);
  seen.push("empty:" + [...document.querySelectorAll(".advice")].filter(words => !words.textContent).length);
  seen.push("warned:" + document.querySelector(".warning").textContent);
  document.getElementById("seen").textContent = seen.join("\n");
}, 200);
</script>)";

static std::string output(const std::string& command)
{
    std::string text;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    char block[4096];
    while (const std::size_t got = std::fread(block, 1, sizeof block, pipe)) text.append(block, got);
    pclose(pipe);
    return text;
}

// What becomes of a page, opened at a place in it; and the console's words.
struct Opened {
    std::string dom, log;
};
static Opened opened(const std::string& page, const std::string& place, const std::string& name)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / name; // tests run side by side
    std::filesystem::create_directories(folder);
    writeText(folder / "study.html", page);
    Opened result;
    result.dom = output("HOME='" + folder.string() +
                        "' timeout 120 chromium --headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage --enable-logging=stderr"
                        " --virtual-time-budget=4000 --dump-dom 'file://" +
                        (folder / "study.html").string() + place + "' 2>'" + (folder / "log").string() + "'");
    result.log = readText(folder / "log");
    std::filesystem::remove_all(folder);
    return result;
}

static bool isThereABrowser() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

// As `./run study` has the README's plot.
TEST(StudyPage, prints_a_plot_alone)
{
    if (!isThereABrowser()) GTEST_SKIP() << "there is no Chromium here";
    const auto [dom, log] = opened(pageOf(handMade()), "#plot=triangles", "study_plot");
    EXPECT_EQ(log.find("CONSOLE"), std::string::npos) << log;
    const std::size_t from = dom.find("<svg "), to = dom.find("</svg>");
    ASSERT_TRUE(from != std::string::npos && to != std::string::npos) << dom;
    EXPECT_EQ(dom.find('\n', from) < to, false) << "on one line";
    EXPECT_EQ(dom.find("<h1"), std::string::npos) << "and nothing else";
    std::size_t marks = 0;
    for (std::size_t at = from; (at = dom.find("r=\"4.5\"", at + 1)) != std::string::npos;) ++marks;
    EXPECT_EQ(marks, 6u);
}

// Stands behind the page's own script, and says of each plot how many names it has, and how many of them lie on another or on a mark.
static const char* kReader = R"(<pre id="seen"></pre><script>
const soft = 0.5; // px, of a glyph's edge
const overlap = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > soft && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > soft;
document.getElementById("seen").textContent = [...document.querySelectorAll(".chart svg")].map(svg => {
  const scale = svg.getBoundingClientRect().width / 520;
  const drawn = name => [...svg.querySelectorAll(name)].map(e => e.getBoundingClientRect());
  const names = drawn("text.name").map(b => ({ left: b.left, right: b.right, top: b.top + 2 * scale, bottom: b.bottom - 2 * scale })), marks = drawn("circle.mark");
  const bad = names.filter((a, i) => names.some((b, k) => k !== i && overlap(a, b)) || marks.some(b => overlap(a, b)));
  return [...svg.querySelectorAll("text.name")].map(e => e.textContent).join(" ") + " | " + bad.length + " bad";
}).join("\n");
</script>)";

static std::string between(const std::string& text, const std::string& from, const std::string& to)
{
    const std::size_t begin = text.find(from);
    if (begin == std::string::npos) return "";
    return text.substr(begin + from.size(), text.find(to, begin) - begin - from.size());
}

// Names of points that all but coincide lie beside each other; where there is no room the default keeps its name.
TEST(StudyPage, prints_no_name_over_another)
{
    if (!isThereABrowser()) GTEST_SKIP() << "there is no Chromium here";
    Report report = handMade();
    const Curve model = report.subjects[1].curves[0];
    const auto curveOf = [&](const std::vector<std::pair<double, double>>& timesAndErrors, std::size_t standard) {
        Curve curve = model;
        curve.points.clear();
        for (const auto& [ms, error] : timesAndErrors) {
            Point& point = curve.points.emplace_back(model.points[0]);
            point.name = std::to_string(1000 + curve.points.size()), point.ms = ms, point.error = error;
            point.standard = curve.points.size() == standard;
        }
        return curve;
    };
    const Curve near = curveOf({{1.0, 0.1}, {1.03, 0.099}, {1.06, 0.1}, {50.0, 0.01}}, 4);
    std::vector<std::pair<double, double>> eight(8, {1.0, 0.1});
    eight.push_back({50.0, 0.01});
    const Curve heap = curveOf(eight, 6);
    report.subjects = {{"near", "", "on", {near}}, {"heap", "", "on", {heap}}};
    const std::string seen = between(opened(pageOf(report) + kReader, "", "study_names").dom, "<pre id=\"seen\">", "</pre>");
    EXPECT_EQ(seen.substr(0, seen.find('\n')), "1001 1002 1003 1004 | 0 bad");
    const std::string heaped = seen.substr(seen.find('\n') + 1);
    EXPECT_TRUE(heaped.ends_with("| 0 bad")) << heaped;
    EXPECT_NE(heaped.find("1006"), std::string::npos) << heaped;
}

// Stands behind the page's own script, and says of each plot whether it has a row of no error, how many marks lie on it, how many on the
// scale above, and over how many pieces its line goes.
static const char* kSurveyor = R"(<pre id="seen"></pre><script>
document.getElementById("seen").textContent = [...document.querySelectorAll(".chart svg")].map(svg => {
  const zero = svg.querySelector("line.none"), lowest = Math.max(...[...svg.querySelectorAll("line.break")].map(e => +e.getAttribute("y1")));
  const heights = [...svg.querySelectorAll("circle.mark")].map(e => +e.getAttribute("cy")), pieces = svg.querySelector("path.row").getAttribute("d").split("L").length - 1;
  const on = zero ? heights.filter(y => y === +zero.getAttribute("y1")).length : 0, above = heights.filter(y => !zero || y < lowest).length;
  return (zero ? svg.querySelector("text.none").textContent : "no row") + ": " + on + " on it, " + above + " above, " + pieces + " pieces";
}).join("\n");
</script>)";

// A logarithm knows no 0: it lies below a break of the axis, and no line leads there.
TEST(StudyPage, draws_no_error_apart_from_the_scale)
{
    if (!isThereABrowser()) GTEST_SKIP() << "there is no Chromium here";
    Report report = handMade();
    Curve some = report.subjects[1].curves[0], one = some, all = some;
    one.points[1].error = 0.0;
    one.points.push_back(one.points[0]), one.points[3].ms = 64.0;
    for (Point& point : all.points) point.error = 0.0;
    report.subjects = {{"some", "", "on", {some}}, {"one", "", "on", {one}}, {"all", "", "on", {all}}};
    EXPECT_EQ(between(opened(pageOf(report) + kSurveyor, "", "study_none").dom, "<pre id=\"seen\">", "</pre>"),
              "no row: 0 on it, 3 above, 2 pieces\n0: 1 on it, 3 above, 1 pieces\nno row: 0 on it, 3 above, 2 pieces");
}

TEST(StudyPage, is_read_and_used_in_a_browser)
{
    if (!isThereABrowser()) GTEST_SKIP() << "there is no Chromium here";
    const auto [dom, log] = opened(pageOf(handMade()) + kVisitor, "", "study_page");
    EXPECT_EQ(log.find("CONSOLE"), std::string::npos) << log;
    const std::size_t from = dom.find("<pre id=\"seen\">");
    ASSERT_NE(from, std::string::npos) << log;
    const std::string seen = dom.substr(from, dom.find("</pre>", from) - from);
    for (const char* fact :
         {"focus:true", "wipe:inset(0px 0px 0px 20%)", "loaded:true", "dots:6", "tip:rays 1: 1 ms", "picked:rays 1: 1 ms, error 10 %",
          "chosen:1", "law:1", "timed:1 with 6 and 2", "ray:rays by a tree, 1 per pixel: 1 ns a ray", "bold:4", "empty:0",
          "warned:Other work shared the machine: a load of 5 on 2 processors", "title:What accuracy costs: a &lt;/script&gt;"})
        EXPECT_NE(seen.find(fact), std::string::npos) << fact << " is not in\n" << seen;
    EXPECT_EQ(seen.find("ERROR"), std::string::npos) << seen;
}
}
