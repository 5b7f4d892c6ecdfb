// A number with its unit that edits as one step: what is typed is committed with Enter or when the field is left; while
// an arrow is held or the wheel turned the value is previewed and committed once at the end. Called by the panels,
// which connect the two signals to the editor; knows no document.
#pragma once

#include <QDoubleSpinBox>
#include <QTimer>

namespace boxprobe {

class ValueField : public QDoubleSpinBox {
  Q_OBJECT

 public:
  struct Format {
    double minimum = -1e7;
    double maximum = 1e7;
    double step = 0.1;
    int decimals = 3;
    QString suffix;
  };

  explicit ValueField(const Format& format, QWidget* parent = nullptr);

  /// Shows a value of the document; no signal. Text being typed stays.
  void show(double value);
  /// What it stands for differs: a dash is shown in place of the number, and what is typed counts even where it is the
  /// number behind the dash.
  void setDiffers(bool differs);
  bool differs() const { return differs_; }
  /// Narrows what can be entered; the value shown always stays within.
  void setBounds(double minimum, double maximum);
  /// For scrubbing from outside: previews `value`, brought into range.
  void scrubTo(double value);
  void endScrub();

  /// How many milliseconds steps may be apart and still be one edit. Tests lengthen it: a slow machine is no rest.
  void setRest(int milliseconds);
  static constexpr int kRestMilliseconds = 400;

 signals:
  void previewed(double value);
  void committed(double value);
  /// One line: why what was typed was not taken.
  void refused(const QString& why);

 protected:
  QString textFromValue(double value) const override;
  /// One separator is the decimal mark, whatever the locale. What is wrong stays until the field is left.
  QValidator::State validate(QString& text, int& cursor) const override;
  double valueFromText(const QString& text) const override;
  /// Says why what was typed is not taken; the value from before comes back.
  void fixup(QString& text) const override;
  void stepBy(int steps) override;
  void wheelEvent(QWheelEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QString withoutUnit(const QString& text) const;
  void changed(double value);
  void commitPreview();
  void commitSoon();

  QTimer restTimer_;
  bool stepping_ = false;
  bool previewing_ = false;
  bool differs_ = false, typed_ = false;
};

}  // namespace boxprobe
