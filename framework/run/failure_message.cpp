#include "run/failure_message.h"

#include <new>

namespace moire {

std::string failure_message(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

}  // namespace moire
