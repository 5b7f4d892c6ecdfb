// See place_keys.h.
#include "app/gui/widgets/place_keys.h"

#include <QKeyEvent>
#include <QLatin1String>

namespace boxprobe {

namespace {

struct Row {
  quint32 first;  ///< the code of its first key: that of Linux and 8
  const char* keys;
};

constexpr Row kDigits[] = {{10, "1234567890"}};
constexpr Row kLetters[] = {{24, "QWERTYUIOP[]"}, {38, "ASDFGHJKL"}, {52, "ZXCVBNM"}};

template <std::size_t Count>
int keyAt(const Row (&rows)[Count], quint32 code) {
  for (const Row& row : rows) {
    const auto length = static_cast<quint32>(QLatin1String(row.keys).size());
    if (code >= row.first && code < row.first + length) return row.keys[code - row.first];
  }
  return 0;
}

/// Of a script other than Latin.
bool isForeignLetter(int key) {
  constexpr int kLastCharacter = 0xffff;
  if (key <= 0 || key > kLastCharacter) return false;
  const QChar letter(static_cast<ushort>(key));
  // The micro sign and the ordinal indicators stand on Latin keyboards.
  return letter.isLetter() && letter.script() != QChar::Script_Latin && letter.script() != QChar::Script_Common;
}

}  // namespace

int keyByPlace(const QKeyEvent& event) {
  const int key = event.key();
  const quint32 code = event.nativeScanCode();
  if ((key >= Qt::Key_0 && key <= Qt::Key_9) || event.modifiers().testFlag(Qt::KeypadModifier)) return key;
  // With Shift these keys are punctuation on most keyboards.
  const int digit = event.modifiers().testFlag(Qt::ShiftModifier) ? 0 : keyAt(kDigits, code);
  if (digit != 0 && key >= 0x20 && key < 0x1000000) return digit;
  const int letter = isForeignLetter(key) ? keyAt(kLetters, code) : 0;
  return letter != 0 ? letter : key;
}

}  // namespace boxprobe
