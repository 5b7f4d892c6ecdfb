// What a field shows in place of a value where several things are edited at once and do not agree. Called by the
// fields.
#pragma once

#include <QString>

namespace boxprobe {

inline QString differsText() {
  return QString(QChar(0x2014));
}

}  // namespace boxprobe
