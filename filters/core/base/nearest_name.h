// "Did you mean ...?" for messages about unknown names.
#pragma once

#include <string>
#include <vector>

namespace boxprobe {

/// The candidate with the fewest edits (insert, delete, replace, swap of neighbours; case ignored) from `name`; "" if
/// even that one differs in more than a third of its letters.
std::string nearestName(const std::string& name, const std::vector<std::string>& candidates);

/// `; did you mean "floor"?`, or "" without a similar name. To be appended to a message.
std::string didYouMean(const std::string& name, const std::vector<std::string>& candidates);

/// "a, b, c", truncated after `limit` names with the number of those left; "none" for an empty list.
std::string nameList(const std::vector<std::string>& names, std::size_t limit = 12);

}  // namespace boxprobe
