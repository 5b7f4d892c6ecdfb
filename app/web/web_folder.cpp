// See web_folder.h.
#include "app/web/web_folder.h"

#include <filesystem>

#include "app/web/markup.h"
#include "app/web/page_policy.h"
#include "app/web/web_source.h"
#include "filters/io/files/atomic_file.h"

namespace boxprobe {

namespace {

std::string viewerPage(const std::string& title) {
  const std::string mark = "@TITLE@";
  std::string page(webSource("viewer.html"));
  const std::string text = markup(title);
  for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos; at += text.size()) {
    page.replace(at, mark.size(), text);
  }
  return withPolicy(page, {" 'self'", " 'self'", "connect-src 'self'; "});
}

}  // namespace

std::vector<std::string> writeWebFolder(const WebScene& scene, const std::string& title, const std::string& folder) {
  std::vector<std::string> files;
  const auto write = [&](const std::string& name, const std::string& bytes) {
    files.push_back((std::filesystem::path(folder) / name).string());
    writeTextAtomically(files.back(), bytes);
  };
  for (const WebFile& file : scene.files) write(file.name, file.bytes);
  write("scene.json", scene.json);
  for (const char* name : {"room.js", "page.css"}) write(name, std::string(webSource(name)));
  write("index.html", viewerPage(title));
  return files;
}

}  // namespace boxprobe
