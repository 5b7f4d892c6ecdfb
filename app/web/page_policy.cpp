// See page_policy.h.
#include "app/web/page_policy.h"

#include <array>
#include <cstdint>

#include "app/web/base64.h"

namespace boxprobe {

namespace {

constexpr std::array<std::uint32_t, 64> kRounds = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

std::uint32_t turned(std::uint32_t v, int bits) {
  return v >> bits | v << (32 - bits);
}

void addBlock(std::array<std::uint32_t, 8>& state, const char* block) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t i = 0; i < 64; ++i) {
    w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(block[i]);
  }
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) + w[i - 7] + (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t one =
        h + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + ((e & f) ^ (~e & g)) + kRounds[i] + w[i];
    const std::uint32_t two = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
  }
  const std::array<std::uint32_t, 8> more = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) state[i] += more[i];
}

/// " 'sha256-..'" of each element that `opening` begins.
std::string hashesOf(const std::string& page, const std::string& opening, const std::string& end) {
  std::string hashes;
  for (std::size_t at = 0; (at = page.find(opening, at)) != std::string::npos;) {
    at += opening.size();
    const std::size_t to = page.find(end, at);
    hashes += " 'sha256-" + base64(sha256(std::string_view(page).substr(at, to - at))) + "'";
  }
  return hashes;
}

std::string directive(const char* name, const std::string& sources) {
  return sources.empty() ? std::string() : name + sources + "; ";
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<std::uint32_t, 8> state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  // The text, a bit, zeros to a whole block less eight bytes, the text's length in bits.
  std::string all(bytes);
  all += '\x80';
  all.append((120 - all.size() % 64) % 64, '\0');
  const std::uint64_t bits = std::uint64_t(8) * bytes.size();
  for (int shift = 56; shift >= 0; shift -= 8) all += static_cast<char>(bits >> shift & 255u);
  for (std::size_t at = 0; at < all.size(); at += 64) addBlock(state, all.data() + at);
  std::string sum;
  for (const std::uint32_t word : state) {
    for (int shift = 24; shift >= 0; shift -= 8) sum += static_cast<char>(word >> shift & 255u);
  }
  return sum;
}

std::string withPolicy(const std::string& page, const PageSources& sources) {
  const std::string mark = "<meta charset=\"utf-8\">";
  const std::string policy = "default-src 'none'; " +
                             directive("script-src", hashesOf(page, "<script>", "</script>") + sources.scripts) +
                             directive("style-src-elem", hashesOf(page, "<style>", "</style>") + sources.styles) +
                             sources.others + "base-uri 'none'; form-action 'none'";
  const std::size_t at = page.find(mark);
  if (at == std::string::npos) return page;  // none of ours
  std::string result = page;
  return result.insert(at + mark.size(), "\n<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\">");
}

}  // namespace boxprobe
