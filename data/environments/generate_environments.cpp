// Writes the pictures of this folder again: `generate_environments OUTDIR`.
#include <filesystem>
#include <iostream>

#include "data/environments/studio.h"
#include "filters/io/files/atomic_file.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "generate_environments OUTDIR\n";
    return 2;
  }
  try {
    std::filesystem::create_directories(argv[1]);
    boxprobe::writeTextAtomically(std::string(argv[1]) + "/studio.hdr", boxprobe::environments::studioHdr());
  } catch (const std::exception& error) {
    std::cerr << "generate_environments: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
