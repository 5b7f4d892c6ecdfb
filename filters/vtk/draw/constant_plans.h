// Which numbers each object's program is made for while nothing is edited, so that programs stay few: what all objects
// of a program share costs no further one; many objects that differ by a number keep it as a uniform.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/draw/resting_values.h"

namespace boxprobe {

/// One object: its program without constants (equal strings share one), and the numbers it is drawn with.
struct ConstantUse {
  std::string program;
  RestingValues values;
};

/// For each object, in the order of `uses`, the numbers its program is made for; objects of one program that share a
/// pointer share the program that comes of it. Where most objects gain most, up to `more` programs are added to those
/// there are. O(n log n) in the number of objects.
std::vector<std::shared_ptr<const RestingValues>> foldableConstants(const std::vector<ConstantUse>& uses,
                                                                    std::size_t more);

}  // namespace boxprobe
