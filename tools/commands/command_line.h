// The command line of a program: commands, their options, and what makes a value right. Only
// command_line.cpp knows the library that parses it (CLI11), which takes seconds to compile.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/manual/command_description.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace warplut {

// An option that was added; a handle, as long as its CommandLine lives.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption& Required();
  // The help shows the value that the variable has now.
  CommandOption& ShowDefault();
  // A list of values is separated by commas.
  CommandOption& Separated();
  // Each value is one of these.
  CommandOption& OneOf(const std::vector<std::string>& values);
  // Each value lies in [least, greatest].
  CommandOption& Within(int least, int greatest);
  CommandOption& NotNegative();
  CommandOption& Excludes(const CommandOption& other);
  CommandOption& Needs(const CommandOption& other);

 private:
  CLI::Option* option_;
};

// A command, or the program itself; a handle, as long as its CommandLine lives.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  Command AddCommand(const std::string& name, const std::string& help);
  // Adds an option, "--name" or a positional "name". Parsing it sets `value`, which must outlive
  // the parsing. T: the types that command_line.cpp lists.
  template <class T>
  CommandOption Add(const std::string& name, T& value, const std::string& help);
  CommandOption AddFlag(const std::string& name, bool& value, const std::string& help);
  // Called after the parsing, if the command was given.
  void OnParsed(std::function<void()> then);
  // Whether the option was given; to be asked after the parsing.
  bool Given(const std::string& name) const;
  // All that was added to it so far, and to the commands below it.
  CommandDescription Describe() const;

 private:
  CLI::App* app_;
};

class CommandLine {
 public:
  CommandLine(const std::string& name, const std::string& help, const std::string& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command program() { return Command(app_.get()); }

  // Returns false if the help or the version was asked for, which are printed then. Throws
  // UsageError.
  bool Parse(int argc, const char* const* argv);

 private:
  std::unique_ptr<CLI::App> app_;
};

}  // namespace warplut
