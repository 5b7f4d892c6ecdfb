// See welcome.h.
#include "app/gui/window/welcome.h"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/gui/widgets/flow_layout.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/scene_card.h"
#include "app/gui/widgets/thumbnails.h"

namespace boxprobe {

namespace {

constexpr int kGap = 8;
constexpr const char* kSceneSuffix = ".boxprobe.json";

struct Example {
  const char *name, *title, *words;
};

/// Those to begin with first.
constexpr Example kExamples[] = {
    {"room", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Room"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "one box fits exactly")},
    {"building", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Building"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "an open pavilion")},
    {"flat", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Flat"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "furnished, evening sun")},
    {"furnished", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Furnished"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "the limits of a box")},
    {"windows", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Windows"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "light through openings")},
    {"glass", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Glass"), QT_TRANSLATE_NOOP("boxprobe::Welcome", "refraction")},
    {"gallery", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Gallery"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "for measuring")},
    {"mirror-hall", QT_TRANSLATE_NOOP("boxprobe::Welcome", "Mirror hall"),
     QT_TRANSLATE_NOOP("boxprobe::Welcome", "planar mirrors")},
};

QLabel* heading(const QString& text, double scale) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(scale * font.pointSizeF());
  font.setBold(true);
  label->setFont(font);
  return label;
}

}  // namespace

Welcome::Welcome(QWidget* picture, const QString& scenes) : QWidget(picture) {
  setAttribute(Qt::WA_NoMousePropagation);  // to the picture below, which it covers
  setObjectName("welcome");
  setAutoFillBackground(true);
  setCursor(Qt::ArrowCursor);
  picture->installEventFilter(this);
  resize(picture->size());

  auto* content = new QWidget;
  auto* rows = new QVBoxLayout(content);
  constexpr int kMargin = 16;
  rows->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  rows->setSpacing(kGap);
  rows->addWidget(heading(tr("Welcome"), 1.5));
  auto* hint = new QLabel(tr("Open a scene or a model, or drop a file into this window."));
  hint->setObjectName("help");
  hint->setWordWrap(true);
  rows->addWidget(hint);
  rows->addWidget(buttons());
  const auto section = [rows](const QString& title, QLabel*& label, FlowLayout*& cards) {
    rows->addSpacing(kGap);
    rows->addWidget(label = heading(title, 1.1));
    rows->addLayout(cards = new FlowLayout(kGap));
  };
  section(tr("Recent"), recentTitle_, recent_);
  section(tr("Examples"), examplesTitle_, examples_);
  rows->addStretch(1);

  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);

  reading_.setInterval(0);
  connect(&reading_, &QTimer::timeout, this, &Welcome::readNext);
  addExamples(scenes);
  setRecent({});
}

QWidget* Welcome::buttons() {
  auto* row = new QWidget;
  auto* flow = new FlowLayout(kGap);
  row->setLayout(flow);
  const auto button = [&](const QString& text, const QString& tip, const char* name, void (Welcome::*asked)()) {
    auto* made = new QPushButton(text);
    made->setObjectName(name);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, asked);
    flow->addWidget(made);
  };
  button(tr("Open..."), tr("A scene or a model (Ctrl+O)"), "welcomeOpen", &Welcome::openRequested);
  button(tr("New from a model..."), tr("A new scene: probe, camera, light and exposure are fitted to the model"),
         "welcomeModel", &Welcome::modelRequested);
  button(tr("Lessons"), tr("Reflection probes, step by step (F1)"), "welcomeLessons", &Welcome::lessonsRequested);
  return row;
}

void Welcome::addExamples(const QString& folder) {
  for (const Example& each : kExamples) {
    const QString path = QDir(folder).filePath(each.name + QString(kSceneSuffix));
    if (!QFileInfo::exists(path)) continue;
    add(examples_, tr(each.title), tr(each.words), path,
        QDir(folder).filePath(QString("thumbnails/%1.jpg").arg(each.name)));
  }
  examplesTitle_->setVisible(examples_->count() > 0);
}

void Welcome::setRecent(const QStringList& paths) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  for (const QString& path : paths) {
    QString name = QFileInfo(path).fileName();
    if (name.endsWith(kSceneSuffix)) name.chop(static_cast<int>(qstrlen(kSceneSuffix)));
    add(recent_, name, QDir::toNativeSeparators(QFileInfo(path).path()), path, thumbnailPath(path));
  }
  recentTitle_->setVisible(!paths.isEmpty());
}

void Welcome::add(FlowLayout* to, const QString& title, const QString& words, const QString& path,
                  const QString& thumbnail) {
  auto* card = new SceneCard(title, words);
  card->setToolTip(plainToolTip(QDir::toNativeSeparators(path)));
  connect(card, &QPushButton::clicked, this, [this, path] { emit chosen(path); });
  to->addWidget(card);
  card->show();
  waiting_.append({card, thumbnail});
  reading_.start();
}

void Welcome::readNext() {
  if (!isVisible()) return reading_.stop();  // goes on once it is seen
  while (!waiting_.isEmpty()) {
    const Waiting next = waiting_.takeFirst();
    if (next.card == nullptr) continue;
    next.card->setPicture(readThumbnail(next.thumbnail));
    return;
  }
  reading_.stop();
}

bool Welcome::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parent() && event->type() == QEvent::Resize) resize(parentWidget()->size());
  return QWidget::eventFilter(watched, event);
}

void Welcome::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  raise();  // what stands over the picture was made later
  reading_.start();
}

}  // namespace boxprobe
