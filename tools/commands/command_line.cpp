#include "tools/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

#include "tools/commands/command.h"

namespace warplut {

CommandOption& CommandOption::Required() {
  option_->required();
  return *this;
}

CommandOption& CommandOption::ShowDefault() {
  option_->capture_default_str();
  return *this;
}

CommandOption& CommandOption::Separated() {
  option_->delimiter(',');
  return *this;
}

CommandOption& CommandOption::OneOf(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}

CommandOption& CommandOption::Within(int least, int greatest) {
  option_->check(CLI::Range(least, greatest));
  return *this;
}

CommandOption& CommandOption::NotNegative() {
  option_->check(CLI::NonNegativeNumber);
  return *this;
}

CommandOption& CommandOption::Excludes(const CommandOption& other) {
  option_->excludes(other.option_);
  return *this;
}

CommandOption& CommandOption::Needs(const CommandOption& other) {
  option_->needs(other.option_);
  return *this;
}

Command Command::AddCommand(const std::string& name, const std::string& help) {
  app_->require_subcommand(0, 1);
  return Command(app_->add_subcommand(name, help));
}

template <class T>
CommandOption Command::Add(const std::string& name, T& value, const std::string& help) {
  return CommandOption(app_->add_option(name, value, help));
}

template CommandOption Command::Add(const std::string&, std::string&, const std::string&);
template CommandOption Command::Add(const std::string&, std::filesystem::path&, const std::string&);
template CommandOption Command::Add(const std::string&, int&, const std::string&);
template CommandOption Command::Add(const std::string&, std::uint64_t&, const std::string&);
template CommandOption Command::Add(const std::string&, float&, const std::string&);
template CommandOption Command::Add(const std::string&, double&, const std::string&);
template CommandOption Command::Add(const std::string&, std::optional<double>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<std::string>&,
                                    const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<int>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<float>&, const std::string&);
template CommandOption Command::Add(const std::string&, std::vector<double>&, const std::string&);

CommandOption Command::AddFlag(const std::string& name, bool& value, const std::string& help) {
  return CommandOption(app_->add_flag(name, value, help));
}

void Command::OnParsed(std::function<void()> then) { app_->callback(std::move(then)); }

bool Command::Given(const std::string& name) const { return app_->count(name) > 0; }

CommandLine::CommandLine(const std::string& name, const std::string& help,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(help, name)) {
  app_->set_version_flag("--version", name + " " + version);
}

CommandLine::~CommandLine() = default;

bool CommandLine::Parse(int argc, const char* const* argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    app_->exit(asked);
    return false;
  } catch (const CLI::ParseError& wrong) {
    throw UsageError(wrong.what());
  }
  return true;
}

}  // namespace warplut
