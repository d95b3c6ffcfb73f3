// OSMesa 22.3 keeps about 180 bytes per OSMesaMakeCurrent until the process ends; they are not ours to free.
// Read by LeakSanitizer only. Everything else that leaks still fails the run.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
