#include "filters/io/cube/cube_seal.h"

#include <OpenEXR/ImfStringAttribute.h>
#include <xxhash.h>

#include <cstdio>

namespace boxprobe {

namespace {

constexpr std::size_t kSealDigits = 32;

/// The offset of the digits, behind the attribute's name, type and size as OpenEXR writes them. npos: not found.
std::size_t sealAt(const std::string& bytes) {
  static const std::string head("checksum\0string\0\x20\0\0\0", 20);
  static_assert(kSealDigits == 0x20);
  const std::size_t at = bytes.find(head);
  return at == std::string::npos || bytes.size() - at < head.size() + kSealDigits ? std::string::npos
                                                                                  : at + head.size();
}

std::string digitsOf(const std::string& bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  char digits[kSealDigits + 1];
  std::snprintf(digits, sizeof digits, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits;
}

}  // namespace

void addSeal(Imf::Header& header) {
  header.insert("checksum", Imf::StringAttribute(std::string(kSealDigits, '0')));
}

void seal(std::string& bytes) {
  const std::size_t at = sealAt(bytes);
  if (at != std::string::npos) bytes.replace(at, kSealDigits, digitsOf(bytes));
}

Seal checkSeal(std::string bytes) {
  const std::size_t at = sealAt(bytes);
  if (at == std::string::npos) return Seal::None;
  const std::string found = bytes.substr(at, kSealDigits);
  bytes.replace(at, kSealDigits, kSealDigits, '0');
  return found == digitsOf(bytes) ? Seal::Whole : Seal::Broken;
}

}  // namespace boxprobe
