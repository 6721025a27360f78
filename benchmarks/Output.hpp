#pragma once
/// What a program writes, for tests of benchmarks.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

/// What it wrote and how it ended, as waitpid has it.
struct Output
{
  std::string text;
  int status = -1;
};

/// Runs a command of the shell.
inline Output outputOf(const std::string& command)
{
  Output output;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr)
  {
    ADD_FAILURE() << "no shell for " << command;
    return output;
  }
  std::array<char, 4096> buffer;
  for (std::size_t got; (got = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    output.text.append(buffer.data(), got);
  output.status = pclose(pipe);
  return output;
}
