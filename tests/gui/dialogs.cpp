// See dialogs.h.
#include "tests/gui/dialogs.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QInputDialog>
#include <QLineEdit>
#include <QPointer>
#include <QTest>
#include <QTimer>

namespace boxprobe {

namespace {

constexpr int kPollMilliseconds = 20;
constexpr int kPolls = 6000;  // of an event loop that turns: two minutes

/// Of dialogs of that kind: one at a time.
template <typename Dialog>
QPointer<QTimer>& pendingAnswer() {
  static QPointer<QTimer> pending;
  return pending;
}

/// Calls `answer` with the modal dialog once there is one of that kind.
template <typename Dialog, typename Answer>
void whenShown(const Answer& answer) {
  // An answer that no dialog came for must not be given to the dialog of a later test.
  QPointer<QTimer>& pending = pendingAnswer<Dialog>();
  delete pending.data();
  auto* timer = new QTimer(qApp);
  pending = timer;
  timer->setInterval(kPollMilliseconds);
  QObject::connect(timer, &QTimer::timeout, [timer, answer, left = kPolls]() mutable {
    auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
    if (!dialog && --left > 0) return;
    timer->stop();
    timer->deleteLater();
    if (dialog) answer(dialog);
  });
  timer->start();
}

}  // namespace

std::shared_ptr<SeenDialog> answerMessageBox(QMessageBox::StandardButton button) {
  auto seen = std::make_shared<SeenDialog>();
  whenShown<QMessageBox>([seen, button](QMessageBox* box) {
    seen->text = box->text();
    seen->plain = box->textFormat() == Qt::PlainText;
    QTest::mouseClick(box->button(button), Qt::LeftButton);
  });
  return seen;
}

std::shared_ptr<SeenDialog> answerMessageBox(const QString& button) {
  auto seen = std::make_shared<SeenDialog>();
  whenShown<QMessageBox>([seen, button](QMessageBox* box) {
    seen->text = box->text();
    seen->plain = box->textFormat() == Qt::PlainText;
    for (QAbstractButton* each : box->buttons()) {
      if (QString(each->text()).remove('&').startsWith(button)) return QTest::mouseClick(each, Qt::LeftButton);
    }
    box->reject();
  });
  return seen;
}

std::shared_ptr<SeenDialog> answerInputDialog(const QString& text) {
  auto seen = std::make_shared<SeenDialog>();
  whenShown<QInputDialog>([seen, text](QInputDialog* dialog) {
    seen->text = dialog->windowTitle() + ": " + dialog->labelText() + " " + dialog->textValue();
    if (text.isEmpty()) return dialog->reject();
    dialog->setTextValue(text);
    dialog->accept();
  });
  return seen;
}

std::shared_ptr<SeenDialog> answerFileDialog(const QString& path) {
  auto seen = std::make_shared<SeenDialog>();
  whenShown<QFileDialog>([seen, path](QFileDialog* dialog) {
    seen->text = dialog->windowTitle();
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    name->setText(path);
    QTest::keyClick(name, Qt::Key_Return);
  });
  return seen;
}

}  // namespace boxprobe
