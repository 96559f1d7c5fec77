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
