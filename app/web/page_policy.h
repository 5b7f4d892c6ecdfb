// What a browser may load and run for a page of ours: a Content-Security-Policy within the page. Called by whatever
// writes pages.
#pragma once

#include <string>
#include <string_view>

namespace boxprobe {

/// SHA-256 (FIPS 180-4): 32 bytes.
std::string sha256(std::string_view bytes);

/// Besides what stands in the page itself, as lists of sources: " 'self'".
struct PageSources {
  std::string scripts, styles;
  std::string others;  ///< whole directives, each with "; " behind it
};

/// `page` with the policy behind its <meta charset="utf-8">: nothing is allowed but `sources` and the scripts and
/// styles that stand in the page now, between <script> or <style> and their ends, each by its hash. To be called last.
std::string withPolicy(const std::string& page, const PageSources& sources);

}  // namespace boxprobe
