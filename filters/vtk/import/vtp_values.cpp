#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

#include "filters/core/base/errors.h"
#include "filters/core/base/read_number.h"
#include "filters/vtk/import/vtp_file.h"

namespace boxprobe {

namespace {

int base64Value(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/// Reads bytes sequentially, from base64 text or raw data.
class VtpSource {
 public:
  VtpSource(std::string_view text, bool base64) : text_(text), base64_(base64) {}

  /// False if fewer bytes are left.
  bool read(std::size_t count, std::string& bytes) {
    if (!base64_) {
      if (text_.size() - at_ < count) return false;
      bytes.append(text_.substr(at_, count));
      at_ += count;
      return true;
    }
    for (const std::size_t end = bytes.size() + count; bytes.size() < end;) {
      if (held_ == 0 && !decode()) return false;
      bytes += group_[kGroup - held_--];
    }
    return true;
  }
  /// Starts a new base64 stream, after a padded group.
  void endStream() { held_ = 0; }
  std::size_t most() const { return text_.size() - at_ + kGroup; }

 private:
  static constexpr std::size_t kGroup = 3;

  bool decode() {
    std::uint32_t bits = 0;
    std::size_t digits = 0, padding = 0;
    for (; digits < 4 && at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
      const int value = c == '=' ? 0 : base64Value(c);
      if (value < 0 || (padding > 0 && c != '=')) return false;
      padding += c == '=' ? 1 : 0;
      bits = (bits << 6) | static_cast<std::uint32_t>(value);
      ++digits;
    }
    if (digits < 4 || padding > 2) return false;
    held_ = kGroup - padding;
    // Right-aligned, so that the first byte is at kGroup - held_.
    for (std::size_t i = 0; i < held_; ++i) {
      group_[padding + i] = static_cast<char>(bits >> (16 - 8 * i));
    }
    return true;
  }

  std::string_view text_;
  bool base64_;
  std::size_t at_ = 0, held_ = 0;
  char group_[kGroup] = {};
};

struct VtpType {
  const char* name;
  std::size_t size;
  double (*value)(const char*);
};

template <typename T>
double valueAt(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

constexpr VtpType kVtpTypes[] = {{"Int8", 1, valueAt<std::int8_t>},   {"UInt8", 1, valueAt<std::uint8_t>},
                                 {"Int16", 2, valueAt<std::int16_t>}, {"UInt16", 2, valueAt<std::uint16_t>},
                                 {"Int32", 4, valueAt<std::int32_t>}, {"UInt32", 4, valueAt<std::uint32_t>},
                                 {"Int64", 8, valueAt<std::int64_t>}, {"UInt64", 8, valueAt<std::uint64_t>},
                                 {"Float32", 4, valueAt<float>},      {"Float64", 8, valueAt<double>}};

/// Decompresses a block to exactly `space` bytes at `target`; false if the size differs.
using Unpack = bool (*)(const std::string& block, char* target, std::size_t space);

bool unpackZlib(const std::string& block, char* target, std::size_t space) {
  uLongf made = space;
  return uncompress(reinterpret_cast<Bytef*>(target), &made, reinterpret_cast<const Bytef*>(block.data()),
                    block.size()) == Z_OK &&
         made == space;
}

bool unpackLz4(const std::string& block, char* target, std::size_t space) {
  constexpr std::size_t kMost = LZ4_MAX_INPUT_SIZE;
  return block.size() <= kMost && space <= kMost &&
         LZ4_decompress_safe(block.data(), target, static_cast<int>(block.size()), static_cast<int>(space)) ==
             static_cast<int>(space);
}

bool unpackLzma(const std::string& block, char* target, std::size_t space) {
  std::uint64_t memory = std::uint64_t(1) << 28;
  std::size_t used = 0, made = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(block.data()), &used,
                                   block.size(), reinterpret_cast<std::uint8_t*>(target), &made, space) == LZMA_OK &&
         made == space;
}

/// Null for an unknown compressor.
Unpack unpackOf(const std::string& compressor) {
  if (compressor == "vtkZLibDataCompressor") return unpackZlib;
  if (compressor == "vtkLZ4DataCompressor") return unpackLz4;
  return compressor == "vtkLZMADataCompressor" ? unpackLzma : nullptr;
}

class ArrayReader {
 public:
  ArrayReader(const VtpFile& file, const VtpArray& array, std::size_t wanted, const std::string& path)
      : file_(file), array_(array), wanted_(wanted), path_(path) {}

  std::vector<double> read() {
    const auto type = std::find_if(std::begin(kVtpTypes), std::end(kVtpTypes),
                                   [&](const VtpType& t) { return array_.type == t.name; });
    if (type == std::end(kVtpTypes)) fail("has the type " + array_.type + ", which is not read; save it again");
    if (array_.format == VtpFormat::Text) return readText();
    std::string bytes = readBytes(wanted_ * type->size);
    if (file_.bigEndian) {
      for (std::size_t i = 0; i < bytes.size(); i += type->size) {
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                     bytes.begin() + static_cast<std::ptrdiff_t>(i + type->size));
      }
    }
    std::vector<double> values(wanted_);
    for (std::size_t i = 0; i < wanted_; ++i) values[i] = type->value(bytes.data() + i * type->size);
    return values;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    failVtp(path_, array_.section + ": array \"" + array_.name.substr(0, 100) + "\" " + reason);
  }
  [[noreturn]] void failSize(std::size_t found) const {
    fail("holds " + std::to_string(found) + " bytes or values where " + std::to_string(wanted_) +
         " values are needed; the file is damaged");
  }

  std::vector<double> readText() const {
    const std::string& text = array_.text;
    if (text.size() + 1 < 2 * wanted_) failSize(text.size());  // at least a digit and a space each
    std::vector<double> values;
    values.reserve(wanted_);
    for (const char *at = text.data(), *end = at + text.size();;) {
      while (at < end && (*at == ' ' || *at == '\n' || *at == '\r' || *at == '\t')) ++at;
      if (at == end) break;
      double value = 0.0;
      const auto result = readNumber(*at == '+' ? at + 1 : at, end, value);
      if (result.ec == std::errc::invalid_argument) fail("has a word that is not a number; save the file again");
      values.push_back(result.ec == std::errc() ? value : std::numeric_limits<double>::quiet_NaN());
      at = result.ptr;
      if (values.size() > wanted_) break;
    }
    if (values.size() != wanted_) failSize(values.size());
    return values;
  }

  VtpSource source() const {
    if (array_.format == VtpFormat::Base64) return {array_.text, true};
    const std::string& bytes = file_.bytes;
    if (file_.appended == std::string::npos || array_.offset > bytes.size() - file_.appended) {
      fail("lies behind the end of the file; it is cut off");
    }
    return {std::string_view(bytes).substr(file_.appended + array_.offset), file_.appendedBase64};
  }

  std::uint64_t headerNumber(VtpSource& from) const {
    std::string bytes;
    if (!from.read(file_.wideHeaders ? 8 : 4, bytes)) fail("ends within its header; the file is cut off");
    if (file_.bigEndian) std::reverse(bytes.begin(), bytes.end());
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data(), bytes.size());
    return value;
  }

  std::string readBytes(std::size_t wanted) const {
    VtpSource from = source();
    std::string bytes;
    if (file_.compressor.empty()) {
      const std::uint64_t size = headerNumber(from);
      if (size != wanted) failSize(size);
      if (wanted > from.most() || !from.read(wanted, bytes)) fail("ends early; the file is cut off");
      return bytes;
    }
    const Unpack unpack = unpackOf(file_.compressor);
    if (unpack == nullptr) {
      failVtp(path_,
              "is compressed by " + file_.compressor + ", which is not known; save it with vtkZLibDataCompressor");
    }
    // The number of blocks, the size of each, the size of a shorter last one, then the compressed sizes.
    const std::uint64_t blocks = headerNumber(from), size = headerNumber(from), last = headerNumber(from);
    if (blocks > from.most() || size > wanted + (std::uint64_t(1) << 32)) fail("has a damaged header");
    std::vector<std::uint64_t> packed;
    std::uint64_t unpacked = 0;
    for (std::uint64_t i = 0; i < blocks; ++i) {
      packed.push_back(headerNumber(from));
      unpacked += i + 1 == blocks && last > 0 ? last : size;
      if (packed.back() > from.most() || unpacked > wanted) failSize(unpacked);
    }
    if (unpacked != wanted) failSize(unpacked);
    from.endStream();
    bytes.resize(wanted);
    std::size_t at = 0;
    for (std::uint64_t i = 0; i < blocks; ++i) {
      std::string block;
      if (!from.read(packed[i], block)) fail("ends early; the file is cut off");
      const std::size_t space = i + 1 == blocks && last > 0 ? last : size;
      if (!unpack(block, bytes.data() + at, space)) fail("cannot be decompressed; the file is damaged");
      at += space;
    }
    return bytes;
  }

  const VtpFile& file_;
  const VtpArray& array_;
  std::size_t wanted_;
  const std::string& path_;
};

}  // namespace

std::vector<double> vtpValues(const VtpFile& file, const VtpArray& array, std::size_t wanted, const std::string& path) {
  return ArrayReader(file, array, wanted, path).read();
}

}  // namespace boxprobe
