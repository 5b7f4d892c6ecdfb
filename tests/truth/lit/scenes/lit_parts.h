// What the lit scenes are put together from: surfaces that glTF and Cycles both express exactly, and rooms of thick
// walls. Called by the scenes; knows no file format.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "data/scenes/composer.h"

namespace boxprobe::scenes {

/// Lambert's law and nothing else: no specular reflection at any angle (KHR_materials_specular of 0).
Material lambert(const std::string& name, glm::vec3 albedo);
/// The picture repeats.
Material lambert(const std::string& name, const Picture& albedo);
/// Emits `radiance` and reflects nothing.
Material glow(const std::string& name, glm::vec3 radiance);
/// GGX with Schlick's Fresnel law from `f0` to white.
Material metal(const std::string& name, glm::vec3 f0, float roughness);
/// A dielectric of index 1.5 over black: its interface alone.
Material blackGloss(const std::string& name, float roughness);

/// A box as a node of its own.
void addBox(Composer& scene, const std::string& node, glm::dvec3 low, glm::dvec3 high, int material);
/// The same with the repeating picture once every `metres`.
void addTiledBox(Composer& scene, const std::string& node, glm::dvec3 low, glm::dvec3 high, double metres,
                 int material);
/// A mesh about the origin, turned about the vertical and put at `position`.
void addTurned(Composer& scene, const std::string& node, MeshBuilder builder, glm::dvec3 position, double degrees,
               int material);

/// A closed room: the inside is [low, high], the walls stand outside of it. Walls with holes are left out and added by
/// the scene; materials are indices, -1 leaves the wall out.
struct ThickRoom {
  glm::dvec3 low, high;
  double thick;
  int floor, ceiling, north, east, south, west;
  double floorMetres = 1.0, northMetres = 1.0;  ///< of their repeating pictures
};
void addRoom(Composer& scene, const ThickRoom& room);

}  // namespace boxprobe::scenes
