#pragma once

#include <string>

namespace stemware::pipeline
{

/// Returns the address of a module's function table, nullptr unless the module is loaded. A module is a
/// shared object with a part of the program and the libraries that only this part needs; tests link their
/// modules.
const void *loaded_table(const std::string &table);

/// Returns the address after loading libstemware_MODULE_module.so if necessary. Throws BadInput if that
/// fails; @p purpose is the subject of its sentence.
const void *load_table(const std::string &module, const std::string &table, const std::string &purpose);

} // namespace stemware::pipeline
