// The rows of probes and their parts.
#include "filters/core/scene/scene_fields.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

const std::vector<FieldRow<Probe>>& probeFields() {
  static const std::vector<bool Changes::*> shape = {&Changes::probeShape};
  static const std::vector<bool Changes::*> technique = {&Changes::probeTechnique};
  static const std::vector<bool Changes::*> capture = {&Changes::probeCapture};
  static const std::vector<FieldRow<Probe>> rows = {
      field<&Probe::name>("name", "", "Name of the probe; each has its own.")
          .require("add \"name\": \"...\"")
          .changing({&Changes::probeList}),
      field<&Probe::origin>("origin", "m", "Where the cubemap is captured.")
          .usually(-1e7, 1e7)
          .always()
          .changing(capture),
      field<&Probe::box>("box", "", "Projection box: its faces belong on the walls of the room.")
          .writtenAs("object, below")
          .always()
          .changing(shape),
      field<&Probe::rotationDegrees>("rotationDegrees", "°", "Turns the box about its centre: X, then Y, then Z.")
          .anyFinite()
          .usually(-360, 360)
          .changing({&Changes::probeShape, &Changes::probeCapture}),
      field<&Probe::influence>("influence", "", "Box that the probe lights, in the frame of the projection box.")
          .writtenAs("object as `box`")
          .leftOut("the projection box")
          .changing(shape),
      field<&Probe::nearDistance>("near", "m", "Nothing nearer to the origin is captured.")
          .above(0)
          .endless()
          .usually(1e-4, 1e6)
          .changing(capture),
      field<&Probe::farDistance>("far", "m", "Nothing farther from the origin is captured; more than `near`.")
          .usually(1e-3, 1e7)
          .changing(capture),
      field<&Probe::clear>("clear", "", "What the probe holds where it sees no object.")
          .choose({{"sky", "the scene's sky, as the camera sees it"},
                   {"none", "nothing: other probes, or the sky, fill in"},
                   {"open", "the current sky shows through, not box-projected; it may change without a recapture"}})
          .writtenAs("`\"sky\"`, `\"none\"`, `\"open\"` or [r, g, b]")
          .changing(capture),
      field<&Probe::blendDistance>("blendDistance", "m",
                                   "Distance inside the influence box over which the probe's weight rises from 0 to 1.")
          .writtenAs("number or object, below")
          .usually(0, 1e7)
          .changing(shape),
      field<&Probe::importance>("importance", "", "Where probes overlap, the more important one takes its share first.")
          .usually(0, 1000)
          .changing(shape),
      field<&Probe::intensity>("intensity", "", "Factor on the probe's light; 1 is as captured.")
          .atLeast(0)
          .usually(0, 1000)
          .changing(shape),
      field<&Probe::projection>("projection", "",
                                "Off: looked up with the bare reflection vector, as if infinitely far away.")
          .changing(technique),
      field<&Probe::technique>("technique", "",
                               "How reflections are projected and evaluated: PROJECTION, EVALUATION or "
                               "PROJECTION+EVALUATION.")
          .changing(technique),
      field<&Probe::parameters>("parameters", "", "Settings of the technique by name.")
          .writtenAs("object, below")
          .changing(technique),
      field<&Probe::faceSize>("faceSize", "texels",
                              "Edge length of a cubemap face: larger is sharper and takes more memory.")
          .powersOfTwo(16, 2048)
          .changing(capture),
      field<&Probe::bounces>("bounces", "",
                             "Captures in turn, each with the last one's light; with 1, mirrors are black in their "
                             "own probe.")
          .within(1, 5)
          .choose({{"all", "until another changes the light they bring by less than 1 %, 16 at most"}})
          .writtenAs("whole number from 1 to 5, or `\"all\"`")
          .changing(capture),
      field<&Probe::mode>("mode", "", "Where the probe's light comes from.")
          .choose({{"baked", "captured when an input changes, and kept"},
                   {"realtime", "recaptured continuously, one face per frame; sees objects that move"},
                   {"custom", "not captured: `image` takes the capture's place"}})
          .changing(capture),
      field<&Probe::image>("image", "",
                           "Picture of the surroundings for mode `custom`: .exr or .hdr, or .png or .jpg with an "
                           "`encoding`.")
          .as(FieldKind::File)
          .leftOut("none")
          .changing(capture),
      field<&Probe::imageLayout>("imageLayout", "", "How the surroundings lie in the image.")
          .choose({{"auto", "by the file's attributes, shape or name"},
                   {"latlong", "latitude-longitude, 2:1"},
                   {"strip", "six faces in a row or column"},
                   {"cross", "4:3 or 3:4"},
                   {"six", "one file per face"}})
          .changing(capture),
      field<&Probe::cubeView>("cubeView", "", "From where the faces of a cube in the image are seen.")
          .choose({{"outside", "as OpenGL and engines lay a cubemap out: right of +Z is +X"},
                   {"inside", "as in a photograph: right of +Z is -X, what a viewer in the middle has there"}})
          .changing(capture),
      field<&Probe::imageRotationDegrees>("imageRotationDegrees", "°",
                                          "Turns the image about the vertical, as `rotationDegrees` of the sky does: "
                                          "90 takes +Z to +X.")
          .anyFinite()
          .usually(-360, 360)
          .changing(capture),
      field<&Probe::encoding>("encoding", "", "How the image's texels hold radiance.")
          .choose({{"linear", "radiance as it is: .exr, .hdr"},
                   {"rgbm", "multiplier * M^exponent * colour, M in alpha, colour bytes sRGB: Unity's RGBM"},
                   {"dldr", "multiplier * colour, colour bytes sRGB: Unity's double LDR"},
                   {"rgbmLinear", "as `rgbm`, the colour bytes linear"}})
          .changing(capture),
      field<&Probe::decode>("decode", "", "Decode instruction of the encoding: multiplier and exponent.")
          .writtenAs("[multiplier, exponent]")
          .leftOut("[34.493242, 2.2] for rgbm, [4.594793, 1] for dldr, [5, 1] for rgbmLinear")
          .changing(capture),
      field<&Probe::filter>("filter", "", "How mip levels for rough surfaces are made from the capture.")
          .choose({{"ggx", "as the renderer's rough surfaces reflect"},
                   {"gaussian", "an angular Gaussian of CubeMapGen's widths: a soft, frosted look"}})
          .changing(capture),
      field<&Probe::samplesPerPixel>("samplesPerPixel", "",
                                     "Samples per captured texel: smoother edges, longer "
                                     "capture.")
          .oneOf({1, 4, 16})
          .changing(capture),
      field<&Probe::filterSamples>("filterSamples", "",
                                   "Filter samples per texel at mip level 1, doubled with each level: smoother around "
                                   "lamps, longer filtering.")
          .within(kMinSamples, kMaxSamples)
          .changing(capture),
      field<&Probe::hides>("hides", "", "Nodes this probe does not see, such as an object at its origin.")
          .changing(capture),
      field<&Probe::bevel>("bevel", "m",
                           "Rounds the edges of the projection box, so that reflections turn a corner "
                           "instead of breaking at it.")
          .writtenAs("number or object, below")
          .leftOut("sharp edges")
          .changing(shape),
      field<&Probe::occlusion>("occlusion", "",
                               "Darkens near reflections by mix(1, clamp(multiplier * d^power, 0, 1), strength), d "
                               "metres along the reflected ray. A look; it makes no picture truer.")
          .writtenAs("object, below")
          .leftOut("none")
          .changing(shape),
      field<&Probe::lattice>(
          "lattice", "",
          "The nodes at which diffuse light is known; with `false` there are none, and the whole map "
          "lights every place alike.")
          .writtenAs("object, below, or `false`")
          .leftOut("nodes about 1 m apart, closer where light falls steeply")
          .changing(shape),
  };
  return rows;
}

const std::vector<FieldRow<Box>>& boxFields() {
  static const std::vector<FieldRow<Box>> rows = {
      field<&Box::min>("min", "m", "Least corner.").require("give both min and max").usually(-1e7, 1e7),
      field<&Box::max>("max", "m", "Greatest corner; no component less than that of `min`.")
          .require("give both min and max")
          .usually(-1e7, 1e7),
  };
  return rows;
}

const std::vector<FieldRow<BlendDistance>>& blendDistanceFields() {
  static const std::vector<FieldRow<BlendDistance>> rows = {
      field<&BlendDistance::min>("min", "m", "Distances inside the -x, -y and -z faces.")
          .atLeast(0)
          .always()
          .usually(0, 1e7),
      field<&BlendDistance::max>("max", "m", "Distances inside the +x, +y and +z faces.")
          .atLeast(0)
          .always()
          .usually(0, 1e7),
  };
  return rows;
}

const std::vector<FieldRow<ProbeLattice>>& latticeFields() {
  static const std::vector<FieldRow<ProbeLattice>> rows = {
      field<&ProbeLattice::spacing>(
          "spacing", "m",
          "Distance between the nodes, about: at least 2 and at most 16 of them stand along each "
          "axis.")
          .above(0)
          .always()
          .usually(0.01, 1e6),
  };
  return rows;
}

const std::vector<FieldRow<Bevel>>& bevelFields() {
  static const std::vector<FieldRow<Bevel>> rows = {
      field<&Bevel::radius>("radius", "m",
                            "Radius of the box's edges: reflections turn a corner instead of breaking at it; 0 is "
                            "sharp.")
          .atLeast(0)
          .usually(0, 1e7),
      field<&Bevel::fromRoughness>("fromRoughness", "m",
                                   "Radius added at roughness 1, in proportion to the roughness: rough surfaces show "
                                   "no edge.")
          .atLeast(0)
          .usually(0, 1e7),
  };
  return rows;
}

const std::vector<FieldRow<BoxOcclusion>>& occlusionFields() {
  static const std::vector<FieldRow<BoxOcclusion>> rows = {
      field<&BoxOcclusion::multiplier>("multiplier", "", "Openness at a distance of 1 m: 1 is fully open, 0.2 a fifth.")
          .atLeast(0)
          .usually(0, 1000),
      field<&BoxOcclusion::power>("power", "", "How fast it opens with distance: 1 in proportion, 0 not at all.")
          .atLeast(0)
          .usually(0, 16),
      field<&BoxOcclusion::strength>("strength", "", "Share of the darkening that is applied.").within(0, 1),
  };
  return rows;
}

}  // namespace boxprobe
