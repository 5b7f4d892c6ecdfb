// The probes that are proposed, one below the other: a tick, why each is there and what it gains, and small pictures of
// its room before and after. Called by the place panel; knows no scene.
#pragma once

#include <QDialog>
#include <QImage>
#include <QString>
#include <QWidget>
#include <array>
#include <vector>

class QCheckBox;

namespace boxprobe {

/// One room as an eye in it sees it.
struct PlacedPictures {
  enum Kind { Before, After, Traced, ErrorBefore, ErrorAfter };
  static constexpr int kCount = 5;
  std::array<QImage, kCount> images;  ///< of one size; null: there are none
};

struct PlacedEntry {
  QString name;
  QString reason, gain;  ///< one or two lines; what more there is to say is in `details`
  QString details;
  PlacedPictures pictures;
};

class PlacedList : public QWidget {
  Q_OBJECT

 public:
  explicit PlacedList(QWidget* parent = nullptr);

  /// All of them ticked.
  void show(const std::vector<PlacedEntry>& entries);
  bool ticked(std::size_t entry) const;

 signals:
  void changed();

 private:
  QWidget* rows_ = nullptr;
  std::vector<QCheckBox*> ticks_;
};

/// The pictures of one entry side by side, large.
class PlacedPicturesDialog : public QDialog {
  Q_OBJECT

 public:
  PlacedPicturesDialog(const PlacedEntry& entry, QWidget* parent);
};

}  // namespace boxprobe
