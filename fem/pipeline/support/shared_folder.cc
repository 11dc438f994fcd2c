#include "fem/pipeline/support/shared_folder.h"

#include "fem/pipeline/support/ranks.h"

namespace stemware::pipeline
{

SharedFolder::SharedFolder(const std::filesystem::path &target)
    : partial(on_first_rank(
        [&]
        {
          owned = std::make_unique<ResultsFolder>(target);
          return owned->working_folder().string();
        }))
{
}

void SharedFolder::write(const std::function<void(ResultsFolder &)> &work)
{
  on_first_rank(
    [&]
    {
      work(*owned);
      if (!owned->is_published())
        owned->record();
      return std::string();
    });
}

} // namespace stemware::pipeline
