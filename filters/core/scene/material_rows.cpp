// The rows of changes to the models: materials, objects, planar mirrors.
#include "filters/core/scene/scene_fields.h"

namespace boxprobe {

const std::vector<FieldRow<MaterialOverride>>& materialFields() {
  using M = MaterialOverride;
  static const auto row = [](FieldRow<M> made) { return made.leftOut("the model's"); };
  static const std::vector<FieldRow<M>> rows = {
      row(field<&M::baseColor>("baseColor", "", "Base colour, multiplied by the texture.")),
      row(field<&M::metallic>("metallic", "", "0 is a dielectric, 1 a metal.").within(0, 1)),
      row(field<&M::roughness>("roughness", "", "Perceptual roughness as in glTF: 0 is a mirror, 1 is fully rough.")
              .within(0, 1)),
      row(field<&M::emissive>("emissive", "", "Radiance the surface emits.")),
      row(field<&M::normalScale>("normalScale", "", "Strength of the normal texture.")),
      row(field<&M::coat>("coat", "", "Strength of a clear coat.").within(0, 1)),
      row(field<&M::ior>("ior", "",
                         "Index of refraction: 1 bends nothing, water 1.33, glass 1.5, diamond 2.42. Below 1 the "
                         "surroundings are denser.")
              .above(0)
              // Diamond has the greatest index of common clear solids; some minerals reach 3.
              .usually(0.25, 4)),
      row(field<&M::transmission>("transmission", "",
                                  "Share of light that passes through the surface instead of being scattered: 1 is "
                                  "glass.")
              .within(0, 1)),
      row(field<&M::thickness>("thickness", "m",
                               "Length of the path inside, for the forms that do not find it; 0 makes a thin sheet.")
              .atLeast(0)
              .usually(0, 1e4)),
      row(field<&M::attenuationDistance>("attenuationDistance", "m",
                                         "Distance after which white light has `attenuationColor`; 0 absorbs nothing.")
              .atLeast(0)
              .usually(0, 1e6)),
      row(field<&M::attenuationColor>("attenuationColor", "",
                                      "What is left of white light after `attenuationDistance` (Beer's law).")
              .within(0, 1)),
      row(field<&M::thin>("thin", "", "A thin sheet: reflects on both sides, bends and absorbs nothing.")),
      row(field<&M::glass>("glass", "", "How the light's path through a transmissive material is found.")
              .choose({{"auto",
                        "`two-interface` where a shell describes the object, thin walls where it is hollow, "
                        "else `two-pass`"},
                       {"one-pass", "bent once, at the front, then looked up, as published"},
                       {"two-pass", "the same for the back faces, and the front faces blended over them, as published"},
                       {"two-interface", "followed through the object's shell, bent where it enters and leaves"}})),
  };
  return rows;
}

const std::vector<FieldRow<ObjectOverride>>& objectFields() {
  using O = ObjectOverride;
  static const std::vector<FieldRow<O>> rows = {
      field<&O::visible>("visible", "", "Drawn in the picture."),
      field<&O::seenByProbes>("seenByProbes", "",
                              "Captured by probes. With `visible` false: a stand-in that only reflections show."),
      field<&O::dynamic>("dynamic", "",
                         "It moves: baked probes leave it out, so moving it needs no recapture; planar mirrors show "
                         "it."),
      field<&O::probeUsage>("probeMode", "",
                            "Which probes light this object. Ray-traced reflections take all for `blend+sky`.")
          .choose({{"off", "none: the sky alone"},
                   {"simple", "one probe, no blending"},
                   {"blend", "a blend of probes"},
                   {"blend+sky", "a blend of probes, and of the sky where they fade out"}}),
      field<&O::weights>("weights", "", "Where the weights of probes are computed.")
          .choose({{"pixel", "at each pixel"},
                   {"object",
                    "once, from the share of its bounds inside a probe's influence box: cheaper, and wrong "
                    "for large objects"}}),
      field<&O::translation>("translation", "m", "Moves the object from where its model puts it.").usually(-1e7, 1e7),
      field<&O::rotationDegrees>("rotationDegrees", "°",
                                 "Turns the object about its node's origin: X, then Y, then Z of the world.")
          .anyFinite()
          .usually(-3600, 3600),
  };
  return rows;
}

const std::vector<FieldRow<PlanarMirror>>& mirrorFields() {
  static const std::vector<FieldRow<PlanarMirror>> rows = {
      field<&PlanarMirror::enabled>("enabled", "", "Off: the entry is kept and does nothing."),
      field<&PlanarMirror::maxRoughness>("maxRoughness", "",
                                         "A surface rougher than this has no mirrored picture and costs nothing.")
          .within(0, 1),
      field<&PlanarMirror::resolution>("resolution", "",
                                       "Texels of the mirrored picture per pixel of the screen, each way.")
          .within(0.1, 4),
  };
  return rows;
}

}  // namespace boxprobe
