#include "filters/vtk/draw/frame_parts.h"

namespace boxprobe {

namespace {

void replaceEach(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// Replaces "texture(bpTexBaseColor, uv)" by a constant colour; for a normal map, by an unperturbed normal.
void leaveOutTextures(std::string& text) {
  const std::string call = "texture(bpTex";
  for (std::size_t at = text.find(call); at != std::string::npos; at = text.find(call, at + 1)) {
    std::size_t end = at + call.size();
    for (int depth = 1; depth > 0 && end < text.size(); ++end)
      depth += text[end] == '(' ? 1 : text[end] == ')' ? -1 : 0;
    text.replace(at, end - at, "vec4(0.5f, 0.5f, 1.0f, 1.0f)");
  }
  replaceEach(text, "#define BP_TANGENT 1", "#define BP_TANGENT 0");
}

}  // namespace

void removeParts(std::string& fragment, FrameParts parts) {
  if ((parts & kReflectionPart) != 0) {
    replaceEach(fragment, "float remaining = bpShareOut(position);", "return light;\n  float remaining = 0.0f;");
  }
  if ((parts & kOpennessPart) != 0) replaceEach(fragment, "#define BP_OPENNESS 1", "#define BP_OPENNESS 0");
  if ((parts & kLampsPart) != 0) replaceEach(fragment, "Lo += ", "if (false) Lo += ");
  if ((parts & kMaterialPart) != 0) leaveOutTextures(fragment);
  // Keeps the exposure: our programs are recognized by that uniform, and their samplers are set.
  if ((parts & kOutputPart) != 0) {
    replaceEach(fragment, "? bpDisplayed(color * bpExposure) :", "? color * bpExposure :");
  }
  if ((parts & kFragmentPart) != 0) {
    replaceEach(fragment, "void main()\n{",
                "void main()\n{\n  gl_FragData[0] = vec4(0.5f, 0.5f, 0.5f, 1.0f);\n  return;");
  }
}

}  // namespace boxprobe
