#include "app/session.h"

#include "metrics/registry.h"
#include "pictures/registry.h"
#include "sampling/filters.h"
#include "sampling/lookups.h"

namespace moire::app {

Session::Session(const std::vector<std::filesystem::path>& folders)
    : catalog(Catalog::open(plugin_folders(folders))),
      vocabulary{&catalog, metric_descriptions(), lookups(), picture_descriptions(), filters()} {}

}  // namespace moire::app
