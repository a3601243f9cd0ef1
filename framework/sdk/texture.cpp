#include <moire/texture.h>

#include <atomic>
#include <mutex>
#include <optional>

#include <moire/error.h>

#include "sdk/images_module.h"

namespace moire {

struct Texture::Lazy {
  std::once_flag once, oiio_once;
  std::optional<Pyramid> pyramid;
  std::atomic<const Pyramid*> made = nullptr;  // asked for by every lookup: call_once alone takes some 4 ns
  std::unique_ptr<OiioTexture> oiio;
};

Texture::Texture(std::vector<Level> levels, Wrap wrap)
    : levels_(std::move(levels)), wrap_(wrap), lazy_(std::make_shared<Lazy>()) {}

const Pyramid& Texture::pyramid() const {
  if (const Pyramid* made = lazy_->made.load(std::memory_order_acquire)) return *made;
  std::call_once(lazy_->once, [this] {
    const Level& finest = levels_.front();
    lazy_->pyramid.emplace(finest.rgb, finest.stride, finest.width, finest.height);
    lazy_->made.store(&*lazy_->pyramid, std::memory_order_release);
  });
  return *lazy_->pyramid;
}

const OiioTexture& Texture::oiio() const {
  std::call_once(lazy_->oiio_once, [this] {
    std::string problem;
    lazy_->oiio.reset(images_module().make_texture(pyramid(), wrap_, problem));
    if (!lazy_->oiio) throw Error(problem);
  });
  return *lazy_->oiio;
}

}  // namespace moire
