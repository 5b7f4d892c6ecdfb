// MTL materials as metallic-roughness ones. The table of filters/io/README.md says what becomes of each statement.
#pragma once

#include <set>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/io/obj/mtl_file.h"
#include "filters/io/obj/mtl_pictures.h"

namespace boxprobe {

/// What stands in for materials that a file does not have: plastic of a light grey.
Material greyMaterial();
/// The same where the file has colours or a picture all the same: they multiply white. Without highlights, because most
/// such files are scans, whose colours have them already.
Material whiteMaterial();

/// The perceptual roughness of a microfacet lobe as wide as Blinn's of this shininess (Ns): its square, alpha, is
/// sqrt(2 / (shininess + 2)) (Walter et al. 2007).
float roughnessOfShininess(double shininess);

/// Converts a material; `leftOut` gets what has no place in the result.
Material materialOfMtl(const MtlMaterial& source, MtlPictures& pictures, std::set<std::string>& leftOut);

}  // namespace boxprobe
