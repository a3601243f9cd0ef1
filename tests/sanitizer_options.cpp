// How the address sanitizer watches the tests.

// It guesses from where a thread's variables lie how many bytes of them there are, and guesses wrong where they happen
// to begin 16 bytes into a page: its search for leaks then reads nowhere and dies (glibc 2.36). Without the guess it
// finds as much.
extern "C" __attribute__((visibility("default"), no_sanitize("address"))) const char* __asan_default_options() {
  return "intercept_tls_get_addr=0";
}
