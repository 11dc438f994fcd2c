#pragma once

#include <string>

namespace stemware::pipeline
{

/// Address of the table of functions @p table of the module @p module, nullptr unless it is loaded. A module
/// is a part of the program in a shared object of its own, with the libraries that only this part needs; a
/// test has its modules linked in.
const void *loaded_table(const std::string &table);

/// The same address; loads libstemware_MODULE_module.so first if it is not loaded. Throws BadInput with one
/// sentence if that fails; @p purpose is its subject.
const void *load_table(const std::string &module, const std::string &table, const std::string &purpose);

} // namespace stemware::pipeline
