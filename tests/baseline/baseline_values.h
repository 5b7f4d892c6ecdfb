// What a run has printed or written, as numbers and texts that can be kept and compared.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace boxprobe::test {

using BaselineJson = nlohmann::ordered_json;

/// Of a line or JSON on stdout. Times, memory and the driver's name are left out, and `folder` wherever it stands.
BaselineJson printedValues(const std::string& text, const std::string& folder);

/// Of a file, or of all files below a folder by their names. Pictures: means of 4 x 3 pixels, in
/// thousandths of the picture's mean. Baked maps: parts,
/// attributes, and some texels of each level. Cubes of other programs: the header, and some half floats.
BaselineJson writtenValues(const std::string& path, const std::string& folder);

/// One line for each value that differs, "name/of/value: 0.25 is 0.26 (4 %)". `drawn`: by what pictures may differ with
/// another driver, in place of 1e-5. Of a picture three places may be anything: the edge of a thing may take or lose a
/// pixel.
std::vector<std::string> differences(const BaselineJson& expected, const BaselineJson& actual, bool drawn);

/// Each entry of each run on a line of its own.
std::string baselineText(const BaselineJson& runs);

}  // namespace boxprobe::test
