// What single widgets say, hold and do without a window, against widget_values.txt.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/widgets/accessible_names.h"
#include "app/gui/widgets/axis_colors.h"
#include "app/gui/widgets/cube_view.h"
#include "app/gui/widgets/flow_layout.h"
#include "app/gui/widgets/message_box.h"
#include "app/gui/widgets/panel_layout.h"
#include "app/gui/widgets/panel_section.h"
#include "app/gui/widgets/place_keys.h"
#include "app/gui/widgets/preferences.h"
#include "app/gui/widgets/recent_files.h"
#include "app/gui/widgets/scene_card.h"
#include "app/gui/widgets/scrub_label.h"
#include "app/gui/widgets/search_field.h"
#include "app/gui/widgets/text_button.h"
#include "app/gui/widgets/thumbnails.h"
#include "app/gui/widgets/value_field.h"
#include "app/gui/widgets/vector_row.h"
#include "app/gui/widgets/window_style.h"
#include "app/gui/widgets/window_words.h"
#include "tests/gui/painted_panels.h"
#include "tests/gui/value_lines.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

QString utf8(const char* what) {
  return QString::fromUtf8(what);
}

/// A widget of a fixed size for layouts.
class Sized : public QWidget {
 public:
  Sized(int width, int height, QWidget* parent) : QWidget(parent), size_(width, height) {}
  QSize sizeHint() const override { return size_; }
  QSize minimumSizeHint() const override { return size_ / 2; }

 private:
  QSize size_;
};

void addStyle(ValueLines& lines) {
  for (const Theme theme : {Theme::Light, Theme::System, Theme::Dark}) {
    applyWindowStyle(*qApp, theme);
    const std::string name = "theme " + std::to_string(static_cast<int>(theme));
    for (const auto group : {QPalette::Active, QPalette::Disabled}) {
      QString colors;
      for (int role = 0; role < QPalette::NColorRoles; ++role) {
        if (role == QPalette::Light || role == QPalette::Midlight || role == QPalette::Dark || role == QPalette::Mid ||
            role == QPalette::Shadow)
          continue;
        colors += qApp->palette().color(group, static_cast<QPalette::ColorRole>(role)).name(QColor::HexArgb) + " ";
      }
      lines.add(name, colors + qApp->palette().color(group, QPalette::Light).name(QColor::HexArgb));
    }
    for (const char* kind : {"QMenu", "QCheckBox", "QLabel"}) {
      lines.add(name + " " + kind, QApplication::palette(kind).color(QPalette::Window).name());
    }
    QString colors;
    for (const auto color : {StyleColor::Accent, StyleColor::Dim, StyleColor::Good, StyleColor::Bad,
                             StyleColor::Deciding, StyleColor::Remarkable}) {
      colors += styleColor(color).name() + " ";
    }
    lines.add(name + " colors", colors);
    lines.add(name + " sheet", qApp->styleSheet());
    VectorRow row({}, "tip", nullptr, "XYZ");
    lines.tree(name + " row", row);
  }
  const QColor tones[] = {QColor(255, 166, 26), QColor(20, 60, 200), QColor(120, 120, 120), QColor(0, 0, 0),
                          QColor(255, 255, 255)};
  for (const QColor& one : tones) {
    for (const QColor& other : tones) {
      lines.add("contrast", contrast(one, other));
      lines.add("readable", readable(one, other).name());
    }
  }
  lines.add("colors", axisColor(0).name() + axisColor(1).name() + axisColor(2).name() + boxColor().name() +
                          blendColor().name() + influenceColor().name() + originColor().name() + haloColor().name());
}

void addLayouts(ValueLines& lines) {
  QWidget whole;
  auto* flow = new FlowLayout(7);
  whole.setLayout(flow);
  std::vector<Sized*> blocks;
  for (const auto& [width, height] : {std::pair{50, 20}, {31, 44}, {83, 10}, {19, 35}, {64, 18}}) {
    blocks.push_back(new Sized(width, height, &whole));
    flow->addWidget(blocks.back());
  }
  for (const int width : {40, 88, 89, 130, 171, 400}) {
    flow->setGeometry(QRect(3, 5, width, 300));
    QString text = QString("%1 high").arg(flow->heightForWidth(width));
    for (const Sized* block : blocks) {
      const QRect at = block->geometry();
      text += QString(" %1,%2 %3x%4").arg(at.x()).arg(at.y()).arg(at.width()).arg(at.height());
    }
    lines.add("flow of " + std::to_string(width), text);
  }
  lines.add("flow at least", QString("%1 x %2").arg(flow->minimumSize().width()).arg(flow->minimumSize().height()));
  lines.add("flow takes", QString("%1 %2").arg(flow->takeAt(-1) == nullptr).arg(flow->takeAt(5) == nullptr));
  QLayoutItem* taken = flow->takeAt(0);
  lines.add("flow has", QString("%1 %2 %3").arg(taken != nullptr).arg(flow->count()).arg(flow->hasHeightForWidth()));
  delete taken;

  QWidget content;
  auto* column = new QVBoxLayout(&content);
  QFormLayout* form = addSection(&content, "Sizes");
  addRow(form, "&Width:", new QSlider(&content), "How wide it is. As in the picture");
  auto* pair = new QWidget(&content);
  auto* inPair = new QHBoxLayout(pair);
  auto* lower = new QLineEdit(pair);
  lower->setToolTip("<b>Lower</b> end; in metres");
  auto* upper = new QLineEdit(pair);
  upper->setToolTip("Upper end\nof the range");
  auto* named = new QComboBox(pair);
  named->setAccessibleName("named already");
  for (QWidget* each :
       std::initializer_list<QWidget*>{lower, upper, named, new QPushButton("Words", pair), new QToolButton(pair)})
    inPair->addWidget(each);
  addRow(form, "Range", pair, "");
  auto* vector = new VectorRow({-5.0, 5.0, 0.25, 2, " m"}, "where it is", &content, "XYZ");
  addRow(form, "Place", vector, "Its place");
  addRow(form, "", new QCheckBox(&content), "a switch without words");
  QFormLayout* other = addSection(&content, "Other");
  auto* part = new QLabel("hidden part", &content);
  QToolButton* unfold = unfoldButton(part, "Shows more", &content);
  other->addRow(unfold);
  other->addRow(part);
  other->addRow(new QRadioButton("&Choose one", &content));
  auto* find = new QLineEdit(&content);
  find->setPlaceholderText("Find");
  find->setClearButtonEnabled(true);
  other->addRow(find);
  auto* help = helpLabel(&content);
  help->setText("words of help");
  column->addWidget(help);
  nameControls(&content);
  lines.tree("form", content);
  for (const bool shown : {true, false}) {
    unfold->setChecked(shown);
    lines.add("unfolded", QString("%1 %2").arg(unfold->arrowType()).arg(part->isHidden()));
  }
  QWidget* searched = withSearch(&content, "Search the panel");
  auto* words = searched->findChild<QLineEdit*>("search");
  searched->show();
  lines.tree("searched", *searched);
  const auto sections = content.findChildren<PanelSection*>();
  const auto stateOf = [&] {
    QString text;
    for (PanelSection* section : sections) {
      text += section->title() + (section->isHidden() ? " hidden" : " shown") + (section->folded() ? " folded" : "") +
              (section->maximumHeight() == QWIDGETSIZE_MAX ? " whole; " : " title; ");
    }
    return text;
  };
  for (const char* typed : {"SIZES", "as in the picture", "choose one", "  words ", "metres", "named",
                            "nothing like it", "hidden part", ""}) {
    words->setText(typed);
    lines.add(std::string("search ") + typed, stateOf());
  }
  sections[0]->setFolded(true);
  lines.add("folded", stateOf() + (sectionIsFolded("Sizes") ? "kept" : ""));
  words->setText("width");
  lines.add("folded and found", stateOf());
  sections[1]->setVisible(false);
  words->setText("");
  lines.add("not wanted", stateOf());
  sections[1]->setVisible(true);
  const auto press = [](QWidget* widget, const QPoint& at, Qt::MouseButton button) {
    QMouseEvent event(QEvent::MouseButtonPress, at, at, button, button, {});
    QApplication::sendEvent(widget, &event);
  };
  const int title = sections[1]->fontMetrics().height();
  for (const auto& [y, button] : {std::pair{2, Qt::LeftButton},
                                  {2, Qt::RightButton},
                                  {title + 8, Qt::LeftButton},
                                  {title + 9, Qt::LeftButton},
                                  {2, Qt::LeftButton}}) {
    press(sections[1], {20, y}, button);
    lines.add("pressed", stateOf());
  }
  words->setText("other");
  press(sections[1], {20, 2}, Qt::LeftButton);
  lines.add("pressed while it is searched", stateOf());
  words->setText("");
  sections[0]->setFolded(false);
  // Esc empties the field first.
  words->setText("typed");
  for (int i = 0; i < 2; ++i) {
    QKeyEvent first(QEvent::ShortcutOverride, Qt::Key_Escape, {}), then(QEvent::KeyPress, Qt::Key_Escape, {});
    first.ignore();
    QApplication::sendEvent(words, &first);
    const QString between = words->text();
    QApplication::sendEvent(words, &then);
    lines.add("escape", QString("%1 '%2' '%3'").arg(first.isAccepted()).arg(between, words->text()));
  }
  content.setParent(nullptr);
  delete searched;
}

void addFields(ValueLines& lines) {
  ValueField field({-2.5, 40.0, 0.25, 2, " m"});
  lines.tree("field", field);
  QStringList told;
  QObject::connect(&field, &ValueField::previewed, [&](double value) { told += QString("previewed %1").arg(value); });
  QObject::connect(&field, &ValueField::committed, [&](double value) { told += QString("committed %1").arg(value); });
  QObject::connect(&field, &ValueField::refused, [&](const QString& why) { told += why; });
  const auto done = [&](const std::string& what) {
    lines.add("field " + what, field.text() + " " + told.join(", "));
    told.clear();
  };
  class Open : public ValueField {
   public:
    using ValueField::fixup;
    using ValueField::stepBy;
    using ValueField::validate;
    using ValueField::valueFromText;
  };
  auto& open = static_cast<Open&>(field);
  field.show(3.0);
  done("shown");
  for (const bool differs : {false, true}) {
    field.setDiffers(differs);
    done(differs ? "that differs" : "that does not");
    for (const char* typed : {"3", "3 m", " 7,5 m", "-2.5", "-2.6", "40", "40.01", "1e2", "1.2.3", "", "-", "m",
                              "\u2014", "\u2014 m", "0.004"}) {
      QString typedText = utf8(typed);
      int cursor = 0;
      const int state = open.validate(typedText, cursor);
      lines.add(std::string("typed ") + typed, QString("%1 %2").arg(state).arg(open.valueFromText(typedText)));
      open.fixup(typedText);
      done("after that");
    }
  }
  field.setDiffers(false);
  field.setPrefix("up to ");
  field.setRest(24 * 3600 * 1000);
  QString prefixed = "up to 5 m";
  lines.add("prefixed", open.valueFromText(prefixed));
  open.stepBy(2);
  done("stepped");
  field.endScrub();
  done("at rest");
  field.scrubTo(-9.0);
  done("scrubbed");
  field.endScrub();
  field.endScrub();
  done("let go");
  field.setBounds(0.0, 1.0);
  lines.add("bounds", QString("%1 to %2").arg(field.minimum()).arg(field.maximum()));
  done("bounded");
  field.setValue(0.5);
  done("set");
  ScrubLabel label("X", &field, nullptr);
  field.setBounds(-50.0, 50.0);
  const auto mouse = [&](QEvent::Type type, double x, Qt::MouseButton button, Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(type, QPointF(x, 4.0), QPointF(x, 4.0), QPointF(x, 4.0), button, Qt::LeftButton, keys);
    QApplication::sendEvent(&label, &event);
  };
  mouse(QEvent::MouseMove, 50.0, Qt::NoButton);
  done("moved over");
  mouse(QEvent::MouseButtonPress, 10.0, Qt::RightButton);
  mouse(QEvent::MouseMove, 50.0, Qt::NoButton);
  done("of the right button");
  mouse(QEvent::MouseButtonPress, 10.0, Qt::LeftButton);
  for (const double x : {14.0, 30.0, -15.0}) {
    mouse(QEvent::MouseMove, x, Qt::NoButton);
    done("dragged to " + std::to_string(x));
  }
  mouse(QEvent::MouseMove, 85.0, Qt::NoButton, Qt::ShiftModifier);
  done("dragged finely");
  mouse(QEvent::MouseMove, 9000.0, Qt::NoButton);
  done("dragged too far");
  mouse(QEvent::MouseButtonRelease, 10.0, Qt::RightButton);
  done("not let go");
  mouse(QEvent::MouseButtonRelease, 10.0, Qt::LeftButton);
  mouse(QEvent::MouseMove, 50.0, Qt::NoButton);
  done("dragged and let go");
  field.setEnabled(false);
  mouse(QEvent::MouseButtonPress, 10.0, Qt::LeftButton);
  mouse(QEvent::MouseMove, 50.0, Qt::NoButton);
  done("that is grey");
  VectorRow row({-5.0, 5.0, 0.25, 2, ""}, "where it is", nullptr, "RGB");
  QObject::connect(&row, &VectorRow::previewed,
                   [&](int axis, double value) { told += QString("%1 previewed %2").arg(axis).arg(value); });
  QObject::connect(&row, &VectorRow::committed,
                   [&](int axis, double value) { told += QString("%1 committed %2").arg(axis).arg(value); });
  row.show({1.0, -2.0, 3.5});
  row.setName("Colour");
  for (int axis = 0; axis < 3; ++axis) {
    row.field(axis)->scrubTo(0.5 + axis);
    row.field(axis)->endScrub();
  }
  done("of a row");
  lines.tree("row", row);
}

void addKeysAndFiles(ValueLines& lines) {
  const auto place = [&](int key, quint32 code, Qt::KeyboardModifiers keys) {
    return keyByPlace(QKeyEvent(QEvent::KeyPress, key, keys, code, 0, 0));
  };
  for (const Qt::KeyboardModifiers keys :
       {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier), Qt::KeyboardModifiers(Qt::KeypadModifier)}) {
    for (const int key : {int(Qt::Key_0), int(Qt::Key_9), int(Qt::Key_Slash), int(Qt::Key_Colon), int(Qt::Key_A),
                          int(Qt::Key_Escape), 0x0444, 0x00b5, 0x00e9, 0x00aa, 0x20, 0xffff, 0}) {
      QString found;
      for (const quint32 code : {9u, 10u, 18u, 19u, 20u, 24u, 35u, 36u, 38u, 46u, 47u, 52u, 58u, 59u})
        found += QString(" %1").arg(place(key, code, keys), 0, 16);
      lines.add("key " + QString::number(key, 16).toStdString() + " with " + std::to_string(int(keys) >> 24), found);
    }
  }
  TextButton button;
  int clicks = 0;
  QObject::connect(&button, &TextButton::clicked, [&clicks] { ++clicks; });
  for (const int key : {int(Qt::Key_Return), int(Qt::Key_Enter), int(Qt::Key_A), int(Qt::Key_Space)}) {
    QTest::keyClick(&button, static_cast<Qt::Key>(key));
    lines.add("clicks after a key", clicks);
  }
  lines.tree("text button", button);
  const QFontMetrics metrics(button.font());
  lines.add("least", QString("%1 x %2")
                         .arg(button.minimumSizeHint().width())
                         .arg(button.minimumSizeHint().height() - metrics.height()));
  lines.add("usual", button.sizeHint().width());
  for (const char* heading : {"", "A heading"}) {
    for (const char* body : {"", "Words of it"}) {
      button.show(heading, body, "corner");
      lines.add("name", button.accessibleName());
      lines.add("lines", QString::number((button.heightForWidth(400) - 18) / metrics.height()) + " and " +
                             QString::number((button.heightForWidth(400) - 18) % metrics.height()));
    }
  }
  SceneCard card("title", "words"), bare("title", "");
  lines.tree("card", card);
  lines.add("card", QString("%1 x %2, %3")
                        .arg(card.sizeHint().width())
                        .arg(card.sizeHint().height() - 2 * card.fontMetrics().lineSpacing())
                        .arg(bare.accessibleName()));
  CubeFaces faces;
  lines.tree("faces", faces);
  for (const auto kind : {CubePictureKind::Cross, CubePictureKind::LatLong}) {
    faces.show(nullptr, kind, 1.0f, "");
    lines.add("faces", QString("%1 %2 %3")
                           .arg(faces.sizeHint().width())
                           .arg(faces.sizeHint().height())
                           .arg(faces.heightForWidth(120)));
  }

  QTemporaryDir folder;
  for (int i = 0; i < 11; ++i) rememberFile(folder.filePath(QString("%1.json").arg(i)));
  rememberFile(folder.filePath("6.json"));
  forgetFile(folder.filePath("4.json"));
  forgetFile(folder.filePath("none.json"));
  QString recent;
  for (const QString& each : recentFiles()) recent += QFileInfo(each).fileName() + " ";
  lines.add("recent", recent);
  keepThumbnail(folder.filePath("6.json"), someColors(500, 130));
  const QImage small = readThumbnail(thumbnailPath(folder.filePath("6.json")));
  lines.add("thumbnail", QString("%1 x %2").arg(small.width()).arg(small.height()));
  if (!small.isNull()) {
    // JPEG is not exact: tens.
    for (const auto& [x, y] : {std::pair{5, 5}, {300, 110}, {170, 200}}) {
      const QColor at = small.pixelColor(x, y);
      lines.add("its colours", QString("%1 %2").arg((at.red() + 5) / 20).arg((at.green() + 5) / 20));
    }
  }
  for (const auto& [width, height] : {std::pair{1024, 8}, {1025, 8}, {8, 1024}, {8, 1025}}) {
    const QString path = folder.filePath(QString("%1x%2.png").arg(width).arg(height));
    someColors(width, height).save(path);
    lines.add("read", QString("%1 %2").arg(width).arg(readThumbnail(path).width()));
  }
  lines.add("read nothing", readThumbnail(folder.filePath("none.jpg")).width());

  lines.add("preferences", QString("%1 %2 %3 %4")
                               .arg(cutsAway())
                               .arg(refinesAtRest())
                               .arg(cheaperWhileMoving().has_value())
                               .arg(chosenTheme().value_or(-1)));
  keepCutaway(true);
  keepRefinesAtRest(false);
  keepCheaperWhileMoving(true);
  for (const int theme : {0, 1, 2, 3, -1}) {
    keepTheme(theme);
    lines.add("theme", chosenTheme().value_or(-7));
  }
  preferences()->setValue("theme", "dark");
  lines.add("theme", chosenTheme().value_or(-7));
  keepTheme(1);
  lines.add("preferences", QString("%1 %2 %3 %4")
                               .arg(cutsAway())
                               .arg(refinesAtRest())
                               .arg(cheaperWhileMoving().value_or(false))
                               .arg(chosenTheme().value_or(-1)));
  keepWindowLayout("geometry", "docks");
  lines.add("layout", QString(windowLayout().geometry + " " + windowLayout().docks));
  for (const char* key : {"cutaway", "refinesAtRest", "cheaperWhileMoving", "theme", "windowGeometry", "windowDocks"})
    preferences()->remove(key);
  for (const char* sentence :
       {"Which unit? --set models.0.unit=cm", "Up is Y, --set models.0.upAxis=z", "It is so; or --set a=1",
        "All of it, or use --as interior or not", "It loses; --lossy drops it", "Say --set x=1, then"}) {
    lines.add("words", windowWords(sentence));
  }
  for (const char* tip : {"plain", "<b>rich</b>", "a < b"}) lines.add("tip", plainToolTip(tip));
  PlainQuestion question(nullptr, "Title", "<b>Is it?</b>", QMessageBox::Yes | QMessageBox::No);
  lines.add("question", QString("%1 %2 %3 %4")
                            .arg(question.text())
                            .arg(question.textFormat())
                            .arg(question.icon())
                            .arg(int(question.standardButtons())));
}

TEST(WidgetValues, OfEachWidgetAreAsBefore) {
  if (!widgetLinesHold()) GTEST_SKIP() << "kept for another Qt than " << qVersion();
  ValueLines lines;
  addStyle(lines);
  addLayouts(lines);
  addFields(lines);
  addKeysAndFiles(lines);
  expectKeptWidgets("gui/values/widget_values.txt", lines.lines());
}

}  // namespace
}  // namespace boxprobe
