// How the heap takes memory from the system.
#pragma once

namespace boxprobe {

/// Has the heap grow in large pages, which are taken from the system a thousand times more seldom, and keeps what is
/// freed. To be called before threads are started. Does nothing where the C library or the system has no such thing or
/// addresses are limited (ulimit -v).
void useLargePages();

}  // namespace boxprobe
