#include "filters/math/technique/parameter_table.h"

namespace boxprobe {

const std::vector<ParameterRow>& parameterRows() {
  using Kind = ParameterKind;
  using Values = shading::TechniqueParameters;
  static const std::vector<ParameterRow> rows = {
      {"samples",
       "Samples",
       "",
       "Reflected rays per pixel, each one lookup.",
       Kind::WholeNumber,
       1,
       256,
       64,
       {},
       &Values::samples},
      {"total",
       "Rays in all",
       "",
       "Of an animated picture: rays per pixel of all frames that are averaged, which each ray's blur is made for. 0: "
       "of "
       "one frame, whose blur stays however many frames there are.",
       Kind::WholeNumber,
       0,
       65536,
       0,
       {},
       &Values::total},
      {"pattern",
       "Pattern",
       "",
       "How rays are spread: at random (white), evenly with fine-grained noise (blue), evenly with a shift per pixel "
       "(r2), or equally in every pixel (deterministic), which shows ghosts instead of noise.",
       Kind::Choice,
       0,
       0,
       1,
       {"white", "blue", "r2", "deterministic"},
       nullptr,
       &Values::pattern},
      {"animated",
       "Animated",
       "",
       "Draws a new pattern every frame and averages the frames.",
       Kind::Switch,
       0,
       0,
       0,
       {}},
      {"levelOffset",
       "Level offset",
       "",
       "Blurs each ray's lookup by its share of the lobe and the distance to what it hits.",
       Kind::Switch,
       0,
       0,
       0,
       {},
       nullptr,
       &Values::levelOffset},
      {"filtered",
       "Filtered",
       "",
       "Blurs each ray's lookup by the patch of wall it stands for: far less noise and error.",
       Kind::Switch,
       0,
       0,
       0,
       {},
       nullptr,
       &Values::filtered},
      {"sampling",
       "Sampling",
       "",
       "Distribution of the rays: the surface's lobe, or half of them from the probe's brightness, for small lights. "
       "Blurred rays find lights by themselves and come from the lobe alone.",
       Kind::Choice,
       0,
       0,
       0,
       {"ggx", "luminance"},
       nullptr,
       &Values::sampling},
      {"blur", "Blur", "", "Smooths the sampled picture, but not across different normals.", Kind::Switch, 0, 0, 0, {}},
      {"power",
       "Power",
       "",
       "Exponent of the Fresnel-like factor (1 - N.V)^power: the higher, the closer to grazing it sets in. Published: "
       "4; "
       "2 and 3 are cheaper forms.",
       Kind::Number,
       0.01,
       16,
       4,
       {},
       &Values::power},
      {"hardeningLength",
       "Hardening length",
       "m",
       "Distance from the surface to the reflected surface at which the reflection has its full roughness. Published: "
       "6.",
       Kind::Number,
       1e-6,  // a divisor, so never 0
       1e6,
       6,
       {},
       &Values::hardeningLength},
      {"fresnel",
       "Fresnel",
       "",
       "Factor towards grazing angles: the one above, or the surface's own Fresnel reflectance.",
       Kind::Choice,
       0,
       0,
       0,
       {"power", "surface"},
       nullptr,
       &Values::fresnel},
      {"curve",
       "Blur by roughness",
       "",
       "How blurred the reflection is at each roughness: the curve to the mip level. Own is what the levels were "
       "filtered for; the others show a mismatch.",
       Kind::Choice,
       0,
       0,
       0,
       {"own", "unity", "linear", "exact", "marmoset", "three-level"},
       nullptr,
       &Values::curve},
      {"steps",
       "Steps",
       "",
       "Lookups of the captured distances that refine the box's hit: 1 at the hit, 2 also on the way to it, 3 also "
       "behind it; from 4 on the most that following the ray through them may take: 24 are enough.",
       Kind::WholeNumber,
       1,
       256,
       3,
       {},
       &Values::steps},
      {"budget",
       "Error budget",
       "",
       "Largest accepted error, RMSE of (x/(1+x))^(1/2.2) as `boxprobe bench` measures it.",
       Kind::Number,
       0,
       1,
       0.04,
       {},
       &Values::budget},
  };
  return rows;
}

const ParameterRow* findParameter(std::string_view name) {
  for (const ParameterRow& row : parameterRows()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

shading::TechniqueParameters standardParameters() {
  shading::TechniqueParameters values{};
  for (const ParameterRow& row : parameterRows()) {
    if (row.number != nullptr) values.*row.number = static_cast<float>(row.standard);
    if (row.choice != nullptr) values.*row.choice = static_cast<int>(row.standard);
  }
  return values;
}

}  // namespace boxprobe
