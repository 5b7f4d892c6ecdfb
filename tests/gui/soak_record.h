// What a long run holds, row by row: memory, handles, widgets, programs. Written as a table and drawn as curves over
// time. Called by the soak of the window.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// One look at this process.
struct SoakRow {
  double minutes = 0.0;            ///< since the start
  std::string scene = {};          ///< on show in the round that ended here
  double residentMegabytes = 0.0;  ///< anonymous and shared memory; pages of files come and go as the system likes
  double heapMegabytes = 0.0;      ///< handed out by malloc
  double mapMegabytes = 0.0;       ///< probes' maps, those kept for undo among them
  int descriptors = 0;             ///< open files, sockets and pipes
  int threads = 0;
  int widgets = 0;   ///< Qt's, hidden ones too
  int programs = 0;  ///< shader programs compiled since the start
};

/// Looks at this process now; the fields it cannot know (minutes, scene, mapMegabytes, programs) are left to the
/// caller.
SoakRow lookAtProcess();

/// As lines of values with commas between, under a line of names. Throws InputError where it cannot be written.
void writeSoakTable(const std::string& path, const std::vector<SoakRow>& rows);

/// Two charts, memory above and handles below, over minutes: a PNG. A display must be there. Throws InputError where it
/// cannot be written.
void drawSoak(const std::string& path, const std::vector<SoakRow>& rows);

}  // namespace boxprobe
