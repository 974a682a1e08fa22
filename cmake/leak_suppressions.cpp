/// Leaks that are not ours. CLN 1.3.6 forgets one string at each start of a program, in
/// cl_prin_globals_init_helper; its frames have no names a suppression could be about.
extern "C" const char* __lsan_default_suppressions();

extern "C" const char* __lsan_default_suppressions() { return "leak:libcln.so\n"; }

/// Tests compare what the program prints, so nothing is said about the suppression.
extern "C" const char* __lsan_default_options();

extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
