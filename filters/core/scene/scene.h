// A scene as plain values: the contents of a *.boxprobe.json file, with defaults filled in. Frames: everything is in
// world space, right-handed, +Y up; lengths are scene units (metres for glTF), angles degrees, colours linear.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <variant>
#include <vector>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

struct Model;

/// The length in metres of one unit of a model file: glTF prescribes metres, other formats nothing.
enum class LengthUnit { Metre, Centimetre, Millimetre, Inch, Foot };
/// The up axis of a model file; models are rotated so that it becomes +Y.
enum class UpAxis { X, Y, Z };

/// A model file and its placement. The transform (units and up axis, then scale, then rotation X then Y then Z, then
/// translation) is kept in double, so that a scene far from the origin keeps its precision.
struct ModelFile {
  std::string file;  ///< absolute or, once loaded, relative to the working directory
  glm::dvec3 translation{0.0};
  glm::dvec3 rotationDegrees{0.0};
  double scale = 1.0;
  LengthUnit unit = LengthUnit::Metre;
  UpAxis upAxis = UpAxis::Y;
  std::string variant = {};         ///< variant of a glTF file's materials; empty: its defaults
  std::optional<double> time = {};  ///< time in a glTF file's animations, seconds; none: the rest pose
  bool operator==(const ModelFile&) const;
};

/// The same radiance in every direction.
struct SkyColor {
  glm::vec3 color{0.0f};
  bool operator==(const SkyColor&) const;
};
/// Radiance by elevation: horizon to top above, horizon to ground below, linear in the direction's y.
struct SkyGradient {
  glm::vec3 top{0.30f, 0.45f, 0.70f};
  glm::vec3 horizon{0.75f, 0.82f, 0.90f};
  glm::vec3 ground{0.18f, 0.17f, 0.16f};
  bool operator==(const SkyGradient&) const;
};
/// From where the faces of a cube in a picture are seen: the picture of one is the other's mirrored.
enum class CubeView {
  Outside,  ///< as OpenGL, Unity and CubeMapGen lay a cubemap out: right of +Z is +X
  Inside,   ///< as a viewer in its middle sees it, photographs: right of +Z is -X
};
/// What becomes of a sun in a picture of the surroundings.
enum class SkySunForm {
  Lamp,       ///< taken out of the picture and drawn as a directional light of its energy, direction and width
  InPicture,  ///< stays; what half floats cannot hold is spread over the directions around it
};
/// Image of the surroundings (EXR or HDR), linear radiance: latitude-longitude, or a cube.
struct SkyImage {
  std::string file;
  CubeView cubeView = CubeView::Outside;  ///< of a cube
  SkySunForm sun = SkySunForm::Lamp;
  bool operator==(const SkyImage&) const;
};
using Sky = std::variant<SkyGradient, SkyColor, SkyImage>;

struct Camera {
  std::string name = "main";
  glm::dvec3 position{0.0, 1.6, 5.0};
  glm::dvec3 target{0.0, 1.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double verticalFovDegrees = 45.0;
  double parallelHeight = 0.0;  ///< above 0: parallel projection; scene units from the picture's bottom to its top
  bool operator==(const Camera&) const;
};

enum class LightType { Directional, Point, Spot };
/// What blocks a light outside a probe's box.
enum class LightShadows {
  None,            ///< nothing: the light passes through walls
  Coverage,        ///< for static objects: what the probe saw in the light's direction
  CoverageAndMap,  ///< and a shadow map of moving objects
};
/// What makes a shadow's edge soft.
enum class ShadowLevel {
  Size,      ///< the light's size as seen from the surface
  Distance,  ///< the distance to the wall alone: levels are proportional to it
};
struct Light {
  LightType type = LightType::Directional;
  glm::dvec3 direction{0.0, -1.0, 0.0};  ///< directional, spot: the way the light travels; need not be unit length
  glm::dvec3 position{0.0};              ///< point, spot
  glm::vec3 color{1.0f};
  float intensity = 1.0f;  ///< directional: irradiance at normal incidence; else radiant intensity, falls with 1/d²
  double innerConeDegrees = 0.0;   ///< spot: half the angle of full intensity
  double outerConeDegrees = 45.0;  ///< spot: half the angle beyond which it is dark; above the inner one, at most 90
  double range = 0.0;              ///< not directional: the light fades to 0 towards it; 0: unlimited
  LightShadows shadows = LightShadows::None;
  double angleDegrees = 0.53;  ///< directional: apparent diameter of its disc; the default is the sun's
  double radius = 0.05;        ///< not directional: of its sphere, scene units
  ShadowLevel shadowLevel = ShadowLevel::Size;
  double levelsPerUnit = 0.0;  ///< of ShadowLevel::Distance; 0: all levels over the longest distance in the box
  bool operator==(const Light&) const;
};

/// How a light-transmitting material is drawn.
enum class GlassForm {
  Automatic,     ///< TwoInterface where its shell describes the object, thin walls where it is hollow, else TwoPass
  OnePass,       ///< refracted once, at the front, then looked up
  TwoPass,       ///< the same for the back faces first, with the front faces blended over them
  TwoInterface,  ///< followed through the object: refracted at the front and at the exit, reflected inside
};

/// Overrides of a glTF material by its name; values left out keep the model's.
struct MaterialOverride {
  std::optional<glm::vec3> baseColor;
  std::optional<float> metallic, roughness;
  std::optional<glm::vec3> emissive;
  std::optional<float> normalScale, coat, ior, transmission;
  std::optional<float> thickness, attenuationDistance;  ///< scene units
  std::optional<glm::vec3> attenuationColor;
  std::optional<bool> thin;
  std::optional<GlassForm> glass;
  bool operator==(const MaterialOverride&) const;
};

enum class ProbeUsage { Off, Simple, Blend, BlendAndSky };  ///< which probes an object uses
enum class WeightMode { Pixel, Object };

/// Overrides of a glTF node by its name.
struct ObjectOverride {
  bool visible = true;
  bool seenByProbes = true;
  bool dynamic = false;  ///< moves: baked probes leave it out, so that its movement does not make them stale
  ProbeUsage probeUsage = ProbeUsage::BlendAndSky;
  WeightMode weights = WeightMode::Pixel;
  /// Applied after the model's placement: rotated about its node's origin, then moved. World axes, in double.
  glm::dvec3 translation{0.0};
  glm::dvec3 rotationDegrees{0.0};
  bool operator==(const ObjectOverride&) const;
};

/// A planar mirror for moving objects, by glTF node name: a picture of dynamic objects alone through a mirrored camera,
/// over the probes' reflections.
struct PlanarMirror {
  bool enabled = true;
  double maxRoughness = 0.3;  ///< if it is rougher than this everywhere, no picture is drawn
  double resolution = 1.0;    ///< texels of its picture per screen pixel, along each axis
  bool operator==(const PlanarMirror&) const;
};

/// Axis-aligned in the probe's own frame: `min` and `max` are world-unit offsets along the box's axes as if it were not
/// rotated; a rotation turns the box about its centre.
struct Box {
  glm::dvec3 min{-1.0};
  glm::dvec3 max{1.0};
  glm::dvec3 center() const { return 0.5 * (min + max); }
  glm::dvec3 size() const { return max - min; }
  bool operator==(const Box&) const;
};

/// The distance inside each face over which a probe's weight rises from 0 to 1.
struct BlendDistance {
  glm::dvec3 min{1.0};
  glm::dvec3 max{1.0};
  bool operator==(const BlendDistance&) const;
};

enum class ProbeMode {
  Baked,     ///< kept until an input of its capture changes
  Realtime,  ///< recaptured continuously, one face per frame; shows moving objects
  Custom,    ///< filtered from a picture file
};
/// The layout of the six faces in a picture of the surroundings.
enum class CubeLayout {
  Automatic,  ///< from the envmap attribute, else the picture's shape, else the names of six files
  LatLong,    ///< 2:1
  Strip,      ///< 6:1 or 1:6; faces in OpenEXR's order if the file says envmap = cube, else in OpenGL's
  Cross,      ///< 4:3 horizontal or 3:4 vertical
  SixFiles,   ///< one file per face
};
/// The encoding of a custom probe's picture; used with the instruction (multiplier, exponent) of `decode`.
enum class ImageEncoding {
  Linear,      ///< linear radiance: EXR, HDR
  Rgbm,        ///< 8 bits; multiplier * M^exponent * colour, colour bytes sRGB, M in alpha: Unity's RGBM textures
  Dldr,        ///< 8 bits; multiplier * colour, colour bytes sRGB, alpha unused: Unity's double LDR
  RgbmLinear,  ///< as Rgbm, with linear colour bytes
};
enum class FilterKind { Ggx, Gaussian };
/// What a probe holds where it saw nothing.
struct ClearToSky {
  bool operator==(const ClearToSky&) const { return true; }
};
struct ClearToNone {
  bool operator==(const ClearToNone&) const { return true; }
};
/// Nothing; lookups there show the current sky, which is not box-projected.
struct ClearToOpen {
  bool operator==(const ClearToOpen&) const { return true; }
};
using Clear = std::variant<ClearToSky, ClearToNone, glm::vec3, ClearToOpen>;
using ParameterValue = std::variant<double, bool, std::string>;

/// Rounded edges of the projection box: the radius in scene units is `radius` plus `fromRoughness` times the roughness.
struct Bevel {
  double radius = 0.0;
  double fromRoughness = 0.0;
  bool operator==(const Bevel&) const;
};

/// Where a probe knows its diffuse light: at the nodes of a lattice, between which it is blended.
struct ProbeLattice {
  bool used = true;      ///< false: the light of the whole map everywhere
  double spacing = 1.0;  ///< of the nodes, about, > 0, scene units
  bool operator==(const ProbeLattice&) const;
};

/// Darkening by hit distance d: mix(1, saturate(multiplier * d^power), strength).
struct BoxOcclusion {
  double multiplier = 1.0;
  double power = 1.0;
  double strength = 1.0;
  bool operator==(const BoxOcclusion&) const;
};

struct Probe {
  std::string name = "probe";
  glm::dvec3 origin{0.0};  ///< capture origin
  Box box;                 ///< projection (proxy) box
  glm::dvec3 rotationDegrees{0.0};
  std::optional<Box> influence;  ///< empty: the projection box
  double nearDistance = 0.01;
  double farDistance = 1000.0;
  Clear clear = ClearToSky{};
  BlendDistance blendDistance;
  double importance = 1.0;
  double intensity = 1.0;
  bool projection = true;  ///< false: sampled with the bare reflection vector, as by `infinite`
  std::string technique = "box";
  std::map<std::string, ParameterValue> parameters;
  int faceSize = 256;  ///< texels, a power of two from 16 to 2048
  int bounces = 1;     ///< 1 to 5
  ProbeMode mode = ProbeMode::Baked;
  std::string image;  ///< custom mode
  CubeLayout imageLayout = CubeLayout::Automatic;
  CubeView cubeView = CubeView::Outside;  ///< of an image that is a cube
  double imageRotationDegrees = 0.0;      ///< rotation of the image about +Y: 90 takes +Z to +X
  ImageEncoding encoding = ImageEncoding::Linear;
  std::optional<glm::dvec2> decode;  ///< multiplier and exponent; empty: the encoding's usual ones
  FilterKind filter = FilterKind::Ggx;
  int samplesPerPixel = 4;         ///< 1, 4 or 16
  int filterSamples = 64;          ///< samples per texel of level 1 of the filtered chain, 8 to 768
  std::vector<std::string> hides;  ///< names of nodes left out of this probe's capture
  std::optional<Bevel> bevel;
  std::optional<BoxOcclusion> occlusion;
  std::optional<ProbeLattice> lattice;  ///< empty: nodes a metre apart, and half of it where light falls steeply

  const Box& influenceBox() const { return influence ? *influence : box; }
  bool hasLattice() const { return !lattice || lattice->used; }
  bool operator==(const Probe&) const;
};

/// The fate of light that meets more than one microfacet of a rough surface.
enum class Energy {
  Single,    ///< lost
  Multiple,  ///< added back (Turquin 2019)
};

/// The source of diffuse light from lamps.
enum class LampForm {
  InMap,   ///< a probe's map, as nine coefficients that apply all over its box
  Shapes,  ///< lamps from their shapes, the rest from a lattice in the box
};

/// What is behind everything in a picture. Probes, reflections and linear pictures always have the sky.
enum class Background {
  Environment,  ///< the sky
  Blurred,      ///< the sky as a rough surface reflects it
  Plain,        ///< a grey backdrop, brighter in the middle
  Color,        ///< one colour, Scene::backgroundColor
};

struct Scene {
  std::vector<ModelFile> models;
  Sky sky;
  double skyRotationDegrees = 0.0;  ///< rotation of the sky about +Y: 90 takes +Z to +X
  std::vector<Camera> cameras;      ///< in file order, names unique
  std::vector<Light> lights;
  std::map<std::string, MaterialOverride> materials;
  std::map<std::string, ObjectOverride> objects;
  std::map<std::string, PlanarMirror> mirrors;
  double mirrorBudget = 8.0e6;  ///< texels of all mirrors' pictures per frame; the largest on screen come first
  std::vector<Probe> probes;    ///< names unique
  double exposure = 1.0;        ///< factor of linear light before tone mapping and the display's transfer curve
  Tone tone = Tone::None;
  Background background = Background::Environment;
  glm::vec3 backgroundColor{0.6f};  ///< linear, 0 to 1; displayed as it is, whatever the exposure
  bool groundShadow = false;        ///< below everything, in the picture only
  bool ambientOcclusion = false;    ///< the scene occludes its own sky
  Energy energy = Energy::Single;
  LampForm lamps = LampForm::Shapes;

  bool operator==(const Scene&) const;
};

/// Index of the probe of that name, or nothing.
std::optional<std::size_t> findProbe(const Scene& scene, const std::string& name);

/// Names for new probes of a scene. Many are named in linear time.
class ProbeNames {
 public:
  explicit ProbeNames(const Scene& scene);
  /// The first of `stem`, `stem 2`, `stem 3`, ... that no probe has; taken from then on.
  std::string take(const std::string& stem);

 private:
  std::unordered_set<std::string> taken_;
  std::unordered_map<std::string, std::size_t> next_;  ///< by stem: the first number not tried
};

/// The first of `stem`, `stem 2`, `stem 3`, ... that no probe has.
std::string unusedProbeName(const Scene& scene, const std::string& stem);

/// What the scene asks for that has no effect: features that this version accepts but does not implement, a flat box,
/// an image that nothing uses. One sentence each, the key path first; for `info` and warnings.
std::vector<std::string> featuresNotUsed(const Scene& scene);

/// Overrides and `hides` entries that name no material or node of the models: one sentence each, with the nearest name.
std::vector<std::string> unmatchedOverrides(const Scene& scene, const std::vector<const Model*>& models);

/// Throws InputError (a FieldError) whose text starts with the key path ("probes.room.box: ...") at the first value out
/// of range: non-finite numbers, box with min > max, duplicate or empty names, unknown technique, sizes and counts out
/// of range.
void validate(const Scene& scene);

}  // namespace boxprobe
