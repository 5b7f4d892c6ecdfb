// Mutates a GLB file inside its chunks and packs it again: with lengths left as they were, nearly every insertion would
// end at the container's length check and never reach what is behind it. One in eight is mutated as plain bytes, for
// the sake of those checks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maxSize);

namespace {

struct Chunk {
  std::string type;  ///< 4 bytes
  std::string bytes;
};

std::uint32_t word(const std::uint8_t* bytes) {
  std::uint32_t value;
  std::memcpy(&value, bytes, 4);
  return value;
}

/// The chunks of a whole GLB file; none if it is not one.
std::vector<Chunk> chunksOf(const std::uint8_t* data, std::size_t size) {
  std::vector<Chunk> chunks;
  if (size < 20 || std::memcmp(data, "glTF", 4) != 0) return chunks;
  for (std::size_t at = 12; at + 8 <= size;) {
    const std::size_t length = std::min<std::size_t>(word(data + at), size - at - 8);
    const char* text = reinterpret_cast<const char*>(data + at);
    chunks.push_back({std::string(text + 4, 4), std::string(text + 8, length)});
    at += 8 + length;
  }
  return chunks;
}

std::string wordText(std::size_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &number, 4);
  return bytes;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned int seed) {
  std::vector<Chunk> chunks = chunksOf(data, size);
  if (chunks.empty() || seed % 8 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  // Most of what a model can get wrong stands in the JSON chunk, the first.
  Chunk& chosen = seed % 3 != 0 ? chunks.front() : chunks[(seed / 24) % chunks.size()];
  std::size_t others = 12;
  for (const Chunk& chunk : chunks) others += 8 + (&chunk == &chosen ? 3 : (chunk.bytes.size() + 3) / 4 * 4);
  if (others >= maxSize) return LLVMFuzzerMutate(data, size, maxSize);
  const std::size_t room = maxSize - others, length = std::min(chosen.bytes.size(), room);
  chosen.bytes.resize(room);
  chosen.bytes.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(chosen.bytes.data()), length, room));

  std::string packed;
  for (Chunk& chunk : chunks) {
    chunk.bytes.resize((chunk.bytes.size() + 3) / 4 * 4, &chunk == &chunks.front() ? ' ' : '\0');
    packed += wordText(chunk.bytes.size()) + chunk.type + chunk.bytes;
  }
  packed = "glTF" + wordText(2) + wordText(12 + packed.size()) + packed;
  if (packed.size() > maxSize) return LLVMFuzzerMutate(data, size, maxSize);
  std::memcpy(data, packed.data(), packed.size());
  return packed.size();
}
