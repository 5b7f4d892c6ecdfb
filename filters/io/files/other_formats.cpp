#include "filters/io/files/other_formats.h"

#include <algorithm>
#include <iterator>

namespace boxprobe {

namespace {

struct OtherFormat {
  const char* extension;
  const char* called;
  const char* converted;  ///< how it becomes glTF
};

constexpr const char* kByBlender = "import it into Blender and export glTF (.glb)";
constexpr const char* kByAssimp = "convert it with assimp-utils: assimp export IN OUT.glb -fglb2";
constexpr const char* kByFreeCad = "open it in FreeCAD and export glTF (.glb)";

constexpr OtherFormat kOtherFormats[] = {
    {".fbx", "FBX", kByBlender},
    {".usd", "USD", kByBlender},
    {".usda", "USD", kByBlender},
    {".usdc", "USD", kByBlender},
    {".usdz", "USD", kByBlender},
    {".dae", "Collada", kByBlender},
    {".abc", "Alembic", kByBlender},
    {".x3d", "X3D", kByBlender},
    {".wrl", "VRML", kByBlender},
    {".blend", "Blender", "open it in Blender and export glTF (.glb)"},
    {".3ds", "3D Studio", kByAssimp},
    {".lwo", "LightWave", kByAssimp},
    {".off", "OFF", kByAssimp},
    {".3mf", "3MF", kByAssimp},
    {".max", "3ds Max", "open it in 3ds Max and export glTF (.glb)"},
    {".ma", "Maya", "open it in Maya, export FBX, import that into Blender and export glTF (.glb)"},
    {".mb", "Maya", "open it in Maya, export FBX, import that into Blender and export glTF (.glb)"},
    {".skp", "SketchUp", "open it in SketchUp and export glTF (.glb)"},
    {".step", "STEP", kByFreeCad},
    {".stp", "STEP", kByFreeCad},
    {".iges", "IGES", kByFreeCad},
    {".igs", "IGES", kByFreeCad},
    {".ifc", "IFC", kByFreeCad},
    {".vrm", "VRM", "it is glTF: give it the extension .glb"},
    {".vtk", "legacy VTK", "write it as .vtp: vtkXMLPolyDataWriter, or File > Save Data in ParaView"},
    {".vtu", "VTK volume", "extract its surface and write that as .vtp, in ParaView"},
};

}  // namespace

std::string conversionAdvice(const std::string& extension) {
  const auto* const found = std::find_if(std::begin(kOtherFormats), std::end(kOtherFormats),
                                         [&](const OtherFormat& format) { return extension == format.extension; });
  if (found == std::end(kOtherFormats)) return {};
  return std::string(found->called) + " files are not read; " + found->converted;
}

}  // namespace boxprobe
