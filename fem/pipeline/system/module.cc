#include "fem/pipeline/system/module.h"

#include "fem/pipeline/support/failures.h"

#include <dlfcn.h>

namespace stemware::pipeline
{

const void *loaded_table(const std::string &table)
{
  return ::dlsym(RTLD_DEFAULT, table.c_str());
}

const void *load_table(const std::string &module, const std::string &table, const std::string &purpose)
{
  if (const void *loaded = loaded_table(table))
    return loaded;
  // The loader looks where the program's run path says: beside the program in a build, in lib/stemware where
  // it is installed. The symbols are for other modules too.
  const std::string name = "stemware_" + module + "_module", file = "lib" + name + ".so";
  if (::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL) == nullptr)
    throw BadInput(
      purpose + " needs a part of Stemware that cannot be loaded (" + ::dlerror() +
      "); build it with `./quickstart install`, or in a build folder with `cmake --build . --target " + name +
      "`.");
  return loaded_table(table);
}

} // namespace stemware::pipeline
