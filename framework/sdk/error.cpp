// Error's destructor lives here so that its type is one thing in the program and in every plugin.
#include <moire/error.h>

namespace moire {

Error::~Error() = default;

}  // namespace moire
