#include "app/cli/options/help_text.h"

namespace boxprobe {

namespace {

constexpr std::size_t kColumn = 30;

// A name and what it means in the second column, on a line of its own where the name is too long.
std::string entry(const std::string& name, const std::string& meaning) {
  std::string text = "  " + name;
  if (meaning.empty()) return text + "\n";
  text += text.size() >= kColumn ? "\n" + std::string(kColumn, ' ') : std::string(kColumn - text.size(), ' ');
  for (const char c : meaning) text += c == '\n' ? "\n" + std::string(kColumn, ' ') : std::string(1, c);
  return text + "\n";
}

// "OPTIONS" from 2.5 on, "Options" before.
std::string heading(const std::string& group) {
  std::string text = group.substr(0, 1) + CLI::detail::to_lower(group.substr(1));
  return "\n" + (CLI::detail::to_lower(group) == "options" ? text : group) + ":\n";
}

bool takesMany(const CLI::Option& option) {
  return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string listed(const char* what, const std::set<CLI::Option*>& options) {
  if (options.empty()) return {};
  std::string text = std::string(" ") + what + ":";
  for (const CLI::Option* option : options) text += " " + option->get_name();
  return text;
}

std::string values(const CLI::Option& option) {
  if (!option.get_option_text().empty()) return " " + option.get_option_text();
  std::string text;
  if (option.get_type_size() != 0) {
    if (!option.get_type_name().empty()) text += " " + option.get_type_name();
    if (!option.get_default_str().empty()) text += "=" + option.get_default_str();
    if (takesMany(option)) {
      text += " ...";
    } else if (option.get_expected_min() > 1) {
      text += " x " + std::to_string(option.get_expected());
    }
    if (option.get_required()) text += " REQUIRED";
  }
  return text + listed("Needs", option.get_needs()) + listed("Excludes", option.get_excludes());
}

std::string usage(const CLI::App& app, const std::string& name) {
  std::string text = "Usage: " + name;
  if (!app.get_options([](const CLI::Option* o) { return o->nonpositional(); }).empty()) text += " [OPTIONS]";
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
    std::string place = option->get_name(true, false);
    if (takesMany(*option)) {
      place += "...";
    } else if (option->get_expected_max() > 1) {
      place += "(" + std::to_string(option->get_expected()) + "x)";
    }
    text += option->get_required() ? " " + place : " [" + place + "]";
  }
  if (!app.get_subcommands([](const CLI::App*) { return true; }).empty()) {
    text += app.get_require_subcommand_min() == 0 ? " [SUBCOMMAND]" : " SUBCOMMAND";
  }
  return text + "\n";
}

}  // namespace

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const {
  std::string text = app->get_description() + "\n" + usage(*app, name);
  const auto section = [&](const std::string& title, const std::vector<const CLI::Option*>& options, bool places) {
    if (options.empty()) return;
    text += heading(title);
    for (const CLI::Option* option : options) {
      text += entry(option->get_name(places, !places) + values(*option), option->get_description());
    }
  };
  section("Positionals",
          app->get_options([](const CLI::Option* o) { return !o->get_group().empty() && o->get_positional(); }), true);
  for (const std::string& group : app->get_groups()) {
    if (group.empty()) continue;
    section(group,
            app->get_options([&](const CLI::Option* o) { return o->get_group() == group && o->nonpositional(); }),
            false);
  }
  const auto commands = app->get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
  if (!commands.empty()) text += "\nSubcommands:\n";
  for (const CLI::App* command : commands) text += entry(command->get_name(), command->get_description());
  return text + "\n" + (app->get_footer().empty() ? "" : app->get_footer() + "\n");
}

}  // namespace boxprobe
