#include <moire/texture.h>

#include <mutex>
#include <optional>

namespace moire {

struct Texture::Lazy {
  std::once_flag once;
  std::optional<Pyramid> pyramid;
};

Texture::Texture(std::vector<Level> levels, Wrap wrap)
    : levels_(std::move(levels)), wrap_(wrap), lazy_(std::make_shared<Lazy>()) {}

const Pyramid& Texture::pyramid() const {
  std::call_once(lazy_->once, [this] {
    const Level& finest = levels_.front();
    lazy_->pyramid.emplace(finest.rgb, finest.stride, finest.width, finest.height);
  });
  return *lazy_->pyramid;
}

}  // namespace moire
