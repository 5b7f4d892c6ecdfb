// This process: its CPU time, memory, number, path and environment.
#pragma once

#include <cstdint>
#include <string>

namespace boxprobe {

/// User and system seconds since the process started, all threads.
double processCpuSeconds();

/// The largest resident set of this process so far.
std::uint64_t peakResidentBytes();

/// Main memory of the machine; 0 if unknown.
std::uint64_t physicalMemoryBytes();

/// For names that no other process chooses at the same time.
long processNumber();

/// Is there a process of this number? True where the system does not tell.
bool processLives(long number);

/// The user's number or name, for names in folders that users share.
std::string userText();

/// The file of the running program; empty if unknown.
std::string programPath();

/// Sets an environment variable of this process and its children; one that is there stays unless `replace`. Before
/// threads are started: others may be reading.
void setEnvironment(const char* name, const char* value, bool replace);

}  // namespace boxprobe
