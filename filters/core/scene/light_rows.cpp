// The rows of lights.
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

const std::vector<FieldRow<Light>>& lightFields() {
  using Type = LightType;
  static const std::vector<FieldRow<Light>> rows = {
      field<&Light::type>("type", "", "Kind of light.")
          .choose({{"directional", "parallel light, such as the sun's"},
                   {"point", "shines in every direction"},
                   {"spot", "shines in a cone"}})
          .require("add \"type\": \"directional\", \"point\" or \"spot\""),
      field<&Light::direction>("direction", "", "Direction the light travels in; any length.")
          .as(FieldKind::Direction)
          .anyFinite()
          .usually(-1e6, 1e6)
          .ofTypes({Type::Directional, Type::Spot}, "position")
          .always(),
      field<&Light::position>("position", "m", "Where the light stands.")
          .usually(-1e6, 1e6)
          .ofTypes({Type::Point, Type::Spot}, "direction")
          .always(),
      field<&Light::color>("color", "", "Colour of the light, multiplied by its intensity."),
      field<&Light::intensity>("intensity", "",
                               "Directional: irradiance at normal incidence. Others: radiant intensity; irradiance "
                               "falls with the square of the distance.")
          .atLeast(0)
          .usually(0, 1e6),
      field<&Light::innerConeDegrees>("innerConeDegrees", "°",
                                      "Half angle of the cone within which the light is at full strength; less than "
                                      "`outerConeDegrees`.")
          .within(0, 90)
          .ofTypes({Type::Spot}),
      field<&Light::outerConeDegrees>("outerConeDegrees", "°", "Half angle of the cone beyond which it is dark.")
          .within(0, 90)
          .ofTypes({Type::Spot}),
      field<&Light::range>("range", "m", "Distance at which the light has faded to nothing; 0 is no limit.")
          .atLeast(0)
          .ofTypes({Type::Point, Type::Spot}),
      field<&Light::shadows>("shadows", "",
                             "What blocks the light where it stands outside of a probe's box. Ray-traced reflections "
                             "trace it, but for `none`.")
          .choose({{"none",
                    "nothing that it is told of: where lamps are shapes, what stands still shadows it by itself; with "
                    "lamps "
                    "in the map it shines through walls"},
                   {"coverage", "what the probe saw in the light's direction"},
                   {"coverage+map", "the same, and a shadow map of the objects that move"}}),
      field<&Light::angleDegrees>("angleDegrees", "°",
                                  "Whole angle its disc is seen under, which softens shadows; the sun's is 0.53.")
          .within(0, 90)
          .ofTypes({Type::Directional}, "radius"),
      field<&Light::radius>("radius", "m", "Radius of the light's sphere, which softens shadows.")
          .atLeast(0)
          .usually(0, 1e4)
          .ofTypes({Type::Point, Type::Spot}, "angleDegrees"),
      field<&Light::shadowLevel>("shadowLevel", "", "What chooses the mip level of the coverage: the softness.")
          .choose({{"size", "the light's size as seen from the surface"},
                   {"distance", "in proportion to the distance to the wall, as published"}}),
      field<&Light::levelsPerUnit>("levelsPerUnit", "1/m",
                                   "Mip levels per metre for `distance`; 0 spreads all levels over the longest "
                                   "distance in the probe's box.")
          .atLeast(0)
          .usually(0, 100),
  };
  return rows;
}

}  // namespace boxprobe
