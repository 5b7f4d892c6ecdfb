// Linked into every program of the AddressSanitizer build: shared libraries stay loaded until the process ends.
// Mesa's drivers and GLX are unloaded before leaks are looked for. What their globals still point to then counts as
// leaked, from "<unknown module>", which no suppression can name. Kept loaded they leak nothing, and what is reported
// is ours.
extern "C" int dlclose(void* /*handle*/);

extern "C" int dlclose(void* /*handle*/) {
  return 0;
}
