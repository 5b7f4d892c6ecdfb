// The rows of the scene file's top level, and of models, skies and cameras.
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

const std::vector<FieldRow<Scene>>& sceneFields() {
  static const std::vector<FieldRow<Scene>> rows = {
      keyOnly<Scene>("format", "What kind of file this is: the same in every scene file.")
          .as(FieldKind::Text)
          .writtenAs("`\"boxprobe-scene\"`")
          .require("\"format\": \"boxprobe-scene\""),
      keyOnly<Scene>("version", "Version of the format.").as(FieldKind::Integer).oneOf({1}).require("\"version\": 1"),
      keyOnly<Scene>("model", "The model, if there is one: a file name, or an object as in `models`.")
          .writtenAs("file name or object")
          .leftOut("none")
          .changing({&Changes::models}),
      field<&Scene::models>("models", "", "Several models in place of `model`: a list of file names or objects.")
          .writtenAs("list of file names and objects")
          .leftOut("none")
          .changing({&Changes::models}),
      field<&Scene::sky>("sky", "", "What is seen where there is no object: an image, one colour, or a gradient.")
          .writtenAs("object")
          .leftOut("the gradient below")
          .changing({&Changes::sky}),
      field<&Scene::cameras>("cameras", "", "Viewpoints by name; the first is shown when the scene opens.")
          .writtenAs("objects by name")
          .leftOut("those of the models")
          .changing({&Changes::cameras}),
      field<&Scene::lights>("lights", "", "A list of lights.")
          .writtenAs("list of objects")
          .leftOut("those of the models")
          .changing({&Changes::lights}),
      field<&Scene::materials>("materials", "", "Changes to materials of the models, by the material's name.")
          .writtenAs("objects by name")
          .leftOut("none")
          .changing({&Changes::materials}),
      field<&Scene::objects>("objects", "", "Changes to objects of the models, by the node's name.")
          .writtenAs("objects by name")
          .leftOut("none")
          .changing({&Changes::objects}),
      field<&Scene::mirrors>("mirrors", "",
                             "Planar mirrors, by the node's name: each shows the dynamic objects over the probes' "
                             "reflection.")
          .writtenAs("objects by name")
          .leftOut("none")
          .changing({&Changes::objects}),
      field<&Scene::mirrorBudget>("mirrorBudget", "texels",
                                  "Limit on the pictures of all planar mirrors in one frame; the largest mirrors on "
                                  "the screen come first.")
          .atLeast(0)
          .changing({&Changes::objects}),
      field<&Scene::probes>("probes", "", "A list of reflection probes, at most 10000.")
          .writtenAs("list of objects")
          .leftOut("none"),  // its own rows name the kinds of change
      field<&Scene::exposure>("exposure", "", "Factor on linear light before tone mapping and the curve of sRGB.")
          .within(0, 1e12)
          .usually(1e-6, 1e6)
          .changing({&Changes::exposure}),
      field<&Scene::tone>("tone", "",
                          "How light beyond a display's white is shown. Linear pictures, errors and explanations are "
                          "before it.")
          .choose({{"none", "it is white"},
                   {"neutral", "Khronos PBR Neutral: base colours stay, highlights are compressed towards white"},
                   {"agx", "AgX: a long shoulder, bright colours become white"},
                   {"aces", "the Academy's contrast, by Hill's fit"}})
          .changing({&Changes::exposure}),
      field<&Scene::background>("background", "", "What a picture shows where nothing stands; probes see the sky.")
          .choose({{"environment", "the sky"},
                   {"blurred", "the sky as a rough surface reflects it"},
                   {"plain", "a grey backdrop"},
                   {"color", "one colour, `backgroundColor`"}})
          .changing({&Changes::exposure}),
      field<&Scene::backgroundColor>(
          "backgroundColor", "", "What `color` shows, linear: the display's own colour, whatever exposure and tone.")
          .within(0, 1)
          .changing({&Changes::exposure}),
      field<&Scene::groundShadow>("groundShadow", "",
                                  "Everything together casts a soft shadow of the sky's light on a plane below it, in "
                                  "display colours only: no probe, mirror or linear picture shows it.")
          .changing({&Changes::exposure}),
      field<&Scene::ambientOcclusion>("ambientOcclusion", "",
                                      "What stands in the scene hides the sky from its own hollows and contacts, where "
                                      "the sky alone lights it; probes show it without.")
          .changing({&Changes::lights}),
      field<&Scene::energy>("energy", "",
                            "What becomes of light that meets more than one microfacet of a rough surface.")
          .choose({{"single", "it is lost: rough metals darken"},
                   {"multiple", "it is added back, of lamps and probes alike (Turquin 2019)"}})
          .changing({&Changes::lights}),
      field<&Scene::lamps>("lamps", "", "How shining objects light diffuse surfaces.")
          .choose({{"in-map", "from the probe's map, alike all over its box"},
                   {"shapes", "flat lamps by their shapes, everything else by a lattice in the box"}})
          .changing({&Changes::lights}),
  };
  return rows;
}

const std::vector<FieldRow<ModelFile>>& modelFields() {
  static const std::vector<FieldRow<ModelFile>> rows = {
      field<&ModelFile::file>("file", "", "Model file: .glb, .gltf, .obj, .ply, .stl or .vtp.")
          .as(FieldKind::File)
          .require("add \"file\": \"NAME.glb\"")
          .notEmpty("name a model file"),
      field<&ModelFile::translation>("translation", "m", "Moves the model, last of all."),
      field<&ModelFile::rotationDegrees>("rotationDegrees", "°", "Turns the model about X, then Y, then Z.")
          .anyFinite(),
      field<&ModelFile::scale>("scale", "", "Scales the model, before it is turned.").above(0),
      field<&ModelFile::unit>("unit", "", "Length of one unit in the model file; glTF files are in metres.")
          .choose({{"m"}, {"cm"}, {"mm"}, {"in"}, {"ft"}}),
      field<&ModelFile::upAxis>("upAxis", "", "Axis that points up in the model file; the model is turned to +Y.")
          .choose({{"x"}, {"y"}, {"z"}}),
      field<&ModelFile::variant>("variant", "", "Name of one of a glTF file's material variants."),
      field<&ModelFile::time>("time", "s", "When a glTF file's animations are looked at.")
          .leftOut("at rest")
          .atLeast(0)
          .usually(0, 3600),
  };
  return rows;
}

const std::vector<FieldRow<SkyImage>>& skyImageFields() {
  static const std::vector<FieldRow<SkyImage>> rows = {
      field<&SkyImage::file>(
          "image", "", "Picture of linear radiance, .exr or .hdr: latitude-longitude, or a cube as a strip or a cross.")
          .as(FieldKind::File)
          .notEmpty("name an EXR or HDR file")
          .leftOut("none")
          .always(),
      field<&SkyImage::cubeView>("cubeView", "", "From where the faces of a cube in the image are seen.")
          .choose({{"outside", "as OpenGL and engines lay a cubemap out: right of +Z is +X"},
                   {"inside", "as in a photograph: right of +Z is -X, what a viewer in the middle has there"}}),
      field<&SkyImage::sun>("sun", "", "What becomes of a sun in the image, a small bright disc.")
          .choose({{"lamp", "it is drawn as a directional light, with its shadow, and taken out of the image"},
                   {"in-picture", "it stays in the image"}}),
  };
  return rows;
}

const std::vector<FieldRow<SkyColor>>& skyColorFields() {
  static const std::vector<FieldRow<SkyColor>> rows = {
      field<&SkyColor::color>("color", "", "The same radiance in every direction.").leftOut("none").always(),
  };
  return rows;
}

const std::vector<FieldRow<SkyGradient>>& skyGradientFields() {
  static const std::vector<FieldRow<SkyGradient>> rows = {
      field<&SkyGradient::top>("top", "", "Radiance straight up.").always(),
      field<&SkyGradient::horizon>("horizon", "", "Radiance at the horizon.").always(),
      field<&SkyGradient::ground>("ground", "", "Radiance straight down.").always(),
  };
  return rows;
}

const std::vector<FieldRow<Scene>>& anySkyFields() {
  static const std::vector<FieldRow<Scene>> rows = {
      field<&Scene::skyRotationDegrees>("rotationDegrees", "°",
                                        "Turns the sky about the vertical: 90 takes +Z to +X. Probes that clear to "
                                        "`open` follow without a capture.")
          .anyFinite()
          .usually(-360, 360)
          .changing({&Changes::sky}),
  };
  return rows;
}

const std::vector<FieldRow<Camera>>& cameraFields() {
  static const std::vector<FieldRow<Camera>> rows = {
      field<&Camera::position>("position", "m", "Where the camera stands.").always(),
      field<&Camera::target>("target", "m", "Point the camera looks at; not its own position.").always(),
      field<&Camera::up>("up", "", "Direction that points up in the picture; not along the view direction.")
          .as(FieldKind::Direction)
          .anyFinite(),
      field<&Camera::verticalFovDegrees>("verticalFovDegrees", "°", "Angle of view from bottom to top.")
          .between(0, 180),
      field<&Camera::parallelHeight>("parallelHeight", "m",
                                     "Height of the view of a parallel projection; 0 is a perspective view.")
          .atLeast(0),
  };
  return rows;
}

}  // namespace boxprobe
