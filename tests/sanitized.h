// Whether sanitizers watch, under which tests take some ten times as long: thorough tests then look at fewer cases.
#pragma once

namespace moire::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace moire::test
