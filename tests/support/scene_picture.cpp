#include "tests/support/scene_picture.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "filters/io/gltf/model_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_file.h"
#include "tests/support/gpu_window.h"

namespace boxprobe::test {

namespace {

float encoded(float linear) {
  return std::pow(std::clamp(linear, 0.0f, 1.0f), 1.0f / 2.2f);
}

const char* outputFolder() {
  return std::getenv("BOXPROBE_TEST_OUTPUT");
}

}  // namespace

ScenePicture::ScenePicture(Scene s, int width, int height, int multiSamples)
    : scene(std::move(s)),
      window(makeWindow(width, height, multiSamples)),
      renderer(std::make_unique<SceneRenderer>(window)) {}

ScenePicture ScenePicture::fromFile(const std::string& nameInData, int width, int height) {
  return ScenePicture(loadSceneFile(std::string(BOXPROBE_DATA_DIR) + "/" + nameInData), width, height);
}

void ScenePicture::show(const Camera& camera) {
  if (!loaded_) {
    std::vector<std::shared_ptr<const Model>> models;
    for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
    renderer->setModels(std::move(models));
    loaded_ = true;
  }
  renderer->sync(scene, Changes::all());
  renderer->applyCamera(camera);
  renderer->finishWork();
  if (!renderer->error().empty()) throw std::runtime_error(renderer->error());
}

void ScenePicture::setParallel(double height) {
  vtkCamera* camera = renderer->renderer()->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * height);
}

ImageRgbaF ScenePicture::linear(int samplesPerPixel) {
  const int* size = window->GetSize();
  return renderer->renderLinear(size[0], size[1], samplesPerPixel);
}

ImageRgbaF ScenePicture::fineLinear() {
  constexpr int kFiner = 4;
  const int* size = window->GetSize();
  const int width = size[0], height = size[1];
  const ImageRgbaF fine = renderer->renderLinear(kFiner * width, kFiner * height, 1);
  ImageRgbaF mean = fine;
  mean.width = width;
  mean.height = height;
  mean.pixels.assign(static_cast<std::size_t>(4 * width * height), 0.0f);
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t i = 0; i < fine.pixels.size(); ++i) {
    const std::size_t pixel = i / 4, x = pixel % (kFiner * columns) / kFiner, y = pixel / (kFiner * columns) / kFiner;
    mean.pixels[4 * (y * columns + x) + i % 4] += fine.pixels[i] / (kFiner * kFiner);
  }
  return mean;
}

const Camera& cameraNamed(const Scene& scene, const std::string& name) {
  for (const Camera& camera : scene.cameras) {
    if (camera.name == name) return camera;
  }
  throw std::runtime_error("no camera " + name);
}

Camera mirroredInFloor(const Camera& camera, double height) {
  Camera mirrored = camera;
  mirrored.position.y = 2.0 * height - camera.position.y;
  mirrored.target.y = 2.0 * height - camera.target.y;
  // A proper camera cannot be left-handed: it keeps the mirror image's right and so has its up downwards.
  mirrored.up = glm::dvec3(camera.up.x, -camera.up.y, camera.up.z) * -1.0;
  return mirrored;
}

ImageRgbaF flippedTopToBottom(const ImageRgbaF& image) {
  ImageRgbaF flipped = image;
  const auto row = static_cast<std::size_t>(image.width) * 4;
  for (int y = 0; y < image.height; ++y) {
    const auto from = image.pixels.begin() + static_cast<long>(static_cast<std::size_t>(image.height - 1 - y) * row);
    std::copy(from, from + static_cast<long>(row),
              flipped.pixels.begin() + static_cast<long>(static_cast<std::size_t>(y) * row));
  }
  return flipped;
}

double psnr(const ImageRgbaF& a, const ImageRgbaF& b, const std::vector<bool>& mask) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (i % 4 == 3 || (!mask.empty() && !mask[i / 4])) continue;
    const double d = encoded(a.pixels[i]) - encoded(b.pixels[i]);
    sum += d * d;
    ++count;
  }
  return count == 0 ? 0.0 : 10.0 * std::log10(static_cast<double>(count) / std::max(sum, 1e-12));
}

void keepPicture(const ImageRgbaF& image, const std::string& name) {
  if (outputFolder() == nullptr) return;
  ImageRgba8 display{image.width, image.height, std::vector<std::uint8_t>(image.pixels.size()), {}};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    display.pixels[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(std::lround(255.0f * encoded(image.pixels[i])));
  }
  savePng(std::string(outputFolder()) + "/" + name + ".png", display);
}

void keepPicture(const ImageRgba8& image, const std::string& name) {
  if (outputFolder() != nullptr) savePng(std::string(outputFolder()) + "/" + name + ".png", image);
}

}  // namespace boxprobe::test
