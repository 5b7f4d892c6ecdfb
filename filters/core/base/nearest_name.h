// "Did you mean ...?" for every message about a name that is not known. Called by core, io and the command line.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// The candidate with the fewest edits (insert, delete, replace, swap of neighbours; case ignored) from `name`, or ""
/// where even that one differs in more than a third of its letters: a wild guess helps nobody.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

/// `; did you mean "floor"?`, or "" without a near name. To be put behind a message.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

/// "a, b, c", cut after `limit` names with how many more there are; "none" for an empty list.
std::string nameList(const std::vector<std::string>& names, std::size_t limit = 12);

}  // namespace boxprobe
