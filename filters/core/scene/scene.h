// A scene as plain values: what a *.boxprobe.json file holds, after defaults. Read by every layer above; knows neither
// VTK nor Qt nor files. Frames: everything is world space, right-handed, +Y up; lengths are scene units (metres for
// glTF), angles degrees, colours linear.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

struct Model;

/// What one unit of a model file is, in metres (which a scene's lengths are): glTF says metres, other formats nothing.
enum class LengthUnit { Metre, Centimetre, Millimetre, Inch, Foot };
/// Which way a model file takes for up; it is turned so that this becomes +Y.
enum class UpAxis { X, Y, Z };

/// A model file and where it stands. The transform (units and up axis, then scale, then rotation X then Y then Z, then
/// translation) stays in double so that a scene far from the origin keeps its precision.
struct ModelFile {
  std::string file;  ///< absolute, or relative to the working directory once loaded
  glm::dvec3 translation{0.0};
  glm::dvec3 rotationDegrees{0.0};
  double scale = 1.0;
  LengthUnit unit = LengthUnit::Metre;
  UpAxis upAxis = UpAxis::Y;
  std::string variant = {};         ///< of a glTF file's materials; empty: its own
  std::optional<double> time = {};  ///< of a glTF file's animations, seconds; none: at rest
  bool operator==(const ModelFile&) const;
};

/// Radiance the same in every direction.
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
/// Latitude-longitude image (EXR or HDR), linear radiance.
struct SkyImage {
  std::string file;
  bool operator==(const SkyImage&) const;
};
using Sky = std::variant<SkyGradient, SkyColor, SkyImage>;

struct Camera {
  std::string name = "main";
  glm::dvec3 position{0.0, 1.6, 5.0};
  glm::dvec3 target{0.0, 1.0, 0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double verticalFovDegrees = 45.0;
  double parallelHeight = 0.0;  ///< above 0: parallel projection of so many scene units from top to bottom
  bool operator==(const Camera&) const;
};

enum class LightType { Directional, Point, Spot };
/// What stands between a light outside of a probe's box and what it shines on.
enum class LightShadows {
  None,            ///< nothing: the light goes through walls
  Coverage,        ///< what the probe saw in the light's direction, for what does not move
  CoverageAndMap,  ///< and a shadow map of the objects that do
};
/// What makes a shadow's edge soft.
enum class ShadowLevel {
  Size,      ///< the light's size as seen from the surface
  Distance,  ///< levels in proportion to the distance to the wall, whatever the light's size
};
struct Light {
  LightType type = LightType::Directional;
  glm::dvec3 direction{0.0, -1.0, 0.0};  ///< directional, spot: the way the light travels; need not be unit length
  glm::dvec3 position{0.0};              ///< point, spot
  glm::vec3 color{1.0f};
  float intensity = 1.0f;  ///< directional: irradiance at normal incidence; else radiant intensity, falls with 1/d²
  double innerConeDegrees = 0.0;   ///< spot: half the angle within which it is whole
  double outerConeDegrees = 45.0;  ///< spot: half the angle beyond which it is dark, above the inner one, at most 90
  double range = 0.0;              ///< not directional: fades to nothing towards it; 0: never
  LightShadows shadows = LightShadows::None;
  double angleDegrees = 0.53;  ///< directional: the whole angle its disc is seen under, the sun's by default
  double radius = 0.05;        ///< not directional: of its sphere, scene units
  ShadowLevel shadowLevel = ShadowLevel::Size;
  double levelsPerUnit = 0.0;  ///< of ShadowLevel::Distance; 0: all levels over the longest distance in the box
  bool operator==(const Light&) const;
};

/// How a material that transmits light is drawn.
enum class GlassForm {
  Automatic,     ///< TwoInterface where its shell describes the object, thin walls where it is hollow, else TwoPass
  OnePass,       ///< bent once, at the front, then looked up
  TwoPass,       ///< the same of the back faces first, and the front faces blended over them
  TwoInterface,  ///< followed through the object: bent at the front and where it leaves, mirrored within
};

/// Overrides of a glTF material by its name; what is left out keeps the model's value.
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

enum class ProbeUsage { Off, Simple, Blend, BlendAndSky };  ///< of an object: which probes it uses
enum class WeightMode { Pixel, Object };

/// Overrides of a glTF node by its name.
struct ObjectOverride {
  bool visible = true;
  bool seenByProbes = true;
  bool dynamic = false;  ///< moves: baked probes leave it out, so that its movement does not undo them
  ProbeUsage probeUsage = ProbeUsage::BlendAndSky;
  WeightMode weights = WeightMode::Pixel;
  /// On top of where its model puts it: turned about its node's own origin, then moved. World axes, in double.
  glm::dvec3 translation{0.0};
  glm::dvec3 rotationDegrees{0.0};
  bool operator==(const ObjectOverride&) const;
};

/// A planar mirror for objects that move, by glTF node name: a picture through a mirrored camera of dynamic objects
/// alone, over what the probes reflect.
struct PlanarMirror {
  bool enabled = true;
  double maxRoughness = 0.3;  ///< rougher than this all over, it has no picture
  double resolution = 1.0;    ///< texels of its picture a pixel of the screen, each way
  bool operator==(const PlanarMirror&) const;
};

/// Axis-aligned in the probe's own frame: `min` and `max` are offsets in world units along the box's axes as if it were
/// not rotated; a rotation turns the box about its centre.
struct Box {
  glm::dvec3 min{-1.0};
  glm::dvec3 max{1.0};
  glm::dvec3 center() const { return 0.5 * (min + max); }
  glm::dvec3 size() const { return max - min; }
  bool operator==(const Box&) const;
};

/// Distance inside each face over which a probe's weight rises from 0 to 1.
struct BlendDistance {
  glm::dvec3 min{1.0};
  glm::dvec3 max{1.0};
  bool operator==(const BlendDistance&) const;
};

enum class ProbeMode {
  Baked,     ///< kept until an input of its capture changes
  Realtime,  ///< follows what it shows, objects that move included, one face per frame
  Custom,    ///< filtered from a picture
};
/// How the six faces lie in a picture of the surroundings.
enum class CubeLayout {
  Automatic,  ///< by the envmap attribute, else by the picture's shape, else by the names of six files
  LatLong,    ///< 2:1
  Strip,      ///< 6:1 or 1:6, faces in OpenEXR's order if the file says envmap = cube, else OpenGL's
  Cross,      ///< 4:3 horizontal or 3:4 vertical
  SixFiles,   ///< one file per face
};
/// What a texel of a custom probe's picture stands for; with the instruction (multiplier, exponent) of `decode`.
enum class ImageEncoding {
  Linear,      ///< radiance as it is: EXR, HDR
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
/// Nothing, as none, but the sky shows through wherever it is looked up, as it is by then.
struct ClearToOpen {
  bool operator==(const ClearToOpen&) const { return true; }
};
using Clear = std::variant<ClearToSky, ClearToNone, glm::vec3, ClearToOpen>;
using ParameterValue = std::variant<double, bool, std::string>;

/// Edges of the projection box rounded by a radius in scene units: `radius`, plus `fromRoughness` times the roughness.
struct Bevel {
  double radius = 0.0;
  double fromRoughness = 0.0;
  bool operator==(const Bevel&) const;
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
  std::optional<Box> influence;  ///< left out: the projection box
  double nearDistance = 0.01;
  double farDistance = 1000.0;
  Clear clear = ClearToSky{};
  BlendDistance blendDistance;
  double importance = 1.0;
  double intensity = 1.0;
  bool projection = true;  ///< false: looked up with the bare reflection vector, as `infinite`
  std::string technique = "box";
  std::map<std::string, ParameterValue> parameters;
  int faceSize = 256;  ///< texels, a power of two from 16 to 2048
  int bounces = 1;     ///< 1 to 5
  ProbeMode mode = ProbeMode::Baked;
  std::string image;  ///< custom mode
  CubeLayout imageLayout = CubeLayout::Automatic;
  ImageEncoding encoding = ImageEncoding::Linear;
  std::optional<glm::dvec2> decode;  ///< multiplier and exponent; left out: what the encoding usually has
  FilterKind filter = FilterKind::Ggx;
  int samplesPerPixel = 4;         ///< 1, 4 or 16
  int filterSamples = 64;          ///< directions for a texel of level 1 of the filtered chain, 8 to 768
  std::vector<std::string> hides;  ///< node names left out of this probe's capture
  std::optional<Bevel> bevel;
  std::optional<BoxOcclusion> occlusion;

  const Box& influenceBox() const { return influence ? *influence : box; }
  bool operator==(const Probe&) const;
};

/// What becomes of light that meets more than one microfacet of a rough surface.
enum class Energy {
  Single,    ///< it is lost
  Multiple,  ///< it is added back (Turquin 2019)
};

/// Where diffuse light of what shines comes from.
enum class LampForm {
  InMap,   ///< from a probe's map, as nine coefficients, the same all over its box
  Shapes,  ///< lamps from their shapes, the rest from a lattice in the box
};

/// What stands behind everything in a picture. Probes, reflections and linear pictures have the sky as it is.
enum class Background {
  Environment,  ///< the sky
  Blurred,      ///< the sky as a rough surface reflects it
  Plain,        ///< a grey backdrop, brighter in the middle
  Color,        ///< one colour, Scene::backgroundColor
};

struct Scene {
  std::vector<ModelFile> models;
  Sky sky;
  double skyRotationDegrees = 0.0;  ///< of what it shows, about +Y: 90 takes +Z to +X
  std::vector<Camera> cameras;      ///< in file order, names unique
  std::vector<Light> lights;
  std::map<std::string, MaterialOverride> materials;
  std::map<std::string, ObjectOverride> objects;
  std::map<std::string, PlanarMirror> mirrors;
  double mirrorBudget = 8.0e6;  ///< texels of all mirrors' pictures per frame, the largest on the screen first
  std::vector<Probe> probes;    ///< names unique
  double exposure = 1.0;        ///< factor on linear light before tone mapping and the display's curve
  Tone tone = Tone::None;
  Background background = Background::Environment;
  glm::vec3 backgroundColor{0.6f};  ///< linear, 0 to 1; shown as it is, whatever the exposure
  bool groundShadow = false;        ///< below everything, on the picture alone
  bool ambientOcclusion = false;    ///< what stands in the scene hides the sky from itself
  Energy energy = Energy::Single;
  LampForm lamps = LampForm::Shapes;

  bool operator==(const Scene&) const;
};

/// Index of the probe of that name, or nothing.
std::optional<std::size_t> findProbe(const Scene& scene, const std::string& name);

/// `stem`, or `stem 2`, `stem 3`, ... : the first that no probe has.
std::string unusedProbeName(const Scene& scene, const std::string& stem);

/// What the scene asks for that this version accepts but does not do yet, and what it asks for in vain (a flat box, an
/// image that nothing uses): one sentence each, the key path first; for `info` and warnings.
std::vector<std::string> featuresNotUsed(const Scene& scene);

/// Overrides and `hides` entries that name no material or node of the models: one sentence each, with the nearest name.
std::vector<std::string> unmatchedOverrides(const Scene& scene, const std::vector<const Model*>& models);

/// Throws InputError (a FieldError) whose text starts with the key path ("probes.room.box: ...") at the first value out
/// of its range: non-finite numbers, box with min > max, duplicate or empty names, unknown technique, sizes and counts
/// out of range.
void validate(const Scene& scene);

}  // namespace boxprobe
