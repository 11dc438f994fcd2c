#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <unistd.h>

namespace stemware::fem_tests
{

/// A file that is removed with the object. Its name contains the process id, for parallel tests and ranks.
struct TemporaryFile
{
  explicit TemporaryFile(const std::string &content, const std::string &extension = ".msh")
      : name(::testing::TempDir() + "stemware_mesh_file_test_" + std::to_string(getpid()) + extension)
  {
    std::ofstream(name) << content;
  }
  ~TemporaryFile() { std::remove(name.c_str()); }
  TemporaryFile(const TemporaryFile &) = delete;
  TemporaryFile &operator=(const TemporaryFile &) = delete;

  const std::string name;
};

} // namespace stemware::fem_tests
