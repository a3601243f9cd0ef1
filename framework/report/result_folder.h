// The folder of a run's results: images as they are made, tables after every job.
#pragma once

#include <filesystem>

#include "run/sink.h"

namespace moire::report {

class ResultFolder final : public Sink {
 public:
  // Makes the folder. Error: it cannot be made or written.
  explicit ResultFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }

  std::filesystem::path picture(const std::string& scene, const std::string& sampler, const Picture& picture) override;
  std::filesystem::path map(const std::string& scene, const std::string& sampler, ImageSize size,
                            const Map& map) override;
  std::filesystem::path drawing(const std::string& scene, const std::string& sampler, const std::string& kind,
                                const Picture& picture) override;
  void save(const Results& results) override;

  // The experiment with every default filled in.
  void save_request(const nlohmann::ordered_json& request);

 private:
  std::filesystem::path folder_;
};

}  // namespace moire::report
