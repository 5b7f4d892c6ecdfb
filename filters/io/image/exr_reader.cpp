#include "filters/io/image/exr_reader.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/exr_header_check.h"
#include "filters/io/image/image_detail.h"

namespace boxprobe {

namespace {

constexpr std::size_t kPixelBytes = 4 * sizeof(float);
const char* const kChannelNames[4] = {"R", "G", "B", "A"};
const char* const kLowerNames[4] = {"r", "g", "b", "a"};

std::string partName(const std::string& path, int part) {
  return path + ": part " + std::to_string(part);
}

bool isFlat(const Imf::Header& header) {
  return !header.hasType() || Imf::isImage(header.type());
}

bool hasColor(const Imf::ChannelList& channels) {
  return channels.findChannel("R") && channels.findChannel("G") && channels.findChannel("B");
}

/// The names of red, green, blue and alpha (empty: none): plain, in lower case, or of a layer, Blender's "Combined"
/// first.
std::optional<std::array<std::string, 4>> colorNames(const Imf::ChannelList& channels) {
  const auto namesOf = [&channels](const std::string& layer, bool lower) {
    std::array<std::string, 4> names;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string name = layer + (lower ? kLowerNames[i] : kChannelNames[i]);
      if (channels.findChannel(name) != nullptr) names[i] = name;
    }
    return names;
  };
  const auto whole = [](const std::array<std::string, 4>& n) {
    return !n[0].empty() && !n[1].empty() && !n[2].empty();
  };
  std::optional<std::array<std::string, 4>> found;
  for (const bool lower : {false, true}) {
    if (const auto names = namesOf("", lower); whole(names)) return names;
  }
  for (auto it = channels.begin(); it != channels.end(); ++it) {
    const std::string name = it.name();
    const std::size_t dot = name.rfind('.');
    if (dot == std::string::npos || (name.substr(dot + 1) != "R" && name.substr(dot + 1) != "r")) continue;
    const std::string layer = name.substr(0, dot + 1);
    const auto names = namesOf(layer, name.back() == 'r');
    if (!whole(names)) continue;
    const bool combined = layer == "Combined." || (layer.size() > 10 && layer.rfind(".Combined.") == layer.size() - 10);
    if (combined) return names;
    if (!found) found = names;
  }
  return found;
}
/// Luminance and chroma: RY = (R - Y) / Y and BY = (B - Y) / Y, usually at half the resolution.
bool hasChroma(const Imf::ChannelList& channels) {
  return channels.findChannel("Y") && channels.findChannel("RY") && channels.findChannel("BY");
}
/// The channel of a grey picture: luminance, or the only one whatever its name (Blender writes "V"); else empty.
std::string greyName(const Imf::ChannelList& channels) {
  if (channels.findChannel("RY") || channels.findChannel("BY")) return {};
  if (channels.findChannel("Y")) return "Y";
  const auto first = channels.begin();
  if (first == channels.end()) return {};
  auto second = first;
  const std::string name = first.name();
  const bool alone = ++second == channels.end();
  const std::string bare = name.substr(name.rfind('.') + 1);  // without the layer
  for (const char* other : {"Z", "distance", "A", "a"}) {
    if (bare == other) return {};
  }
  const bool colour = first.channel().type != Imf::UINT;  // else numbers of objects
  return alone && colour ? name : std::string();
}

/// The stored channel for each of R, G, B, A; empty for none.
struct ChannelPlan {
  std::array<std::string, 4> source;
  bool chroma = false;  ///< luminance is read as red; RY and BY make it a colour
  std::string distance;
};

ChannelPlan planChannels(const Imf::ChannelList& channels, const std::string& where) {
  ChannelPlan plan;
  if (const auto colors = colorNames(channels)) {
    plan.source = *colors;
  } else if (hasChroma(channels) || !greyName(channels).empty()) {
    plan.chroma = hasChroma(channels);
    plan.source[0] = plan.chroma ? "Y" : greyName(channels);  // grey: copied to green and blue after reading
    if (channels.findChannel("A") != nullptr) plan.source[3] = "A";
  } else {
    std::string names;
    for (auto it = channels.begin(); it != channels.end(); ++it)
      names += std::string(names.empty() ? "" : ", ") + it.name();
    throw InputError(oneLine(where + " has the channels " + (names.empty() ? "(none)" : names) +
                             "; R, G and B, or luminance Y, alone or with RY and BY, are needed"));
  }
  for (const char* name : {"Z", "distance"}) {
    if (channels.findChannel(name) != nullptr) plan.distance = name;
  }
  for (const std::string& source : {plan.source[0], plan.source[1], plan.source[2], plan.source[3], plan.distance}) {
    if (source.empty()) continue;
    const Imf::Channel& channel = channels[source];
    if (channel.xSampling != 1 || channel.ySampling != 1) {
      throw InputError(oneLine(where + ": channel " + source + " is subsampled; save it at full resolution"));
    }
  }
  return plan;
}

struct Size {
  long long width, height;
};
Size sizeOf(const Imath::Box2i& window) {
  return {static_cast<long long>(window.max.x) - window.min.x + 1,
          static_cast<long long>(window.max.y) - window.min.y + 1};
}

void requireFlat(const Imf::Header& header, const std::string& where) {
  if (!isFlat(header)) throw InputError(where + " is deep data (" + oneLine(header.type()) + "); flatten it first");
}

/// A channel with fewer samples than pixels: one at each pixel whose coordinates are multiples of the sampling.
class CoarseChannel {
 public:
  CoarseChannel(const Imf::Channel& channel, const Imath::Box2i& window)
      : stepX_(channel.xSampling), stepY_(channel.ySampling), window_(window) {
    // The library has checked that the window begins and ends at multiples of the steps.
    width_ = std::max(sizeOf(window).width / stepX_, 1LL);
    height_ = std::max(sizeOf(window).height / stepY_, 1LL);
    values_.assign(static_cast<std::size_t>(width_ * height_), 0.0f);
  }
  Imf::Slice slice() {
    return Imf::Slice::Make(Imf::FLOAT, values_.data(), window_, sizeof(float),
                            sizeof(float) * static_cast<std::size_t>(width_), stepX_, stepY_);
  }
  /// Linear between samples, the last one beyond them; pixels from the window's corner.
  double at(long long x, long long y) const {
    const long long column = std::min(x / stepX_, width_ - 1), row = std::min(y / stepY_, height_ - 1);
    const double right = static_cast<double>(x % stepX_) / stepX_, down = static_cast<double>(y % stepY_) / stepY_;
    const auto mixed = [&](long long r) {
      return (1.0 - right) * sample(column, r) + right * sample(std::min(column + 1, width_ - 1), r);
    };
    return (1.0 - down) * mixed(row) + down * mixed(std::min(row + 1, height_ - 1));
  }

 private:
  double sample(long long column, long long row) const {
    return values_[static_cast<std::size_t>(row * width_ + column)];
  }

  int stepX_, stepY_;
  Imath::Box2i window_;
  long long width_ = 0, height_ = 0;
  std::vector<float> values_;
};

/// Luminance, which stands as red, and chroma become colours of the file's primaries.
void colorsOfChroma(ImageRgbaF& image, const Imf::Header& header, const CoarseChannel& redChroma,
                    const CoarseChannel& blueChroma) {
  const Imf::Chromaticities primaries =
      Imf::hasChromaticities(header) ? Imf::chromaticities(header) : Imf::Chromaticities();
  const Imath::M44f matrix = Imf::RGBtoXYZ(primaries, 1.0f);
  glm::dvec3 share(matrix[0][1], matrix[1][1], matrix[2][1]);  // of red, green and blue in the luminance
  const double all = share.x + share.y + share.z;
  // Green follows from the rest; of XYZ as primaries all luminance is green.
  if (!(share.y > 1e-3 * std::fabs(all) && all > 0.0)) share = {0.2126, 0.7152, 0.0722};
  share /= share.x + share.y + share.z;
  std::size_t texel = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x, texel += 4) {
      const double luminance = image.pixels[texel];
      const double red = (redChroma.at(x, y) + 1.0) * luminance, blue = (blueChroma.at(x, y) + 1.0) * luminance;
      const double green = (luminance - share.x * red - share.z * blue) / share.y;
      image.pixels[texel] = static_cast<float>(red);
      image.pixels[texel + 1] = static_cast<float>(green);
      image.pixels[texel + 2] = static_cast<float>(blue);
    }
  }
}

/// Only of colours: grey has no primaries.
void readPrimaries(const Imf::Header& header, ExrPicture& picture) {
  constexpr const char* kAces = "acesImageContainerFlag";
  const auto* aces = header.findTypedAttribute<Imf::IntAttribute>(kAces);
  if (!Imf::hasChromaticities(header)) {
    if (aces != nullptr && aces->value() == 1) picture.primaries = acesPrimaries();
    return;
  }
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto point = [](const Imath::V2f& xy) { return glm::dvec2(xy.x, xy.y); };
  const ColorPrimaries primaries{point(c.red), point(c.green), point(c.blue), point(c.white)};
  if (rec709From(primaries)) {
    picture.primaries = primaries;
  } else {
    picture.remarks.emplace_back("attribute chromaticities is not followed: its primaries span no colours");
  }
}

}  // namespace

void convertToRec709(ExrPicture& picture) {
  if (!picture.primaries) return;
  const auto matrix = rec709From(*picture.primaries);
  picture.primaries.reset();
  if (!matrix || *matrix == glm::dmat3(1.0)) return;
  std::vector<float>& pixels = picture.image.pixels;
  for (std::size_t texel = 0; texel < pixels.size(); texel += 4) {
    const glm::dvec3 light = *matrix * glm::dvec3(pixels[texel], pixels[texel + 1], pixels[texel + 2]);
    for (int c = 0; c < 3; ++c) pixels[texel + static_cast<std::size_t>(c)] = static_cast<float>(light[c]);
  }
}

void withExrFile(const std::string& path, const std::function<void(Imf::MultiPartInputFile&)>& read) {
  requireInputFile(path);
  checkExrHeader(path);
  try {
    Imf::MultiPartInputFile file(path.c_str());
    if (file.parts() < 1) throw InputError(path + ": has no parts; save it again");
    read(file);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& problem) {
    // The library's messages repeat the file name, which is already in front.
    std::string reason = oneLine(problem.what());
    for (const std::string& named : {"\"" + path + "\"", path}) {
      for (std::size_t at = reason.find(named); at != std::string::npos; at = reason.find(named)) {
        reason.replace(at, named.size(), "it");
      }
    }
    throw InputError(path + ": is not an OpenEXR picture, or is damaged (" + reason + "); save it again");
  }
}

int picturePart(const Imf::MultiPartInputFile& file, const std::string& path) {
  using Channels = Imf::ChannelList;
  const auto partWith = [&file](bool (*holds)(const Channels&)) {
    int first = -1;
    for (int part = 0; part < file.parts(); ++part) {
      const Imf::Header& header = file.header(part);
      if (!isFlat(header) || !holds(header.channels())) continue;
      if (Imf::hasEnvmap(header)) return part;
      if (first < 0) first = part;
    }
    return first;
  };
  // Colours before a single channel, which may be fog or a mask.
  int part =
      partWith([](const Channels& all) { return hasColor(all) || hasChroma(all) || all.findChannel("Y") != nullptr; });
  if (part < 0) part = partWith([](const Channels& all) { return colorNames(all).has_value(); });
  if (part < 0) part = partWith([](const Channels& all) { return !greyName(all).empty(); });
  if (part >= 0) return part;
  requireFlat(file.header(0), partName(path, 0));
  planChannels(file.header(0).channels(), partName(path, 0));  // throws if a channel is missing
  return 0;
}

ExrPicture readExrPart(Imf::MultiPartInputFile& file, int index, const std::string& path) {
  const std::string where = partName(path, index);
  const Imf::Header& header = file.header(index);
  requireFlat(header, where);
  const Imath::Box2i window = header.dataWindow();
  const Size size = sizeOf(window);
  checkImageSize(path, size.width, size.height);
  const ChannelPlan plan = planChannels(header.channels(), where);
  // Also checked before allocating: a header may claim more than the file contains.
  if (!file.partComplete(index)) throw InputError(where + " is not complete; save it again");

  ExrPicture picture;
  ImageRgbaF& image = picture.image;
  image.width = static_cast<int>(size.width);
  image.height = static_cast<int>(size.height);
  const auto texels = static_cast<std::size_t>(size.width * size.height);
  image.pixels.assign(texels * 4, 0.0f);
  picture.hasAlpha = !plan.source[3].empty();
  Imf::FrameBuffer buffer;
  for (std::size_t i = 0; i < 4; ++i) {
    if (plan.source[i].empty()) continue;
    buffer.insert(plan.source[i], Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + i, window, kPixelBytes,
                                                   kPixelBytes * image.width));
  }
  if (!plan.distance.empty()) {
    picture.distance.assign(texels, 0.0f);
    buffer.insert(plan.distance, Imf::Slice::Make(Imf::FLOAT, picture.distance.data(), window));
  }
  std::optional<CoarseChannel> redChroma, blueChroma;
  if (plan.chroma) {
    redChroma.emplace(header.channels()["RY"], window);
    blueChroma.emplace(header.channels()["BY"], window);
    buffer.insert("RY", redChroma->slice());
    buffer.insert("BY", blueChroma->slice());
  }
  Imf::InputPart part(file, index);
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  if (plan.chroma) colorsOfChroma(image, header, *redChroma, *blueChroma);
  for (std::size_t texel = 0; texel < image.pixels.size(); texel += 4) {
    if (plan.source[1].empty() && !plan.chroma) image.pixels[texel + 1] = image.pixels[texel + 2] = image.pixels[texel];
    if (plan.source[3].empty()) image.pixels[texel + 3] = 1.0f;
  }

  if (Imf::hasEnvmap(header)) {
    const int kind = static_cast<int>(Imf::envmap(header));
    if (kind != Imf::ENVMAP_LATLONG && kind != Imf::ENVMAP_CUBE) {
      throw InputError(where + ": attribute envmap is " + std::to_string(kind) +
                       "; 0 (lat-long) and 1 (cube) are known");
    }
    picture.envmap = kind == Imf::ENVMAP_CUBE ? EnvmapKind::Cube : EnvmapKind::LatLong;
  }
  if (!plan.source[1].empty() || plan.chroma) readPrimaries(header, picture);
  const Imath::Box2i display = header.displayWindow();
  const Size displaySize = sizeOf(display);
  const auto asInt = [](long long value) { return static_cast<int>(std::clamp(value, -(1LL << 30), 1LL << 30)); };
  picture.displayWidth = asInt(displaySize.width);
  picture.displayHeight = asInt(displaySize.height);
  picture.offsetX = asInt(static_cast<long long>(window.min.x) - display.min.x);
  picture.offsetY = asInt(static_cast<long long>(window.min.y) - display.min.y);
  return picture;
}

std::vector<float> readExrChannel(Imf::MultiPartInputFile& file, int index, const std::string& channel, int width,
                                  int height, const std::string& path) {
  const std::string where = partName(path, index);
  const Imf::Header& header = file.header(index);
  requireFlat(header, where);
  const Imath::Box2i window = header.dataWindow();
  const Size size = sizeOf(window);
  if (size.width != width || size.height != height) {
    throw InputError(where + ": is " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                     " pixels and must be " + std::to_string(width) + " x " + std::to_string(height) +
                     "; bake it again");
  }
  if (!file.partComplete(index)) throw InputError(where + " is not complete; save it again");
  const Imf::Channel* found = header.channels().findChannel(channel);
  if (found == nullptr || found->xSampling != 1 || found->ySampling != 1) {
    throw InputError(where + ": has no channel " + channel + " at full resolution; bake it again");
  }
  std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  Imf::FrameBuffer buffer;
  buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, values.data(), window));
  Imf::InputPart part(file, index);
  part.setFrameBuffer(buffer);
  part.readPixels(window.min.y, window.max.y);
  return values;
}

}  // namespace boxprobe
