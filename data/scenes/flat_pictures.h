// The pictures of `flat`: wood, cloth, plaster, tiles, books, paintings, and the sky outside. Each is painted by
// formula and tiles, but for books, leaf and paintings.
#pragma once

#include "data/scenes/composer.h"

namespace boxprobe::scenes {

Picture planksPicture();    ///< oak boards along u; 3 m by 3 m
Picture planksRoughness();  ///< the same boards; green is roughness
Picture plasterPicture();   ///< near white; 2 m
Picture grainPicture(const std::string& name, glm::dvec3 dark, glm::dvec3 light);  ///< along u; 1.2 m
Picture clothPicture();                                                            ///< near white, woven; 0.35 m
Picture rugPicture();                                                              ///< one rug, 2.6 m by 1.9 m
Picture glazedTiles();                                                             ///< tiles of 10 cm; 0.8 m
Picture glazedTilesRoughness();                                                    ///< green is roughness
Picture terrazzoPicture();                                                         ///< 0.8 m
Picture leafPicture();
constexpr int kBookKinds = 32;
Picture booksPicture();              ///< kBookKinds columns, each a back of a book; the lowest eighth is paper
Picture paintingPicture(int which);  ///< 0 to 3, 4:5 upright; 3 is 3:2

}  // namespace boxprobe::scenes
