#pragma once

#include "fem/pipeline/support/results_folder.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace stemware::pipeline
{

/// The results folder as all ranks see it; the first one owns it. Collective over all ranks.
class SharedFolder
{
public:
  /// Throws OutputFailure on every rank, as ResultsFolder does on the first.
  explicit SharedFolder(const std::filesystem::path &target);

  /// The hidden folder to write to, the same on every rank.
  const std::filesystem::path &working_folder() const { return partial; }

  /// Runs @p work on the first rank; when it throws, every rank does (on_first_rank()).
  void write(const std::function<void(ResultsFolder &)> &work);

private:
  std::unique_ptr<ResultsFolder> owned;
  const std::filesystem::path partial;
};

} // namespace stemware::pipeline
