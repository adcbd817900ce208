#include <host_sim/tools/output/command_line.hpp>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>

namespace host_sim {

Option& Option::required() {
  option_->required();
  return *this;
}

Option& Option::show_default() {
  option_->capture_default_str();
  return *this;
}

Option& Option::expected(int values) {
  option_->expected(values);
  return *this;
}

Option& Option::existing_file() {
  option_->check(CLI::ExistingFile);
  return *this;
}

Option& Option::one_of(const std::vector<std::string>& values) {
  option_->check(CLI::IsMember(values));
  return *this;
}

template <class T>
Option& Option::range(T lowest, T highest) {
  option_->check(CLI::Range(lowest, highest));
  return *this;
}

template <class T>
Option OptionList::option(const std::string& name, T& value, const std::string& text) {
  return Option(app_->add_option(name, value, text));
}

void OptionList::flag(const std::string& name, bool& value, const std::string& text) {
  app_->add_flag(name, value, text);
}

CommandLine::CommandLine(const std::string& text, const std::string& name)
    : OptionList(nullptr), owned_(std::make_unique<CLI::App>(text, name)) {
  app_ = owned_.get();
  app_->fallthrough();
}

CommandLine::~CommandLine() = default;

OptionList CommandLine::verb(const std::string& name, const std::string& text, const std::function<void()>& job) {
  app_->require_subcommand(1);
  CLI::App* verb = app_->add_subcommand(name, text);
  verb->callback(job);
  return OptionList(verb);
}

int CommandLine::run(int count, char** arguments, const std::function<int()>& job) {
  try {
    app_->parse(count, arguments);
    return job();
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    const std::string name = std::filesystem::path(app_->get_name()).filename();
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 1;
  }
}

template Option& Option::range(int, int);
template Option& Option::range(double, double);
template Option& Option::range(std::uint64_t, std::uint64_t);
template Option OptionList::option(const std::string&, int&, const std::string&);
template Option OptionList::option(const std::string&, unsigned&, const std::string&);
template Option OptionList::option(const std::string&, std::uint64_t&, const std::string&);
template Option OptionList::option(const std::string&, double&, const std::string&);
template Option OptionList::option(const std::string&, std::string&, const std::string&);
template Option OptionList::option(const std::string&, std::vector<double>&, const std::string&);

}  // namespace host_sim
