#include "cli/browser.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <unistd.h>

namespace vkpt::test {
namespace {

/// Looks at the page once it is loaded, and leaves what it saw in an element of it.
constexpr const char* kProbe = R"(
<script>
addEventListener('load', () => {
  const colours = image => {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 200;
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0, 200, 200);
    return new Set(new Uint32Array(context.getImageData(0, 0, 200, 200).data.buffer)).size;
  };
  const images = [...document.images].map(i =>
    ({ alt: i.alt, width: i.naturalWidth, colours: i.naturalWidth > 0 ? colours(i) : 0 }));
  const sliders = [...document.querySelectorAll('section.study')].map(section => {
    const [under, over] = section.querySelectorAll('.pair img');
    const [left, right] = section.querySelectorAll('.choose select');
    const pictures = [...section.querySelectorAll('figure.picture img')].map(i => i.src);
    const cut = section.querySelector('.pair input');
    cut.value = 25;
    cut.dispatchEvent(new Event('input'));
    right.value = pictures.length - 1;
    right.dispatchEvent(new Event('input'));
    return { clip: over.style.clipPath, names: [...left.options].map(o => o.text), left: over.src == pictures[0],
             right: under.src == pictures[pictures.length - 1] };
  });
  const facts = document.createElement('pre');
  facts.textContent = 'FACTS:' + encodeURIComponent(JSON.stringify({ images, sliders })) + ':FACTS';
  document.body.append(facts);
});
</script>
)";

std::string decoded(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      plain += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

} // namespace

std::string chromium() {
  std::istringstream path(std::getenv("PATH") != nullptr ? std::getenv("PATH") : "");
  for (std::string folder; std::getline(path, folder, ':');) {
    const std::string program = folder + "/chromium";
    if (::access(program.c_str(), X_OK) == 0)
      return program;
  }
  return {};
}

OpenedPage openPage(const fs::path& html) {
  const WorkFolder folder;
  fs::copy_file(html, folder / "page.html");
  folder.write("page.html", folder.read("page.html") + kProbe);
  CommandSettings settings{folder.path(), {}};
  settings.validation = false;
  settings.program = chromium();
  const CommandResult r = vkpt({"--headless", "--no-sandbox", "--disable-gpu", "--enable-logging=stderr",
                                "--user-data-dir=" + (folder / "profile").string(), "--dump-dom",
                                "file://" + (folder / "page.html").string()},
                               settings);
  EXPECT_EQ(r.exitCode, 0) << r.err;
  OpenedPage page;
  std::istringstream lines(r.err);
  for (std::string line; std::getline(lines, line);) {
    if (line.find(":CONSOLE") != std::string::npos)
      page.console.push_back(line);
  }
  // the probe's own text comes first in the page, the facts behind it
  const std::size_t begin = r.out.rfind("FACTS:", r.out.rfind(":FACTS") - 1);
  const std::size_t end = r.out.rfind(":FACTS");
  if (begin == std::string::npos || end == std::string::npos || begin + 6 > end) {
    ADD_FAILURE() << "the page did not load: " << r.err;
    return page;
  }
  page.facts = nlohmann::json::parse(decoded(r.out.substr(begin + 6, end - begin - 6)), nullptr, false);
  return page;
}

} // namespace vkpt::test
