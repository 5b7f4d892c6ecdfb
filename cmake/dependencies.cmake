# Every library the program stands on, and why it is there.
find_package(glm REQUIRED)            # vectors and matrices; also compiles shaders/shared as C++
find_package(OpenEXR REQUIRED)        # HDR images in and out
find_package(nlohmann_json REQUIRED)  # scene files, statistics
find_package(CLI11 REQUIRED)          # argument parsing
find_package(Threads REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL)
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h REQUIRED)  # glTF and GLB: whole core format and extensions as JSON
find_library(TINYGLTF_LIBRARY tinygltf REQUIRED)
find_path(STB_INCLUDE_DIR stb/stb_image.h REQUIRED)  # PNG, JPEG and Radiance HDR decoding
find_package(VTK 9.1 REQUIRED COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms
  FiltersCore FiltersGeneral FiltersSources IOImage IOXML InteractionStyle InteractionWidgets
  RenderingCore RenderingOpenGL2 RenderingAnnotation RenderingFreeType glew GUISupportQt)
find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui Widgets)
find_package(GTest REQUIRED)
