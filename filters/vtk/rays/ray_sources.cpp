// See ray_sources.h.
#include "filters/vtk/rays/ray_sources.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "filters/core/geometry/model_placement.h"
#include "filters/core/scene/material_override.h"
#include "filters/vtk/rays/ray_scene.h"
#include "filters/vtk/scene/model_actors.h"

namespace boxprobe {

struct RaySources::Part {
  std::string object;
  const Mesh* mesh = nullptr;
  glm::dmat4 worldFromModel{1.0};
  glm::dmat3 normalMatrix{1.0};
  bool cullsBackFaces = true;
  float roughness = 1.0f;
  const TextureUse* roughnessTexture = nullptr;
  int glass = -1;
  long long firstCell = 0;
};

struct RaySources::Triangle {
  const Part* part = nullptr;
  std::uint32_t index[3] = {};
  glm::dvec3 corner[3];    // world
  glm::dvec3 facing{0.0};  // towards the front; its length is twice the area
};

namespace {

// Limit of back faces that a ray passes.
constexpr int kMostPassedThrough = 64;
// How far above the line's own point a drop starts, relative to the scene's size, so that a line drawn on the floor
// finds the floor.
constexpr double kDropFrom = 1.0e-3;

double wrapped(double x, Wrap wrap) {
  if (wrap == Wrap::ClampToEdge) return std::clamp(x, 0.0, 1.0);
  const double whole = std::floor(x);
  const double rest = x - whole;
  const bool turned = wrap == Wrap::MirroredRepeat && std::fmod(std::abs(whole), 2.0) == 1.0;
  return turned ? 1.0 - rest : rest;
}

// The green channel of glTF's metallic-roughness texture, nearest texel.
float textureRoughness(const TextureUse& use, const glm::dvec2& uv) {
  const ImageRgba8& image = *use.image;
  if (image.width <= 0 || image.height <= 0 || !std::isfinite(uv.x) || !std::isfinite(uv.y)) return 1.0f;
  const auto index = [](double x, int size) { return std::min(static_cast<int>(x * size), size - 1); };
  const auto column = static_cast<std::size_t>(index(wrapped(uv.x, use.wrapS), image.width));
  const auto row = static_cast<std::size_t>(index(wrapped(uv.y, use.wrapT), image.height));
  return static_cast<float>(image.pixels[(row * static_cast<std::size_t>(image.width) + column) * 4 + 1]) / 255.0f;
}

// Barycentric coordinates of a point in the triangle's plane, by areas.
glm::dvec3 barycentric(const glm::dvec3 (&corner)[3], const glm::dvec3& facing, const glm::dvec3& p) {
  const double square = glm::dot(facing, facing);
  if (!(square > 0.0)) return {1.0, 0.0, 0.0};
  const double a = glm::dot(glm::cross(corner[2] - corner[1], p - corner[1]), facing) / square;
  const double b = glm::dot(glm::cross(corner[0] - corner[2], p - corner[2]), facing) / square;
  return {a, b, 1.0 - a - b};
}

}  // namespace

RaySources::RaySources(std::vector<std::shared_ptr<const Model>> models, const Scene& scene)
    : models_(std::move(models)) {
  long long cells = 0;
  for (std::size_t i = 0; i < models_.size() && i < scene.models.size(); ++i) {
    const Model& model = *models_[i];
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : model.instances) {
      if (const auto it = scene.objects.find(instance.node); it != scene.objects.end() && !it->second.visible) continue;
      Part part;
      part.object = instance.node;
      part.mesh = &model.meshes[static_cast<std::size_t>(instance.mesh)];
      part.worldFromModel = movedInstance(placement * instance.worldFromModel, scene, instance.node);
      part.normalMatrix = glm::transpose(glm::inverse(glm::dmat3(part.worldFromModel)));
      if (part.mesh->material >= 0) {
        const Material& material = model.materials[static_cast<std::size_t>(part.mesh->material)];
        part.cullsBackFaces = !material.doubleSided;
        part.roughness = material.roughness;
        if (material.metallicRoughnessTexture.image) part.roughnessTexture = &material.metallicRoughnessTexture;
        const auto it = scene.materials.find(material.name);
        if (it != scene.materials.end() && it->second.roughness) part.roughness = *it->second.roughness;
        const Material shown = overriddenMaterial(material, scene);
        if (shown.transmits()) {
          part.cullsBackFaces = false;
          part.glass = static_cast<int>(glass_.size());
          glass_.push_back({instance.node, {}});
          glass_.back().surface.apply(shown, *part.mesh, part.worldFromModel);
        }
      }
      part.firstCell = cells;
      cells += static_cast<long long>(part.mesh->indices.size() / 3);
      parts_.push_back(part);
    }
  }
}

RaySources::~RaySources() = default;

int RaySources::glassOf(const std::string& object) const {
  for (std::size_t i = 0; i < glass_.size(); ++i) {
    if (glass_[i].object == object) return static_cast<int>(i);
  }
  return -1;
}

std::vector<std::string> RaySources::objects() const {
  std::vector<std::string> names;
  for (const Part& part : parts_) {
    if (std::find(names.begin(), names.end(), part.object) == names.end()) names.push_back(part.object);
  }
  return names;
}

void RaySources::build() {
  if (scene_) return;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const vtkIdType first = points->GetNumberOfPoints();
    for (const glm::vec3& p : part.mesh->positions) {
      const glm::dvec4 world = part.worldFromModel * glm::dvec4(glm::dvec3(p), 1.0);
      points->InsertNextPoint(&world.x);
    }
    const std::vector<std::uint32_t>& indices = part.mesh->indices;
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
      cells->InsertNextCell({first + indices[k], first + indices[k + 1], first + indices[k + 2]});
      partOfCell_.push_back(static_cast<int>(i));
    }
  }
  triangles_ = vtkSmartPointer<vtkPolyData>::New();
  triangles_->SetPoints(points);
  triangles_->SetPolys(cells);
  scene_ = std::make_unique<RayScene>(triangles_);
}

vtkPolyData* RaySources::triangles() {
  build();
  return triangles_;
}

RaySources::Triangle RaySources::triangle(long long cell) const {
  Triangle t;
  t.part = &parts_[static_cast<std::size_t>(partOfCell_[static_cast<std::size_t>(cell)])];
  const auto first = static_cast<std::size_t>(3 * (cell - t.part->firstCell));
  for (std::size_t i = 0; i < 3; ++i) {
    t.index[i] = t.part->mesh->indices[first + i];
    t.corner[i] = glm::dvec3(t.part->worldFromModel * glm::dvec4(glm::dvec3(t.part->mesh->positions[t.index[i]]), 1.0));
  }
  t.facing = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
  return t;
}

// `seenAlong`: the view direction; a back face is seen with its normal reversed, as VTK shades it. Zero: from the
// front.
RaySample RaySources::sample(const Triangle& t, const glm::dvec3& b, const glm::dvec3& seenAlong) const {
  const Mesh& mesh = *t.part->mesh;
  RaySample s;
  s.object = t.part->object;
  s.positionWorld = b.x * t.corner[0] + b.y * t.corner[1] + b.z * t.corner[2];
  glm::dvec3 normal = t.facing;
  if (!mesh.normals.empty()) {
    normal = glm::dvec3(0.0);
    for (int i = 0; i < 3; ++i) normal += b[i] * glm::dvec3(mesh.normals[t.index[i]]);
    normal = t.part->normalMatrix * normal;
  }
  const double length = glm::length(normal);
  if (length > 0.0) s.normalWorld = normal / length;
  s.glass = t.part->glass;
  s.back = glm::dot(t.facing, seenAlong) > 0.0;
  if (s.back) s.normalWorld = -s.normalWorld;
  s.roughness = t.part->roughness;
  const TextureUse* use = t.part->roughnessTexture;
  if (use == nullptr) return s;
  const std::vector<glm::vec2>& set = use->uvSet == 1 ? mesh.uv1 : mesh.uv;
  if (!set.empty()) {
    glm::dvec2 uv(0.0);
    for (int i = 0; i < 3; ++i) uv += b[i] * glm::dvec2(set[t.index[i]]);
    s.roughness *= textureRoughness(*use, glm::dmat3x2(use->uvTransform) * glm::dvec3(uv, 1.0));
  }
  return s;
}

std::optional<RaySample> RaySources::under(const PixelRay& ray) {
  build();
  const double far = scene_->reachFrom(ray.originWorld);
  const double step = 1.0e-9 * (scene_->diagonal() + far);
  double from = 0.0;
  for (int i = 0; i < kMostPassedThrough; ++i) {
    const auto hit = scene_->firstHit(ray.originWorld, ray.direction, from, far);
    if (!hit) return std::nullopt;
    const Triangle t = triangle(hit->cell);
    const bool back = glm::dot(t.facing, ray.direction) > 0.0;
    if (!back || !t.part->cullsBackFaces) {
      return sample(t, barycentric(t.corner, t.facing, hit->positionWorld), ray.direction);
    }
    from = std::max(hit->distance, from) + step;
  }
  return std::nullopt;
}

std::vector<RaySample> RaySources::over(const std::string& object, int count) {
  build();
  std::vector<long long> cells;
  std::vector<double> areaUpTo;
  double area = 0.0;
  for (const Part& part : parts_) {
    if (part.object != object) continue;
    const auto end = part.firstCell + static_cast<long long>(part.mesh->indices.size() / 3);
    for (long long cell = part.firstCell; cell < end; ++cell) {
      area += 0.5 * glm::length(triangle(cell).facing);
      cells.push_back(cell);
      areaUpTo.push_back(area);
    }
  }
  std::vector<RaySample> samples;
  if (!(area > 0.0)) return samples;
  for (int i = 0; i < count; ++i) {
    // Equal area steps select the triangle, a two-dimensional golden-ratio sequence the place in it.
    const double target = area * (i + 0.5) / count;
    const auto found = std::lower_bound(areaUpTo.begin(), areaUpTo.end(), target);
    const long long cell = cells[static_cast<std::size_t>(std::min(found, areaUpTo.end() - 1) - areaUpTo.begin())];
    double u = std::fmod(0.5 + 0.7548776662466927 * i, 1.0), v = std::fmod(0.5 + 0.5698402909980532 * i, 1.0);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    samples.push_back(sample(triangle(cell), {1.0 - u - v, u, v}, glm::dvec3(0.0)));
  }
  return samples;
}

std::vector<RaySample> RaySources::alongLine(const glm::dvec3& fromWorld, const glm::dvec3& toWorld, int count,
                                             const glm::dvec3& drop) {
  build();
  std::vector<RaySample> samples;
  const double length = glm::length(drop);
  if (!(length > 0.0)) return samples;
  const glm::dvec3 direction = drop / length;
  for (int i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / (count - 1) : 0.5;
    const glm::dvec3 point = fromWorld + share * (toWorld - fromWorld);
    const PixelRay ray{point - kDropFrom * scene_->diagonal() * direction, direction};
    if (auto s = under(ray)) samples.push_back(*std::move(s));
  }
  return samples;
}

std::vector<RaySample> RaySources::screenGrid(const PixelRays& rays, int columns, int rows) {
  std::vector<RaySample> samples;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      // The centre of the pixel in the middle of the part.
      const double x = std::floor((column + 0.5) * rays.width() / columns) + 0.5;
      const double y = std::floor((row + 0.5) * rays.height() / rows) + 0.5;
      if (auto s = under(rays.through(x, y))) samples.push_back(*std::move(s));
    }
  }
  return samples;
}

vtkSmartPointer<vtkPolyData> rayPoints(const std::vector<RaySample>& samples) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> roughness;
  roughness->SetName("roughness");
  vtkNew<vtkIntArray> glass;
  glass->SetName("glass");
  vtkNew<vtkCellArray> vertices;
  for (const RaySample& s : samples) {
    const vtkIdType id = points->InsertNextPoint(&s.positionWorld.x);
    normals->InsertNextTuple(&s.normalWorld.x);
    roughness->InsertNextValue(s.roughness);
    glass->InsertNextValue(s.glass < 0 ? -1 : 2 * s.glass + (s.back ? 1 : 0));
    vertices->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(roughness);
  data->GetPointData()->AddArray(glass);
  return data;
}

}  // namespace boxprobe
