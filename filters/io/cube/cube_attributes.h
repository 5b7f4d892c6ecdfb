// A probe's values as OpenEXR attributes and back: "probe.origin" and "probe.box.min" a v3f (a v3d where float would
// round), "probe.technique" a string, "probe.faceSize" a double, "probe.projection" an int (0 or 1), so that exrheader
// shows them and any reader of attributes finds them. The keys are the scene file's; there is no second list of fields.
// Internal to this folder.
#pragma once

#include <OpenEXR/ImfHeader.h>

#include <string>

#include "filters/io/cube/cube_file.h"

namespace boxprobe {

/// `folder`: that of the written file; the path of a custom image is stored relative to it.
void addProbeAttributes(Imf::Header& header, const BakedProbeInfo& info, const std::string& folder);
/// Throws InputError with path and attribute if one is missing.
BakedProbeMark readProbeMark(const Imf::Header& header, const std::string& path);
/// The same, also if a value is out of range.
BakedProbeInfo readProbeAttributes(const Imf::Header& header, const std::string& folder, const std::string& path);

void addCoefficients(Imf::Header& header, const ShCoefficients& irradiance);
ShCoefficients readCoefficients(const Imf::Header& header, const std::string& path);

/// Throws InputError if the header has no such attribute.
std::string textAttribute(const Imf::Header& header, const std::string& name, const std::string& path);
glm::dvec3 vectorAttribute(const Imf::Header& header, const std::string& name, const std::string& path);
void addVectorAttribute(Imf::Header& header, const std::string& name, const glm::dvec3& value);

}  // namespace boxprobe
