// Fits of a scene's boxes that several processes make together, on one machine or many.
#pragma once

#include <optional>
#include <string>

#include "filters/fit/box/fit_box.h"

namespace boxprobe {

class SharedFits {
 public:
  virtual ~SharedFits() = default;
  /// Of the fits numbered from 0, those that this process makes.
  virtual bool mine(std::size_t number) const = 0;
  /// The fit of that name, if one of the processes made it. `start`: the probe that was fitted, for all of the fields
  /// that a fit leaves as they are.
  virtual std::optional<BoxFit> find(const std::string& name, const Probe& start) const = 0;
  virtual void keep(const std::string& name, const BoxFit& fit) const = 0;
};

}  // namespace boxprobe
