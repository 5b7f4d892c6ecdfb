// The format: lines of text up to an empty one, a line with the size, then for each row 2, 2, the width in two bytes,
// and four channels of runs: a count above 128 and a value to repeat, or a count and that many values.
#include "filters/io/image/radiance_check.h"

namespace boxprobe {

namespace {

class Bytes {
 public:
  Bytes(const std::string& bytes, std::size_t start) : bytes_(bytes), at_(start) {}
  /// -1 at the end.
  int next() { return at_ < bytes_.size() ? static_cast<unsigned char>(bytes_[at_++]) : -1; }
  void skip(int count) { at_ += static_cast<std::size_t>(count); }
  bool within() const { return at_ <= bytes_.size(); }

 private:
  const std::string& bytes_;
  std::size_t at_;
};

/// The offset after the line with the size. A line that begins with a zero byte counts as empty, as in the decoder.
std::size_t firstRow(const std::string& bytes) {
  std::size_t at = 0;
  const auto lineEnd = [&bytes](std::size_t start) {
    const std::size_t end = bytes.find('\n', start);
    return end == std::string::npos ? bytes.size() : end;
  };
  while (at < bytes.size()) {
    const std::size_t end = lineEnd(at);
    const bool empty = end == at || bytes[at] == '\0';
    at = end + 1;
    if (empty) break;
  }
  return at < bytes.size() ? lineEnd(at) + 1 : bytes.size();
}

bool channelIsWhole(Bytes& in, int width) {
  for (int done = 0; done < width;) {
    int count = in.next();
    if (count <= 0) return false;
    const bool repeated = count > 128;
    if (repeated) count -= 128;
    in.skip(repeated ? 1 : count);
    done += count;
    if (done > width || !in.within()) return false;
  }
  return true;
}

}  // namespace

bool radianceRunsAreWhole(const std::string& bytes, int width, int height) {
  if (width < 8 || width > 0x7fff) return true;  // never run-length encoded
  Bytes in(bytes, firstRow(bytes));
  for (int row = 0; row < height; ++row) {
    const int first = in.next(), second = in.next(), high = in.next(), low = in.next();
    if (first != 2 || second != 2 || (high & 0x80) != 0) return row == 0;
    if (low < 0 || 256 * high + low != width) return false;
    for (int channel = 0; channel < 4; ++channel) {
      if (!channelIsWhole(in, width)) return false;
    }
  }
  return true;
}

}  // namespace boxprobe
