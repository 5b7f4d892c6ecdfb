// See mathml_layout.h. Spaces around operators are MathML's own (operator dictionary), coarsely: relations wide, sums
// middling, products and fences none.
#include "app/gui/formula/mathml_layout.h"

#include <QRegularExpression>
#include <QStringList>
#include <QXmlStreamReader>
#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace boxprobe {

namespace {

constexpr double kScriptScale = 0.7, kSmallest = 0.5;

struct Node {
  QString tag, text;
  std::map<QString, QString> attributes;
  std::vector<Node> children;
};

Node readNode(QXmlStreamReader& xml) {
  Node node;
  node.tag = xml.name().toString();
  for (const auto& attribute : xml.attributes())
    node.attributes[attribute.name().toString()] = attribute.value().toString();
  while (!xml.atEnd()) {
    xml.readNext();
    if (xml.isStartElement()) {
      node.children.push_back(readNode(xml));
    } else if (xml.isCharacters()) {
      node.text += xml.text();
    } else if (xml.isEndElement()) {
      break;
    }
  }
  // XML's own blanks alone: an em space is room that was asked for.
  static const QRegularExpression blanks("[ \\t\\r\\n]+");
  node.text = node.text.split(blanks, Qt::SkipEmptyParts).join(' ');
  return node;
}

bool isFence(const QString& text) {
  static const QString fences = QString::fromUtf8("()[]{}|‖⌊⌋⌈⌉⟨⟩");
  return text.size() == 1 && fences.contains(text);
}

bool opens(const QString& text) {
  static const QString opening = QString::fromUtf8("([{⌊⌈⟨");
  return text.size() == 1 && opening.contains(text);
}

/// On both sides of an operator between two operands, in em.
double operatorSpace(const QString& text) {
  static const QString sums = QString::fromUtf8("+-−±∓×∪∩∧∨/");
  static const QString products = QString::fromUtf8("·⋅∘*⊙");
  static const QString close = QString::fromUtf8("′″!:\u2061\u2062\u2063\u2064");
  static const QString large = QString::fromUtf8("∑∏∫");
  const bool room = text.size() == 1 && text[0].isSpace();
  if (room || isFence(text) || close.contains(text)) return 0.0;
  if (text == "/") return 0.06;
  if (text == "," || text == ";" || large.contains(text)) return 0.14;
  if (sums.contains(text)) return 0.22;
  if (products.contains(text)) return 0.14;
  const bool word = text.size() > 1 && text[0].isLetter();
  return word ? 0.14 : 0.28;
}

class Layout {
 public:
  MathBox box(const Node& node, double size) const {
    const auto part = [&](std::size_t i, double s) {
      return i < node.children.size() ? box(node.children[i], s) : MathBox();
    };
    const double script = std::max(size * kScriptScale, kSmallest);
    const QString& tag = node.tag;
    if (tag == "mi") return identifier(node, size);
    if (tag == "mn" || tag == "mtext" || tag == "ms")
      return mathText(node.text, variant(node, MathFont::Upright), size);
    if (tag == "mo") return mathOperator(node, size);
    if (tag == "mspace") return mathSpace(length(node, "width", 0.0) * size);
    if (tag == "mfrac") return mathFraction(part(0, fractionSize(size)), part(1, fractionSize(size)), size);
    if (tag == "msqrt") return mathRoot(row(node.children, size), std::nullopt, size);
    if (tag == "mroot") return mathRoot(part(0, size), part(1, script), size);
    if (tag == "msub") return mathScripts(part(0, size), part(1, script), std::nullopt, size);
    if (tag == "msup") return mathScripts(part(0, size), std::nullopt, part(1, script), size);
    if (tag == "msubsup") return mathScripts(part(0, size), part(1, script), part(2, script), size);
    if (tag == "munder") return mathLimits(part(0, size), part(1, script), std::nullopt, size, false);
    if (tag == "mover") return over(node, size, script);
    if (tag == "munderover") return mathLimits(part(0, size), part(1, script), part(2, script), size, false);
    if (tag == "mfenced") return fenced(node, size);
    if (tag == "mtable") return table(node, size);
    if (tag == "semantics") return part(0, size);
    if (node.children.empty()) return mathText(node.text, MathFont::Upright, size);
    return row(node.children, size);
  }

 private:
  static double fractionSize(double size) {
    return size < 1.0 ? std::max(size * kScriptScale, kSmallest) : 0.92 * size;
  }

  static double length(const Node& node, const char* name, double otherwise) {
    const auto found = node.attributes.find(name);
    if (found == node.attributes.end()) return otherwise;
    QString text = found->second.trimmed();
    if (text.endsWith("em")) text.chop(2);
    bool ok = false;
    const double value = text.toDouble(&ok);
    return ok ? value : otherwise;
  }

  static MathFont variant(const Node& node, MathFont otherwise) {
    const auto found = node.attributes.find("mathvariant");
    if (found == node.attributes.end()) return otherwise;
    if (found->second == "bold") return MathFont::Bold;
    if (found->second == "bold-italic") return MathFont::BoldItalic;
    return found->second == "italic" ? MathFont::Italic : MathFont::Upright;
  }

  static MathBox identifier(const Node& node, double size) {
    // Single letters slant, words and capital Greek stand.
    const bool letter = node.text.size() == 1 && node.text[0].isLetter();
    const bool capitalGreek = letter && node.text[0].unicode() >= 0x391 && node.text[0].unicode() <= 0x3a9;
    return mathText(node.text, variant(node, letter && !capitalGreek ? MathFont::Italic : MathFont::Upright), size);
  }

  static MathBox mathOperator(const Node& node, double size) {
    const QString text = shown(node.text);
    static const QString large = QString::fromUtf8("∑∏∫");
    if (text.size() == 1 && large.contains(text)) return mathFence(text, 1.05 * size, 0.4 * size, size);
    return mathText(text, variant(node, MathFont::Upright), size);
  }

  /// A hyphen is a minus sign; marks that only tell machines what is applied are not seen.
  static QString shown(QString text) {
    for (const int code : {0x2061, 0x2062, 0x2063, 0x2064}) text.remove(QChar(code));
    text.replace(QLatin1String("<="), QString::fromUtf8("≤")).replace(QLatin1String(">="), QString::fromUtf8("≥"));
    return text.replace('-', QChar(0x2212));
  }

  MathBox over(const Node& node, double size, double script) const {
    if (node.children.size() < 2) return row(node.children, size);
    static const QString accents = QString::fromUtf8("^~¯ˉ‾→⃗ˆ˜˙");
    const Node& mark = node.children[1];
    const bool accent = mark.text.size() == 1 && accents.contains(mark.text);
    const MathBox base = box(node.children[0], size);
    if (accent && QString::fromUtf8("¯ˉ‾").contains(mark.text)) {
      MathBox bar;
      bar.width = base.width;
      bar.path.addRect(0.05 * size, -0.05 * size, std::max(base.width - 0.05 * size, 0.2 * size), 0.05 * size);
      bar.ascent = 0.05 * size;
      return mathLimits(base, std::nullopt, bar, size, true);
    }
    return mathLimits(base, std::nullopt, box(mark, script), size, accent);
  }

  MathBox fenced(const Node& node, double size) const {
    const auto attribute = [&](const char* name, const char* otherwise) {
      const auto found = node.attributes.find(name);
      return found == node.attributes.end() ? QString(otherwise) : found->second;
    };
    const auto fence = [](const QString& text) { return Node{"mo", text, {}, {}}; };
    const QString separators = attribute("separators", ",");
    std::vector<Node> parts{fence(attribute("open", "("))};
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      if (i > 0 && !separators.isEmpty()) {
        parts.push_back(
            fence(separators.mid(std::min(static_cast<int>(i), static_cast<int>(separators.size())) - 1, 1)));
      }
      parts.push_back(node.children[i]);
    }
    parts.push_back(fence(attribute("close", ")")));
    return row(parts, size);
  }

  MathBox table(const Node& node, double size) const {
    std::vector<std::vector<MathBox>> rows;
    for (const Node& line : node.children) {
      rows.emplace_back();
      for (const Node& cell : line.children) rows.back().push_back(row(cell.children, size));
    }
    return mathTable(rows, size);
  }

  /// An element that is an operator with something around it counts as that operator.
  static const Node& core(const Node& node) {
    const bool embellished = node.tag == "munder" || node.tag == "mover" || node.tag == "munderover" ||
                             node.tag == "msub" || node.tag == "msup" || node.tag == "msubsup" ||
                             (node.tag == "mrow" && node.children.size() == 1);
    return embellished && !node.children.empty() ? core(node.children.front()) : node;
  }

  /// Every fence as tall as what is between it and its partner, or the end of the row where it has none.
  static void stretchFences(const std::vector<Node>& nodes, std::vector<MathBox>& boxes, double size) {
    const auto enclose = [&](std::size_t first, std::size_t last) {
      double ascent = 0.0, descent = 0.0;
      for (std::size_t i = first; i <= last && i < nodes.size(); ++i) {
        ascent = std::max(ascent, boxes[i].ascent);
        descent = std::max(descent, boxes[i].descent);
      }
      for (const std::size_t i : {first, last}) {
        if (i < nodes.size() && nodes[i].tag == "mo") boxes[i] = mathFence(nodes[i].text, ascent, descent, size);
      }
    };
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& what = core(nodes[i]);
      if (what.tag != "mo" || !isFence(what.text)) continue;
      const bool bar = what.text == "|" || what.text == QString::fromUtf8("‖");
      const bool barCloses = bar && !open.empty() && core(nodes[open.back()]).text == what.text;
      if (opens(what.text) || (bar && !barCloses)) {
        open.push_back(i);
      } else if (!open.empty()) {
        enclose(open.back(), i);
        open.pop_back();
      }
    }
    for (; !open.empty(); open.pop_back()) enclose(open.back(), nodes.size());
  }

  MathBox row(const std::vector<Node>& nodes, double size) const {
    std::vector<MathBox> boxes;
    for (const Node& node : nodes) boxes.push_back(box(node, size));
    stretchFences(nodes, boxes, size);
    MathBox line;
    double pending = 0.0;
    bool operand = false;  // is there something on the left that an operator can take?
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& what = core(nodes[i]);
      // Written as operators by some, but they are what operators work on.
      const bool noun = QString::fromUtf8("∞…").contains(what.text) && !what.text.isEmpty();
      const bool op = what.tag == "mo" && !noun;
      const bool fence = op && isFence(what.text);
      const bool word = what.text.size() > 1 && what.text[0].isLetter() && (op || what.tag == "mi");
      const double lean = op && !fence ? line.slant * 0.5 : (fence ? line.slant : 0.0);
      double before = pending;
      pending = 0.0;
      if (op && !fence && !word && operand) {
        const double space = operatorSpace(what.text) * spacing(size);
        const bool comma = what.text == "," || what.text == ";";
        before += comma ? 0.0 : space;
        pending = comma ? 0.32 * spacing(size) : space;
      } else if (word) {
        before += operand ? 0.16 * spacing(size) : 0.0;
        // A function stands close to what it is applied to in brackets.
        const bool applied = i + 1 < nodes.size() && opens(core(nodes[i + 1]).text);
        pending = applied ? 0.02 : 0.16 * spacing(size);
      } else if (!op && operand && what.tag != "mspace") {
        before = std::max(before, 0.05 * size + 0.5 * line.slant);  // a product: letters must not touch
      }
      appendBox(line, boxes[i], before + lean);
      if (what.tag != "mspace")
        operand = !op || (fence && !opens(what.text)) || QString::fromUtf8("′!″").contains(what.text);
    }
    return line;
  }

  static double spacing(double size) { return size < 0.75 ? 0.45 * size : size; }
};

}  // namespace

MathBox layoutMathml(const QString& mathml) {
  QXmlStreamReader xml(mathml);
  Node root;
  while (!xml.atEnd() && !xml.isStartElement()) xml.readNext();
  if (xml.isStartElement()) root = readNode(xml);
  if (xml.hasError() || root.tag.isEmpty()) return mathText(mathml, MathFont::Upright, 1.0);
  return Layout().box(root, 1.0);
}

}  // namespace boxprobe
