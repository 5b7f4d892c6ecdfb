// The README.md files of the source tree, taken apart: lines, blocks of code, code within sentences. For
// tests/documents alone; knows nothing of what the code means.
#pragma once

#include <string>
#include <vector>

namespace boxprobe::test {

/// A place in a document, for messages: "app/README.md:12".
struct Place {
  std::string file;  ///< relative to the source tree
  int line = 0;      ///< from 1
  std::string text() const { return file + ":" + std::to_string(line); }
};

struct Readme {
  std::string path;                ///< relative to the source tree
  std::vector<std::string> lines;  ///< without line ends
};

/// Every README.md but those of build folders, sorted by path.
std::vector<Readme> readReadmes(const std::string& root);

/// A block between ``` lines, or one that is indented by four spaces (its language is then "indented").
struct CodeBlock {
  Place place;           ///< of its first line of code
  std::string language;  ///< what stands after the first ```; may be empty
  std::vector<std::string> lines;
};
std::vector<CodeBlock> codeBlocks(const Readme& readme);

/// What stands in `backquotes` outside of blocks.
struct CodeSpan {
  Place place;
  std::string text;
};
std::vector<CodeSpan> codeSpans(const Readme& readme);

/// Targets of Markdown links and pictures, and of src="..." and href="...", outside of blocks.
struct Link {
  Place place;
  std::string target;
};
std::vector<Link> links(const Readme& readme);

/// Text between empty lines outside of blocks; each row of a table counts by itself. Headings are left out.
struct Paragraph {
  Place place;  ///< of its first line
  std::vector<std::string> lines;
  std::string text() const;
};
std::vector<Paragraph> paragraphs(const Readme& readme);

/// What a link's #ANCHOR may name: the headings, as GitHub turns them into anchors.
std::vector<std::string> anchors(const Readme& readme);

}  // namespace boxprobe::test
